#pragma once
// The thermometer of a rig with a thermal camera: each object by the sensor on it, by the camera, or by both.

#include "engine/rig/camera_thermometer.h"

#include <memory>
#include <vector>

namespace bask {

/// Use it on the engine thread.
class ObjectThermometer final : public Thermometer {
public:
    /// `contact` has one channel for each object, or one for each object with a sensor on it; it must outlive
    /// this.
    ObjectThermometer(std::vector<ReadBy> readBy, double environment_K, Thermometer& contact,
                      std::unique_ptr<CameraThermometer> camera);

    int channels() const override { return static_cast<int>(m_readBy.size()); }
    void setPeriod(double period_s) override { m_contact.setPeriod(period_s); }
    /// Asks only what objects are read by. Sensors and camera fail apart: the readings of what does not
    /// answer are invalid. Error: nothing that an object is read by answers. While everything is cold, the
    /// mean of the sensors is the temperature of the room by which the camera is zeroed.
    Result<std::vector<Reading>> read() override;

    CameraThermometer& camera() { return *m_camera; }
    const CameraThermometer& camera() const { return *m_camera; }
    /// Return why the sensors or the camera did not answer the last time; the code is None if they did.
    const Message& contactProblem() const { return m_contactProblem; }
    const Message& cameraProblem() const { return m_cameraProblem; }

private:
    Result<std::vector<Reading>> readContact();

    std::vector<ReadBy> m_readBy;
    double m_environment_K; ///< as the experiment states it
    Thermometer& m_contact;
    std::unique_ptr<CameraThermometer> m_camera;
    Message m_contactProblem, m_cameraProblem;
};

} // namespace bask
