#pragma once
// Surfaces for several values of what is held: computed, then played in the scene or written as pictures.

#include "engine/base/result.h"
#include "engine/exchange/target_surfaces.h"
#include "widgets/common/latest_job.h"
#include "widgets/scene/scene_sequence.h"

#include <QObject>
#include <QSize>
#include <QString>

#include <vector>

namespace bask {

/// What is played: nine panels, as in the paper.
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

    /// Plays round and round as soon as the frames are there; while one plays already, it goes on until then
    /// and the new one takes over at its frame.
    void play(Sweep sweep);
    void save(Sweep sweep, const QString& folder, QSize size);
    /// Ends either, half-way too.
    void stop();

    bool isPlaying() const { return m_doing == Doing::Play; }
    bool isSaving() const { return m_doing == Doing::Save; }

signals:
    /// A frame is in the scene.
    void shown(const bask::Vector6d& fixed);
    /// Of save(): frames written; none yet while surfaces are computed.
    void progressed(int done, int of);
    /// save() is done: without a code in `problem`, all went well.
    void saved(const bask::Error& problem);
    /// There are no frames to play.
    void failed(const bask::Error& problem);

private:
    enum class Doing { Nothing, Play, Save };
    void compute(Sweep sweep, std::function<void()> then);

    SceneSequence m_sequence;
    std::vector<Vector6d> m_fixed; ///< of each frame
    int m_shown = 0;
    Doing m_doing = Doing::Nothing;
    LatestJob<Result<std::vector<SurfaceFrame>>> m_job;
};

} // namespace bask
