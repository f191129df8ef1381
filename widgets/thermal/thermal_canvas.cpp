#include "widgets/thermal/thermal_canvas.h"

#include "widgets/common/display.h"
#include "widgets/common/picture_painting.h"
#include "widgets/common/theme.h"
#include "widgets/thermal/thermal_zoom.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QToolTip>

#include <algorithm>
#include <cmath>
#include <utility>

namespace bask {

ThermalCanvas::ThermalCanvas(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("thermalCanvas"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    describe();
}

void ThermalCanvas::setView(const ThermalView& view) {
    m_view = view;
    m_image.reset();
    m_scaled = {};
    const auto isInside = [&view](const std::optional<QPoint>& pixel) {
        return pixel && hasPicture(view) &&
               QRect(0, 0, view.picture->width, view.picture->height).contains(*pixel);
    };
    if (!isInside(m_pinned))
        m_pinned.reset();
    if (!isInside(m_hovered))
        m_hovered.reset();
    choosePixels();
    describe();
    update();
}

void ThermalCanvas::setNames(const std::vector<QString>& names) {
    m_names = names;
    update();
}

void ThermalCanvas::setTemperatureUnit(TemperatureUnit unit) {
    m_unit = unit;
    describe();
    update();
}

void ThermalCanvas::setLook(const ThermalLook& look) {
    if (look == m_look)
        return;
    m_look = look;
    m_image.reset();
    m_scaled = {};
    update();
}

void ThermalCanvas::setSmooth(bool smooth) {
    if (std::exchange(m_isSmooth, smooth) == smooth)
        return;
    m_scaled = {};
    update();
}

void ThermalCanvas::setZoomed(bool zoomed) {
    if (std::exchange(m_isZoomed, zoomed) == zoomed)
        return;
    m_pixels = {};
    choosePixels();
    update();
}

void ThermalCanvas::choosePixels() {
    const QRect before = m_pixels;
    if (!hasPicture(m_view))
        m_pixels = {};
    else
        m_pixels = m_isZoomed ? zoomedPixels(m_view, m_pixels)
                              : QRect(0, 0, m_view.picture->width, m_view.picture->height);
    if (m_pixels != before)
        m_scaled = {};
}

void ThermalCanvas::setChosen(std::optional<std::size_t> object) {
    m_chosen = object;
    update();
}

void ThermalCanvas::setNotice(const QString& sentence, bool isProblem) {
    m_isProblem = isProblem;
    if (std::exchange(m_notice, sentence) == sentence)
        return;
    describe();
    update();
}

const ThermalImage& ThermalCanvas::prepared() const {
    if (!m_image)
        m_image = hasPicture(m_view) ? thermalImage(*m_view.picture, m_look) : ThermalImage{};
    return *m_image;
}

QSizeF ThermalCanvas::shownSize(const QSizeF& room) const {
    const QSizeF pixels = m_pixels.size();
    double scale = std::min(room.width() / pixels.width(), room.height() / pixels.height());
    if (const double whole = std::floor(scale * devicePixelRatioF()); !m_isSmooth && whole >= 1.0)
        scale = whole / devicePixelRatioF();
    return {std::max(1.0, std::round(scale * pixels.width())),
            std::max(1.0, std::round(scale * pixels.height()))};
}

QRectF ThermalCanvas::pictureRect() const {
    const QRectF room = rect();
    if (!hasPicture(m_view))
        return room;
    const double besides = barWidth();
    const QSizeF size = shownSize(room.adjusted(0.0, 0.0, -besides, 0.0).size());
    return {std::floor(0.5 * (room.width() - size.width() - besides)), 0.0, size.width(), size.height()};
}

int ThermalCanvas::widthFor(int height) const {
    if (!hasPicture(m_view))
        return sizeHint().width();
    return static_cast<int>(
        std::ceil(static_cast<double>(height) * m_pixels.width() / m_pixels.height() + barWidth()));
}

QTransform ThermalCanvas::fromPixels() const {
    const QRectF place = pictureRect();
    return QTransform::fromTranslate(place.left(), place.top())
        .scale(place.width() / m_pixels.width(), place.height() / m_pixels.height())
        .translate(0.5 - m_pixels.left(), 0.5 - m_pixels.top());
}

QRectF ThermalCanvas::pixelRect(QPoint pixel) const {
    return fromPixels().mapRect(QRectF(pixel.x() - 0.5, pixel.y() - 0.5, 1.0, 1.0));
}

std::optional<QPoint> ThermalCanvas::pixelAt(QPointF position) const {
    const QRectF place = pictureRect();
    if (!hasPicture(m_view) || !place.contains(position))
        return std::nullopt;
    const auto along = [](double offset, double length, int count) {
        return std::min(count - 1, static_cast<int>(offset / length * count));
    };
    return m_pixels.topLeft() + QPoint(along(position.x() - place.left(), place.width(), m_pixels.width()),
                                       along(position.y() - place.top(), place.height(), m_pixels.height()));
}

QPolygonF ThermalCanvas::outlineOf(std::size_t object) const {
    QPolygonF out;
    for (const Eigen::Vector2d& point : m_view.objects[object].outline_px)
        out << QPointF(point.x(), point.y());
    if (!out.isEmpty() && !out.isClosed())
        out << out.front();
    return out;
}

QString ThermalCanvas::nameOf(std::size_t object) const {
    return object < m_names.size() ? m_names[object] : QString::number(object + 1);
}

QString ThermalCanvas::labelOf(std::size_t object, bool isShort) const {
    const ThermalObjectView& view = m_view.objects[object];
    const QString value = !view.T_K ? QString(kNoValue)
                          : isShort ? formatTemperature(*view.T_K, m_unit)
                                    : formatReading(*view.T_K, view.uncertainty_K, m_unit);
    return nameOf(object) + QStringLiteral("  ") + value;
}

QString ThermalCanvas::pixelText(QPoint pixel) const {
    const double T_K = m_view.picture->at(pixel.x(), pixel.y());
    if (std::isfinite(T_K))
        return formatTemperature(T_K, m_unit);
    return std::isnan(T_K) ? tr("no value") : T_K > 0.0 ? tr("saturated") : tr("below range");
}

std::optional<std::size_t> ThermalCanvas::objectAt(QPoint pixel) const {
    for (std::size_t i = m_view.objects.size(); i-- > 0;)
        if (outlineOf(i).containsPoint(pixel, Qt::OddEvenFill))
            return i;
    return std::nullopt;
}

QString ThermalCanvas::spotText() const {
    if (!spot() || !hasPicture(m_view))
        return {};
    const auto object = objectAt(*spot());
    const QString text =
        tr("%1 at column %2, row %3").arg(pixelText(*spot())).arg(spot()->x()).arg(spot()->y());
    return object ? text + QStringLiteral(", ") + nameOf(*object) : text;
}

QString ThermalCanvas::legend() const {
    const ThermalImage& image = prepared();
    QStringList words;
    const auto add = [&words](int pixels, QRgb colour, QChar swatch, const QString& text) {
        if (pixels > 0)
            words << QStringLiteral("<span style='color:%1'>%2</span>\u00a0%3")
                         .arg(QColor::fromRgb(colour).name(), swatch, text.toHtmlEscaped());
    };
    const QChar plain(0x25a0), chequered(0x25a8);
    add(image.saturated, kSaturatedRgb, plain, tr("saturated %1", "a number of pixels").arg(image.saturated));
    add(image.below, kBelowRgb, plain, tr("below range %1", "a number of pixels").arg(image.below));
    add(image.withoutValue, kNoValueRgbs[1], chequered,
        tr("no value %1", "a number of pixels").arg(image.withoutValue));
    return words.join(QStringLiteral("&nbsp; "));
}

void ThermalCanvas::describe() {
    setAccessibleName(tr("Thermal picture"));
    const QString words =
        !m_notice.isEmpty() ? m_notice
        : spot()            ? spotText()
                 : tr("Arrow keys place a spot, which tells a pixel's temperature; Escape removes it.");
    if (words != accessibleDescription())
        setAccessibleDescription(words);
}

void ThermalCanvas::hover(std::optional<QPoint> pixel) {
    if (std::exchange(m_hovered, pixel) == pixel)
        return;
    describe();
    update();
}

void ThermalCanvas::pin(std::optional<QPoint> pixel) {
    m_pinned = pixel;
    describe();
    update();
}

void ThermalCanvas::mouseMoveEvent(QMouseEvent* event) {
    hover(pixelAt(event->position()));
}

void ThermalCanvas::mousePressEvent(QMouseEvent* event) {
    const auto pixel = pixelAt(event->position());
    if (event->button() != Qt::LeftButton || !pixel)
        return QWidget::mousePressEvent(event);
    constexpr double kNear = 8.0; // a pixel may be smaller than what a hand hits
    const bool isOnPinned =
        m_pinned && QLineF(pixelRect(*m_pinned).center(), event->position()).length() < kNear;
    pin(isOnPinned ? std::nullopt : pixel);
}

void ThermalCanvas::leaveEvent(QEvent* event) {
    hover(std::nullopt);
    QWidget::leaveEvent(event);
}

void ThermalCanvas::keyPressEvent(QKeyEvent* event) {
    const int step = event->modifiers() & Qt::ShiftModifier ? 10 : 1;
    QPoint by;
    switch (event->key()) {
    case Qt::Key_Left:
        by.setX(-step);
        break;
    case Qt::Key_Right:
        by.setX(step);
        break;
    case Qt::Key_Up:
        by.setY(-step);
        break;
    case Qt::Key_Down:
        by.setY(step);
        break;
    case Qt::Key_Escape:
        if (m_pinned)
            return pin(std::nullopt);
        return QWidget::keyPressEvent(event);
    default:
        return QWidget::keyPressEvent(event);
    }
    if (!hasPicture(m_view))
        return;
    const QPoint to = m_pinned ? *m_pinned + by : m_pixels.center();
    pin(QPoint(std::clamp(to.x(), m_pixels.left(), m_pixels.right()),
               std::clamp(to.y(), m_pixels.top(), m_pixels.bottom())));
}

void ThermalCanvas::focusInEvent(QFocusEvent* event) {
    QWidget::focusInEvent(event);
    update();
}

void ThermalCanvas::focusOutEvent(QFocusEvent* event) {
    QWidget::focusOutEvent(event);
    update();
}

bool ThermalCanvas::showToolTip(const QHelpEvent& event) {
    QString text;
    if (const auto pixel = pixelAt(event.pos())) {
        const auto object = objectAt(*pixel);
        if (object && !m_view.objects[*object].T_K)
            text =
                nameOf(*object) + QStringLiteral(": ") + messageText(m_view.objects[*object].reason, m_unit);
    } else if (hasPicture(m_view) && event.pos().x() > pictureRect().right() &&
               barRect().height() > event.pos().y()) {
        text =
            tr("Apparent temperature: that of a black body which looks the same. The objects' temperatures "
               "have reflections and emittance taken into account.");
    }
    QToolTip::showText(event.globalPos(), text, this);
    return true;
}

bool ThermalCanvas::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip)
        return showToolTip(static_cast<const QHelpEvent&>(*event));
    return QWidget::event(event);
}

void ThermalCanvas::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        describe();
    update();
    QWidget::changeEvent(event);
}

} // namespace bask
