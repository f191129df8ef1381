#include "widgets/run/large_tile.h"

#include "widgets/common/display.h"
#include "widgets/common/theme.h"
#include "widgets/run/large_text.h"

#include <QPainter>

#include <algorithm>

namespace bask {
namespace {

constexpr double kTilePadding = 0.025;                                // of its height
constexpr double kNameRow = 0.13, kFigureRow = 0.58, kWordRow = 0.14; // the rest: target and error
constexpr double kSwatchLength = 17.6;                                // pen widths: shows every pattern
constexpr double kCaptionLetters = 0.55;                              // of its value's

QRect paddedTile(QSize size) {
    const int padding = std::max(3, qRound(kTilePadding * size.height()));
    return QRect(QPoint(0, 0), size).adjusted(2 * padding, padding, -2 * padding, -padding);
}

QSize figureRoom(QSize tile) {
    const QSize room = paddedTile(tile).size();
    return {room.width(), qRound(kFigureRow * room.height())};
}

} // namespace

LargeTile::LargeTile(int index, QWidget* parent)
    : QFrame(parent), m_index(index), m_name(new LargeText("largeName", Qt::AlignLeft, this)),
      m_temperature(new LargeText("largeTemperature", Qt::AlignLeft, this)),
      m_word(new LargeText("largeWord", Qt::AlignLeft, this)),
      m_targetCaption(new LargeText("largeTargetCaption", Qt::AlignLeft, this)),
      m_target(new LargeText("largeTarget", Qt::AlignLeft, this)),
      m_errorCaption(new LargeText("largeErrorCaption", Qt::AlignLeft, this)),
      m_error(new LargeText("largeError", Qt::AlignLeft, this)) {
    setObjectName(QStringLiteral("largeTile.%1").arg(index));
    QFont bold = font();
    bold.setBold(true);
    m_name->setFont(bold);
    m_temperature->setFigures(QStringLiteral("000.0"));
    m_targetCaption->setLook({.isGrey = true});
    m_errorCaption->setLook({.isGrey = true});
    setShown({}, TemperatureUnit::Celsius);
}

void LargeTile::setShown(const ShownObject& shown, TemperatureUnit unit) {
    ShownObject object = shown;
    object.decimals = std::min(shown.decimals, 1); // more would make the letters smaller
    const bool isOld = isUnknown(object.activity);
    if (object.activity != m_activity) {
        m_activity = object.activity;
        update();
    }
    const QString word = activityWord(object.activity);
    m_name->setText(object.name);
    m_temperature->setText(formatTemperatureNumber(object.temperature_K, unit, object.decimals));
    m_temperature->setUnit(temperatureUnitSymbol(unit));
    m_temperature->setLook({.isUnknown = isOld,
                            .isGrey = isOld,
                            .isStruck = object.activity == ObjectActivity::SensorDistrusted});
    m_word->setText(object.age.isEmpty() ? word : word + QStringLiteral(" \u00b7 ") + object.age);
    m_word->setLook({.isUnknown = isOld, .priority = activityPriority(object.activity)});
    setCaptions(QStringLiteral("+000.0\u00a0") + temperatureUnitSymbol(unit));
    m_target->setText(formatTemperature(object.target_K, unit, object.decimals));
    m_error->setText(object.errorText(unit));
    setAccessibleName(ObjectTile::nameWords(object.name));
    setAccessibleDescription(
        QStringLiteral("%1, %2, %3 %4, %5 %6")
            .arg(m_word->text(), formatTemperature(object.temperature_K, unit, object.decimals),
                 m_targetCaption->text(), m_target->text(), m_errorCaption->text(), m_error->text()));
}

/// Their widths depend on the language, those of the figures on the unit.
void LargeTile::setCaptions(const QString& widest) {
    if (m_targetCaption->text() == ObjectTile::targetWord() &&
        m_errorCaption->text() == ObjectTile::errorWord() && m_widest == widest)
        return;
    m_targetCaption->setText(ObjectTile::targetWord());
    m_errorCaption->setText(ObjectTile::errorWord());
    m_widest = widest;
    for (LargeText* figures : {m_target, m_error})
        figures->setFigures(widest);
    arrange();
}

int LargeTile::figureHeight(QSize size) const {
    return m_temperature->figureHeight(figureRoom(size));
}

void LargeTile::arrange() {
    const QRect room = paddedTile(size());
    const int name = qRound(kNameRow * room.height()), figures = figureRoom(size()).height(),
              word = qRound(kWordRow * room.height()), values = room.height() - name - figures - word;
    const int pen = std::max(2, name / 12);
    m_swatch = QRect(room.left(), room.top(), std::min(qRound(kSwatchLength * pen), room.width() / 4), name);
    const int left = m_swatch.right() + 1 + 2 * pen;
    m_name->setGeometry(left, room.top(), room.right() + 1 - left, name);
    m_temperature->setGeometry(room.left(), room.top() + name, room.width(), figures);
    m_word->setGeometry(room.left(), room.top() + name + figures, room.width(), word);
    const QFontMetricsF metrics(font());
    const auto share = [&](const LargeText* caption) {
        return kCaptionLetters * metrics.horizontalAdvance(caption->text());
    };
    const double value = metrics.horizontalAdvance(m_widest);
    placeInRow(QRect(room.left(), room.top() + name + figures + word, room.width(), values), 2 * pen,
               {{m_targetCaption, share(m_targetCaption)},
                {m_target, value},
                {m_errorCaption, share(m_errorCaption)},
                {m_error, value}});
}

void LargeTile::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintTileGround(painter, *this, m_activity, std::max(2.0, height() / 90.0));
    painter.setPen(seriesPen(m_index, isDark(this), std::max(2, m_swatch.height() / 12)));
    const double y = m_swatch.center().y() + 0.5;
    painter.drawLine(QPointF(m_swatch.left(), y), QPointF(m_swatch.right() + 1, y));
}

void LargeTile::resizeEvent(QResizeEvent* event) {
    QFrame::resizeEvent(event);
    arrange();
}

} // namespace bask
