#include "app/experiment_edit.h"
#include "engine/experiment/experiment_file.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>

namespace bask::test {
namespace {

const Experiment& example() {
    static const Experiment experiment = readExperiment(BASK_EXAMPLES "/three-objects.json").value();
    return experiment;
}

ThermalCalibration measuredThermal() {
    ThermalCalibration calibration;
    calibration.pose = Vector6d::Ones();
    calibration.poseDate = "2026-11-22T10:00:00Z";
    return calibration;
}

struct Case {
    const char* words;
    ExperimentEdit edit;
    std::function<void(Experiment&)> change;
};

std::vector<Case> cases() {
    const auto all = EditScope::All;
    return {
        {"target of “bunny”",
         {EditKind::Targets, 1, EditScope::Targets, Page::Targets},
         [](Experiment& e) { e.objects[1].target_K += 1.0; }},
        {"targets",
         {EditKind::Targets, -1, EditScope::Targets, Page::Targets},
         [](Experiment& e) { e.objects[0].target_K += 1.0, e.objects[2].target_K += 1.0; }},
        {"controller and gains",
         {EditKind::Controller, -1, EditScope::Controller, Page::Run},
         [](Experiment& e) { e.controller.levelServo.timeConstant_s *= 2.0; }},
        {"markers",
         {EditKind::Markers, -1, EditScope::Vision, Page::Calibrate},
         [](Experiment& e) { e.vision.markers.push_back({}); }},
        {"calibration of the camera",
         {EditKind::CameraLens, -1, EditScope::Vision, Page::Calibrate},
         [](Experiment& e) {
             e.vision.camera = CameraModel(), e.vision.cameraDate = "2026-11-22T10:00:00Z";
         }},
        {"place of the camera",
         {EditKind::CameraPlace, -1, EditScope::Vision, Page::Calibrate},
         [](Experiment& e) { e.vision.cameraPose = Vector6d::Ones(); }},
        {"calibration",
         {EditKind::Vision, -1, EditScope::Vision, Page::Calibrate},
         [](Experiment& e) { e.vision.cameraPose = Vector6d::Ones(), e.vision.dictionary = "5X5_50"; }},
        {"calibration of the thermal camera",
         {EditKind::ThermalCamera, -1, all, Page::Calibrate},
         [](Experiment& e) { calibrateThermalCamera(e, measuredThermal()); }},
        {"place of the source",
         {EditKind::SourcePlace, -1, all, Page::Calibrate},
         [](Experiment& e) { e.source.pose[kX] += 0.001, e.vision.sourcePoseDate = "2026-11-22T10:00:00Z"; }},
        {"following of the source",
         {EditKind::Following, -1, all, Page::Calibrate},
         [](Experiment& e) { e.source.tracked = true; }},
        {"start of runs",
         {EditKind::Start, -1, all, Page::Targets},
         [](Experiment& e) { e.start[kZ] += 0.01; }},
        {"set point of the source",
         {EditKind::SetPoint, -1, all, Page::Rig},
         [](Experiment& e) { e.source.temperature_K += 1.0; }},
        {"emittance of the source",
         {EditKind::Emittance, -1, all, Page::Rig},
         [](Experiment& e) { e.source.emittance = 0.5; }},
        {"workspace",
         {EditKind::Workspace, -1, all, Page::Rig},
         [](Experiment& e) { e.robot.upper[kZ] += 0.01; }},
        {"limits of motion",
         {EditKind::MotionLimits, -1, all, Page::Rig},
         [](Experiment& e) { e.robot.maxSpeed_m_s *= 0.5; }},
        {"safety limits",
         {EditKind::Safety, -1, all, Page::Rig},
         [](Experiment& e) { e.safety.trip_K -= 1.0; }},
        {"choice of the real rig",
         {EditKind::Rig, -1, all, Page::Rig},
         [](Experiment& e) { e.rig.emplace(); }},
        {"move of “hand”",
         {EditKind::Mounting, 2, all, Page::Objects},
         [](Experiment& e) { e.objects[2].mounting[kX] += 0.001; }},
        {"renaming of “hand”",
         {EditKind::Name, 2, all, Page::Objects},
         [](Experiment& e) { e.objects[2].name = "paw"; }},
        {"start values",
         {EditKind::StartValues, -1, all, Page::Objects},
         [](Experiment& e) {
             e.objects[0].estimatedRates = HeatRates{0.2, 2e-11, 0.16};
             e.objects[1].estimatedRates = HeatRates{0.2, 2e-11, 0.16};
         }},
        {"material of “circle”",
         {EditKind::Material, 0, all, Page::Objects},
         [](Experiment& e) { e.objects[0].material.emittance = 0.5; }},
        {"outline of “bunny”",
         {EditKind::Outline, 1, all, Page::Objects},
         [](Experiment& e) { e.objects[1].shape = Disk{0.01}, e.objects[1].origin = {}; }},
        {"air in the room",
         {EditKind::Air, -1, all, Page::Objects},
         [](Experiment& e) { e.air.convection_W_m2K = 8.0; }},
        {"change of “bunny”",
         {EditKind::Object, 1, all, Page::Objects},
         [](Experiment& e) { e.objects[1].target_K += 1.0, e.objects[1].name = "hare"; }},
        {"addition of “disk”",
         {EditKind::ObjectAdded, 3, all, Page::Objects},
         [](Experiment& e) {
             e.objects.push_back(e.objects[0]);
             e.objects.back().name = "disk";
             e.rig.emplace(); // its channels follow the objects
         }},
        {"removal of “bunny”",
         {EditKind::ObjectRemoved, 1, all, Page::Objects},
         [](Experiment& e) { e.objects.erase(e.objects.begin() + 1); }},
        {"change of the experiment",
         {},
         [](Experiment& e) { e.title = "other", e.robot.clearance_m *= 2.0; }},
    };
}

// Catches an edit that is told as another one, undone on another page, or sent to the engine as more or less
// than it is: a kind that includes too much would leave the engine with the old value of the rest.
TEST(ExperimentEdit, IsWhatDiffers) {
    std::set<EditKind> kinds;
    for (const Case& each : cases()) {
        SCOPED_TRACE(each.words);
        Experiment after = example();
        each.change(after);
        const ExperimentEdit edit = compared(example(), after);
        EXPECT_EQ(edit, each.edit);
        EXPECT_EQ(editWords(edit, example(), after).toStdString(), each.words);
        kinds.insert(edit.kind);
        const ExperimentEdit back = compared(after, example());
        EXPECT_EQ(back.scope, edit.scope);
        EXPECT_EQ(back.page, edit.page);
    }
    EXPECT_EQ(kinds.size(), static_cast<std::size_t>(EditKind::Other) + 1) << "a kind without a case";
}

// Catches a choice of camera told as its calibration, a calibration told as a change of devices, and one of
// the rig that is taken for the simulated camera's.
TEST(ExperimentEdit, ACalibratedThermalCameraIsNoOtherCamera) {
    const auto kind = [](const Experiment& before, const Experiment& after) {
        EXPECT_EQ(compared(before, after).kind, compared(after, before).kind);
        return compared(before, after).kind;
    };
    const Experiment& none = example();
    Experiment simulated = none;
    simulated.simulation.thermalCamera.emplace().profile = "lepton-3.5";
    EXPECT_EQ(kind(none, simulated), EditKind::Other);
    Experiment calibrated = simulated;
    calibrateThermalCamera(calibrated, measuredThermal());
    EXPECT_EQ(kind(simulated, calibrated), EditKind::ThermalCamera);
    EXPECT_EQ(kind(none, calibrated), EditKind::Other);

    Experiment real = calibrated;
    ThermalCameraSpec& camera = real.rig.emplace().thermalCamera.emplace();
    camera.device = "0";
    Experiment measured = real;
    calibrateThermalCamera(measured, measuredThermal());
    EXPECT_EQ(kind(real, measured), EditKind::ThermalCamera);
    EXPECT_EQ(editWords(compared(real, measured), real, measured), "calibration of the thermal camera");
    measured.rig->thermalCamera->device = "1";
    EXPECT_EQ(kind(real, measured), EditKind::Rig);
    measured.rig->thermalCamera.reset();
    EXPECT_EQ(kind(real, measured), EditKind::Rig);
    EXPECT_EQ(kind(calibrated, real), EditKind::Rig); // the choice of the real rig
}

// Catches a narrow command for an edit that changes more than it tells: whatever else changes, the engine
// must get the whole experiment.
TEST(ExperimentEdit, TwoThingsAtOnceAreTheWholeExperiment) {
    const auto all = cases();
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            if (all[i].edit.scope == all[k].edit.scope && all[i].edit.scope != EditScope::All)
                continue;
            Experiment after = example();
            all[k].change(after);
            if (after.objects.size() < 3)
                continue;
            all[i].change(after);
            EXPECT_EQ(compared(example(), after).scope, EditScope::All)
                << all[k].words << ", " << all[i].words;
        }
    }
}

} // namespace
} // namespace bask::test
