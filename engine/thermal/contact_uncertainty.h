#pragma once
// How well a sensor on an object tells its temperature, by what is known of it: its zeroing, the step of its
// readings and their noise.

#include <cstddef>
#include <deque>
#include <optional>
#include <span>

namespace bask {

/// Step and noise of a sensor, learned from its readings as they come.
class ReadingScatter {
public:
    /// Takes the next reading, K; one that is not finite is a gap.
    void add(double T_K);
    /// Call where readings are missing: those before and after it do not follow each other. The step stays.
    void gap() { m_newest_K.clear(); }
    /// Returns the smallest change between two readings in a row, K: the resolution of one that shows steps,
    /// and next to nothing of one that does not. 0 until the readings have changed.
    double step_K() const { return m_step_K; }
    /// Returns the standard deviation of a single reading, K, by the second differences of the newest ones,
    /// which a ramp does not have; empty with fewer than kMin of them. 0 of readings that rest within a step.
    std::optional<double> deviation_K() const;

    static constexpr std::size_t kMin = 8, kNewest = 60;

private:
    double m_step_K = 0.0;
    std::deque<double> m_newest_K; ///< two more readings than second differences
};

/// Standard uncertainty of the temperature that a zeroed sensor tells, by the rules of the GUM, in the parts
/// that it is made of, K. They count as independent. Not in it: the sensor's own error away from the room's
/// temperature, of which no device tells, and how well it touches its object.
struct ContactUncertainty {
    double room_K = 0.0;       ///< of the temperature that all sensors were zeroed to
    double zeroing_K = 0.0;    ///< of the sensor's own offset: its noise and its step while it was zeroed
    double resolution_K = 0.0; ///< of the step, evenly likely
    double noise_K = 0.0;      ///< of a single reading

    /// Returns that of the mean of `readings`, of which only the noise gets less: objects at rest show the
    /// same wrong step.
    double ofMean_K(std::size_t readings) const;
    double ofReading_K() const { return ofMean_K(1); }
};

/// Returns it for a sensor that was zeroed together with the others: `offsets_K` are those of all N sensors,
/// found from the means of `window` readings. The room's temperature is the mean of the sensors, each known
/// to kClassB_K or by how far they disagree, whichever is more. Empty while the noise is not known. Throws
/// std::invalid_argument without offsets or with a window below 1.
std::optional<ContactUncertainty> contactUncertainty(std::span<const double> offsets_K, int window,
                                                     const ReadingScatter& scatter);

/// Standard uncertainty of a sensor at the room's temperature: a Pt100 of class B is within 0.43 K, evenly
/// likely.
inline constexpr double kClassB_K = 0.25;

} // namespace bask
