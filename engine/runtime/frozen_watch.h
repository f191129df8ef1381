#pragma once
// Detects a frozen sensor by what its object did just before: a temperature that was changing goes on
// changing.

#include "engine/runtime/lagged_power.h"
#include "engine/runtime/loss_fit.h"

#include <deque>
#include <limits>
#include <optional>
#include <vector>

namespace bask {

/// While a reading stays the same, the object's temperature does too (within the sensor's step), so its
/// losses are constant: its rate is then the one before, changed by k times what the absorbed power has
/// changed. The losses, k and the sensor's lag follow from the last readings (LossFit). The reading should
/// have changed if all that explain kWindow_s before an anchor demand it, with 5 % of the energy taken off.
/// Anchors are the first of the equal readings and later ones.
class FrozenWatch {
public:
    static constexpr double kMin_K = 0.5; ///< smaller missing changes are ignored
    static constexpr double kWindow_s = 90.0;

    FrozenWatch(LossRange losses, double environment_K);

    /// Takes the absorbed power at a time, K/s (NaN: not known, which begins anew), and a valid reading;
    /// empty if there is none. Times must increase.
    void add(double time_s, std::optional<double> temperature_K, double power_K_s);
    void reset();
    /// Call when the sensor has been zeroed: the object is at the room's temperature.
    void restAt(double time_s, double temperature_K);

    /// Returns the smallest change that the reading should have shown since it is the same, K, with its sign:
    /// it is more than kMin_K and twice the changes that the sensor usually shows at once. 0: there is none.
    double missing_K() const { return m_missing_K; }

private:
    /// Integrals from the beginning up to a time.
    struct Mark {
        double time_s = 0.0;
        double temperature_K = 0.0;
        LaggedPower::Energies energy_K{}; ///< as a sensor with this lag sees it
        double integral_K_s = 0.0;        ///< of the temperature over m_first_K
        double jump_K = 0.0;              ///< largest change between two readings since the mark before
    };
    struct Anchor {
        Mark mark;
        std::vector<std::vector<LossFit::Explanation>> explanations{}; ///< for each lag
        double usual_K = 0.0; ///< change that the sensor shows at once
        bool isFitted = false;
    };
    void rememberRest();
    void integrate(double dt_s, double power_K_s);
    void take(double temperature_K);
    void fit(Anchor& anchor) const;
    double expected_K(const Anchor& anchor) const;
    void judge();
    double step_K() const;

    LossRange m_losses;
    LossFit::Room m_room;
    double m_rest_s = -std::numeric_limits<double>::infinity(); ///< when the sensor was zeroed
    std::deque<Mark> m_marks;
    std::deque<Anchor> m_anchors; ///< within the equal readings, the first of them first
    Mark m_now;
    int m_count = 0;
    int m_same = 0; ///< number of equal readings
    double m_first_K = 0.0;
    LaggedPower m_power;
    double m_step_K = 0.0;  ///< smallest change between two readings; 0 if there was none yet
    double m_noise_K = 0.0; ///< from second differences
    double m_before_K = 0.0;
    double m_repeat_s = 0.0; ///< the device was seen to repeat a reading for so long
    double m_missing_K = 0.0;
};

} // namespace bask
