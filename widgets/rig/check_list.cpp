#include "widgets/rig/check_list.h"

#include "engine/base/message_code.h"
#include "widgets/common/alarm_groups.h"
#include "widgets/common/device_words.h"
#include "widgets/common/display.h"
#include "widgets/common/labels.h"
#include "widgets/common/run_state_chip.h"
#include "widgets/common/source_words.h"
#include "widgets/common/theme.h"
#include "widgets/rig/check_mark.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

constexpr int kRowMark = 14;
constexpr double kFreshPeriods = 3.0;

} // namespace

CheckList::CheckList(QWidget* parent) : QWidget(parent), m_title(boldLabel(this)), m_grid(new QGridLayout) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    layout->addWidget(m_title);
    layout->addLayout(m_grid);
    m_grid->setColumnStretch(1, 1);
    m_grid->setVerticalSpacing(4);
    m_devices = addLine("check.devices");
    m_place = addLine("check.place");
    m_sensors = addLine("check.sensors");
    m_source = addLine("check.source");
    m_recording = addLine("check.recording");
    refresh();
}

CheckList::Line CheckList::addLine(const QString& name) {
    Line line{new QLabel(this), new QLabel(this)};
    line.mark->setFixedSize(kRowMark, kRowMark + 2);
    line.text->setObjectName(name);
    line.text->setWordWrap(true);
    line.text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    const int row = m_grid->rowCount();
    m_grid->addWidget(line.mark, row, 0, Qt::AlignTop);
    m_grid->addWidget(line.text, row, 1);
    return line;
}

void CheckList::put(Line& line, Kind kind, const QString& text, int priority) {
    if (line.text->text() != text)
        line.text->setText(text);
    line.mark->show();
    line.text->show();
    if (line.shown == static_cast<int>(kind) && line.priority == priority)
        return;
    line.shown = static_cast<int>(kind);
    line.priority = priority;
    const bool dark = isDark(this);
    const double ratio = devicePixelRatioF();
    const CheckMark mark = kind == Kind::Done    ? CheckMark::Tick
                           : kind == Kind::Wrong ? CheckMark::Cross
                                                 : CheckMark::Waiting;
    line.mark->setPixmap(kind == Kind::Reason    ? alarmPixmap(priority, dark, kRowMark, ratio)
                         : kind == Kind::Unknown ? unknownPixmap(dark, kRowMark, ratio)
                                                 : checkMarkPixmap(mark, dark, kRowMark, ratio));
    const QString word = kind == Kind::Done      ? tr("done")
                         : kind == Kind::Wrong   ? tr("wrong")
                         : kind == Kind::Unknown ? tr("not known")
                                                 : tr("not yet");
    line.text->setAccessibleDescription(word);
}

void CheckList::setExperiment(const Experiment& experiment) {
    m_period_s = experiment.sampling.period_s;
    m_hasSensors = contactSensors(experiment.objects) > 0;
    m_isReadByCamera = readsByCamera(experiment);
    m_setPoint_K = sourceSetPoint_K(experiment.source, 0.0);
    m_rig = experiment.rig;
    refresh();
}

void CheckList::apply(const Snapshot& snapshot) {
    m_last = snapshot;
    m_last.newSamples.clear();
    refresh();
}

void CheckList::setTemperatureUnit(TemperatureUnit unit) {
    m_unit = unit;
    refresh();
}

void CheckList::refresh() {
    m_title->setText(tr("Before a run"));
    showDevices();
    showPlace();
    showSensors();
    showSource();
    showRecording();
    while (m_reasons.size() < m_last.reasons.size())
        m_reasons.push_back(addLine(QStringLiteral("reason.%1").arg(m_reasons.size())));
    const QString sureAgain = placeSureAgainText(m_last);
    for (std::size_t i = 0; i < m_reasons.size(); ++i) {
        if (i < m_last.reasons.size()) {
            const Message& reason = m_last.reasons[i];
            const bool isOver = !sureAgain.isEmpty() && isAboutPlace(reason.code);
            put(m_reasons[i], Kind::Reason, isOver ? sureAgain : sentenceText(reason, m_unit),
                statePriority(RunState::NotReady, reasonPriority(reason, m_last.alarms)));
        } else {
            m_reasons[i].mark->hide();
            m_reasons[i].text->hide();
            m_reasons[i].text->clear(); // it would stay in the language of its day
            m_reasons[i].text->setAccessibleDescription({});
            m_reasons[i].shown = -1;
        }
    }
}

bool CheckList::isDeviceNeeded(DeviceRole role) const {
    if (role == DeviceRole::Thermometer)
        return m_hasSensors;
    if (role == DeviceRole::ThermalCamera)
        return m_isReadByCamera;
    return role != DeviceRole::Camera;
}

void CheckList::showDevices() {
    if (!m_rig)
        return put(m_devices, Kind::Done, tr("Devices: simulated"));
    QStringList missing, silent;
    for (const DeviceRole role : kDeviceRoles) {
        const bool isNeeded = isDeviceNeeded(role);
        if (!hasDevice(*m_rig, role)) {
            if (isNeeded)
                missing << roleWord(role);
            continue;
        }
        if (role == DeviceRole::Camera)
            continue; // its pictures tell on the Calibrate page
        const auto it = std::ranges::find(m_last.devices, role, &RigDeviceState::role);
        if (it == m_last.devices.end() || it->status.link != LinkState::Live)
            silent << roleWord(role);
    }
    if (!missing.isEmpty())
        return put(m_devices, Kind::Wrong, tr("Devices: none set up as %1").arg(missing.join(", ")));
    if (!silent.isEmpty())
        return put(m_devices, Kind::Wrong, tr("Devices: no answer from %1").arg(silent.join(", ")));
    put(m_devices, Kind::Done, tr("Devices: all answer"));
}

void CheckList::showPlace() {
    if (m_last.robotAlarm.code != MessageCode::None)
        return put(m_place, Kind::Wrong, tr("Robot: in alarm"));
    if (m_last.place == PlaceState::Unknown)
        return put(
            m_place, Kind::Unknown,
            tr("Robot: its place is UNKNOWN, what it told last is %1").arg(formatAge(m_last.placeAge_s)));
    if (m_last.place == PlaceState::Unsure)
        return put(m_place, Kind::Wrong, tr("Robot: its place is not sure"));
    put(m_place, Kind::Done, tr("Robot: its place is sure"));
}

void CheckList::showSensors() {
    const auto& objects = m_last.latest.objects;
    if (objects.empty())
        return put(m_sensors, Kind::Waiting, tr("Sensors: no readings yet"));
    const QString age = ageText(m_last.sampleAge_s);
    if (!(m_last.sampleAge_s <= kFreshPeriods * m_period_s))
        return put(m_sensors, Kind::Wrong, tr("Sensors: the newest readings are %1 old").arg(age));
    int bad = 0;
    for (std::size_t i = 0; i < objects.size(); ++i)
        if (!objects[i].valid && !(i < m_last.sensors.size() && m_last.sensors[i] == SensorTrust::Distrusted))
            ++bad;
    if (bad > 0)
        return put(m_sensors, Kind::Wrong,
                   tr("Sensors: %1 of %2 without a valid reading").arg(bad).arg(objects.size()));
    if (const auto doubted = std::ranges::count(m_last.sensors, SensorTrust::Distrusted); doubted > 0)
        return put(m_sensors, Kind::Unknown,
                   tr("Sensors: %1 of %2 not believed").arg(doubted).arg(m_last.sensors.size()));
    if (const auto stale = std::ranges::count(m_last.sensors, SensorTrust::Stale); stale > 0)
        return put(m_sensors, Kind::Unknown,
                   tr("Sensors: %1 of %2 stale").arg(stale).arg(m_last.sensors.size()));
    put(m_sensors, Kind::Done, tr("Sensors: fresh and valid"));
}

void CheckList::showSource() {
    const double wanted_K = m_last.heatSetPoint_K.value_or(m_setPoint_K);
    const double now_K = sourceTemperature_K(m_last);
    const ShownHeat heat = shownHeat(m_last);
    if (heat == ShownHeat::Unknown)
        return put(m_source, Kind::Unknown,
                   tr("Source: UNKNOWN whether it heats, %1").arg(sourceReadingText(m_last, m_unit)));
    if (heat == ShownHeat::Unasked)
        return put(m_source, Kind::Wrong,
                   tr("Source: it heats though its heat is off, %1").arg(sourceReadingText(m_last, m_unit)));
    if (!std::isfinite(now_K))
        return put(m_source, Kind::Waiting, tr("Source: no temperature"));
    const QString now = formatTemperature(now_K, m_unit), wanted = formatTemperature(wanted_K, m_unit);
    if (std::abs(now_K - wanted_K) <= SourceWarmUp::kWarm_K)
        return put(m_source, Kind::Done, tr("Source: warm, %1").arg(now));
    if (now_K > wanted_K)
        return put(m_source, Kind::Waiting, tr("Source: %1, above %2").arg(now, wanted));
    const bool hasTime = m_last.warmUp && m_last.warmUp->setPoint_K == wanted_K;
    //: the last is a sentence about the time that it takes
    put(m_source, Kind::Waiting,
        hasTime ? tr("Source: %1, not at %2 yet. %3").arg(now, wanted, warmUpText(*m_last.warmUp))
                : tr("Source: %1, not at %2 yet").arg(now, wanted));
}

void CheckList::showRecording() {
    const bool hasFailed = std::ranges::any_of(m_last.reasons, [](const Message& reason) {
        return reason.code == MessageCode::ReasonRecorderFailed || reason.code == MessageCode::SafetyDiskLow;
    });
    put(m_recording, hasFailed ? Kind::Wrong : Kind::Done,
        hasFailed                      ? tr("Recording: not possible")
        : m_last.recordingPath.empty() ? tr("Recording: begins with Arm")
                                       : tr("Recording: on"));
}

void CheckList::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() != QEvent::LanguageChange && event->type() != QEvent::PaletteChange)
        return;
    for (Line* line : {&m_devices, &m_place, &m_sensors, &m_source, &m_recording})
        line->shown = -1;
    for (Line& line : m_reasons)
        line.shown = -1;
    refresh();
}

} // namespace bask
