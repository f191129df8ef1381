#pragma once
// The 3-D scene of a run: source, workspace, objects at their pose, and trajectories coloured by temperature.

#include "engine/base/units.h"
#include "engine/devices/device.h"
#include "engine/model/experiment.h"
#include "engine/model/predicted_run.h"
#include "engine/model/trace.h"

#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

namespace bask {

/// Setters in, a picture out; R axes in cm, heated faces look down. Setters only note what is new: frames are
/// drawn later, at most about 15 a second, none while hidden and none for what is shown already. Without
/// OpenGL 3.2 it says so in words in place of the picture. Colours follow the palette, words the language.
class SceneView : public QWidget {
    Q_OBJECT
public:
    explicit SceneView(QWidget* parent = nullptr);
    ~SceneView() override;

    /// Shows another experiment with its objects at the start pose, without a trace.
    void setExperiment(const Experiment& experiment);
    /// Forgets the trajectories and the temperatures; the pose stays.
    void clearTrace();
    /// Adds to the trajectories; pose and temperatures become those of the last sample. A sample with another
    /// number of objects than the experiment is ignored.
    void appendSamples(const std::vector<TraceSample>& samples);
    /// Sets the whole trace at once.
    void setSamples(const std::vector<TraceSample>& samples);
    /// Shows the paths that the objects' centres are predicted to take, dashed, and dimmer beside a trace,
    /// with a cross where the run settles. One without samples removes them, as setExperiment() does;
    /// clearTrace() does not.
    void setPlan(const PredictedRun& run);
    /// Moves the objects only (readings outside of a run, replay).
    void setPose(const Vector6d& coordinates);
    /// Moves the source only, X_RS in the robot's base; a trace's samples move it too.
    void setSourcePose(const Vector6d& coordinates);
    /// Sets the temperature shown beside the source, K; a trace's samples set it too. NaN if not known. It is
    /// drawn from grey in the cold to incandescent at its highest set point, at least half as bright when it
    /// is too hot for a hand; what is not known to be cold looks hot.
    void setSourceTemperature_K(double source_K);
    /// Sets whether the source is heated; none if that is not told, as of a recorded run or of a source that
    /// a person heats: its rim looks hot.
    void setSourceHeat(std::optional<HeatState> heat);
    /// Colours the objects only, K in the experiment's order; NaN or missing if not known.
    void setTemperatures(const std::vector<double>& temperatures_K);
    void setTemperatureUnit(TemperatureUnit unit);

    void viewAlongMinusZ(); ///< from above: x to the right, y up
    void viewAlongX();      ///< from the side: y to the left, z up
    void viewIsometric();

    /// Whether there is a picture at all.
    bool hasPicture() const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void makePicture();
    void showNotice();
    void prepareFrame();
    void fit();
    void requestFrame();
    void moveTo(Pose& pose, const Vector6d& coordinates);

    struct Impl;
    std::unique_ptr<Impl> m;
};

} // namespace bask
