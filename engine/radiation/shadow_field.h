#pragma once
// The radiation through a point that goes from the object to the source and meets a blocker, as a vector.

#include "engine/radiation/conic_roots.h"
#include "engine/radiation/lambert_batch.h"
#include "engine/radiation/sight_scene.h"

#include <cstdint>
#include <span>
#include <vector>

namespace bask {

/// A figure that a ray through the point meets: ahead of it (1), behind it (-1), on either side (0).
struct SightMember {
    std::size_t figure = 0; ///< number in the scene
    int side = 1;
};

/// What is seen from one point.
struct ShadowLook {
    Eigen::Vector3d field = Eigen::Vector3d::Zero(); ///< integral of the directions over the solid angle, sr
    std::uint64_t pattern = 0; ///< of the pieces that bound the solid angle; 0: it is empty
};

/// For points p: the solid angle of the rays, in their direction of travel (down, z < 0), that meet every
/// target and, if `through`, at least one blocker, else none. Its boundary consists of pieces of the figures'
/// outlines, so the integral of the directions over it is half the sum of the integrals of r x dr / |r|^2
/// along the pieces, in closed form on straight parts and circles. Not thread-safe.
class ShadowField {
    /// On an outline: on its circle (edge -1) as a unit vector, or on an edge from 0 to 1.
    struct Place {
        int edge = -1;
        double along = 0.0;
        Eigen::Vector2d on = Eigen::Vector2d::Zero();

        explicit Place(const Eigen::Vector2d& at) : on(at) {}
        Place(int number, double part) : edge(number), along(part) {}
    };
    /// Where the outlines of two figures pass in front of one another.
    struct Crossing {
        std::size_t a, b;
        Place onA, onB;
        bool rises = false;  ///< of a circle B: its form grows along A
        bool isHere = false; ///< found as seen from the present point
    };
    /// A part of an outline that bounds the solid angle, between two crossings; where there is none (-1),
    /// from `first` or to `last`.
    struct Piece {
        std::size_t own;
        double sign;
        int from, to;
        Place first, last;
        double turn; // of an arc, as angleOrder() counts
    };

public:
    /// The pieces that bound the solid angle at a point, and where their ends are.
    struct Sight {
        std::vector<Crossing> crossings;
        std::vector<Piece> pieces;
    };

    ShadowField(const SightScene& scene, std::span<const SightMember> targets,
                std::span<const SightMember> blockers, bool through);

    /// Returns false if the solid angle is empty for every point within `slack_m` of p.
    bool mayBeSeen(const Eigen::Vector3d& p, double slack_m);
    ShadowLook at(const Eigen::Vector3d& p, bool withField);
    /// Goes on to a point beside the last one where the same pieces bound the solid angle: only their ends
    /// are followed. Returns false if that fails; then ask at().
    bool follow(const Eigen::Vector3d& p);
    /// Adds what is seen from the last point as one of a batch.
    void addField(LambertBatch& batch, int point, double factor) const;
    const Sight& sight() const { return m_sight; } ///< at the last point
    /// Lets follow() go on from a point where this was seen.
    void resume(const Sight& sight) { m_sight = sight; }

private:
    /// Such a place on one outline.
    struct CircleCut {
        Eigen::Vector2d at; // on the unit circle
        double order;       // ascending along the circle
        int by;
        int crossing; // -1: an end of the arc
    };
    struct EdgeCut {
        int edge;
        double at;
        int by;
        int crossing;
    };
    /// A point of another figure's plane, homogeneous: (u / w, v / w).
    struct Image {
        double u, v, w;
    };
    /// A circle of another figure's plane that contains the image of a chain; the radius may be infinite.
    struct Shadow {
        Eigen::Vector2d middle;
        double radius;
    };
    struct Seen {
        const SightFigure* figure = nullptr;
        Eigen::Matrix3d axes; // of the figure, in S
        int side = 1;
        bool isTarget = false;
        double x = 0.0, y = 0.0, h = 0.0; // of p in the figure's frame: (x, y, -h)
        Eigen::Vector3d centre;           // as seen from p, in the direction of travel if the side is known
        double reach = 0.0;               // radius of a sphere around it
        double tangent = 0.0;             // length of a tangent to this sphere; negative inside
        bool isActive = true;             // it may bound the solid angle
        std::vector<CircleCut> circleCuts;
        std::vector<EdgeCut> edgeCuts;
    };
    static Image image(const Seen& onto, const Eigen::Vector3d& point) {
        return {onto.h * point.x() + onto.x * point.z(), onto.h * point.y() + onto.y * point.z(),
                point.z() + onto.h};
    }
    /// The bilinear form of a circle about the other figure's origin: zero for a point on it with itself.
    static double formOf(const Image& s, const Image& t, double radius2) {
        return s.u * t.u + s.v * t.v - radius2 * s.w * t.w;
    }
    const SightScene::Relation& relation(std::size_t of, std::size_t to) const {
        return *m_relations[of * m_seen.size() + to];
    }
    double travel(std::size_t own, const Eigen::Vector2d& at) const;
    static bool isAhead(const Seen& seen, double w) { return seen.side == 0 || seen.h * w * seen.side > 0.0; }
    static bool mayOverlap(const Seen& a, const Seen& b);
    bool findActive(double slack_m);
    bool meets(std::size_t own, std::size_t other, const Eigen::Vector2d& at, double way) const;
    bool counts(std::size_t own, const Eigen::Vector2d& at, double way) const;
    static Shadow shadow(const Seen& onto, const std::pair<Eigen::Vector3d, double>& chain);
    void cutCircles(std::size_t a, std::size_t b);
    void cutCircleByEdges(std::size_t circle, std::size_t straight);
    void cutEdges(std::size_t a, std::size_t b);
    void findArcs(std::size_t own, std::uint64_t& pattern);
    void findLines(std::size_t own, std::uint64_t& pattern);
    void lookFrom(const Eigen::Vector3d& p);
    const Place& begin(const Piece& piece) const;
    const Place& end(const Piece& piece) const;
    void addArc(const Piece& piece, LambertBatch& batch, int point, double factor) const;
    void addLine(const Piece& piece, LambertBatch& batch, int point, double factor) const;
    Conic conic(std::size_t a, std::size_t b) const;
    bool placeOnB(Crossing& crossing) const;
    bool follow(Crossing& crossing) const;
    bool followCircles(Crossing& crossing) const;
    bool followCircleAndEdge(Crossing& crossing) const;
    bool followEdges(Crossing& crossing) const;
    static bool isFarFrom(const Seen& seen, const SightFigure::Chain& chain);
    static Eigen::Vector3d smoothField(const Seen& seen, const SightFigure::Chain& chain);

    std::vector<Seen> m_seen; // targets first
    std::size_t m_targets;
    bool m_through;
    std::vector<const SightScene::Relation*> m_relations;
    std::vector<Image> m_images; // scratch: of the corners of a figure
    Sight m_sight;

    Eigen::Vector3d m_p = Eigen::Vector3d::Zero();
};

} // namespace bask
