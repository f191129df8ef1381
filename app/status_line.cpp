#include "app/status_line.h"

#include "app/error_text.h"
#include "engine/base/message_code.h"
#include "widgets/common/device_words.h"
#include "widgets/common/display.h"
#include "widgets/common/elided_label.h"
#include "widgets/common/labels.h"
#include "widgets/common/language.h"

#include <QEvent>
#include <QFileInfo>
#include <QLocale>
#include <QMenu>
#include <QToolButton>

#include <algorithm>

namespace bask {
namespace {

int shownCount(std::uint64_t count) {
    return static_cast<int>(std::min<std::uint64_t>(count, 1'000'000'000));
}

} // namespace

StatusLine::StatusLine(QMenu* unitMenu, QMenu* languageMenu, QWidget* parent)
    : QStatusBar(parent), m_ageLabel(new ElidedLabel(this)), m_loopLabel(new ElidedLabel(this)),
      m_sourceLabel(new QLabel(this)), m_heatMark(new QLabel(this)), m_heatLabel(new QLabel(this)),
      m_trackingLabel(new ElidedLabel(this)), m_recordingLabel(new ElidedLabel(this)),
      m_monitorMark(new QLabel(this)), m_monitorLabel(new QLabel(this)), m_unit(new QToolButton(this)),
      m_language(new QToolButton(this)) {
    m_ageLabel->setObjectName(QStringLiteral("sampleAge"));
    m_loopLabel->setObjectName(QStringLiteral("loopRate"));
    m_sourceLabel->setObjectName(QStringLiteral("sourceState"));
    m_heatLabel->setObjectName(QStringLiteral("heatWord"));
    m_trackingLabel->setObjectName(QStringLiteral("tracking"));
    m_recordingLabel->setObjectName(QStringLiteral("recording"));
    m_unit->setObjectName(QStringLiteral("unitButton"));
    m_language->setObjectName(QStringLiteral("languageButton"));
    setSizeGripEnabled(false);
    for (QLabel* label : {m_ageLabel, m_loopLabel, m_sourceLabel, m_trackingLabel, m_recordingLabel})
        label->setContentsMargins(6, 0, 10, 0);
    for (QLabel* label : {m_ageLabel, m_loopLabel, m_recordingLabel})
        addWidget(label);
    m_monitorLabel->setObjectName(QStringLiteral("monitoring"));
    m_monitorLabel->setContentsMargins(0, 0, 10, 0);
    addPermanentWidget(m_monitorMark);
    addPermanentWidget(m_monitorLabel);
    addPermanentWidget(m_trackingLabel); // no tip hides it
    m_sourceLabel->setContentsMargins(6, 0, 0, 0);
    m_heatLabel->setContentsMargins(0, 0, 10, 0);
    for (QLabel* label : {m_sourceLabel, m_heatMark, m_heatLabel})
        addPermanentWidget(label);
    m_unit->setMenu(unitMenu);
    m_language->setMenu(languageMenu);
    for (QToolButton* button : {m_unit, m_language}) {
        button->setPopupMode(QToolButton::InstantPopup);
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::TabFocus);
        addPermanentWidget(button);
    }
    retranslate();
}

void StatusLine::apply(const Snapshot& snapshot) {
    m_any = !snapshot.latest.objects.empty();
    m_age_s = snapshot.sampleAge_s;
    m_rate_Hz = snapshot.loopRate_Hz;
    m_late = snapshot.lateSteps;
    m_speed = snapshot.simulated ? snapshot.simulationSpeed : 1.0;
    m_rows = snapshot.recordedRows;
    m_isUntilCold = snapshot.isRecordedUntilCold;
    m_tracking = snapshot.tracking;
    m_devices = snapshot.devices;
    m_source.source_K = snapshot.source_K;
    m_source.latest.source_K = snapshot.latest.source_K;
    m_source.sourceAge_s = snapshot.sourceAge_s;
    m_source.heat = snapshot.heat;
    m_source.alarms = snapshot.alarms;
    m_source.isSourceManual = snapshot.isSourceManual;
    m_recording = QString::fromStdString(snapshot.recordingPath);
    refresh();
}

void StatusLine::setAnswering(bool answering) {
    m_answering = answering;
    refresh();
}

void StatusLine::refresh() {
    const auto set = [](QLabel* label, const QString& text) {
        if (label->text() != text)
            label->setText(text);
    };
    m_sourceLabel->setVisible(m_any);
    showHeat();
    if (!m_answering) {
        set(m_ageLabel, tr("engine not answering"));
        return;
    }
    set(m_ageLabel, ageText());
    const QString speed =
        m_speed > 1.0 ? QStringLiteral(" ") + tr("(simulation ×%1)").arg(QLocale().toString(m_speed, 'g', 3))
                      : QString();
    set(m_loopLabel,
        tr("loop %1 Hz, late %2").arg(QLocale().toString(m_rate_Hz, 'f', 1)).arg(m_late) + speed);
    set(m_sourceLabel, sourceText());
    set(m_trackingLabel, trackingText());
    m_trackingLabel->setVisible(m_tracking.has_value());
    set(m_recordingLabel, recordingText());
    m_recordingLabel->setToolTip(m_recording);
}

QString StatusLine::ageText() const {
    QStringList ages;
    for (const RigDeviceState& device : m_devices) {
        const QString age = device.status.link == LinkState::Live ? bask::ageText(device.age_s) : QString();
        ages << roleWord(device.role).toLower() + u' ' +
                    (age.isEmpty() ? linkWord(device.status.link).toLower() : age);
    }
    if (!ages.isEmpty())
        return ages.join(QStringLiteral(", "));
    return m_any ? tr("readings %1 s old").arg(QLocale().toString(m_age_s, 'f', 1)) : tr("no readings");
}

QString StatusLine::recordingText() const {
    if (m_recording.isEmpty())
        return tr("not recording");
    const QString name = QFileInfo(m_recording).completeBaseName();
    if (!m_isUntilCold)
        return tr("recording %1, %2 samples").arg(name).arg(m_rows);
    return tr("recorded until cold: source %1; %2, %3 samples")
        .arg(sourceReadingText(m_source, m_temperatureUnit), name, QString::number(m_rows));
}

QString StatusLine::sourceText() const {
    const QString now = sourceReadingText(m_source, m_temperatureUnit);
    if (!m_source.isSourceManual)
        return tr("source %1,").arg(now);
    return m_source.source_K ? tr("source %1 as typed,").arg(now) : tr("source: no temperature typed,");
}

/// What is not known, or not as ordered, has a word, a mark and a colour of its own, and the last temperature
/// is grey.
void StatusLine::showHeat() {
    const ShownHeat heat = shownHeat(m_source, m_answering);
    const QString text = heatWord(heat);
    if (text != m_heatLabel->text())
        m_heatLabel->setText(text);
    showOld(m_sourceLabel, !m_answering || !m_source.source_K);
    const bool isUnknown = heat == ShownHeat::Unknown;
    const int priority = heatPriority(heat);
    if (priority > 0)
        showAlarmed(m_heatMark, m_heatLabel, priority);
    else
        showUnknown(m_heatMark, m_heatLabel, isUnknown);
    m_heatMark->setVisible(m_any && (isUnknown || priority > 0));
    m_heatLabel->setVisible(m_any);
}

void StatusLine::showMonitor(const MonitorState& state) {
    m_monitor = state;
    showMonitor();
}

/// Not an alarm: the run does not depend on it.
void StatusLine::showMonitor() {
    QStringList problems;
    for (const Message& problem : {m_monitor.brokerProblem, m_monitor.fileProblem})
        if (problem.code != MessageCode::None)
            problems << asSentence(sentence(problem));
    const bool isTrouble = !problems.isEmpty();
    const bool isBeginning = m_monitor.hasBroker && !m_monitor.isConnected;
    m_monitorLabel->setText(isTrouble     ? tr("monitoring fails")
                            : isBeginning ? tr("monitoring begins")
                                          : tr("monitored"));
    if (m_monitor.leftOut > 0)
        problems << tr("%n event(s) were not published", nullptr, shownCount(m_monitor.leftOut));
    const QString what = tr("What the run does is published (View > Monitoring): %n message(s)", nullptr,
                            shownCount(m_monitor.sent));
    m_monitorLabel->setToolTip(problems.isEmpty() ? what : problems.join(u'\n'));
    m_monitorMark->setToolTip(m_monitorLabel->toolTip());
    showUnknown(m_monitorMark, m_monitorLabel, isTrouble);
    m_monitorMark->setVisible(m_monitor.isOn && isTrouble);
    m_monitorLabel->setVisible(m_monitor.isOn);
}

QString StatusLine::trackingText() const {
    if (!m_tracking)
        return {};
    if (!m_tracking->isSeen)
        return tr("source not seen");
    QString text =
        m_tracking->isPredicted
            ? tr("source not seen for %1 s, predicted").arg(QLocale().toString(m_tracking->age_s, 'f', 1))
            : tr("source followed");
    if (m_tracking->latency_s > 0.0)
        text += QStringLiteral(", ") + tr("%1 ms late").arg(m_tracking->latency_s * 1e3, 0, 'f', 0);
    if (m_tracking->position_m > 0.0)
        text += QStringLiteral(", ") +
                tr("\u00b1%1 mm").arg(QLocale().toString(m_tracking->position_m * 1e3, 'f', 1));
    return text;
}

void StatusLine::setTemperatureUnit(TemperatureUnit unit) {
    m_temperatureUnit = unit;
    m_unit->setText(temperatureUnitSymbol(unit));
    refresh();
}

void StatusLine::showLanguage(const QString& code) {
    m_language->setText(Language::ownName(code));
}

void StatusLine::retranslate() {
    m_ageLabel->setToolTip(
        tr("Age of the newest temperature readings; of a real rig, of each device's newest answer"));
    m_loopLabel->setToolTip(tr("Control steps a second, and how many began late"));
    for (QLabel* label : {m_sourceLabel, m_heatMark, m_heatLabel})
        label->setToolTip(
            tr("Newest temperature of the source, and whether it is heated, as the device has confirmed. "
               "UNKNOWN: it may be hot, whatever was ordered. Heats though off: it warms all the same."));
    m_trackingLabel->setToolTip(tr("How the camera follows the source: time from the light to the pose, two "
                                   "standard deviations of its place"));
    m_unit->setToolTip(tr("Temperature unit"));
    m_unit->setAccessibleName(tr("Temperature unit"));
    m_language->setToolTip(tr("Language"));
    m_language->setAccessibleName(tr("Language"));
    showMonitor();
    refresh();
}

void StatusLine::changeEvent(QEvent* event) {
    QStatusBar::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        clearMessage(); // it is in the language before
        retranslate();
    }
    if (event->type() == QEvent::PaletteChange) {
        showHeat();
        showMonitor();
    }
}

} // namespace bask
