#pragma once
// Identifies the heat rates of every object of a recorded run.

#include "engine/base/share_done.h"
#include "engine/control/rig_geometry.h"
#include "engine/recording/session_file.h"
#include "engine/thermal/identification.h"

#include <memory>
#include <optional>
#include <vector>

namespace bask {

/// The terms that are fitted in addition to lambda1 and lambda2.
struct SessionIdentification {
    bool freeAmbient = false; ///< fit lambda3; otherwise it follows from lambda2 and the room's temperature
    bool convection = false;
};

/// The data of a run for the fits, collected sample by sample until Stop, because the heat is off afterwards
/// at any source temperature. Between two samples the robot moves on a straight line, along which the view
/// factor does not: its mean is by Simpson's rule, with the view factor half way. Of a run with more than
/// kMax samples it uses every second one, of a longer run every fourth, and so on.
class HeatRecords {
public:
    static constexpr std::size_t kMax = 1 << 17; // 3.6 h at 10 Hz

    explicit HeatRecords(const SessionRecord& facts);
    void add(const TraceSample& sample);
    /// Number of samples kept.
    std::size_t size() const { return m_records.empty() ? 0 : m_records.front().size(); }

    /// Returns the rates in the experiment's order, with lambda1 at the source's set temperature. The room's
    /// temperature is that of the sensors' zeroing, if it was recorded.
    std::vector<IdentifiedRates> identify(const SessionIdentification& wanted = {},
                                          const ShareDone& done = {}) const;

private:
    double power_W_m2(double T1_K) const;
    /// Adds the integrals of the view factors from the sample before, which ended at `before`.
    void integrate(const TraceSample& before, const TraceSample& sample);
    Eigen::VectorXd neighbourGains_K4(const TraceSample& sample) const;
    void thin();

    double m_until_s;
    SourceSpec m_source;
    IdentificationOptions m_options;
    std::shared_ptr<const RigGeometry> m_geometry;
    std::vector<double> m_environmentShares;        ///< one for each object
    std::vector<AirLoss> m_airPerLambda2;           ///< one for each object
    std::optional<TraceSample> m_before;            ///< the last sample, kept or not
    std::vector<double> m_since_s;                  ///< of each object, int F dt since the last one kept
    std::vector<std::vector<HeatSample>> m_records; ///< one for each object
    std::size_t m_every = 1, m_seen = 0;
};

} // namespace bask
