#include "engine/model/mounting_check.h"

#include "engine/base/message_code.h"
#include "engine/control/dependent_objects.h"
#include "engine/model/experiment_rig.h"
#include "engine/model/passing_shapes.h"
#include "engine/shape/crossing.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <utility>

namespace bask {
namespace {

using Outline = std::vector<Eigen::Vector2d>;
using Rings = std::vector<Outline>;

constexpr int kOutlinePoints = 120;
constexpr std::size_t kManyPoints = 240;
constexpr double kThinned_m = 1e-4;
constexpr double kFlatTriangle = 0.1; ///< height over longest side, below which three places are a line

// Inside the outline and in no hole.
bool covers(const Rings& face, const Eigen::Vector2d& p) {
    return std::ranges::count_if(face, [&](const Outline& ring) { return encloses(ring, p); }) % 2 == 1;
}

bool overlap(const Rings& one, const Rings& other) {
    if (covers(other, one.front().front()) || covers(one, other.front().front()))
        return true;
    return std::ranges::any_of(one, [&](const Outline& ring) {
        return std::ranges::any_of(other,
                                   [&](const Outline& its) { return findMeeting(ring, its).has_value(); });
    });
}

/// Whether two mounted plates lie in one plane, within what nobody could build otherwise.
bool inOnePlane(const Pose& one, const Pose& other) {
    constexpr double kTurn_rad = 1e-3;
    constexpr double kApart_m = 1e-4;
    const Eigen::Vector3d n = one.linear().col(2);
    return n.cross(other.linear().col(2)).norm() < kTurn_rad &&
           std::abs(n.dot(other.translation() - one.translation())) < kApart_m;
}

bool inLine(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    return (b - a).cross(c - a).norm() < kFlatTriangle * longest * longest;
}

MountingRemark dependenceRemark(const DependentObjects& set, const std::vector<ObjectSpec>& objects) {
    const auto name = [&](std::size_t k) { return objects[static_cast<std::size_t>(set.objects[k])].name; };
    if (set.objects.size() == 1)
        return {{MessageCode::MountingUnmoved, {name(0)}}, set.objects};
    if (set.alike)
        return {{MessageCode::MountingAlike, {name(0), name(1)}}, set.objects};
    std::string names = name(0);
    for (std::size_t k = 1; k < set.objects.size(); ++k)
        names += ", " + name(k);
    return {{MessageCode::MountingDependent, {names}}, set.objects};
}

/// What the free axes can do with this arrangement.
std::vector<MountingRemark> freedomRemarks(const Experiment& experiment) {
    std::vector<MountingRemark> out;
    for (const DependentObjects& set : dependentObjects(*rigGeometry(experiment), experiment.start))
        out.push_back(dependenceRemark(set, experiment.objects));
    const int freedom = experiment.robot.degreesOfFreedom();
    if (out.empty() && std::cmp_equal(experiment.objects.size(), freedom))
        out.push_back({{MessageCode::MountingNoneLeft, {std::to_string(freedom)}}, {}});
    return out;
}

MountingRemark overlapRemark(const Experiment& experiment, std::size_t i, std::size_t k) {
    return {{MessageCode::MountingOverlap, {experiment.objects[i].name, experiment.objects[k].name}},
            {static_cast<int>(i), static_cast<int>(k)}};
}

// Calls `take(passage, i, k)` for every two objects, i < k.
template <class F> void forPassages(const Experiment& experiment, const F& take) {
    const std::vector<ObjectSpec>& objects = experiment.objects;
    std::vector<Shape> shapes;
    std::ranges::transform(objects, std::back_inserter(shapes),
                           [](const ObjectSpec& object) { return thinned(object.shape); });
    for (std::size_t k = 1; k < objects.size(); ++k)
        for (std::size_t i = 0; i < k; ++i)
            take(passageOf(shapes[i], poseFromCoordinates(objects[i].mounting), shapes[k],
                           poseFromCoordinates(objects[k].mounting)),
                 i, k);
}

/// A fixture, shield or object, with the place of its pose in files.
struct PlateInRig {
    std::string name;
    Shape shape;
    Pose X = Pose::Identity(); ///< in E, of shields in R
    std::string where;
    int object = -1; ///< -1: none
};

std::vector<PlateInRig> platesOf(const std::vector<PlateSpec>& specs, const std::string& list,
                                 const std::string& pose) {
    std::vector<PlateInRig> plates;
    for (const PlateSpec& spec : specs)
        plates.push_back({spec.name, thinned(spec.shape), poseFromCoordinates(spec.pose),
                          list + '[' + std::to_string(plates.size()) + "]." + pose});
    return plates;
}

// Calls `take(one, other)` for every fixture that passes through an object or another fixture, and for every
// two shields that pass through one another.
template <class F> void forPassingPlates(const Experiment& experiment, const F& take) {
    std::vector<PlateInRig> held;
    for (const ObjectSpec& object : experiment.objects)
        if (!experiment.fixtures.empty())
            held.push_back({object.name,
                            thinned(object.shape),
                            poseFromCoordinates(object.mounting),
                            {},
                            static_cast<int>(held.size())});
    const auto addTo = [&](std::vector<PlateInRig>& before, std::vector<PlateInRig> plates) {
        for (PlateInRig& plate : plates) {
            for (const PlateInRig& other : before)
                if (passageOf(other.shape, other.X, plate.shape, plate.X) == Passage::Through)
                    take(other, plate);
            before.push_back(std::move(plate));
        }
    };
    addTo(held, platesOf(experiment.fixtures, "fixtures", "mounting"));
    std::vector<PlateInRig> standing;
    addTo(standing, platesOf(experiment.shields, "shields", "pose"));
}

Result<void> checkPlates(const Experiment& experiment) {
    Result<void> check;
    forPassingPlates(experiment, [&](const PlateInRig& one, const PlateInRig& other) {
        if (check)
            check = Error(MessageCode::MountingOverlap, other.where, {one.name, other.name});
    });
    return check;
}

/// 12, 3.4: whole percent, but for small shares.
std::string percentText(double share) {
    const double percent = 100.0 * share;
    return formatNumber(percent < 9.95 ? std::round(10.0 * percent) / 10.0 : std::round(percent));
}

Contour thinnedRing(const Contour& ring) {
    if (ring.points_m.size() <= kManyPoints)
        return ring;
    Contour apart; // first what takes no thought: simplified() takes 20 ms for 60,000 points
    for (const Eigen::Vector2d& p : ring.points_m)
        if (apart.points_m.empty() || (p - apart.points_m.back()).norm() >= kThinned_m)
            apart.points_m.push_back(p);
    return apart.points_m.size() < 3 ? ring : simplified(apart, kThinned_m);
}

} // namespace

Shape thinned(const Shape& shape) {
    const auto* polygon = outlineAs<Contour>(shape);
    std::vector<Contour> holes;
    std::ranges::transform(holesOf(shape), std::back_inserter(holes), thinnedRing);
    return withHoles(polygon ? Shape(thinnedRing(*polygon)) : shape, std::move(holes));
}

std::vector<std::vector<Eigen::Vector2d>> mountedRings(const ObjectSpec& object, int points, Coordinate right,
                                                       Coordinate up) {
    const Pose X_EO = poseFromCoordinates(object.mounting);
    Rings rings = shapeRings(object.shape, points);
    for (Outline& ring : rings)
        for (Eigen::Vector2d& p : ring) {
            const Eigen::Vector3d mounted = X_EO * Eigen::Vector3d(p.x(), p.y(), 0.0);
            p = {mounted[right], mounted[up]};
        }
    return rings;
}

Result<void> checkMounting(const Experiment& experiment) {
    Result<void> check = checkPlates(experiment);
    forPassages(experiment, [&](Passage passage, std::size_t i, std::size_t k) {
        if (check && passage == Passage::Through)
            check = Error(MessageCode::MountingOverlap, "objects[" + std::to_string(k) + "].mounting",
                          overlapRemark(experiment, i, k).message.args);
    });
    return check;
}

std::vector<MountingRemark> overlapsInPlane(const Experiment& experiment) {
    std::vector<MountingRemark> out;
    forPassages(experiment, [&](Passage passage, std::size_t i, std::size_t k) {
        if (passage == Passage::Overlap)
            out.push_back(overlapRemark(experiment, i, k));
    });
    return out;
}

std::vector<MountingRemark> shadeRemarks(const Experiment& experiment, const Vector6d& pose,
                                         ShadedPose which) {
    const auto code = which == ShadedPose::Start ? MessageCode::ShadeAtStart : MessageCode::ShadeAtPose;
    std::vector<TakenLight> all = rigGeometry(experiment)->takenLight(pose);
    const std::vector<std::string> takers = takerNames(experiment);
    const auto objectsOf = [&](const TakenLight& taken) {
        std::vector<int> objects{static_cast<int>(taken.object)};
        if (taken.taker < experiment.objects.size())
            objects.push_back(static_cast<int>(taken.taker));
        return objects;
    };
    std::ranges::stable_sort(all, std::ranges::greater(), &TakenLight::share);
    std::vector<MountingRemark> out;
    out.reserve(all.size());
    for (const TakenLight& taken : all)
        out.push_back(
            {{code, {takers[taken.taker], percentText(taken.share), experiment.objects[taken.object].name}},
             objectsOf(taken)});
    return out;
}

bool mayShade(const Experiment& experiment) {
    return MountedObjects(mountedContours(experiment), screensOf(experiment)).mayShade();
}

std::vector<MountingRemark> mountingRemarks(const Experiment& experiment) {
    Experiment quick = experiment;
    const std::vector<ObjectSpec>& objects = quick.objects;
    for (ObjectSpec& object : quick.objects)
        object.shape = thinned(object.shape);
    const double max_m = experiment.robot.maxMountingRadius_m;
    const int count = static_cast<int>(objects.size());
    std::vector<Rings> outlines;
    std::vector<Eigen::Vector3d> places;
    for (const ObjectSpec& object : objects) {
        outlines.push_back(mountedRings(object, kOutlinePoints));
        places.push_back(object.mounting.head<3>());
    }
    const auto name = [&](int i) { return objects[static_cast<std::size_t>(i)].name; };
    const auto at = [](const auto& list, int i) -> const auto& {
        return list[static_cast<std::size_t>(i)];
    };
    std::vector<MountingRemark> out;
    for (int i = 0; i < count; ++i) {
        double radius_m = 0.0;
        for (const Eigen::Vector2d& p : at(outlines, i).front())
            radius_m = std::max(radius_m, p.norm());
        if (max_m > 0.0 && radius_m > max_m)
            out.push_back({{MessageCode::MountingFar,
                            {name(i), formatNumber(100.0 * radius_m, 3), formatNumber(100.0 * max_m, 3)}},
                           {i}});
        for (int k = i + 1; k < count; ++k) {
            const Pose X_EI = poseFromCoordinates(at(objects, i).mounting);
            const Pose X_EK = poseFromCoordinates(at(objects, k).mounting);
            const bool isTold = inOnePlane(X_EI, X_EK)
                                    ? overlap(at(outlines, i), at(outlines, k))
                                    : passageOf(at(quick.objects, i).shape, X_EI, at(quick.objects, k).shape,
                                                X_EK) == Passage::Through;
            if (isTold)
                out.push_back({{MessageCode::MountingOverlap, {name(i), name(k)}}, {i, k}});
            for (int l = k + 1; l < count; ++l)
                if (inLine(at(places, i), at(places, k), at(places, l)))
                    out.push_back({{MessageCode::MountingInLine, {name(i), name(k), name(l)}}, {i, k, l}});
        }
    }
    forPassingPlates(quick, [&](const PlateInRig& one, const PlateInRig& other) {
        out.push_back({{MessageCode::MountingOverlap, {one.name, other.name}},
                       one.object < 0 ? std::vector<int>{} : std::vector<int>{one.object}});
    });
    std::ranges::move(freedomRemarks(quick), std::back_inserter(out));
    std::stable_partition(out.begin(), out.end(), [](const MountingRemark& remark) {
        return remark.message.code == MessageCode::MountingOverlap;
    });
    return out;
}

} // namespace bask
