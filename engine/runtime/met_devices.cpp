#include "engine/runtime/met_devices.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace bask {

MetDevices::MetDevices(std::string file) : m_file(std::move(file)) {
    if (m_file.empty())
        return;
    if (auto met = readDeviceMemory(m_file))
        m_memory = std::move(*met);
    else
        m_problem = met.error().message;
    m_programFile = (std::filesystem::absolute(m_file).parent_path() / "programs.json").string();
    if (auto kept = readProgramMemory(m_programFile))
        m_kept = std::move(*kept);
    else
        m_problem = kept.error().message;
    for (const auto& [hash, command] : m_kept)
        m_programs->add(hash);
}

void MetDevices::remember(const RealRig& rig, BackgroundThread& disk) {
    bool isNew = false;
    for (const auto& [key, device] : rig.met())
        isNew = m_memory.emplace(key, device).second || isNew;
    if (isNew)
        keep(disk);
}

void MetDevices::forget(RealRig& rig, DeviceRole role, BackgroundThread& disk) {
    rig.forget(role, m_memory);
    keep(disk);
}

void MetDevices::keep(BackgroundThread& disk) const {
    if (!m_file.empty())
        disk.post([memory = m_memory, file = m_file] { (void)writeDeviceMemory(memory, file); });
}

void MetDevices::confirm(const std::string& command, const std::string& hash, bool isKept,
                         BackgroundThread& disk) {
    m_programs->add(hash);
    if (!isKept || m_programFile.empty())
        return;
    m_kept[hash] = command;
    disk.post([memory = m_kept, file = m_programFile] { (void)writeProgramMemory(memory, file); });
}

TriedDevice DeviceTrial::state() {
    TriedDevice out;
    const auto states = m_rig.devices();
    if (states.empty())
        return out;
    out.state = states.front();
    const auto add = [&](const Reading& reading) {
        out.temperatures_K.push_back(reading.valid ? reading.value_K : std::nan(""));
    };
    if (out.state.role == DeviceRole::Robot) {
        if (const auto state = m_rig.robot().state())
            out.coordinates = state->coordinates;
    } else if (out.state.role == DeviceRole::Thermometer) {
        if (const auto readings = m_rig.thermometer().read())
            std::ranges::for_each(*readings, add);
    } else if (out.state.role == DeviceRole::ThermalCamera) {
        if (const auto frame = m_rig.thermalCamera()->newest())
            if (const auto range = pictureRange((*frame)->frame.picture))
                out.temperatures_K = {range->min_K, range->max_K};
    } else if (out.state.role == DeviceRole::HeatSource) {
        if (const auto reading = m_rig.heatSource().read())
            add(*reading);
    }
    return out;
}

} // namespace bask
