#pragma once
// Surfaces for several values of a fixed coordinate: computed, then played in the scene or saved as pictures.

#include "engine/base/result.h"
#include "engine/exchange/target_surfaces.h"
#include "widgets/common/latest_job.h"
#include "widgets/scene/scene_sequence.h"

#include <QObject>
#include <QSize>
#include <QString>

#include <vector>

namespace bask {

/// An animation: nine panels, as in the paper.
struct Sweep {
    static constexpr int kFrames = 9;

    TargetGeometry geometry;
    PoseSubset subset = PoseSubset::Translation;
    Coordinate varied = kThetaX;
    std::vector<double> values;
    std::vector<double> viewFactors;
};

/// Frames are computed off the GUI thread. A later call replaces an earlier one. The scene must outlive it.
class SweepPlayer : public QObject {
    Q_OBJECT

public:
    SweepPlayer(TargetScene& scene, QObject* parent);

    /// Plays in a loop as soon as the frames are ready; if another one is playing, it continues until then,
    /// and the new one starts at the same frame.
    void play(Sweep sweep);
    void save(Sweep sweep, const QString& folder, QSize size);
    /// Stops playing or saving, also before its end.
    void stop();

    bool isPlaying() const { return m_doing == Doing::Play; }
    bool isSaving() const { return m_doing == Doing::Save; }

signals:
    /// A frame is shown in the scene.
    void shown(const bask::Vector6d& fixed);
    /// Progress of save(): number of frames written; 0 while surfaces are computed.
    void progressed(int done, int of);
    /// save() has ended; `problem` has no code if there was no error.
    void saved(const bask::Error& problem);
    /// There are no frames to play.
    void failed(const bask::Error& problem);

private:
    enum class Doing { Nothing, Play, Save };
    void compute(Sweep sweep, std::function<void()> then);

    SceneSequence m_sequence;
    std::vector<Vector6d> m_fixed; ///< fixed coordinates of each frame
    int m_shown = 0;
    Doing m_doing = Doing::Nothing;
    LatestJob<Result<std::vector<SurfaceFrame>>> m_job;
};

} // namespace bask
