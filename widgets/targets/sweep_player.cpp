#include "widgets/targets/sweep_player.h"

#include <utility>

namespace bask {

SweepPlayer::SweepPlayer(TargetScene& scene, QObject* parent) : QObject(parent), m_sequence(scene) {
    connect(&m_sequence, &SceneSequence::shown, this, [this](int index) {
        if (!isPlaying())
            return; // back to where it was, after saving
        m_shown = index;
        emit shown(m_fixed.at(static_cast<std::size_t>(index)));
    });
    connect(&m_sequence, &SceneSequence::progressed, this, &SweepPlayer::progressed);
    connect(&m_sequence, &SceneSequence::saved, this, [this](const Error& problem) {
        m_doing = Doing::Nothing;
        emit saved(problem);
    });
}

void SweepPlayer::play(Sweep sweep) {
    if (!isPlaying())
        m_shown = 0;
    m_doing = Doing::Play;
    compute(std::move(sweep), [this] {
        m_sequence.show(m_shown);
        m_sequence.play(true);
    });
}

void SweepPlayer::save(Sweep sweep, const QString& folder, QSize size) {
    m_sequence.play(false);
    m_doing = Doing::Save;
    emit progressed(0, static_cast<int>(sweep.values.size()));
    compute(std::move(sweep), [this, folder, size] { m_sequence.save(folder, size); });
}

void SweepPlayer::stop() {
    m_job.forget();
    m_doing = Doing::Nothing;
    m_sequence.play(false);
    if (m_sequence.isSaving())
        m_sequence.cancel();
}

void SweepPlayer::compute(Sweep sweep, std::function<void()> then) {
    const PoseSubset subset = sweep.subset;
    const Coordinate varied = sweep.varied;
    m_job.run(
        [sweep = std::move(sweep)](const std::stop_token& stop) {
            return targetSweep(sweep.geometry, sweep.varied, sweep.values, sweep.viewFactors, stop);
        },
        [this, subset, varied, then = std::move(then)](Result<std::vector<SurfaceFrame>> frames) {
            if (!frames) {
                const bool saving = isSaving();
                stop();
                return saving ? emit saved(frames.error()) : emit failed(frames.error());
            }
            m_fixed.clear();
            for (const SurfaceFrame& frame : *frames)
                m_fixed.push_back(frame.fixed);
            m_sequence.setFrames(std::move(*frames), subset, varied);
            then();
        });
}

} // namespace bask
