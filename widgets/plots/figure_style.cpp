#include "widgets/plots/figure_style.h"

#include "widgets/common/marked_picture.h"
#include "widgets/common/theme.h"

#include <QBuffer>

namespace bask {

QFont figureFont(int size, bool bold) {
    QFont font;
    font.setPixelSize(size);
    font.setBold(bold);
    return font;
}

void styleAxis(QCPAxis* axis, const QString& label) {
    const QColor ink = themePalette(false).color(QPalette::Text);
    axis->setLabel(label);
    axis->setLabelFont(figureFont(15));
    axis->setTickLabelFont(figureFont(14));
    axis->setLabelColor(ink);
    axis->setTickLabelColor(ink);
    axis->setLabelPadding(6);
    const QPen pen(secondaryText(false), 1);
    axis->setBasePen(pen);
    axis->setTickPen(pen);
    axis->setSubTickPen(pen);
    axis->grid()->setPen(QPen(hairline(false), 1));
    axis->grid()->setZeroLinePen(Qt::NoPen);
}

void addHead(QCustomPlot& plot, const QString& title, const QString& note) {
    int row = 0;
    const auto line = [&](const QString& text, const QFont& font, const QColor& color, int below) {
        auto* element = new QCPTextElement(&plot, text, font);
        element->setTextColor(color);
        element->setTextFlags(Qt::AlignLeft | Qt::TextWordWrap);
        element->setMargins({12, row == 0 ? 10 : 0, 12, below});
        plot.plotLayout()->insertRow(row);
        plot.plotLayout()->addElement(row++, 0, element);
    };
    line(title, figureFont(19, true), themePalette(false).color(QPalette::Text), note.isEmpty() ? 8 : 2);
    if (!note.isEmpty())
        line(note, figureFont(13), secondaryText(false), 8);
}

QByteArray pngOf(QImage image, const QString& comment) {
    image.setDevicePixelRatio(1.0);
    markPicture(image, comment);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return bytes;
}

} // namespace bask
