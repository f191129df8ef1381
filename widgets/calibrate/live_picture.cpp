#include "widgets/calibrate/live_picture.h"

#include "engine/base/clock.h"
#include "engine/base/message_code.h"
#include "widgets/calibrate/live_overlay.h"
#include "widgets/common/display.h"
#include "widgets/common/picture_painting.h"
#include "widgets/common/theme.h"

#include <QEvent>
#include <QImage>
#include <QLocale>
#include <QPainter>

#include <algorithm>

namespace bask {
namespace {

constexpr double kGap = 6.0;

QString localNumber(double value, int decimals) {
    return QLocale().toString(value, 'f', decimals);
}

QImage imageOf(const GreyPicture& picture) {
    return QImage(picture.values.data(), picture.width, picture.height, picture.width,
                  QImage::Format_Grayscale8);
}

} // namespace

LivePicture::LivePicture(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    retranslate();
}

void LivePicture::setView(const VisionView& view) {
    m_view = view;
    m_age_s = view.frame ? SteadyClock().now_s() - view.frame->caught_s : 0.0;
    retranslate();
    update();
}

void LivePicture::setCamera(const std::optional<CameraModel>& camera) {
    m_camera = camera;
    update();
}

void LivePicture::setBoard(const std::optional<Board>& board) {
    m_board = board;
    update();
}

void LivePicture::setHeatMap(const std::optional<HeatMap>& map) {
    m_heatMap = map;
    update();
}

QString LivePicture::sentence() const {
    if (m_view.problem.code != MessageCode::None)
        return sentenceText(m_view.problem);
    return m_view.frame ? QString() : tr("No picture yet: no camera is running.");
}

QString LivePicture::statusText() const {
    if (!m_view.frame)
        return {};
    QStringList words;
    if (!m_view.cameraName.empty())
        words << (m_view.cameraName == "simulated" ? tr("simulated")
                                                   : QString::fromStdString(m_view.cameraName));
    const GreyPicture& picture = m_view.frame->picture;
    words << tr("%1 \u00d7 %2").arg(picture.width).arg(picture.height);
    if (m_view.problem.code == MessageCode::None) {
        words << tr("%1 pictures/s").arg(localNumber(m_view.rate_Hz, 1));
        words << tr("latency %1 ms").arg(localNumber(1000.0 * m_view.latency_s, 0));
    }
    words << tr("age %1 s").arg(localNumber(m_age_s, m_age_s < 1.0 ? 2 : 1));
    if (m_view.tracking && m_view.problem.code == MessageCode::None)
        words << (*m_view.tracking == TrackState::Tracking     ? tr("source tracked")
                  : *m_view.tracking == TrackState::Predicting ? tr("source predicted")
                                                               : tr("source searched"));
    return words.join(QStringLiteral("  \u00b7  "));
}

QString LivePicture::foundText() const {
    QStringList words;
    for (const ViewedMarker& viewed : m_view.markers)
        words << (viewed.part ? tr("marker %1, %2").arg(viewed.marker.id).arg(partWord(*viewed.part))
                              : tr("marker %1").arg(viewed.marker.id));
    if (m_view.board && m_view.board->ok())
        words << tr("the board");
    return words.isEmpty() ? tr("Nothing is found in the picture") : words.join(QStringLiteral("; "));
}

void LivePicture::retranslate() {
    const QString over = sentence();
    setAccessibleName(tr("Live picture of the camera"));
    if (const QString description = over.isEmpty() ? foundText() : over;
        description != accessibleDescription())
        setAccessibleDescription(description);
}

void LivePicture::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
        update();
    QWidget::changeEvent(event);
}

// Fitted into the room above the status line.
QRectF LivePicture::pictureRect() const {
    const QRectF room = QRectF(rect()).adjusted(0.0, 0.0, 0.0, -fontMetrics().height() - kGap);
    if (!m_view.frame || m_view.frame->picture.width < 1 || m_view.frame->picture.height < 1)
        return room;
    QSizeF size(m_view.frame->picture.width, m_view.frame->picture.height);
    size.scale(room.size(), Qt::KeepAspectRatio);
    return QRectF(QPointF(room.center().x() - 0.5 * size.width(), room.top()), size);
}

void LivePicture::paintFound(QPainter& painter, const QRectF& place) const {
    const GreyPicture& picture = m_view.frame->picture;
    const double scale = place.width() / picture.width;
    QTransform map = QTransform::fromTranslate(place.left(), place.top());
    map.scale(scale, scale).translate(0.5, 0.5);
    const OverlayPlace overlay{map, place};
    painter.setClipRect(place);
    if (m_heatMap)
        paintHeatMap(painter, overlay, *m_heatMap);
    if (m_view.board && m_view.board->ok())
        paintBoard(painter, overlay, **m_view.board, m_board ? squareColumns(*m_board) - 1 : 1);
    paintMarkers(painter, overlay, m_view.markers, m_camera);
    constexpr double kSourceAxes_m = 0.05;
    if (m_view.source && m_camera)
        bask::paintAxes(painter, overlay, m_view.source->X_CP, kSourceAxes_m, *m_camera,
                        m_view.source->isAmbiguous || m_view.tracking == TrackState::Predicting);
    painter.setClipping(false);
}

void LivePicture::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const QRectF place = pictureRect();
    if (m_view.frame) {
        painter.setRenderHint(QPainter::SmoothPixmapTransform, place.width() != m_view.frame->picture.width);
        painter.drawImage(place, imageOf(m_view.frame->picture));
    } else {
        painter.fillRect(place, palette().color(QPalette::Base));
    }
    painter.setRenderHint(QPainter::Antialiasing);
    if (m_view.frame && m_view.problem.code == MessageCode::None)
        paintFound(painter, place);
    if (const QString over = sentence(); !over.isEmpty()) {
        if (m_view.frame)
            paintDimmed(painter, place);
        paintNotice(painter, place, over, m_view.problem.code != MessageCode::None, *this);
    }
    painter.setPen(secondaryText(isDark(this)));
    const QRectF line(place.left() + 2.0, place.bottom() + kGap, place.width() - 4.0, fontMetrics().height());
    painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter,
                     fontMetrics().elidedText(statusText(), Qt::ElideRight, static_cast<int>(line.width())));
}

} // namespace bask
