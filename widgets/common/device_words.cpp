#include "widgets/common/device_words.h"

#include "engine/base/message_code.h"
#include "widgets/common/display.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>
#include <limits>

namespace bask {
namespace {

struct DeviceWords {
    Q_DECLARE_TR_FUNCTIONS(bask::Device)
};

constexpr double kLongestAge_s = 1e6; ///< more stands for never

} // namespace

const char* roleName(DeviceRole role) {
    constexpr std::array names{"robot", "thermometer", "source", "camera", "thermalCamera"};
    static_assert(names.size() == kDeviceRoles.size());
    return names.at(static_cast<std::size_t>(role));
}

QString roleWord(DeviceRole role) {
    switch (role) {
    case DeviceRole::Robot:
        return DeviceWords::tr("Robot");
    case DeviceRole::Thermometer:
        return DeviceWords::tr("Thermometer");
    case DeviceRole::HeatSource:
        return DeviceWords::tr("Heat source");
    case DeviceRole::Camera:
        return DeviceWords::tr("Camera");
    case DeviceRole::ThermalCamera:
        return DeviceWords::tr("Thermal camera");
    }
    return {};
}

QString linkWord(LinkState state) {
    switch (state) {
    case LinkState::Closed:
        return DeviceWords::tr("Closed");
    case LinkState::Opening:
        return DeviceWords::tr("Opening");
    case LinkState::Live:
        return DeviceWords::tr("Live");
    case LinkState::Lost:
        return DeviceWords::tr("Lost");
    }
    return {};
}

QString driverWord(const DriverFacts& driver) {
    return QCoreApplication::translate("bask::Device", driver.name);
}

bool hasDevice(const RigSpec& rig, DeviceRole role) {
    switch (role) {
    case DeviceRole::Robot:
        return rig.robot.has_value();
    case DeviceRole::Thermometer:
        return rig.thermometer.has_value();
    case DeviceRole::HeatSource:
        return rig.source.has_value();
    case DeviceRole::Camera:
        return !rig.camera.empty();
    case DeviceRole::ThermalCamera:
        return rig.thermalCamera.has_value();
    }
    return false;
}

QString driverText(const RigSpec& rig, DeviceRole role) {
    if (!hasDevice(rig, role))
        return {};
    const auto withTitle = [](const auto& spec) {
        const DriverFacts& driver = driverOf(spec);
        return driver.isModbus && !spec.profile.title.empty() ? QString::fromStdString(spec.profile.title)
                                                              : driverWord(driver);
    };
    switch (role) {
    case DeviceRole::Robot:
        return driverWord(driverOf(*rig.robot));
    case DeviceRole::Thermometer:
        return withTitle(*rig.thermometer);
    case DeviceRole::HeatSource:
        return withTitle(*rig.source);
    case DeviceRole::Camera:
        return DeviceWords::tr("Pictures");
    case DeviceRole::ThermalCamera:
        return QString::fromStdString(rig.thermalCamera->profile.title);
    }
    return {};
}

QString portText(const RigSpec& rig, DeviceRole role) {
    if (!hasDevice(rig, role))
        return {};
    switch (role) {
    case DeviceRole::Robot:
        return QString::fromStdString(rig.robot->port);
    case DeviceRole::Thermometer:
        return QString::fromStdString(rig.thermometer->port);
    case DeviceRole::HeatSource:
        return isManualSource(*rig.source) ? QString() : QString::fromStdString(rig.source->port);
    case DeviceRole::Camera:
        return QString::fromStdString(rig.camera);
    case DeviceRole::ThermalCamera:
        return QString::fromStdString(rig.thermalCamera->device);
    }
    return {};
}

RigSpec withDevice(RigSpec rig, DeviceRole role, const RigSpec& other) {
    switch (role) {
    case DeviceRole::Robot:
        rig.robot = other.robot;
        break;
    case DeviceRole::Thermometer:
        rig.thermometer = other.thermometer;
        break;
    case DeviceRole::HeatSource:
        rig.source = other.source;
        break;
    case DeviceRole::Camera:
        rig.camera = other.camera;
        break;
    case DeviceRole::ThermalCamera:
        rig.thermalCamera = other.thermalCamera;
        break;
    }
    return rig;
}

RigSpec withoutDevice(RigSpec rig, DeviceRole role) {
    return withDevice(std::move(rig), role, RigSpec());
}

bool isAboutPlace(MessageCode code) {
    return code == MessageCode::RobotPlaceUnsure || code == MessageCode::RobotRestarted ||
           code == MessageCode::RobotElsewhere;
}

bool allowsHome(const Snapshot& snapshot) {
    const RunState state = snapshot.state;
    const bool isAtRest = state == RunState::NotReady || state == RunState::Ready ||
                          state == RunState::Stopped || state == RunState::Fault;
    return isAtRest && snapshot.place != PlaceState::Unknown;
}

QString placeSureAgainText(const Snapshot& snapshot) {
    if (snapshot.place != PlaceState::Sure || snapshot.robotAlarm.code != MessageCode::None)
        return {};
    return snapshot.remedy.code == MessageCode::RemedyReset
               ? DeviceWords::tr("The robot's place was not sure. It is sure again: press Reset.")
               : DeviceWords::tr("The robot's place was not sure. It is sure again.");
}

double sourceTemperature_K(const Snapshot& snapshot) {
    return snapshot.source_K.value_or(std::numeric_limits<double>::quiet_NaN());
}

QString sourceReadingText(const Snapshot& snapshot, TemperatureUnit unit) {
    if (snapshot.source_K || !std::isfinite(snapshot.sourceAge_s))
        return formatTemperature(sourceTemperature_K(snapshot), unit);
    return DeviceWords::tr("%1, %2", "a temperature and how old it is")
        .arg(formatTemperature(snapshot.latest.source_K, unit), formatAge(snapshot.sourceAge_s));
}

ShownHeat shownHeat(const Snapshot& snapshot, bool isAnswering) {
    if (snapshot.isSourceManual)
        return ShownHeat::ByHand;
    if (!isAnswering || snapshot.heat == HeatState::Unknown)
        return ShownHeat::Unknown;
    if (snapshot.heat == HeatState::On)
        return ShownHeat::On;
    const bool isCooling = snapshot.unaskedFall && snapshot.unaskedFall->fallen_K >= UnaskedFall::kCools_K;
    const bool isUnasked = !isCooling && isActive(snapshot.alarms, MessageCode::SafetySourceHeatsUnasked);
    return isUnasked ? ShownHeat::Unasked : ShownHeat::Off;
}

QString heatWord(ShownHeat heat) {
    switch (heat) {
    case ShownHeat::Off:
        return DeviceWords::tr("heat off");
    case ShownHeat::On:
        return DeviceWords::tr("heat on");
    case ShownHeat::Unasked:
        return DeviceWords::tr("heats though off");
    case ShownHeat::ByHand:
        return DeviceWords::tr("heated by hand");
    case ShownHeat::Unknown:
        break;
    }
    return DeviceWords::tr("heat UNKNOWN");
}

int heatPriority(ShownHeat heat) {
    return heat == ShownHeat::Unasked ? alarmPriority(MessageCode::SafetySourceHeatsUnasked) : 0;
}

QString rigWord(bool isSimulated) {
    return isSimulated ? DeviceWords::tr("SIMULATED") : DeviceWords::tr("LIVE");
}

QString ageText(double age_s) {
    if (!(age_s < kLongestAge_s))
        return {};
    if (age_s < 0.9995)
        return DeviceWords::tr("%1 ms").arg(std::max(0.0, 1000.0 * age_s), 0, 'f', 0);
    return age_s < 99.95 ? DeviceWords::tr("%1 s").arg(QLocale().toString(age_s, 'f', 1))
                         : formatDuration(age_s);
}

std::vector<std::string> withSensors(const std::vector<ObjectSpec>& objects) {
    std::vector<std::string> out;
    for (const ObjectSpec& object : objects)
        if (object.readBy != ReadBy::Camera)
            out.push_back(object.name);
    return out;
}

void keepChannels(const std::vector<ObjectSpec>& before, const std::vector<ObjectSpec>& after,
                  std::vector<int>& channels) {
    const std::vector<std::string> old = withSensors(before), now = withSensors(after);
    if (old.size() == now.size() || channels.size() != old.size())
        return;
    constexpr int kNew = -1;
    std::vector<int> kept(now.size(), kNew);
    for (std::size_t i = 0; i < now.size(); ++i) {
        const auto it = std::ranges::find(old, now[i]);
        if (it != old.end())
            kept[i] = channels[static_cast<std::size_t>(it - old.begin())];
    }
    int free = 0;
    for (int& channel : kept)
        if (channel == kNew) {
            while (std::ranges::find(kept, free) != kept.end())
                ++free;
            channel = free;
        }
    channels = std::move(kept);
}

std::vector<int> channelsFor(std::vector<int> channels, std::size_t sensors) {
    if (channels.size() > sensors)
        channels.resize(sensors);
    for (int free = 0; channels.size() < sensors; ++free)
        if (std::ranges::find(channels, free) == channels.end())
            channels.push_back(free);
    return channels;
}

} // namespace bask
