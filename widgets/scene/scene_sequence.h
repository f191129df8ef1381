#pragma once
// A fourth variable as an animation of the target scene, and its export as pictures.

#include "engine/exchange/target_surfaces.h"
#include "widgets/scene/target_scene.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <vector>

namespace bask {

/// Shows frames in a scene one after another in a loop, or saves them: one PNG each, and a sheet with all of
/// them side by side. One frame in each turn of the event loop, so that the window stays responsive. The
/// scene must outlive it.
class SceneSequence : public QObject {
    Q_OBJECT
public:
    static constexpr int kFrameTime_ms = 400;

    explicit SceneSequence(TargetScene& scene, QObject* parent = nullptr);

    /// Sets the surfaces over `subset`; `varied` is the fixed coordinate that differs between the frames.
    /// Stops everything.
    void setFrames(std::vector<SurfaceFrame> frames, PoseSubset subset, Coordinate varied);
    int count() const { return static_cast<int>(m_frames.size()); }
    /// "θx = 22.5°", "z = 5.0 cm".
    QString caption(int index) const;

    void show(int index);
    void play(bool on);
    bool isPlaying() const { return m_player.isActive(); }

    /// Writes frame-1.png ... and panels.png, three in a row, all with their captions, into the folder, which
    /// must exist. Ends with saved(). Replaces an earlier export, but refuses to replace other files.
    void save(const QString& folder, QSize size);
    static QString sheetPath(const QString& folder); ///< of panels.png
    /// Cancels a save() without saved(); pictures already written stay.
    void cancel();
    bool isSaving() const { return m_saver.isActive(); }

signals:
    void shown(int index);
    void progressed(int done, int of);
    /// `problem` has no code if there was no error.
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

/// Returns the picture with a caption at the middle of its upper edge, drawn over the picture.
QImage captioned(QImage picture, const QString& caption, const QPalette& palette, const QFont& font);

/// Returns the pictures side by side in rows, each in its size with its caption above, in the palette's
/// colours.
QImage pictureSheet(const std::vector<QImage>& pictures, const QStringList& captions, int columns,
                    const QPalette& palette, const QFont& font);

} // namespace bask
