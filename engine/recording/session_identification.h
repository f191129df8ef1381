#pragma once
// Heat rates of every object of a recorded run.

#include "engine/recording/session_file.h"
#include "engine/thermal/identification.h"

#include <vector>

namespace bask {

/// Which terms are fitted besides lambda1 and lambda2.
struct SessionIdentification {
    bool freeAmbient = false; ///< lambda3, otherwise tied to lambda2 by the room's temperature
    bool convection = false;
};

/// What the fits need of a run, gathered sample by sample until Stop, since the heat is off afterwards
/// whatever the source's temperature. Of a run of more than kMax samples it keeps every second one, of a
/// longer one every fourth, and so on: the fits rest on windows of a sixteenth of the run.
class HeatRecords {
public:
    static constexpr std::size_t kMax = 1 << 17; // 3.6 h at 10 Hz

    explicit HeatRecords(const SessionRecord& facts);
    void add(const TraceSample& sample);
    std::size_t size() const { return m_records.empty() ? 0 : m_records.front().size(); } ///< kept

    /// Rates in the experiment's order, lambda1 at the source's set temperature; the room's temperature is
    /// that of the sensors' zeroing, where it was recorded.
    std::vector<IdentifiedRates> identify(const SessionIdentification& wanted = {}) const;

private:
    double power_W_m2(double T1_K) const;
    void thin();

    double m_until_s;
    SourceSpec m_source;
    IdentificationOptions m_options;
    std::vector<double> m_absorptanceOverEmittance; ///< an object
    std::vector<std::vector<HeatSample>> m_records; ///< an object
    std::size_t m_every = 1, m_seen = 0;
};

} // namespace bask
