#pragma once
// Fits of one outline with 1 to 40 harmonics, computed one after the other off the GUI thread and kept.

#include "engine/shape/fourier_contour.h"

#include <QObject>

#include <array>
#include <atomic>
#include <memory>
#include <optional>

namespace bask {

/// A fit and the outline's distance from it at each point.
struct OutlineFit {
    FourierFit fit;
    std::vector<double> distances_m; ///< distances of FourierFits::points()
};

/// Lives on the GUI thread. A new outline cancels the fits of the previous one; the wanted number of
/// harmonics is fitted first.
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

    /// The fit; empty if it is not computed yet. 1 <= harmonics <= kMaxHarmonics.
    const std::optional<OutlineFit>& fit(int harmonics) const {
        return m_fits.at(static_cast<std::size_t>(harmonics));
    }
    int done() const { return m_done; }
    bool complete() const { return m_done == kMaxHarmonics; }

    /// The outline's points, with more along its longer edges; empty before the first fit.
    const std::vector<Eigen::Vector2d>& points() const { return *m_points; }

    /// The outline as a polygon with no more corners than an object may have; empty before the first fit.
    const Contour& polygon() const { return *m_polygon; }

signals:
    /// A fit is ready, or the outline cannot have this number of harmonics (then fit() stays empty).
    void fitReady(int harmonics);

private:
    using Points = std::vector<Eigen::Vector2d>;
    struct Job {
        std::atomic<bool> cancelled{false};
        std::atomic<int> wanted{0};
    };
    struct Work;
    void run();

    std::shared_ptr<const Contour> m_outline = std::make_shared<Contour>();
    std::shared_ptr<const Points> m_points = std::make_shared<Points>();
    std::shared_ptr<const Contour> m_polygon = std::make_shared<Contour>();
    std::array<std::optional<OutlineFit>, kMaxHarmonics + 1> m_fits;
    int m_done = 0;
    std::shared_ptr<Job> m_job;
};

} // namespace bask
