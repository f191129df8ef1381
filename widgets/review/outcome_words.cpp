#include "widgets/review/outcome_words.h"

#include "engine/recording/session_header.h"
#include "widgets/common/theme.h"

#include <QCoreApplication>
#include <QPainter>

namespace bask {
namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(bask::Outcome)
};

} // namespace

Outcome outcomeOf(const std::string& recorded) {
    if (recorded.empty() || recorded == kOutcomeInterrupted)
        return Outcome::Interrupted;
    if (recorded == "settled")
        return Outcome::Settled;
    if (recorded == "not-settled")
        return Outcome::NotSettled;
    if (recorded == "stopped")
        return Outcome::Stopped;
    if (recorded == "emergency-stop")
        return Outcome::EmergencyStop;
    return recorded == "fault" ? Outcome::Fault : Outcome::Other;
}

QString outcomeWord(Outcome outcome) {
    switch (outcome) {
    case Outcome::Settled:
        return Words::tr("Settled");
    case Outcome::NotSettled:
        return Words::tr("Not settled");
    case Outcome::Stopped:
        return Words::tr("Stopped");
    case Outcome::EmergencyStop:
        return Words::tr("STOP");
    case Outcome::Fault:
        return Words::tr("Fault");
    case Outcome::Interrupted:
        return Words::tr("Interrupted");
    case Outcome::Recording:
        return Words::tr("Recording");
    case Outcome::Damaged:
        return Words::tr("Damaged");
    case Outcome::Altered:
        return Words::tr("Altered");
    case Outcome::Unreadable:
        return Words::tr("Unreadable");
    case Outcome::Other:
        return {};
    }
    return {};
}

QString outcomeWord(Outcome outcome, int priority) {
    const QString word = outcomeWord(outcome);
    return outcome == Outcome::Fault && priority > 0
               ? Words::tr("%1, by an alarm of priority %2", "the outcome of a run").arg(word).arg(priority)
               : word;
}

QPixmap outcomePixmap(Outcome outcome, bool dark, int size, double devicePixelRatio, int priority) {
    if (outcome == Outcome::Fault && priority > 0)
        return alarmPixmap(priority, dark, size, devicePixelRatio, true);
    QPixmap pixmap(QSize(size, size) * devicePixelRatio);
    pixmap.setDevicePixelRatio(devicePixelRatio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor colour = secondaryText(dark); // what is past is no alarm
    painter.setPen(QPen(colour, size * 0.13, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    const auto at = [size](double x, double y) { return QPointF(x * size, y * size); };
    switch (outcome) {
    case Outcome::Settled: // tick
        painter.drawPolyline(QPolygonF{at(0.16, 0.54), at(0.40, 0.78), at(0.84, 0.24)});
        break;
    case Outcome::NotSettled: // ring
        painter.drawEllipse(QRectF(at(0.2, 0.2), at(0.8, 0.8)));
        break;
    case Outcome::Stopped: // square
        painter.drawRect(QRectF(at(0.24, 0.24), at(0.76, 0.76)));
        break;
    case Outcome::EmergencyStop: // octagon
        painter.drawPolygon(QPolygonF{at(0.33, 0.1), at(0.67, 0.1), at(0.9, 0.33), at(0.9, 0.67),
                                      at(0.67, 0.9), at(0.33, 0.9), at(0.1, 0.67), at(0.1, 0.33)});
        break;
    case Outcome::Fault: // exclamation mark in a triangle
        painter.drawPolygon(QPolygonF{at(0.5, 0.1), at(0.92, 0.9), at(0.08, 0.9)});
        painter.drawLine(at(0.5, 0.4), at(0.5, 0.56));
        painter.drawPoint(at(0.5, 0.74));
        break;
    case Outcome::Interrupted: // a line that breaks off
        painter.drawLine(at(0.1, 0.5), at(0.5, 0.5));
        painter.drawPoint(at(0.7, 0.5));
        painter.drawPoint(at(0.9, 0.5));
        break;
    case Outcome::Recording: // disk
        painter.setBrush(colour);
        painter.drawEllipse(QRectF(at(0.24, 0.24), at(0.76, 0.76)));
        break;
    case Outcome::Altered: // not equal
        painter.drawLine(at(0.16, 0.38), at(0.84, 0.38));
        painter.drawLine(at(0.16, 0.64), at(0.84, 0.64));
        painter.drawLine(at(0.66, 0.16), at(0.34, 0.86));
        break;
    case Outcome::Damaged:
    case Outcome::Unreadable: // cross
        painter.drawLine(at(0.22, 0.22), at(0.78, 0.78));
        painter.drawLine(at(0.78, 0.22), at(0.22, 0.78));
        break;
    default:
        break;
    }
    return pixmap;
}

} // namespace bask
