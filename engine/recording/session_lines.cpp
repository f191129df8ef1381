#include "engine/recording/session_lines.h"

#include "engine/model/mounting_check.h"
#include "engine/thermal/source_emission.h"

#include <cmath>
#include <limits>
#include <numeric>

namespace bask {
namespace {

constexpr int kOutlinePoints = 120;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

double drawn_K(const ObjectSample& object) {
    const double T_K = judgedTemperature_K(object);
    return std::isfinite(T_K) ? T_K : object.measured_K;
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
    std::vector<const ObjectColumn*> columns;
    for (const ObjectColumn& column : kObjectColumns)
        if (column.vtk != nullptr && session.rig().has(column.needs)) {
            columns.push_back(&column);
            poly.pointData.push_back({column.vtk, {}});
        }
    PolyArray time{"time_s", {}};
    PolyArray number{"object", {}};
    for (std::size_t i = 0; i < objects.size() && !session.samples.empty(); ++i) {
        const Eigen::Vector3d p_EO = poseFromCoordinates(objects[i].mounting).translation();
        poly.lines.push_back(lineOf(poly.points.size(), session.samples.size()));
        number.values.push_back(static_cast<double>(i + 1));
        for (const TraceSample& sample : session.samples) {
            poly.points.push_back(poseFromCoordinates(sample.coordinates) * p_EO);
            time.values.push_back(sample.time_s);
            for (std::size_t c = 0; c < columns.size(); ++c)
                poly.pointData[c].values.push_back(columns[c]->value.get(sample.objects[i]));
        }
    }
    poly.pointData.push_back(time);
    poly.lineData = {number};
    return poly;
}

PolyLines endEffectorTrajectory(const SessionRecord& session) {
    PolyLines poly;
    poly.title = "Trajectory of the end-effector's origin in the robot's base, m";
    PolyArray time{"time_s", {}}, velocity{"velocity_m_s", {}, 3}, rotation{"angular_velocity_rad_s", {}, 3},
        quaternion{"quaternion_wxyz", {}, 4};
    for (const RunColumn& column : kRunColumns)
        if (column.vtk != nullptr)
            poly.pointData.push_back({column.vtk, {}});
    for (const TraceSample& sample : session.samples) {
        const Pose X_RE = poseFromCoordinates(sample.coordinates);
        poly.points.push_back(X_RE.translation());
        time.values.push_back(sample.time_s);
        for (int k = 0; k < 3; ++k) {
            velocity.values.push_back(sample.twist[k]);
            rotation.values.push_back(sample.twist[3 + k]);
        }
        std::size_t c = 0;
        for (const RunColumn& column : kRunColumns)
            if (column.vtk != nullptr)
                poly.pointData[c++].values.push_back(column.value.get(sample));
        const Eigen::Quaterniond q(X_RE.linear());
        for (const double part : {q.w(), q.x(), q.y(), q.z()})
            quaternion.values.push_back(part);
    }
    if (!session.samples.empty())
        poly.lines.push_back(lineOf(0, session.samples.size()));
    poly.pointData.insert(poly.pointData.begin(), {time, velocity, rotation});
    poly.pointData.push_back(quaternion);
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
    for (const SourcePartSpec& part : e.source.uneven.parts) {
        addRings(poly, part.shape, poseFromCoordinates(sample.source) * poseFromCoordinates(part.pose));
        const PartTemperature own{part.temperatureRatio, part.temperatureOffset_K};
        fill(0, own.at_K(sample.source_K, e.environment_K), kNaN);
    }
    const Pose X_RE = poseFromCoordinates(sample.coordinates);
    for (std::size_t i = 0; i < e.objects.size(); ++i) {
        addRings(poly, e.objects[i].shape, X_RE * poseFromCoordinates(e.objects[i].mounting));
        fill(i + 1, drawn_K(sample.objects[i]), sample.objects[i].target_K);
    }
    poly.lineData = {temperature, target, number};
    return poly;
}

} // namespace bask
