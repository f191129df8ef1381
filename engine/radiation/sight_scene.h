#pragma once
// Plates that may be seen from one point, and how each lies in the frames of the others.

#include "engine/radiation/sight_figure.h"

#include <memory>
#include <utility>
#include <vector>

namespace bask {

/// The figures of a scene, and how each lies in the frames of the others. It must outlive what refers to it.
class SightScene {
public:
    /// A figure's axes, origin and corners in the frame of another one.
    struct Relation {
        Eigen::Vector3d origin, e1, e2;
        std::vector<Eigen::Vector3d> corners;
        std::vector<std::pair<Eigen::Vector3d, double>> chains; ///< middle and radius
    };

    /// Returns the number of the new figure.
    std::size_t add(SightFigure figure);
    /// Returns the number of the figure or, if it does not lie wholly in the half space, of a new one that
    /// does.
    std::size_t clipped(std::size_t figure, const HalfSpace& space);
    const SightFigure& figure(std::size_t number) const { return m_figures[number]; }
    const Relation& relation(std::size_t of, std::size_t to) const;

private:
    std::vector<SightFigure> m_figures;
    mutable std::vector<std::unique_ptr<Relation>> m_relations; // made when asked for
};

} // namespace bask
