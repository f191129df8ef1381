#include "engine/export/session_lines.h"

#include "engine/session/mounting_check.h"

#include <cmath>
#include <limits>
#include <numeric>

namespace bask {
namespace {

constexpr int kOutlinePoints = 120;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

double temperature_K(const ObjectSample& object) {
    return std::isfinite(object.true_K)        ? object.true_K
           : std::isfinite(object.estimated_K) ? object.estimated_K
                                               : object.measured_K;
}

/// Indices of `count` points from `first` on.
std::vector<int> lineOf(std::size_t first, std::size_t count) {
    std::vector<int> line(count);
    std::iota(line.begin(), line.end(), static_cast<int>(first));
    return line;
}

std::vector<std::string> objectNames(const Experiment& experiment) {
    std::vector<std::string> names;
    for (const ObjectSpec& object : experiment.objects)
        names.push_back(object.name);
    return names;
}

/// A column of the objects' trajectories.
struct ObjectColumn {
    const char* name;
    double (*of)(const TraceSample&, const ObjectSample&);
};

constexpr ObjectColumn kObjectColumns[]{
    {"measured_K", [](const TraceSample&, const ObjectSample& o) { return o.measured_K; }},
    {"estimated_K", [](const TraceSample&, const ObjectSample& o) { return o.estimated_K; }},
    {"target_K", [](const TraceSample&, const ObjectSample& o) { return o.target_K; }},
    {"error_K", [](const TraceSample&, const ObjectSample& o) { return o.measured_K - o.target_K; }},
    {"view_factor", [](const TraceSample&, const ObjectSample& o) { return o.viewFactor; }},
    {"reading_valid", [](const TraceSample&, const ObjectSample& o) { return o.valid ? 1.0 : 0.0; }},
    {"time_s", [](const TraceSample& s, const ObjectSample&) { return s.time_s; }},
    {"true_K", [](const TraceSample&, const ObjectSample& o) { return o.true_K; }},
};

void addRings(PolyLines& poly, const Shape& shape, const Pose& X_RO) {
    for (const std::vector<Eigen::Vector2d>& ring : shapeRings(thinned(shape), kOutlinePoints)) {
        const std::size_t first = poly.points.size();
        for (const Eigen::Vector2d& p : ring)
            poly.points.push_back(X_RO * Eigen::Vector3d(p.x(), p.y(), 0.0));
        poly.lines.push_back(lineOf(first, ring.size()));
        poly.lines.back().push_back(static_cast<int>(first)); // closed
    }
}

} // namespace

PolyLines objectTrajectories(const SessionRecord& session) {
    PolyLines poly;
    poly.title = "Trajectories of the objects' centres in the robot's base, m";
    poly.words = {{"object_names", objectNames(session.experiment)}};
    const auto& objects = session.experiment.objects;
    const std::size_t columns = std::size(kObjectColumns) - (session.simulated ? 0 : 1);
    for (std::size_t c = 0; c < columns; ++c)
        poly.pointData.push_back({kObjectColumns[c].name, {}});
    PolyArray number{"object", {}};
    for (std::size_t i = 0; i < objects.size() && !session.samples.empty(); ++i) {
        const Eigen::Vector3d p_EO = poseFromCoordinates(objects[i].mounting).translation();
        poly.lines.push_back(lineOf(poly.points.size(), session.samples.size()));
        number.values.push_back(static_cast<double>(i + 1));
        for (const TraceSample& sample : session.samples) {
            poly.points.push_back(poseFromCoordinates(sample.coordinates) * p_EO);
            for (std::size_t c = 0; c < columns; ++c)
                poly.pointData[c].values.push_back(kObjectColumns[c].of(sample, sample.objects[i]));
        }
    }
    poly.lineData = {number};
    return poly;
}

PolyLines endEffectorTrajectory(const SessionRecord& session) {
    PolyLines poly;
    poly.title = "Trajectory of the end-effector's origin in the robot's base, m";
    PolyArray time{"time_s", {}}, velocity{"velocity_m_s", {}, 3}, rotation{"angular_velocity_rad_s", {}, 3},
        source{"source_K", {}}, limits{"limits", {}}, quaternion{"quaternion_wxyz", {}, 4};
    for (const TraceSample& sample : session.samples) {
        const Pose X_RE = poseFromCoordinates(sample.coordinates);
        poly.points.push_back(X_RE.translation());
        time.values.push_back(sample.time_s);
        for (int k = 0; k < 3; ++k) {
            velocity.values.push_back(sample.twist[k]);
            rotation.values.push_back(sample.twist[3 + k]);
        }
        source.values.push_back(sample.source_K);
        limits.values.push_back(sample.limits.bits);
        const Eigen::Quaterniond q(X_RE.linear());
        for (const double part : {q.w(), q.x(), q.y(), q.z()})
            quaternion.values.push_back(part);
    }
    if (!session.samples.empty())
        poly.lines.push_back(lineOf(0, session.samples.size()));
    poly.pointData = {time, velocity, rotation, source, limits, quaternion};
    return poly;
}

PolyLines outlinesAt(const SessionRecord& session, const TraceSample& sample) {
    const Experiment& e = session.experiment;
    PolyLines poly;
    poly.title = "Outlines of the source and the objects in the robot's base, m";
    std::vector<std::string> names{"source"};
    for (const std::string& name : objectNames(e))
        names.push_back(name);
    poly.words = {{"object_names", names}};
    PolyArray temperature{"temperature_K", {}}, target{"target_K", {}}, number{"object", {}};
    const auto fill = [&](std::size_t k, double T_K, double target_K) {
        temperature.values.resize(poly.lines.size(), T_K);
        target.values.resize(poly.lines.size(), target_K);
        number.values.resize(poly.lines.size(), static_cast<double>(k));
    };
    addRings(poly, e.source.shape, poseFromCoordinates(sample.source));
    fill(0, sample.source_K, kNaN);
    const Pose X_RE = poseFromCoordinates(sample.coordinates);
    for (std::size_t i = 0; i < e.objects.size(); ++i) {
        addRings(poly, e.objects[i].shape, X_RE * poseFromCoordinates(e.objects[i].mounting));
        fill(i + 1, temperature_K(sample.objects[i]), sample.objects[i].target_K);
    }
    poly.lineData = {temperature, target, number};
    return poly;
}

} // namespace bask
