#include "app/experiment_edit.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace bask {
namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(bask::ExperimentEdit)
};

using Take = void (*)(Experiment& to, const Experiment& from);

template <auto... Members> void takeOfObjects(Experiment& to, const Experiment& from) {
    for (std::size_t i = 0; i < std::min(to.objects.size(), from.objects.size()); ++i)
        ((to.objects[i].*Members = from.objects[i].*Members), ...);
}

template <auto... Members> void takeOfVision(Experiment& to, const Experiment& from) {
    ((to.vision.*Members = from.vision.*Members), ...);
}

/// A simulated camera that nobody has described comes with its calibration, and goes with it.
void takeThermalCalibration(Experiment& to, const Experiment& from) {
    const ThermalCalibration calibration = thermalCalibration(from, !from.rig);
    if (calibration == thermalCalibration(to, !to.rig))
        return;
    calibrateThermalCamera(to, calibration);
    if (!from.simulation.thermalCamera && to.simulation.thermalCamera == SimulatedThermalCameraSpec())
        to.simulation.thermalCamera.reset();
}

struct Row {
    EditKind kind;
    EditScope scope;
    Page page;
    Take take; ///< all that such an edit changes
};

/// The first whose parts are all that differs counts, so the narrower come first.
constexpr std::array kRows{
    Row{EditKind::Targets, EditScope::Targets, Page::Targets, takeOfObjects<&ObjectSpec::target_K>},
    Row{EditKind::Controller, EditScope::Controller, Page::Run,
        [](Experiment& to, const Experiment& from) { to.controller = from.controller; }},
    Row{EditKind::Markers, EditScope::Vision, Page::Calibrate,
        takeOfVision<&VisionSpec::markers, &VisionSpec::dictionary>},
    Row{EditKind::CameraLens, EditScope::Vision, Page::Calibrate,
        takeOfVision<&VisionSpec::camera, &VisionSpec::cameraDate>},
    Row{EditKind::CameraPlace, EditScope::Vision, Page::Calibrate,
        takeOfVision<&VisionSpec::cameraPose, &VisionSpec::cameraPoseDate>},
    Row{EditKind::Vision, EditScope::Vision, Page::Calibrate,
        [](Experiment& to, const Experiment& from) { to.vision = from.vision; }},
    Row{EditKind::ThermalCamera, EditScope::All, Page::Calibrate, takeThermalCalibration},
    Row{EditKind::SourcePlace, EditScope::All, Page::Calibrate,
        [](Experiment& to, const Experiment& from) {
            to.vision = from.vision;
            to.source.pose = from.source.pose;
            to.simulation.sourcePose = from.simulation.sourcePose;
        }},
    Row{EditKind::Following, EditScope::All, Page::Calibrate,
        [](Experiment& to, const Experiment& from) {
            to.vision = from.vision;
            to.source.tracked = from.source.tracked;
        }},
    Row{EditKind::Start, EditScope::All, Page::Targets,
        [](Experiment& to, const Experiment& from) { to.start = from.start; }},
    Row{EditKind::SetPoint, EditScope::All, Page::Rig,
        [](Experiment& to, const Experiment& from) { to.source.temperature_K = from.source.temperature_K; }},
    Row{EditKind::Emittance, EditScope::All, Page::Rig,
        [](Experiment& to, const Experiment& from) {
            to.source.emittance = from.source.emittance;
            to.source.emittanceUncertainty = from.source.emittanceUncertainty;
        }},
    Row{EditKind::Workspace, EditScope::All, Page::Rig,
        [](Experiment& to, const Experiment& from) {
            to.robot.lower = from.robot.lower;
            to.robot.upper = from.robot.upper;
        }},
    Row{EditKind::MotionLimits, EditScope::All, Page::Rig,
        [](Experiment& to, const Experiment& from) { to.robot = from.robot; }},
    Row{EditKind::Safety, EditScope::All, Page::Rig,
        [](Experiment& to, const Experiment& from) { to.safety = from.safety; }},
    Row{EditKind::Rig, EditScope::All, Page::Rig,
        [](Experiment& to, const Experiment& from) { to.rig = from.rig; }},
    Row{EditKind::Mounting, EditScope::All, Page::Objects, takeOfObjects<&ObjectSpec::mounting>},
    Row{EditKind::Name, EditScope::All, Page::Objects, takeOfObjects<&ObjectSpec::name>},
    Row{EditKind::StartValues, EditScope::All, Page::Objects, takeOfObjects<&ObjectSpec::estimatedRates>},
    Row{EditKind::Material, EditScope::All, Page::Objects,
        takeOfObjects<&ObjectSpec::material, &ObjectSpec::estimatedRates>},
    Row{EditKind::Outline, EditScope::All, Page::Objects,
        takeOfObjects<&ObjectSpec::shape, &ObjectSpec::origin>},
    Row{EditKind::Air, EditScope::All, Page::Objects,
        [](Experiment& to, const Experiment& from) { to.air = from.air; }},
    Row{EditKind::Object, EditScope::All, Page::Objects,
        [](Experiment& to, const Experiment& from) {
            if (to.objects.size() == from.objects.size())
                to.objects = from.objects;
        }},
};

/// The index of the one object that `more` has and `fewer` has not, all else but the rig's channels being the
/// same; else -1.
int additional(const Experiment& fewer, const Experiment& more) {
    if (more.objects.size() != fewer.objects.size() + 1)
        return -1;
    const auto at = std::ranges::mismatch(more.objects, fewer.objects).in1 - more.objects.begin();
    Experiment rest = more;
    rest.objects.erase(rest.objects.begin() + at);
    rest.rig = fewer.rig;
    return rest == fewer ? static_cast<int>(at) : -1;
}

int onlyOneThatDiffers(const std::vector<ObjectSpec>& before, const std::vector<ObjectSpec>& after) {
    int found = -1;
    for (std::size_t i = 0; i < before.size() && before.size() == after.size(); ++i) {
        if (before[i] == after[i])
            continue;
        if (found >= 0)
            return -1;
        found = static_cast<int>(i);
    }
    return found;
}

QString rigWords(const Experiment& before, const Experiment& after) {
    if (!before.rig)
        return Words::tr("choice of the real rig");
    return after.rig ? Words::tr("devices of the rig") : Words::tr("choice of the simulated rig");
}

} // namespace

ExperimentEdit compared(const Experiment& before, const Experiment& after) {
    Experiment patched = before;
    for (const Row& row : kRows) {
        row.take(patched, after);
        if (patched == after)
            return {row.kind, onlyOneThatDiffers(before.objects, after.objects), row.scope, row.page};
        row.take(patched, before);
    }
    if (const int added = additional(before, after); added >= 0)
        return {EditKind::ObjectAdded, added, EditScope::All, Page::Objects};
    if (const int removed = additional(after, before); removed >= 0)
        return {EditKind::ObjectRemoved, removed, EditScope::All, Page::Objects};
    return {};
}

QString editWords(const ExperimentEdit& edit, const Experiment& before, const Experiment& after) {
    const auto& objects = edit.kind == EditKind::ObjectAdded ? after.objects : before.objects;
    const auto index = static_cast<std::size_t>(edit.object);
    const QString name =
        edit.object >= 0 && index < objects.size() ? QString::fromStdString(objects[index].name) : QString();
    const auto ofObject = [&](const QString& one, const QString& several) {
        return name.isEmpty() ? several : one.arg(name);
    };
    switch (edit.kind) {
    case EditKind::Targets:
        return ofObject(Words::tr("target of “%1”"), Words::tr("targets"));
    case EditKind::Controller:
        return Words::tr("controller and gains");
    case EditKind::Markers:
        return Words::tr("markers");
    case EditKind::CameraLens:
        return Words::tr("calibration of the camera");
    case EditKind::CameraPlace:
        return Words::tr("place of the camera");
    case EditKind::Vision:
        return Words::tr("calibration");
    case EditKind::ThermalCamera:
        return Words::tr("calibration of the thermal camera");
    case EditKind::SourcePlace:
        return Words::tr("place of the source");
    case EditKind::Following:
        return Words::tr("following of the source");
    case EditKind::Start:
        return Words::tr("start of runs");
    case EditKind::SetPoint:
        return Words::tr("set point of the source");
    case EditKind::Emittance:
        return Words::tr("emittance of the source");
    case EditKind::Workspace:
        return Words::tr("workspace");
    case EditKind::MotionLimits:
        return Words::tr("limits of motion");
    case EditKind::Safety:
        return Words::tr("safety limits");
    case EditKind::Rig:
        return rigWords(before, after);
    case EditKind::Mounting:
        return ofObject(Words::tr("move of “%1”"), Words::tr("moves"));
    case EditKind::Name:
        return ofObject(Words::tr("renaming of “%1”"), Words::tr("names"));
    case EditKind::StartValues:
        return ofObject(Words::tr("start values of “%1”"), Words::tr("start values"));
    case EditKind::Material:
        return ofObject(Words::tr("material of “%1”"), Words::tr("materials"));
    case EditKind::Outline:
        return ofObject(Words::tr("outline of “%1”"), Words::tr("outlines"));
    case EditKind::Air:
        return Words::tr("air in the room");
    case EditKind::Object:
        return ofObject(Words::tr("change of “%1”"), Words::tr("change of several objects"));
    case EditKind::ObjectAdded:
        return Words::tr("addition of “%1”").arg(name);
    case EditKind::ObjectRemoved:
        return Words::tr("removal of “%1”").arg(name);
    case EditKind::Other:
        break;
    }
    return Words::tr("change of the experiment");
}

bool mayBeOneOfMany(EditKind kind) {
    switch (kind) {
    case EditKind::Targets:
    case EditKind::SetPoint:
    case EditKind::Emittance:
    case EditKind::Workspace:
    case EditKind::MotionLimits:
    case EditKind::Safety:
    case EditKind::Mounting:
    case EditKind::Material:
    case EditKind::Outline:
    case EditKind::Object:
    case EditKind::Air:
        return true;
    default:
        return false;
    }
}

} // namespace bask
