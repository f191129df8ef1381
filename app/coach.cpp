#include "app/coach.h"

#include "widgets/common/display.h"
#include "widgets/common/message_bar.h"

#include <algorithm>
#include <array>
#include <filesystem>

namespace bask {
namespace {

struct Place {
    Page page;
    const char* control;
};

constexpr std::array<Place, Coach::kSteps> kPlaces{{{Page::Objects, "harmonicsSlider"},
                                                    {Page::Objects, "editMenu"},
                                                    {Page::Targets, "target0"},
                                                    {Page::Targets, "useNearest"},
                                                    {Page::Run, "armButton"},
                                                    {Page::Run, "startButton"},
                                                    {Page::Run, "plot.measured_K"},
                                                    {Page::Run, "controllerPanel"},
                                                    {Page::Run, "toolsMenu"},
                                                    {Page::Run, "alarmButton"},
                                                    {Page::Run, "toolsMenu"},
                                                    {Page::Run, "holdButton"},
                                                    {Page::Run, "stopRunButton"},
                                                    {Page::Review, "sessionTree"},
                                                    {Page::Run, "fileMenu"},
                                                    {Page::Rig, "fileMenu"},
                                                    {Page::Rig, "card.robot"},
                                                    {Page::Rig, "setUp.thermometer"}}};

/// Where the example serial-rig has its ports.
const QString kPorts = QStringLiteral("/tmp/bask-");

/// Of a run that is on; the last one ends it.
bool isInRun(Coach::Step step) {
    return step >= Coach::Step::Note && step <= Coach::Step::Resume;
}

/// One of the example's, if a pseudo-terminal is there or nothing: anybody can put a link to a true port into
/// /tmp.
bool isPlayedPort(const std::filesystem::path& port) {
    constexpr const char* kPseudoTerminals = "/dev/pts";
    if (!QString::fromStdString(port).startsWith(kPorts))
        return false;
    std::error_code failed;
    if (!std::filesystem::is_symlink(port, failed))
        return !std::filesystem::exists(port, failed);
    const auto target = std::filesystem::canonical(port, failed);
    return (failed ? std::filesystem::read_symlink(port, failed) : target).parent_path() == kPseudoTerminals;
}

/// Its devices are those of `bask simulate-rig`.
bool isPlayed(const Snapshot& snapshot) {
    return !snapshot.devices.empty() &&
           std::ranges::all_of(snapshot.devices,
                               [](const RigDeviceState& device) { return isPlayedPort(device.port); });
}

bool isLive(const Snapshot& snapshot, DeviceRole role) {
    const auto device = std::ranges::find(snapshot.devices, role, &RigDeviceState::role);
    return device != snapshot.devices.end() && device->status.link == LinkState::Live;
}

} // namespace

Coach::Coach(MessageBar& bar, QObject* parent) : QObject(parent), m_bar(bar) {
    connect(&m_bar, &MessageBar::actionClicked, this, &Coach::act);
    connect(&m_bar, &MessageBar::otherClicked, this, &Coach::skip);
    connect(&m_bar, &MessageBar::closed, this, &Coach::end);
}

void Coach::offer() {
    m_isOffer = true;
    say();
}

void Coach::begin() {
    m_isOffer = false;
    m_hasRun = false;
    m_step = Step::Harmonics;
    say();
}

void Coach::end() {
    m_isOffer = false;
    m_step.reset();
    m_bar.clear();
    emit answered();
}

void Coach::act() {
    if (m_isOffer) {
        emit answered();
        begin();
    }
    if (m_step) {
        Place place = kPlaces[static_cast<std::size_t>(*m_step)];
        if (isRunOver())
            place = {Page::Run, m_isFaultOn                  ? "toolsMenu"
                                : m_state == RunState::Fault ? "resetButton"
                                : m_state == RunState::Armed ? "startButton"
                                                             : "armButton"};
        emit showWanted(place.page, QLatin1String(place.control));
    }
}

void Coach::skip() {
    if (m_isOffer)
        end();
    else if (m_step)
        done(*m_step);
}

void Coach::done(Step step) {
    if (m_step != step)
        return;
    if (step == Step::Find) {
        m_step.reset();
        m_bar.say(
            MessageBar::Kind::Note,
            tr("That was all. “Simulated rig” on the Rig page leads back to the simulated one; F1 opens "
               "the manual, which has the rest."));
        return;
    }
    m_step = static_cast<Step>(static_cast<int>(step) + 1);
    say();
}

void Coach::see(const EditStep& edit) {
    if (edit.edit.kind == EditKind::Outline)
        done(Step::Harmonics);
    else if (edit.edit.kind == EditKind::Controller)
        done(Step::Gain);
}

void Coach::seeUndone(const EditStep& edit) {
    if (edit.edit.kind == EditKind::Outline)
        done(Step::Undo);
}

void Coach::seeVerdict(bool isFeasible) {
    done(isFeasible ? Step::Feasible : Step::TooHot);
}

void Coach::see(const Snapshot& snapshot) {
    const QString before = m_step ? words() : QString();
    const RunState state = m_state = snapshot.state;
    m_hasRun = m_hasRun || isRunOn(state);
    m_isFaultOn = std::ranges::any_of(snapshot.alarms, &Alarm::isActive);
    const bool isHarmless = snapshot.simulated || isPlayed(snapshot);
    if (m_isHarmless != isHarmless) {
        m_isHarmless = isHarmless;
        if (!m_isHarmless && (m_step || m_isOffer))
            end();
    }
    if (state == RunState::Armed || isRunOn(state))
        done(Step::Arm);
    if (isRunOn(state))
        done(Step::Start);
    if (!snapshot.newNotes.empty())
        done(Step::Note);
    if (state == RunState::Holding && !snapshot.alarms.empty())
        done(Step::Fault);
    if (std::ranges::all_of(snapshot.alarms, &Alarm::isAcknowledged))
        done(Step::Acknowledge);
    if (snapshot.faults.empty())
        done(Step::Restore);
    if (state == RunState::Running || state == RunState::Settled)
        done(Step::Resume);
    if (m_hasRun && !isRunOn(state))
        done(Step::Stop);
    seeDevices(snapshot);
    if (m_step && words() != before)
        say();
}

void Coach::seeDevices(const Snapshot& snapshot) {
    const bool isThermometerLive = isLive(snapshot, DeviceRole::Thermometer);
    if (!snapshot.simulated && !snapshot.devices.empty())
        done(Step::SerialRig);
    if (isThermometerLive && isLive(snapshot, DeviceRole::Robot) && isLive(snapshot, DeviceRole::HeatSource))
        done(Step::Connect);
    m_hasFound = m_step == Step::Find && (m_hasFound || (snapshot.search && !snapshot.search->found.empty()));
    if (m_hasFound && isThermometerLive)
        done(Step::Find);
}

/// It ended by itself before the steps in it were done: a hold that lasts does.
bool Coach::isRunOver() const {
    return m_step && isInRun(*m_step) && m_hasRun && !isRunOn(m_state);
}

void Coach::seeReview() {
    done(Step::Review);
}

void Coach::seeThermalPicture() {
    done(Step::Thermal);
}

void Coach::setTemperatureUnit(TemperatureUnit unit) {
    m_unit = unit;
    retranslate();
}

void Coach::retranslate() {
    if (m_isOffer || m_step)
        say();
}

void Coach::say() {
    if (m_isOffer)
        return m_bar.ask(
            //: how many
            tr("New here? %1 small steps on simulated rigs show what Bask does. Nothing can burn.")
                .arg(kSteps),
            tr("Show me"), tr("Not now"));
    //: number of the step, of so many, what to do
    m_bar.ask(tr("%1 of %2: %3").arg(static_cast<int>(*m_step) + 1).arg(kSteps).arg(words()),
              tr("Show where"), tr("Skip"));
}

QString Coach::words() const {
    const auto typed = [this](double t_degC) {
        return formatTemperature(kelvinFromCelsius(t_degC), m_unit, 0);
    };
    if (isRunOver())
        return m_state == RunState::Fault
                   ? tr("The run has ended in a fault, as a hold that lasts does. End it in Tools > Simulate "
                        "fault, press Reset, then Arm (F5) and Start (F6) again.")
               : m_isFaultOn
                   ? tr("The run has ended. End the fault in Tools > Simulate fault, then Arm (F5) and Start "
                        "(F6) again.")
                   : tr("The run has ended. Arm (F5) and Start (F6) again.");
    switch (*m_step) {
    case Step::Harmonics:
        return tr("On the Objects page, select “bunny” and drag Harmonics. With fewer of them its outline "
                  "leaves the drawing's.");
    case Step::Undo:
        return tr("Take that back with Ctrl+Z. Every edit can be undone.");
    case Step::TooHot:
        return tr("On the Targets page, type %1 for one object and read why it cannot be held.")
            .arg(typed(200.0));
    case Step::Feasible:
        return tr("Press “Use nearest feasible”: targets that can be held together.");
    case Step::Arm:
        return tr("Type %1 there again, which is reached sooner. Then Arm (F5): the sensors are zeroed and "
                  "the recording is opened. Nothing moves yet.")
            .arg(typed(40.0));
    case Step::Start:
        return tr("Start (F6): the heat is on, and the robot moves.");
    case Step::Note:
        return tr("The temperatures go to their targets. Press N on the Run page and note something.");
    case Step::Gain:
        return tr("Change a gain at the controller and apply it: the traces are marked there.");
    case Step::Fault:
        //: a simulated fault, as the menu has it
        return tr("Tools > Simulate fault > %1: choose an object. The run holds, and an alarm says what to "
                  "do.")
            .arg(simulatedFaultWord(SimulatedFault::SensorLost));
    case Step::Acknowledge:
        return tr("Acknowledge the alarm (F9): you have seen it.");
    case Step::Restore:
        return tr(
            "Remove its cause: choose the fault again in the same menu, which ends it. The sensor tells "
            "its temperature again.");
    case Step::Resume:
        return tr("Resume (Shift+F7): the run goes on where it was held.");
    case Step::Stop:
        return tr("Stop (F8): heat off, the robot retreats, the recording is closed.");
    case Step::Review:
        return tr("On the Review page, open the recording of this run.");
    case Step::Thermal:
        return tr(
            "File > Examples > thermal-camera: three objects that only a thermal camera reads. On the Run "
            "page, look at the tab Thermal picture.");
    case Step::SerialRig:
        return tr(
            "File > Examples > serial-rig: a rig with devices of its own, as a real one has. They are at "
            "serial ports, where nothing answers yet.");
    case Step::Connect:
        return tr(
            "Type “bask simulate-rig” in a terminal: it plays robot, thermometer and heat source at these "
            "ports. On the Rig page all three become live.");
    case Step::Find:
        //: the path of a serial port
        return tr("Find a device: “Remove” the thermometer, then “Set up…” with port %1. “Find devices” "
                  "lists what answers there; choose it and press “Use”.")
            .arg(kPorts + QStringLiteral("thermometer"));
    }
    return {};
}

} // namespace bask
