#pragma once
// The paper's model-based controller: u = L+ (-D v - K dtau + 4 T Lambda v), so that dv/dt = -D v - K dtau.

#include "engine/control/controller.h"

namespace bask {

/// Knows lambda1, lambda2 of each object and what the air takes, if the experiment says; its slope joins
/// 4 Lambda T. Without limits the error follows a second-order response of natural
/// frequency sqrt(K) and damping D / (2 sqrt K). Source: paper, section IV-A.
class ModelBasedController final : public Controller {
public:
    ModelBasedController(const ControllerSettings& settings, ControlModel model);
    ControlOutput step(const Observation& observation, double dt_s) override;
    void setTargets(const std::vector<double>& targets_K) override { m_model.targets_K = targets_K; }
    void setGeometry(std::shared_ptr<const RigGeometry> geometry) override {
        m_model.geometry = std::move(geometry);
    }
    void setGains(const ControllerSettings& settings) override { m_settings = settings; }

private:
    ControllerSettings m_settings;
    ControlModel m_model;
};

} // namespace bask
