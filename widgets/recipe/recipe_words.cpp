#include "widgets/recipe/recipe_words.h"

#include "widgets/common/display.h"
#include "widgets/common/theme.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QPainter>

namespace bask {
namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(bask::Recipe)
};

using State = RecipeProgress::State;
using Until = RecipeStep::Until;

} // namespace

QString stepWords(const RecipeStep& step) {
    if (!step.example.empty())
        return QString::fromStdString(step.example);
    return step.experiment.empty() ? Words::tr("Wait")
                                   : QFileInfo(QString::fromStdString(step.experiment)).fileName();
}

QString conditionWords(const RecipeStep& step, TemperatureUnit unit) {
    switch (step.until) {
    case Until::Settled:
        return Words::tr("all have been settled for %1").arg(formatDuration(step.duration_s));
    case Until::Time:
        return Words::tr("%1 have passed").arg(formatDuration(step.duration_s));
    case Until::Above:
        return Words::tr("%1 is at %2 or above")
            .arg(QString::fromStdString(step.object), formatTemperature(step.temperature_K, unit));
    case Until::Below:
        return Words::tr("%1 is at %2 or below")
            .arg(QString::fromStdString(step.object), formatTemperature(step.temperature_K, unit));
    }
    return {};
}

QString maxDurationWords(const RecipeStep& step) {
    return formatDuration(step.until == Until::Time ? step.duration_s : step.maxDuration_s);
}

QString stateWord(State state) {
    switch (state) {
    case State::Waiting:
        return Words::tr("To come");
    case State::Underway:
        return Words::tr("Under way");
    case State::Done:
        return Words::tr("Done");
    case State::NotReached:
        return Words::tr("Not reached");
    case State::Failed:
        return Words::tr("Failed");
    case State::Stopped:
        return Words::tr("Stopped");
    case State::Paused:
        return Words::tr("Held");
    }
    return {};
}

QPixmap statePixmap(State state, bool dark, int size, double devicePixelRatio) {
    if (state == State::Failed)
        return alarmPixmap(1, dark, size, devicePixelRatio);
    QPixmap pixmap(QSize(size, size) * devicePixelRatio);
    pixmap.setDevicePixelRatio(devicePixelRatio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor colour = state == State::Underway ? accentColor(dark) : secondaryText(dark);
    painter.setPen(QPen(colour, size * 0.13, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    const auto at = [size](double x, double y) { return QPointF(x * size, y * size); };
    if (state == State::Done) // tick
        painter.drawPolyline(QPolygonF{at(0.16, 0.54), at(0.40, 0.78), at(0.84, 0.24)});
    else if (state == State::NotReached) // ring
        painter.drawEllipse(QRectF(at(0.2, 0.2), at(0.8, 0.8)));
    else if (state == State::Stopped) // square
        painter.drawRect(QRectF(at(0.24, 0.24), at(0.76, 0.76)));
    else if (state == State::Paused) // two bars
        painter.drawLines({QLineF(at(0.34, 0.22), at(0.34, 0.78)), QLineF(at(0.66, 0.22), at(0.66, 0.78))});
    painter.setBrush(colour);
    if (state == State::Underway) // arrow
        painter.drawPolygon(QPolygonF{at(0.28, 0.2), at(0.8, 0.5), at(0.28, 0.8)});
    else if (state == State::Waiting)
        painter.drawEllipse(at(0.5, 0.5), 0.06 * size, 0.06 * size);
    return pixmap;
}

QString endWords(RecipeEnd end) {
    switch (end) {
    case RecipeEnd::None:
        return {};
    case RecipeEnd::Done:
        return Words::tr("The recipe is done.");
    case RecipeEnd::StepFailed:
        return Words::tr("The recipe has ended: not every step was done.");
    case RecipeEnd::Stopped:
        return Words::tr("The recipe was stopped.");
    case RecipeEnd::TakenOver:
        return Words::tr("The recipe has ended, since the rig or the experiment was taken in hand.");
    case RecipeEnd::Alarm:
        return Words::tr("The recipe was ended by an alarm.");
    case RecipeEnd::Fault:
        return Words::tr("The recipe was ended by a fault.");
    }
    return {};
}

} // namespace bask
