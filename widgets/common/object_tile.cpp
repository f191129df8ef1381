#include "widgets/common/object_tile.h"

#include "engine/base/message_code.h"
#include "engine/model/safety_spec.h"
#include "widgets/common/display.h"
#include "widgets/common/labels.h"
#include "widgets/common/theme.h"

#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <limits>

namespace bask {
namespace {

constexpr int kStateIcon = 14;
constexpr double kNoTenths = 9.5;            // of twice an uncertainty
constexpr double kLongestInSeconds_s = 99.5; ///< as an age
constexpr double kLimitGround = 0.18;        ///< share of its colour in the ground of a tile

} // namespace

QPixmap activityPixmap(ObjectActivity activity, bool dark, const QColor& ink, double devicePixelRatio) {
    if (isUnknown(activity))
        return unknownPixmap(dark, kStateIcon, devicePixelRatio);
    if (const int priority = activityPriority(activity); priority > 0)
        return alarmPixmap(priority, dark, kStateIcon, devicePixelRatio);
    QPixmap pixmap(QSize(kStateIcon, kStateIcon) * devicePixelRatio);
    pixmap.setDevicePixelRatio(devicePixelRatio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(kStateIcon / 2.0, kStateIcon / 2.0);
    painter.setPen(QPen(ink, 1.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    switch (activity) {
    case ObjectActivity::Heating: // arrow up
        painter.drawLine(QPointF(0, 5), QPointF(0, -4.5));
        painter.drawPolyline(QPolygonF{{-4, -0.5}, {0, -4.5}, {4, -0.5}});
        break;
    case ObjectActivity::Cooling: // arrow down
        painter.drawLine(QPointF(0, -5), QPointF(0, 4.5));
        painter.drawPolyline(QPolygonF{{-4, 0.5}, {0, 4.5}, {4, 0.5}});
        break;
    case ObjectActivity::Settling: // arrows towards a line
        painter.drawLine(QPointF(-5, 0), QPointF(5, 0));
        painter.drawPolyline(QPolygonF{{-2.5, -5}, {0, -2.8}, {2.5, -5}});
        painter.drawPolyline(QPolygonF{{-2.5, 5}, {0, 2.8}, {2.5, 5}});
        break;
    case ObjectActivity::Settled: // tick
        painter.drawPolyline(QPolygonF{{-5, 0.3}, {-1.5, 4}, {5, -4}});
        break;
    case ObjectActivity::Steady: // level
        painter.drawLine(QPointF(-5, -2), QPointF(5, -2));
        painter.drawLine(QPointF(-5, 2), QPointF(5, 2));
        break;
    default: // waiting: ring
        painter.drawEllipse(QPointF(0, 0), 4.5, 4.5);
        break;
    }
    return pixmap;
}

QString activityWord(ObjectActivity activity) {
    switch (activity) {
    case ObjectActivity::Waiting:
        return ObjectTile::tr("No reading yet");
    case ObjectActivity::SensorInvalid:
        return ObjectTile::tr("UNKNOWN", "the temperature of an object");
    case ObjectActivity::SensorStale:
        return ObjectTile::tr("Stale", "the reading of an object");
    case ObjectActivity::SensorDistrusted:
        return ObjectTile::tr("Not believed", "the reading of an object");
    case ObjectActivity::Heating:
        return ObjectTile::tr("Heating");
    case ObjectActivity::Cooling:
        return ObjectTile::tr("Cooling");
    case ObjectActivity::Steady:
        return ObjectTile::tr("Off target", "steady, outside the tolerance band");
    case ObjectActivity::Settling:
        return ObjectTile::tr("Settling");
    case ObjectActivity::Settled:
        return ObjectTile::tr("Settled");
    case ObjectActivity::AboveWarning:
        return ObjectTile::tr("Above its warning limit", "the temperature of an object");
    case ObjectActivity::AboveTrip:
        return ObjectTile::tr("Above its trip limit", "the temperature of an object");
    }
    return {};
}

int activityPriority(ObjectActivity activity) {
    if (activity == ObjectActivity::AboveTrip)
        return alarmPriority(MessageCode::SafetyObjectHot);
    return activity == ObjectActivity::AboveWarning ? alarmPriority(MessageCode::SafetyObjectWarm) : 0;
}

void paintTileGround(QPainter& painter, const QWidget& tile, ObjectActivity activity, double frame) {
    const bool dark = isDark(&tile);
    const int priority = activityPriority(activity);
    const QColor base = tile.palette().color(QPalette::Base);
    painter.setBrush(priority > 0 ? mixed(alarmColor(priority, dark), base, kLimitGround) : base);
    painter.setPen(priority > 0          ? QPen(alarmEdgeColor(priority, dark), frame)
                   : isUnknown(activity) ? QPen(unknownColor(dark), frame, Qt::DashLine)
                                         : QPen(hairline(dark), 1.0));
    painter.drawRoundedRect(QRectF(tile.rect()).adjusted(1, 1, -1, -1), 4, 4);
}

bool isUnknown(ObjectActivity activity) {
    return activity == ObjectActivity::SensorInvalid || activity == ObjectActivity::SensorStale ||
           activity == ObjectActivity::SensorDistrusted;
}

QString ShownObject::errorText(TemperatureUnit unit) const {
    return formatPrintedDifference(isUnknown(activity) ? kNothing : temperature_K, target_K, unit, decimals);
}

ObjectTile::ObjectTile(int index, QWidget* parent) : QFrame(parent), m_index(index) {
    setObjectName(QStringLiteral("objectTile.%1").arg(index));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    const auto label = [this](const char* name, Qt::Alignment alignment) {
        auto* made = new QLabel(this);
        made->setObjectName(QLatin1String(name));
        made->setAlignment(alignment | Qt::AlignVCenter);
        return made;
    };
    m_swatch = label("tileSwatch", Qt::AlignLeft);
    m_nameLabel = label("tileName", Qt::AlignLeft);
    m_nameLabel->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_stateIcon = label("tileStateIcon", Qt::AlignRight);
    m_stateLabel = label("tileState", Qt::AlignRight);
    m_temperature = label("tileTemperature", Qt::AlignLeft);
    m_age = label("tileAge", Qt::AlignLeft);
    m_confirm = new QPushButton(this);
    m_confirm->setObjectName(QStringLiteral("confirmSensor"));
    connect(m_confirm, &QPushButton::clicked, this, &ObjectTile::confirmRequested);
    m_targetCaption = label("tileTargetCaption", Qt::AlignRight);
    m_errorCaption = label("tileErrorCaption", Qt::AlignRight);
    m_rateCaption = label("tileRateCaption", Qt::AlignRight);
    m_target = label("tileTarget", Qt::AlignRight);
    m_error = label("tileError", Qt::AlignRight);
    m_rate = label("tileRate", Qt::AlignRight);

    auto* header = new QHBoxLayout;
    header->setSpacing(8);
    header->addWidget(m_swatch);
    header->addWidget(m_nameLabel, 1);
    header->addWidget(m_stateIcon);
    header->addWidget(m_stateLabel);
    auto* numbers = new QGridLayout;
    numbers->setHorizontalSpacing(8);
    numbers->setVerticalSpacing(0);
    auto* reading = new QVBoxLayout;
    reading->setSpacing(0);
    reading->addStretch(1);
    reading->addWidget(m_temperature);
    reading->addWidget(m_age);
    reading->addWidget(m_confirm, 0, Qt::AlignLeft);
    reading->addStretch(1);
    numbers->addLayout(reading, 0, 0, 3, 1);
    numbers->setColumnStretch(0, 1);
    QLabel* const rows[3][2] = {
        {m_targetCaption, m_target}, {m_errorCaption, m_error}, {m_rateCaption, m_rate}};
    for (int row = 0; row < 3; ++row) {
        numbers->addWidget(rows[row][0], row, 1);
        numbers->addWidget(rows[row][1], row, 2);
    }
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(12, 7, 12, 8);
    layout->setSpacing(2);
    layout->addLayout(header);
    layout->addLayout(numbers);
    clear(std::numeric_limits<double>::quiet_NaN());
    restyle();
    retranslateUi();
}

void ObjectTile::setName(const QString& name) {
    m_name = name;
    m_nameLabel->setText(name);
    m_nameLabel->setToolTip(name);
    retranslateUi();
}

void ObjectTile::setLimits(double warning_K, double trip_K) {
    m_warning_K = warning_K;
    m_trip_K = trip_K;
}

void ObjectTile::clear(double target_K) {
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    m_sample = ObjectSample{};
    m_sample.measured_K = m_sample.estimated_K = m_sample.rate_K_s = kNaN;
    m_sample.target_K = target_K;
    m_sensor = {};
    m_believed_K = kNaN;
    m_inBandSince_s = -1.0;
    m_trend.clear();
    m_activity = ObjectActivity::Waiting;
    showValues();
}

/// From one sample to the next the estimate's noise is several K/min.
void ObjectTile::takeRate(double time_s, const ObjectSample& sample) {
    m_trend.passTo(time_s);
    if (sample.valid && std::isfinite(sample.measured_K))
        m_trend.add(time_s, sample.measured_K, sample.rate_K_s);
}

ObjectActivity ObjectTile::judge(double time_s, const ObjectSample& sample) {
    takeRate(time_s, sample);
    const double error_K = sample.measured_K - sample.target_K;
    const bool inBand = sample.valid && std::abs(error_K) <= kSettledBand_K;
    if (!inBand)
        m_inBandSince_s = -1.0;
    else if (m_inBandSince_s < 0.0 || m_inBandSince_s > time_s)
        m_inBandSince_s = time_s;
    if (m_sensor.trust == SensorTrust::Distrusted)
        return ObjectActivity::SensorDistrusted;
    if (!sample.valid || !std::isfinite(sample.measured_K))
        return ObjectActivity::SensorInvalid;
    if (m_sensor.trust == SensorTrust::Stale)
        return ObjectActivity::SensorStale;
    const auto isAbove = [&](double limit_K, bool wasAbove) {
        return sample.measured_K > limit_K - (wasAbove ? SafetySpec::kHysteresis_K : 0.0);
    };
    const bool wasAboveTrip = m_activity == ObjectActivity::AboveTrip;
    if (isAbove(m_trip_K, wasAboveTrip))
        return ObjectActivity::AboveTrip;
    if (isAbove(m_warning_K, wasAboveTrip || m_activity == ObjectActivity::AboveWarning))
        return ObjectActivity::AboveWarning;
    if (inBand)
        return time_s - m_inBandSince_s >= kSettledAfter_s ? ObjectActivity::Settled
                                                           : ObjectActivity::Settling;
    if (const double rate_K_s = m_trend.told_K_s(); rate_K_s != 0.0)
        return rate_K_s > 0.0 ? ObjectActivity::Heating : ObjectActivity::Cooling;
    return ObjectActivity::Steady;
}

void ObjectTile::setSample(double time_s, const ObjectSample& sample, const SensorView& sensor) {
    m_sample = sample;
    m_sensor = sensor;
    if (sample.valid)
        m_believed_K = sample.measured_K;
    m_activity = judge(time_s, sample);
    showValues();
}

void ObjectTile::setMoment(const std::vector<TraceSample>& samples, std::size_t k, std::size_t i) {
    std::size_t first = k;
    while (first > 0 && samples[first].time_s > samples[k].time_s - kSettledAfter_s)
        --first;
    m_inBandSince_s = -1.0;
    m_trend.clear();
    m_sensor = {};
    m_sensor.uncertainty_K = m_recorded_K;
    m_activity = ObjectActivity::Waiting;
    for (std::size_t row = first; row <= k; ++row)
        m_activity = judge(samples[row].time_s, samples[row].objects[i]);
    m_sample = samples[k].objects[i];
    showValues();
}

void ObjectTile::setRecordedUncertainty(double u_K) {
    m_recorded_K = m_sensor.uncertainty_K = u_K;
    showValues();
}

void ObjectTile::setTemperatureUnit(TemperatureUnit unit) {
    m_unit = unit;
    m_told_u = std::numeric_limits<double>::quiet_NaN();
    showValues();
}

/// The age is that of the newest reading that was believed, and is told beside no other.
QString ObjectTile::ageText() const {
    if (m_activity == ObjectActivity::SensorStale && std::isfinite(m_sensor.sameFor_s))
        return m_sensor.sameFor_s < kLongestInSeconds_s
                   ? tr("same for %1 s", "the value of a frozen sensor").arg(m_sensor.sameFor_s, 0, 'f', 0)
                   : tr("same for %1", "the value of a frozen sensor; %1 is minutes and seconds")
                         .arg(formatDuration(m_sensor.sameFor_s));
    const bool isOther = std::isfinite(m_sensor.told_K) && m_sensor.told_K != m_believed_K;
    const bool isBelieved = m_activity != ObjectActivity::SensorDistrusted && !isOther;
    return isUnknown(m_activity) && isBelieved && std::isfinite(m_sensor.age_s) ? formatAge(m_sensor.age_s)
                                                                                : QString();
}

/// What is shown of a reading that is not known is the last that was told: grey, of one that was believed
/// with its age, never as if it were the present one, and never 0.
ShownObject ObjectTile::shown() const {
    const bool isOld = isUnknown(m_activity);
    const double told_K =
        std::isfinite(m_sensor.told_K) || !m_sample.valid ? m_sensor.told_K : m_sample.measured_K;
    const double known_K = m_sample.valid && !isOld ? m_sample.measured_K : ShownObject::kNothing;
    return {m_name, m_activity, isOld ? told_K : known_K, m_sample.target_K, ageText(), m_decimals};
}

/// What differs little from what is told changes nothing: else digits would come and go with its noise.
void ObjectTile::takeUncertainty() {
    constexpr double kSteady = 0.15;
    const double u = displayDifference(m_sensor.uncertainty_K, m_unit);
    if (!(std::abs(u - m_told_u) <= kSteady * m_told_u)) {
        m_told_u = u;
        m_decimals = decimalsOf(2.0 * u, 2.0 * u < kNoTenths ? 1 : 0).value_or(1); // as of formatReading()
    }
    const QString widest = formatTemperatureNumber(0.0, TemperatureUnit::Kelvin, m_decimals);
    m_temperature->setMinimumWidth(
        m_temperature->fontMetrics().horizontalAdvance(QStringLiteral("00%1\u00a0\u00b0C").arg(widest)));
}

void ObjectTile::showValues() {
    takeUncertainty();
    const ShownObject now = shown();
    const bool isKnown = m_sample.valid && !isUnknown(m_activity);
    showTemperature(now);
    m_target->setText(formatTemperature(now.target_K, m_unit, now.decimals));
    m_error->setText(now.errorText(m_unit));
    m_rate->setText(formatRate(isKnown ? m_trend.meanRate_K_s() : ShownObject::kNothing, m_unit));
    sayWithText(m_target, m_targetCaption->text());
    sayWithText(m_error, m_errorCaption->text());
    sayWithText(m_rate, m_rateCaption->text());

    const bool dark = isDark(this);
    const QColor ink = isUnknown(m_activity) ? unknownColor(dark) : palette().color(QPalette::WindowText);
    if (const QString word = activityWord(m_activity);
        word != m_stateLabel->text() || m_stateIcon->pixmap().isNull()) {
        m_stateLabel->setText(word);
        m_stateIcon->setPixmap(activityPixmap(m_activity, dark, secondaryText(dark), devicePixelRatioF()));
        QPalette state = palette();
        state.setColor(QPalette::WindowText, ink);
        m_stateLabel->setPalette(state);
        update();
    }
    QStringList told{m_temperature->text()};
    for (const QString& more : {isKnown ? uncertaintyText() : QString(), isKnown ? cameraText() : now.age})
        if (!more.isEmpty())
            told << more;
    setAccessibleDescription(m_stateLabel->text() + QStringLiteral(", ") + told.join(u' '));
}

void ObjectTile::showTemperature(const ShownObject& now) {
    const bool isOld = isUnknown(m_activity);
    const bool isDoubted = m_activity == ObjectActivity::SensorDistrusted;
    m_temperature->setText(formatTemperature(now.temperature_K, m_unit, now.decimals));
    sayWithText(m_temperature, tr("Measured temperature of %1").arg(m_name));
    if (const QString tip = isOld ? QString() : uncertaintyTip(); tip != m_temperature->toolTip())
        m_temperature->setToolTip(tip);
    if (QFont font = m_temperature->font(); font.strikeOut() != isDoubted) {
        font.setStrikeOut(isDoubted);
        m_temperature->setFont(font);
    }
    QPalette shown = palette();
    if (isOld)
        shown.setColor(QPalette::WindowText, secondaryText(isDark(this)));
    if (m_temperature->palette() != shown)
        m_temperature->setPalette(shown);
    const QString camera = cameraText();
    m_age->setText(isOld ? now.age : camera.isEmpty() ? uncertaintyText() : camera);
    m_age->setVisible(!isDoubted);
    m_confirm->setVisible(isDoubted);
}

/// What the thermal camera sees, in the place of an age.
QString ObjectTile::cameraText() const {
    if (!std::isfinite(m_sample.camera.T_K))
        return {};
    const QString reading = formatReading(m_sample.camera.T_K, m_sample.camera.uncertainty_K, m_unit);
    return m_sample.camera.isPartlyOutside ? tr("Camera %1 (part)").arg(reading)
                                           : tr("Camera %1").arg(reading);
}

/// "± 0.15 K"; empty where it is not known.
QString ObjectTile::uncertaintyText() const {
    const auto decimals = decimalsOf(m_told_u, 1);
    if (!decimals)
        return {};
    return QStringLiteral("\u00b1 %1\u00a0%2")
        .arg(QLocale().toString(m_told_u, 'f', *decimals + 1), differenceUnitSymbol(m_unit));
}

/// Empty where the uncertainty is not known.
QString ObjectTile::uncertaintyTip() const {
    const double u_K = displayDifference(m_sensor.uncertainty_K, m_unit);
    const auto decimals = decimalsOf(u_K, 1);
    if (!decimals)
        return {};
    const QString words =
        tr("Standard uncertainty %1 %2. Of a sensor it is that of the room's temperature to which it was "
           "zeroed, of its zeroing, and of step and noise of its readings. Not in it: the sensor's own error "
           "away from the room's temperature, and how well it touches its object.")
            .arg(QLocale().toString(u_K, 'f', *decimals + 1), differenceUnitSymbol(m_unit));
    return QStringLiteral("<p>%1</p>").arg(words.toHtmlEscaped()); // breaks its lines
}

QString ObjectTile::targetWord() {
    return tr("Target");
}

QString ObjectTile::errorWord() {
    return tr("Error");
}

QString ObjectTile::nameWords(const QString& name) {
    return tr("Object %1").arg(name);
}

void ObjectTile::retranslateUi() {
    m_targetCaption->setText(targetWord());
    m_errorCaption->setText(errorWord());
    m_errorCaption->setToolTip(tr("Measured minus target"));
    m_rateCaption->setText(tr("Rate"));
    m_rateCaption->setToolTip(tr("Mean of the last 10 s"));
    setAccessibleName(nameWords(m_name));
    m_age->setToolTip(tr(
        "Standard uncertainty of the reading, or what the thermal camera sees of the object, with twice its "
        "own; of a reading that is not believed its age, or how long the sensor has told the same value. "
        "(part): some of the object is outside of the picture"));
    m_confirm->setText(tr("Confirm"));
    m_confirm->setAccessibleName(tr("Confirm the sensor of %1").arg(m_name));
    m_confirm->setToolTip(
        tr("You have looked: the sensor is on its object and right. It is believed again."));
    m_stateIcon->clear();
    showValues();
}

void ObjectTile::restyle() {
    const bool dark = isDark(this);
    QFont bold = font();
    bold.setBold(true);
    m_nameLabel->setFont(bold);
    QFont big = font();
    big.setPointSizeF(font().pointSizeF() * 2.1);
    big.setStrikeOut(m_temperature->font().strikeOut());
    m_temperature->setFont(big);
    m_swatch->setPixmap(seriesSwatch(m_index, dark, {44, 14}, devicePixelRatioF()));
    for (QLabel* caption : {m_targetCaption, m_errorCaption, m_rateCaption, m_age})
        caption->setPalette(captionPalette(palette()));
    // Widths of the longest figures, so that nothing moves while the numbers run.
    const QFontMetrics metrics(font());
    for (QLabel* value : {m_target, m_error, m_rate})
        value->setMinimumWidth(metrics.horizontalAdvance(QStringLiteral("+00.0\u00a0K/min")) + 2);
    m_told_u = std::numeric_limits<double>::quiet_NaN(); // the letters may have another size
    const int foot = std::max(m_age->sizeHint().height(), m_confirm->sizeHint().height());
    m_age->setMinimumHeight(foot); // the tile is as high with the one as with the other
    m_stateIcon->clear();
    showValues();
    update();
}

void ObjectTile::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintTileGround(painter, *this, m_activity, 2.0);
}

void ObjectTile::changeEvent(QEvent* event) {
    QFrame::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslateUi();
    else if (event->type() == QEvent::PaletteChange)
        restyle();
}

} // namespace bask
