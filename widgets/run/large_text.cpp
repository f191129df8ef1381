#include "widgets/run/large_text.h"

#include "widgets/common/theme.h"

#include <QEvent>
#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>

namespace bask {
namespace {

constexpr int kLeastLetters_px = 5;
constexpr int kInset = 2; ///< px on both sides: the edges of letters are soft
// Of a figure's height, above it and below the line: round figures are higher, a comma hangs.
constexpr double kAboveFigures = 0.06, kBelowFigures = 0.24;
constexpr double kUnitLetters = 0.42, kUnitGap = 0.12, kMarkOverUnit = 0.36; // of the figures' letters
constexpr double kMarkGap = 0.35;                                            // of the mark

} // namespace

LargeText::LargeText(const char* name, Qt::Alignment side, QWidget* parent) : QLabel(parent) {
    setObjectName(QLatin1String(name));
    setAlignment(side | Qt::AlignVCenter);
    setTextFormat(Qt::PlainText);
}

void LargeText::setLook(const LargeLook& look) {
    if (look == m_look)
        return;
    m_look = look;
    forgetSize();
}

void LargeText::setFigures(const QString& widest) {
    if (widest == m_figures)
        return;
    m_figures = widest;
    forgetSize();
}

void LargeText::setUnit(const QString& unit) {
    if (unit == m_unit)
        return;
    m_unit = unit;
    forgetSize();
}

void LargeText::forgetSize() {
    m_size_px = 0;
    update();
}

QFont LargeText::sized(double size_px) const {
    QFont letters = font();
    letters.setPixelSize(std::max(1, qRound(size_px)));
    letters.setBold(letters.bold() || (m_look.isUnknown && !m_look.isGrey));
    letters.setStrikeOut(m_look.isStruck);
    return letters;
}

double LargeText::unitWidth(int size_px) const {
    return std::max(QFontMetricsF(sized(kUnitLetters * size_px)).horizontalAdvance(m_unit),
                    kMarkOverUnit * size_px);
}

int LargeText::markSide(int size_px) const {
    return m_unit.isEmpty() ? qRound(1.1 * QFontMetricsF(sized(size_px)).capHeight())
                            : qRound(kMarkOverUnit * size_px);
}

double LargeText::besides(int size_px) const {
    if (!m_unit.isEmpty())
        return kUnitGap * size_px + unitWidth(size_px);
    return hasMark() ? (1.0 + kMarkGap) * markSide(size_px) : 0.0;
}

/// Of figures, what their size is for.
QString LargeText::widest() const {
    const QFontMetricsF metrics(sized(100.0));
    return metrics.horizontalAdvance(text()) <= metrics.horizontalAdvance(m_figures) ? m_figures : text();
}

bool LargeText::fits(const QString& text, int size_px, QSize room) const {
    const QFontMetricsF metrics(sized(size_px));
    const double width = room.width() - 2.0 * kInset - besides(size_px);
    if (wordWrap()) {
        const QRectF needed =
            metrics.boundingRect(QRectF(0.0, 0.0, width, 1e5), Qt::AlignLeft | Qt::TextWordWrap, text);
        return needed.width() <= width && needed.height() <= room.height();
    }
    const double height =
        m_figures.isEmpty() ? metrics.height() : (1.0 + kAboveFigures + kBelowFigures) * metrics.capHeight();
    return metrics.horizontalAdvance(text) <= width && height <= room.height();
}

int LargeText::fit(const QString& text, QSize room) const {
    int least = kLeastLetters_px, most = std::max(least, 2 * room.height());
    while (least < most) {
        const int middle = (least + most + 1) / 2;
        if (fits(text, middle, room))
            least = middle;
        else
            most = middle - 1;
    }
    return least;
}

int LargeText::size_px() const {
    const QString wanted = m_figures.isEmpty() ? text() : widest();
    if (m_size_px == 0 || wanted != m_fitted) {
        m_size_px = fit(wanted, size());
        m_fitted = wanted;
    }
    return m_size_px;
}

int LargeText::figureHeight(QSize room) const {
    return qFloor(QFontMetricsF(sized(fit(m_figures, room))).capHeight());
}

bool LargeText::isShortened() const {
    return !text().isEmpty() && !fits(text(), size_px(), size());
}

QColor LargeText::ink() const {
    const bool dark = isDark(this);
    return m_look.isGrey       ? secondaryText(dark)
           : m_look.isUnknown  ? unknownColor(dark)
           : m_look.isAlarmInk ? alarmColor(m_look.priority, dark)
                               : palette().color(QPalette::WindowText);
}

void LargeText::drawMark(QPainter& painter, QPointF corner, int size_px) const {
    const bool dark = isDark(this);
    const int side = markSide(size_px);
    painter.drawPixmap(corner, m_look.isUnknown
                                   ? unknownPixmap(dark, side, devicePixelRatioF())
                                   : alarmPixmap(m_look.priority, dark, side, devicePixelRatioF()));
}

void LargeText::paintEvent(QPaintEvent*) {
    if (text().isEmpty())
        return;
    const int letters_px = size_px();
    QPainter painter(this);
    painter.setFont(sized(letters_px));
    painter.setPen(ink());
    const QFontMetricsF metrics(painter.font());
    const double extra = besides(letters_px), room = width() - 2.0 * kInset - extra;
    const double cap = metrics.capHeight();
    const double baseline = m_figures.isEmpty()
                                ? 0.5 * (height() - metrics.height()) + metrics.ascent()
                                : 0.5 * (height() + (1.0 + kAboveFigures - kBelowFigures) * cap);
    const QString shown = wordWrap() ? text() : metrics.elidedText(text(), Qt::ElideRight, room);
    const double wide = wordWrap() ? room : std::min(room, metrics.horizontalAdvance(shown));
    double x = kInset;
    if (alignment() & Qt::AlignRight)
        x += room - wide;
    else if (alignment() & Qt::AlignHCenter)
        x += 0.5 * (room - wide);
    if (m_unit.isEmpty() && hasMark()) {
        const int side = markSide(letters_px);
        const double y = wordWrap() ? 0.5 * (height() - side) : baseline - 0.5 * (cap + side);
        drawMark(painter, {x, std::max(0.0, y)}, letters_px);
        x += extra;
    }
    if (wordWrap()) {
        painter.drawText(QRectF(x, 0.0, room, height()), Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap,
                         shown);
        return;
    }
    painter.drawText(QPointF(x, baseline), shown);
    if (m_unit.isEmpty())
        return;
    x += wide + kUnitGap * letters_px;
    if (hasMark())
        drawMark(painter, {x, baseline - cap}, letters_px);
    QFont small = sized(kUnitLetters * letters_px);
    small.setStrikeOut(false);
    painter.setFont(small);
    painter.drawText(QPointF(x, baseline), m_unit);
}

bool LargeText::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip && isShortened()) {
        QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), text(), this);
        return true;
    }
    return QLabel::event(event);
}

void LargeText::changeEvent(QEvent* event) {
    QLabel::changeEvent(event);
    forgetSize(); // it may be another font
}

void LargeText::resizeEvent(QResizeEvent* event) {
    QLabel::resizeEvent(event);
    forgetSize();
}

void placeInRow(const QRect& row, int gap, std::initializer_list<std::pair<QWidget*, double>> shares) {
    double all = 0.0, before = 0.0;
    for (const auto& [widget, share] : shares)
        all += share;
    const double width = row.width() - gap * (static_cast<double>(shares.size()) - 1.0);
    int gaps = 0;
    for (const auto& [widget, share] : shares) {
        const int left = row.left() + gaps + qRound(width * before / all);
        before += share;
        widget->setGeometry(left, row.top(), row.left() + gaps + qRound(width * before / all) - left,
                            row.height());
        gaps += gap;
    }
}

} // namespace bask
