#pragma once
// Fits of one outline with 1 to 40 harmonics, computed one after the other off the GUI thread and kept.

#include "engine/shape/fourier_contour.h"

#include <QObject>

#include <array>
#include <atomic>
#include <memory>
#include <optional>

namespace bask {

/// Lives on the GUI thread. A new outline cancels the fits of the one before; the wanted number of harmonics
/// goes first.
class FourierFits : public QObject {
    Q_OBJECT

public:
    explicit FourierFits(QObject* parent = nullptr);
    ~FourierFits() override;

    /// Starts fitting; an outline equal to the present one keeps its fits. An empty outline clears.
    void setOutline(const Contour& outline);
    const Contour& outline() const { return *m_outline; }

    /// Asks for this number to be fitted next.
    void want(int harmonics);

    /// The fit if it is there already. 1 <= harmonics <= kMaxHarmonics.
    const std::optional<FourierFit>& fit(int harmonics) const {
        return m_fits.at(static_cast<std::size_t>(harmonics));
    }
    bool complete() const { return m_done == kMaxHarmonics; }

signals:
    /// A fit arrived, or the outline refuses this number of harmonics (then fit() stays empty).
    void fitReady(int harmonics);

private:
    struct Job {
        std::atomic<bool> cancelled{false};
        std::atomic<int> wanted{0};
    };
    void run();
    void take(const std::shared_ptr<Job>& job, int harmonics, std::optional<FourierFit> fit);

    std::shared_ptr<const Contour> m_outline = std::make_shared<Contour>();
    std::array<std::optional<FourierFit>, kMaxHarmonics + 1> m_fits;
    int m_done = 0;
    std::shared_ptr<Job> m_job;
};

} // namespace bask
