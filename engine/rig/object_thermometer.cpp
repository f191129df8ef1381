#include "engine/rig/object_thermometer.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bask {
namespace {

constexpr double kRoomWithin_K = 5.0; // of the experiment's environment, as zeroing allows

} // namespace

ObjectThermometer::ObjectThermometer(std::vector<ReadBy> readBy, double environment_K, Thermometer& contact,
                                     std::unique_ptr<CameraThermometer> camera)
    : m_readBy(std::move(readBy)), m_environment_K(environment_K), m_contact(contact),
      m_camera(std::move(camera)) {}

/// One reading for each object, invalid where it has no sensor.
Result<std::vector<Reading>> ObjectThermometer::readContact() {
    const auto read = m_contact.read();
    if (!read)
        return read.error();
    const bool isOneEach = read->size() == m_readBy.size();
    std::vector<Reading> out(m_readBy.size());
    double sum_K = 0.0;
    int valid = 0;
    for (std::size_t i = 0, channel = 0; i < m_readBy.size(); ++i) {
        if (m_readBy[i] == ReadBy::Camera)
            continue;
        out[i] = read->at(isOneEach ? i : channel);
        ++channel;
        if (out[i].valid) {
            sum_K += out[i].value_K;
            ++valid;
        }
    }
    if (valid > 0 && m_camera->isCold())
        if (const double mean_K = sum_K / valid; std::abs(mean_K - m_environment_K) < kRoomWithin_K)
            m_camera->setRoom(mean_K);
    return out;
}

Result<std::vector<Reading>> ObjectThermometer::read() {
    const auto isBy = [this](ReadBy readBy) { return std::ranges::find(m_readBy, readBy) != m_readBy.end(); };
    const bool hasContact = isBy(ReadBy::Contact) || isBy(ReadBy::Both);
    const bool hasCamera = isBy(ReadBy::Camera);
    const auto byContact = hasContact ? readContact() : Result<std::vector<Reading>>(std::vector<Reading>());
    if (byContact && hasContact)
        m_camera->setSensors(*byContact);
    else
        m_camera->setSensors({});
    const auto byCamera = m_camera->read();
    m_contactProblem = byContact ? Message{} : byContact.error().message;
    m_cameraProblem = byCamera ? Message{} : byCamera.error().message;
    if (!byContact && !(hasCamera && byCamera))
        return byContact.error();
    if (!byCamera && hasCamera && !hasContact)
        return byCamera.error();
    std::vector<Reading> out(m_readBy.size());
    for (std::size_t i = 0; i < m_readBy.size(); ++i) {
        const bool isContact = m_readBy[i] != ReadBy::Camera;
        if (isContact && byContact)
            out[i] = (*byContact)[i];
        else if (!isContact && byCamera)
            out[i] = (*byCamera)[i];
        else if (!isContact)
            out[i].reason = m_cameraProblem;
    }
    return out;
}

} // namespace bask
