#pragma once
// Stands for a device that a rig does not have: every call returns that it is missing.

#include "engine/base/message_code.h"
#include "engine/devices/heat_source.h"
#include "engine/devices/robot.h"
#include "engine/devices/thermometer.h"

namespace bask {

class MissingRobot final : public Robot {
public:
    Result<RobotState> state() override { return absence(); }
    Result<void> setTwist(const Vector6d&, double) override { return absence(); }
    Result<void> halt() override { return absence(); }
    Result<void> home() override { return absence(); }
    Result<void> clearAlarm() override { return absence(); }

private:
    static Error absence() { return {MessageCode::RigIncomplete, {}, {"robot"}}; }
};

class MissingThermometer final : public Thermometer {
public:
    explicit MissingThermometer(const char* name) : m_name(name) {}
    int channels() const override { return 0; }
    Result<std::vector<Reading>> read() override { return Error(MessageCode::RigIncomplete, {}, {m_name}); }

private:
    const char* m_name;
};

class MissingHeatSource final : public HeatSource {
public:
    Result<Reading> read() override { return absence(); }
    Result<void> keepHeating(double, double) override { return absence(); }
    Result<void> heatOff() override { return absence(); }
    bool heating() const override { return false; }
    HeatState heatState() const override { return HeatState::Unknown; }

private:
    static Error absence() { return {MessageCode::RigIncomplete, {}, {"heat source"}}; }
};

} // namespace bask
