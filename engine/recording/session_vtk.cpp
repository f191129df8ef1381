#include "engine/recording/session_vtk.h"

#include "engine/base/plain_text.h"
#include "engine/exchange/field_file.h"
#include "engine/exchange/target_surfaces.h"
#include "engine/model/experiment_rig.h"
#include "engine/model/uneven_source.h"
#include "engine/recording/ro_crate.h"
#include "engine/recording/session_lines.h"
#include "engine/recording/staged_files.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bask {
namespace {

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();
constexpr double kAfterTrajectories = 0.1, kAfterOutlines = 0.2, kAfterFields = 0.9; // of the work
constexpr int kMaxFieldSteps = 60; // along an axis: some seconds an object

/// Where everything is before the first sample.
TraceSample atStart(const Experiment& e) {
    TraceSample sample;
    sample.coordinates = e.start;
    sample.source = e.source.pose;
    sample.source_K = kNoValue;
    for (const ObjectSpec& object : e.objects) {
        ObjectSample row;
        row.measured_K = row.estimated_K = row.true_K = row.viewFactor = kNoValue;
        row.unshadedViewFactor = kNoValue;
        row.target_K = object.target_K;
        sample.objects.push_back(row);
    }
    return sample;
}

/// Evenly from the first to the last, a sample once.
std::vector<std::size_t> chosen(std::size_t samples) {
    std::vector<std::size_t> out;
    const std::size_t steps = std::min<std::size_t>(samples, kMaxOutlineSteps);
    for (std::size_t k = 0; k < steps; ++k)
        out.push_back(steps < 2 ? 0 : k * (samples - 1) / (steps - 1));
    return out;
}

class VtkExport {
public:
    VtkExport(const SessionRecord& session, StagedFiles& files, const std::stop_token& stop,
              const ShareDone& done)
        : m_session(session), m_files(files), m_stop(stop), m_done(done) {}

    Result<void> all() {
        for (const auto part : {&VtkExport::trajectories, &VtkExport::outlines, &VtkExport::fields})
            if (auto done = (this->*part)(); !done)
                return done;
        return {};
    }

private:
    /// Errors name the place that was asked for.
    Result<void> write(const std::string& name, const auto& writer) {
        const auto path = m_files.place(name);
        if (!path)
            return path.error();
        const auto done = writer(*path);
        return done ? Result<void>()
                    : Error(done.error().code(), m_files.target(name), done.error().message.args);
    }

    Result<void> put(const PolyLines& poly, const std::string& name) {
        if (auto place = checkPolyFile(m_files.target(name)); !place)
            return place;
        return write(name, [&](const std::string& path) { return writePolyFile(poly, path); });
    }

    Result<void> trajectories() {
        if (m_session.samples.empty())
            return {};
        auto done = put(objectTrajectories(m_session), "trajectories.vtp");
        return done ? put(endEffectorTrajectory(m_session), "end_effector.vtp") : done;
    }

    Result<void> outlines() {
        if (auto place = checkCollectionFile(m_files.target("outlines.pvd")); !place)
            return place;
        std::vector<TraceSample> moments;
        for (const std::size_t k : chosen(m_session.samples.size()))
            moments.push_back(m_session.samples[k]);
        if (moments.empty())
            moments.push_back(atStart(m_session.experiment));
        std::vector<TimedFile> files;
        tellShare(m_done, kAfterTrajectories);
        ShareCount count(partOf(m_done, kAfterTrajectories, kAfterOutlines),
                         static_cast<double>(moments.size()));
        for (const TraceSample& moment : moments) {
            std::string number = std::to_string(files.size());
            number.insert(0, 4 - number.size(), '0');
            files.push_back({moment.time_s, "outlines/" + number + ".vtp"});
            if (auto done = put(outlinesAt(m_session, moment), files.back().name); !done)
                return done;
            count.add();
        }
        return m_files.write("outlines.pvd", collectionXml(files));
    }

    /// Angles and source of the last sample under control.
    TraceSample lastUnderControl() const {
        const auto samples = m_session.controlledSamples();
        return samples.empty() ? atStart(m_session.experiment) : samples.back();
    }

    Result<void> fields() {
        const Experiment& e = m_session.experiment;
        const TraceSample last = lastUnderControl();
        const double span_m = (e.robot.upper - e.robot.lower).head<3>().maxCoeff();
        const TargetGeometry geometry{.source = radiatingSource(e),
                                      .X_RS = poseFromCoordinates(last.source),
                                      .objects = mountedContours(e),
                                      .screens = screensOf(e),
                                      .axes = surfaceAxes(PoseSubset::OwnTranslation, e.robot,
                                                          std::max(kSurfaceStep_m, span_m / kMaxFieldSteps)),
                                      .fixed = last.coordinates,
                                      .ofOwnCentres = true,
                                      .clearance_m = e.robot.clearance_m};
        const auto sampled = targetFields(geometry, m_stop, partOf(m_done, kAfterOutlines, kAfterFields));
        if (!sampled)
            return sampled.error();
        for (std::size_t i = 0; i < e.objects.size(); ++i)
            if (auto done = putField(*(*sampled)[i], i); !done)
                return done;
        return {};
    }

    Result<void> putField(const Field& factor, std::size_t i) {
        const ObjectSpec& object = m_session.experiment.objects[i];
        const std::string ending = std::to_string(i + 1) + "_" + plainFileName(object.name) + ".vti";
        const std::string where = ", over the positions of its centre in the robot's base";
        Field steady = factor;
        steady.quantity = "steady_temperature";
        steady.unit = "K";
        const HeatRates rates = startRates(object, surroundingsOf(m_session.experiment));
        for (double& value : steady.values)
            value = std::isfinite(value) ? rates.steadyTemperature_K(value) : kNoValue;
        if (auto done = putOne(factor, "view_factor_" + ending, "View factor of " + object.name + where);
            !done)
            return done;
        return putOne(steady, "steady_temperature_" + ending, "Steady temperature of " + object.name + where);
    }

    Result<void> putOne(const Field& field, const std::string& name, const std::string& title) {
        if (auto place = checkFieldFile(m_files.target(name), field.axes); !place)
            return place;
        return write(name, [&](const std::string& path) { return writeField(field, path, title); });
    }

    const SessionRecord& m_session;
    StagedFiles& m_files;
    const std::stop_token& m_stop;
    const ShareDone& m_done;
};

} // namespace

Result<std::vector<std::string>> exportVtk(const SessionRecord& session, const std::string& folder,
                                           const std::stop_token& stop, const ShareDone& told) {
    auto files = StagedFiles::into(folder);
    if (!files)
        return files.error();
    auto done = VtkExport(session, *files, stop, told).all();
    if (done)
        done = addCrate(*files, session);
    if (!done)
        return done.error();
    tellShare(told, 1.0);
    return files->commit();
}

} // namespace bask
