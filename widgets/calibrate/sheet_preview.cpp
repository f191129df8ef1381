#include "widgets/calibrate/sheet_preview.h"

#include "widgets/common/theme.h"

#include <QPainter>

#include <algorithm>

namespace bask {

SheetPreview::SheetPreview(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void SheetPreview::setSheet(const std::optional<BoardSheet>& sheet) {
    m_sheet = sheet;
    m_picture = {};
    update();
}

void SheetPreview::resizeEvent(QResizeEvent*) {
    m_picture = {};
}

void SheetPreview::paintEvent(QPaintEvent*) {
    if (!m_sheet)
        return;
    if (m_picture.isNull()) {
        const QSizeF page_mm = m_sheet->page.fullRect().size();
        const QSizeF room = QSizeF(size() - QSize(2, 2)) * devicePixelRatioF();
        const double dots_mm = std::min(room.width() / page_mm.width(), room.height() / page_mm.height());
        m_picture = QPixmap((page_mm * dots_mm).toSize().expandedTo({1, 1}));
        m_picture.fill(Qt::white);
        QPainter painter(&m_picture);
        paintSheet(painter, dots_mm, *m_sheet);
        painter.end();
        m_picture.setDevicePixelRatio(devicePixelRatioF());
    }
    QPainter painter(this);
    QRect place(QPoint(), m_picture.deviceIndependentSize().toSize());
    place.moveCenter(rect().center());
    painter.drawPixmap(place.topLeft(), m_picture);
    painter.setPen(hairline(isDark(this)));
    painter.drawRect(place.adjusted(-1, -1, 0, 0));
}

} // namespace bask
