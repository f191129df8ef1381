#pragma once
// A fourth variable as an animation of the target scene, and its export as pictures.

#include "engine/exchange/target_surfaces.h"
#include "widgets/scene/target_scene.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <vector>

namespace bask {

/// Shows frames in a scene one after another, over and over, or writes them: a PNG each and a sheet of all of
/// them side by side. One frame a turn of the event loop, so that the window answers meanwhile. The scene
/// must outlive it.
class SceneSequence : public QObject {
    Q_OBJECT
public:
    static constexpr int kFrameTime_ms = 400;

    explicit SceneSequence(TargetScene& scene, QObject* parent = nullptr);

    /// Surfaces over `subset`; `varied` is the held coordinate that tells the frames apart. Stops everything.
    void setFrames(std::vector<SurfaceFrame> frames, PoseSubset subset, Coordinate varied);
    int count() const { return static_cast<int>(m_frames.size()); }
    /// "θx = 22.5°", "z = 5.0 cm".
    QString caption(int index) const;

    void show(int index);
    void play(bool on);
    bool isPlaying() const { return m_player.isActive(); }

    /// Writes frame-1.png ... and panels.png, three to a row, all with their captions, into the folder, which
    /// must be there. Ends with saved(); replaces an earlier export, but refuses to replace other files.
    void save(const QString& folder, QSize size);
    /// Ends a save() half-way, without saved(); pictures written so far stay.
    void cancel();
    bool isSaving() const { return m_saver.isActive(); }

signals:
    void shown(int index);
    void progressed(int done, int of);
    /// Where nothing went wrong, `problem` has no code.
    void saved(const bask::Error& problem);

private:
    void saveNext();
    void finish(const Error& problem);

    TargetScene& m_scene;
    std::vector<SurfaceFrame> m_frames;
    PoseSubset m_subset = PoseSubset::Translation;
    Coordinate m_varied = kThetaX;
    int m_shown = 0;
    QTimer m_player;
    QTimer m_saver;
    QString m_folder;
    QSize m_size;
    std::vector<QImage> m_pictures;
};

/// The picture with a caption at the middle of its upper edge, over whatever is there.
QImage captioned(QImage picture, const QString& caption, const QPalette& palette, const QFont& font);

/// Pictures side by side in rows, each with its caption above, in the palette's colours; each keeps its size.
QImage pictureSheet(const std::vector<QImage>& pictures, const QStringList& captions, int columns,
                    const QPalette& palette, const QFont& font);

} // namespace bask
