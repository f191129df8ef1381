#include "widgets/run/source_tile.h"

#include "widgets/common/device_words.h"
#include "widgets/common/display.h"
#include "widgets/common/labels.h"
#include "widgets/common/source_words.h"
#include "widgets/common/theme.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>

#include <cmath>
#include <limits>

namespace bask {
namespace {

constexpr double kNoTemperature = std::numeric_limits<double>::quiet_NaN();
constexpr double kNever_s = -1e300;
constexpr int kAlarmMark = 16;
constexpr double kSameReading_s = 0.01; ///< one reading is told by several snapshots

} // namespace

SourceTile::SourceTile(QWidget* parent) : QFrame(parent) {
    setObjectName(QStringLiteral("sourceTile"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    const auto label = [this](const char* name) {
        auto* made = new QLabel(this);
        made->setObjectName(QLatin1String(name));
        return made;
    };
    m_name = boldLabel(this);
    m_temperature = label("sourceTileTemperature");
    m_age = label("sourceTileAge");
    m_stateIcon = label("sourceTileStateIcon");
    m_state = label("sourceTileState");
    m_setPointCaption = label("sourceTileSetPointCaption");
    m_setPoint = label("sourceTileSetPoint");
    m_rateCaption = label("sourceTileRateCaption");
    m_rate = label("sourceTileRate");
    m_setPoint->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_rate->setAlignment(Qt::AlignRight | Qt::AlignVCenter);

    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 1, 12, 1);
    row->setSpacing(8);
    row->addWidget(m_name);
    row->addSpacing(8);
    row->addWidget(m_temperature);
    row->addWidget(m_age);
    row->addSpacing(8);
    row->addWidget(m_stateIcon);
    row->addWidget(m_state);
    row->addStretch(1);
    row->addWidget(m_setPointCaption);
    row->addWidget(m_setPoint);
    row->addSpacing(8);
    row->addWidget(m_rateCaption);
    row->addWidget(m_rate);
    clear();
    restyle();
    retranslateUi();
}

void SourceTile::clear() {
    m_trend.clear();
    m_now_K.reset();
    m_last_K = m_goal_K = kNoTemperature;
    m_age_s = std::numeric_limits<double>::infinity();
    m_read_s = kNever_s;
    m_activity = ObjectActivity::Waiting;
    m_heat = ShownHeat::Unknown;
    showValues();
}

void SourceTile::apply(const Snapshot& snapshot) {
    m_now_K = snapshot.source_K;
    m_age_s = snapshot.sourceAge_s;
    m_last_K = std::isfinite(m_age_s) ? snapshot.latest.source_K : kNoTemperature;
    m_goal_K = sourceGoal_K(snapshot);
    const double read_s = snapshot.clock_s - m_age_s;
    m_trend.passTo(snapshot.clock_s + kSameReading_s);
    if (m_now_K && std::isfinite(read_s) && std::abs(read_s - m_read_s) > kSameReading_s) {
        m_trend.add(read_s, *m_now_K, kNoTemperature);
        m_read_s = read_s;
    }
    m_activity = judge();
    m_heat = shownHeat(snapshot);
    showValues();
}

/// A source has no band in which it has to stay for a time: it is at its set point, or not.
ObjectActivity SourceTile::judge() const {
    if (!m_now_K)
        return std::isfinite(m_age_s) ? ObjectActivity::SensorInvalid : ObjectActivity::Waiting;
    if (const double rate_K_s = m_trend.told_K_s(); rate_K_s != 0.0)
        return rate_K_s > 0.0 ? ObjectActivity::Heating : ObjectActivity::Cooling;
    return std::abs(*m_now_K - m_goal_K) <= SourceWarmUp::kWarm_K ? ObjectActivity::Settled
                                                                  : ObjectActivity::Steady;
}

void SourceTile::setTemperatureUnit(TemperatureUnit unit) {
    m_unit = unit;
    showValues();
}

void SourceTile::showValues() {
    const bool isNotKnown = isUnknown(m_activity);
    m_temperature->setText(formatTemperature(m_now_K.value_or(m_last_K), m_unit));
    sayWithText(m_temperature, tr("Temperature of the source"));
    showOld(m_temperature, isNotKnown);
    m_age->setText(isNotKnown ? formatAge(m_age_s) : QString());
    m_age->setVisible(isNotKnown);
    m_setPoint->setText(formatTemperature(m_goal_K, m_unit));
    m_rate->setText(formatRate(m_now_K ? m_trend.slope_K_s() : kNoTemperature, m_unit));
    sayWithText(m_setPoint, m_setPointCaption->text());
    sayWithText(m_rate, m_rateCaption->text());
    showState();
    setAccessibleDescription(
        QStringLiteral("%1, %2 %3").arg(m_state->text(), m_temperature->text(), m_age->text()).trimmed());
}

void SourceTile::showState() {
    const int priority = heatPriority(m_heat);
    const bool isAtRest = m_activity == ObjectActivity::Settled || m_activity == ObjectActivity::Steady;
    const bool isLeft = m_heat == ShownHeat::Off && isAtRest; // nobody wants it to be anywhere
    const QString word = priority > 0 ? heatWord(m_heat)
                         : isLeft     ? asSentence(heatWord(m_heat))
                                      : activityWord(m_activity);
    if (word == m_state->text() && !m_stateIcon->pixmap().isNull())
        return;
    const bool dark = isDark(this);
    m_state->setText(word);
    m_stateIcon->setPixmap(priority > 0 ? alarmPixmap(priority, dark, kAlarmMark, devicePixelRatioF())
                                        : activityPixmap(isLeft ? ObjectActivity::Steady : m_activity, dark,
                                                         secondaryText(dark), devicePixelRatioF()));
    QPalette ink = palette();
    if (priority > 0)
        ink.setColor(QPalette::WindowText, alarmColor(priority, dark));
    else if (isUnknown(m_activity))
        ink.setColor(QPalette::WindowText, unknownColor(dark));
    m_state->setPalette(ink);
    update();
}

void SourceTile::retranslateUi() {
    m_name->setText(tr("Source"));
    m_setPointCaption->setText(tr("Set point"));
    m_rateCaption->setText(tr("Rate"));
    m_rateCaption->setToolTip(tr("Slope of the readings of the last 10 s"));
    m_setPoint->setToolTip(
        tr("Where the heat goes, or the set point with which a run begins while it is off"));
    m_setPointCaption->setToolTip(m_setPoint->toolTip());
    setAccessibleName(tr("Source"));
    m_stateIcon->clear();
    showValues();
}

void SourceTile::restyle() {
    for (QLabel* caption : {m_setPointCaption, m_rateCaption, m_age})
        caption->setPalette(captionPalette(palette()));
    QFont big = font();
    big.setPointSizeF(font().pointSizeF() * 1.3);
    m_temperature->setFont(big);
    // Widths of the longest figures, so that nothing moves while the numbers run.
    const QFontMetrics metrics(font());
    constexpr int kEdges = 2; // a label wants a little more than its text
    m_temperature->setMinimumWidth(kEdges +
                                   QFontMetrics(big).horizontalAdvance(QStringLiteral("000.0\u00a0\u00b0C")));
    m_setPoint->setMinimumWidth(kEdges + metrics.horizontalAdvance(QStringLiteral("000.0\u00a0\u00b0C")));
    m_rate->setMinimumWidth(kEdges + metrics.horizontalAdvance(QStringLiteral("+00.0\u00a0K/min")));
    m_stateIcon->clear();
    showValues();
    update();
}

void SourceTile::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const bool dark = isDark(this);
    painter.setBrush(palette().color(QPalette::Base));
    painter.setPen(isUnknown(m_activity) ? QPen(unknownColor(dark), 2.0, Qt::DashLine)
                                         : QPen(hairline(dark), 1.0));
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 4, 4);
}

void SourceTile::changeEvent(QEvent* event) {
    QFrame::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslateUi();
    else if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        restyle();
}

} // namespace bask
