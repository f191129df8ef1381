#include "widgets/scene/scene_sequence.h"

#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "widgets/common/display.h"
#include "widgets/common/marked_picture.h"

#include <QDir>
#include <QFileInfo>
#include <QFontMetrics>
#include <QPainter>
#include <QPalette>

#include <algorithm>
#include <array>

namespace bask {

namespace {

constexpr int kColumns = 3;
const QString kMark = QStringLiteral("Surfaces of an experiment's targets");

QString framePath(const QString& folder, int index) {
    return QDir(folder).filePath(QStringLiteral("frame-%1.png").arg(index + 1));
}

/// A file is there that is no earlier export.
bool isForeign(const QString& path) {
    return QFileInfo(path).size() > 0 && !isMarkedPicture(path, kMark);
}

QFont captionFont(const QImage& picture, QFont font) {
    font.setBold(true);
    font.setPixelSize(std::max(12, picture.height() / 30));
    return font;
}

} // namespace

QString SceneSequence::sheetPath(const QString& folder) {
    return QDir(folder).filePath(QStringLiteral("panels.png"));
}

SceneSequence::SceneSequence(TargetScene& scene, QObject* parent) : QObject(parent), m_scene(scene) {
    m_player.setInterval(kFrameTime_ms);
    connect(&m_player, &QTimer::timeout, this, [this] { show((m_shown + 1) % std::max(1, count())); });
    connect(&m_saver, &QTimer::timeout, this, &SceneSequence::saveNext);
}

void SceneSequence::setFrames(std::vector<SurfaceFrame> frames, PoseSubset subset, Coordinate varied) {
    m_player.stop();
    m_saver.stop();
    m_frames = std::move(frames);
    m_subset = subset;
    m_varied = varied;
    m_shown = 0;
}

QString SceneSequence::caption(int index) const {
    static constexpr std::array<const char*, 6> kNames{"x", "y", "z", "θx", "θy", "θz"};
    const double value = m_frames.at(static_cast<std::size_t>(index)).fixed[m_varied];
    const bool turns = m_varied >= kThetaX;
    return QStringLiteral("%1 = %2%3")
        .arg(QString::fromUtf8(kNames[m_varied]),
             formatSigned(turns ? degFromRad(value) : 100.0 * value, 1).remove(u'+'),
             turns ? QStringLiteral("°") : QStringLiteral(" cm"));
}

void SceneSequence::show(int index) {
    if (index < 0 || index >= count())
        return;
    m_shown = index;
    const SurfaceFrame& frame = m_frames[static_cast<std::size_t>(index)];
    m_scene.setSurfaces(frame.surfaces, frame.fixed, m_subset);
    emit shown(index);
}

void SceneSequence::play(bool on) {
    if (on && count() > 1)
        m_player.start();
    else
        m_player.stop();
}

void SceneSequence::save(const QString& folder, QSize size) {
    m_player.stop();
    m_folder = folder;
    m_size = size;
    m_pictures.clear();
    QStringList paths{sheetPath(folder)};
    for (int i = 0; i < count(); ++i)
        paths << framePath(folder, i);
    for (const QString& path : paths)
        if (isForeign(path))
            return finish(Error(MessageCode::ExportForeign, path.toStdString()));
    m_saver.start(0);
}

void SceneSequence::saveNext() {
    const int index = static_cast<int>(m_pictures.size());
    if (index == count()) {
        QStringList captions;
        for (int i = 0; i < count(); ++i)
            captions << caption(i);
        const QString path = sheetPath(m_folder);
        QImage sheet = pictureSheet(m_pictures, captions, kColumns, m_scene.palette(), m_scene.font());
        markPicture(sheet, kMark);
        finish(!sheet.isNull() && sheet.save(path, "PNG")
                   ? Error()
                   : Error(MessageCode::FileUnwritable, path.toStdString(), {"it cannot be written"}));
        return;
    }
    const SurfaceFrame& frame = m_frames[static_cast<std::size_t>(index)];
    m_scene.setSurfaces(frame.surfaces, frame.fixed, m_subset);
    const QString path = framePath(m_folder, index);
    m_pictures.push_back(m_scene.image(m_size));
    QImage frameWithCaption = captioned(m_pictures.back(), caption(index), m_scene.palette(), m_scene.font());
    markPicture(frameWithCaption, kMark);
    if (!frameWithCaption.save(path, "PNG")) {
        finish(Error(MessageCode::FileUnwritable, path.toStdString(), {"it cannot be written"}));
        return;
    }
    emit progressed(index + 1, count());
}

void SceneSequence::cancel() {
    m_saver.stop();
    m_pictures.clear();
    show(m_shown);
}

void SceneSequence::finish(const Error& problem) {
    cancel();
    emit saved(problem);
}

QImage captioned(QImage picture, const QString& caption, const QPalette& palette, const QFont& font) {
    if (picture.isNull())
        return picture;
    const QFont bold = captionFont(picture, font);
    QPainter painter(&picture);
    painter.setFont(bold);
    painter.setPen(palette.color(QPalette::Text));
    painter.drawText(QRectF(QPointF(), QSizeF(picture.width() / picture.devicePixelRatio(),
                                              QFontMetrics(bold).height() * 1.5)),
                     Qt::AlignCenter, caption);
    return picture;
}

QImage pictureSheet(const std::vector<QImage>& pictures, const QStringList& captions, int columns,
                    const QPalette& palette, const QFont& font) {
    if (pictures.empty() || columns < 1)
        return {};
    const QFont bold = captionFont(pictures.front(), font);
    const int line = QFontMetrics(bold).height() * 3 / 2;
    const QSize panel = pictures.front().size() / pictures.front().devicePixelRatio() + QSize(0, line);
    const int count = static_cast<int>(pictures.size());
    const int rows = (count + columns - 1) / columns;
    QImage sheet(std::min(columns, count) * panel.width(), rows * panel.height(), QImage::Format_RGB32);
    sheet.fill(palette.color(QPalette::Base));
    QPainter painter(&sheet);
    painter.setFont(bold);
    painter.setPen(palette.color(QPalette::Text));
    for (int i = 0; i < count; ++i) {
        const QPoint corner(i % columns * panel.width(), i / columns * panel.height());
        painter.drawText(QRect(corner, QSize(panel.width(), line)), Qt::AlignCenter, captions.value(i));
        painter.drawImage(QRect(corner + QPoint(0, line), panel - QSize(0, line)),
                          pictures[static_cast<std::size_t>(i)]);
    }
    return sheet;
}

} // namespace bask
