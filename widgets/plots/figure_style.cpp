#include "widgets/plots/figure_style.h"

#include "widgets/common/marked_picture.h"
#include "widgets/common/theme.h"

#include <QBuffer>
#include <QPdfWriter>
#include <QSvgGenerator>
#include <QTextLayout>

#include <array>

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

void addLegend(QCustomPlot& plot, int columns) {
    auto* legend = plot.legend;
    legend->setVisible(true);
    legend->setFont(figureFont(14));
    legend->setBorderPen(Qt::NoPen);
    legend->setIconSize(38, 16);
    legend->setWrap(columns);
    legend->setFillOrder(QCPLayoutGrid::foColumnsFirst);
    legend->setColumnSpacing(24);
    auto* below = new QCPLayoutGrid;
    below->setMargins({12, 0, 12, 8});
    const int row = plot.plotLayout()->rowCount();
    plot.plotLayout()->addElement(row, 0, below);
    below->addElement(0, 0, legend);
    plot.plotLayout()->setRowStretchFactor(row, 0.001);
}

void addLegendEntry(QCustomPlot& plot, const QString& name, const QPen& pen, const QBrush& brush) {
    QCPGraph* graph = plot.addGraph();
    graph->setName(name);
    graph->setPen(pen);
    graph->setBrush(brush);
}

QCPScatterStyle figureMarker(int index, const QColor& color) {
    static constexpr std::array kShapes{QCPScatterStyle::ssDisc,        QCPScatterStyle::ssSquare,
                                        QCPScatterStyle::ssTriangle,    QCPScatterStyle::ssDiamond,
                                        QCPScatterStyle::ssCircle,      QCPScatterStyle::ssTriangleInverted,
                                        QCPScatterStyle::ssCrossSquare, QCPScatterStyle::ssPlus};
    const bool isFilled = index % static_cast<int>(kShapes.size()) != 4;
    return {kShapes[static_cast<std::size_t>(index) % kShapes.size()], QPen(color, 1.3),
            isFilled ? QBrush(color) : QBrush(Qt::white), 6.5};
}

QList<qreal> dotGroups(int index) {
    QList<qreal> dashes;
    const int dots = 2 + index % 6;
    for (int k = 1; k <= dots; ++k)
        dashes << 1.5 << (k < dots ? 1.5 : 6.0);
    return dashes;
}

QString inLines(const QString& text, const QFont& font, double width) {
    QTextLayout layout(text, font);
    layout.beginLayout();
    QStringList lines;
    for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
        line.setLineWidth(width);
        lines << text.mid(line.textStart(), line.textLength()).trimmed();
    }
    layout.endLayout();
    return lines.join(u'\n');
}

void shadeAboutZero(QCustomPlot& plot, double band) {
    if (band <= 0.0)
        return;
    auto* rectangle = new QCPItemRect(&plot);
    rectangle->setLayer(QStringLiteral("background"));
    for (QCPItemPosition* corner : {rectangle->topLeft, rectangle->bottomRight}) {
        corner->setTypeX(QCPItemPosition::ptAxisRectRatio);
        corner->setTypeY(QCPItemPosition::ptPlotCoords);
    }
    rectangle->topLeft->setCoords(0.0, band);
    rectangle->bottomRight->setCoords(1.0, -band);
    rectangle->setPen(Qt::NoPen);
    rectangle->setBrush(kBandColor);
}

QByteArray pngOf(QImage image, const QString& comment) {
    constexpr double kInch_m = 0.0254;
    image.setDevicePixelRatio(1.0);
    image.setDotsPerMeterX(qRound(kFigureDots / kInch_m));
    image.setDotsPerMeterY(qRound(kFigureDots / kInch_m));
    markPicture(image, comment);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return bytes;
}

QByteArray pictureOf(QCustomPlot& plot, QSize size_px, FigureFormat format, const QString& comment) {
    const int width = static_cast<int>(size_px.width() / kFigureScale);
    const int height = static_cast<int>(size_px.height() / kFigureScale);
    if (format == FigureFormat::Png)
        return pngOf(plot.toPixmap(width, height, kFigureScale).toImage(), comment);
    constexpr int kUnits = 96, kPoints = 72; // an inch
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QCPPainter painter;
    const auto draw = [&] {
        painter.setMode(QCPPainter::pmVectorized);
        painter.setMode(QCPPainter::pmNoCaching); // else the numbers at the axes are pictures
        plot.toPainter(&painter, width, height);
        painter.end();
    };
    if (format == FigureFormat::Svg) {
        QSvgGenerator svg;
        svg.setOutputDevice(&buffer);
        svg.setResolution(kUnits);
        svg.setSize({width, height});
        svg.setViewBox(QRect(0, 0, width, height));
        svg.setDescription(comment);
        painter.begin(&svg);
        draw();
    } else {
        constexpr int kDotsPerUnit = 12;
        QPdfWriter pdf(&buffer);
        pdf.setCreator(comment);
        pdf.setResolution(kUnits * kDotsPerUnit);
        pdf.setPageSize(
            QPageSize(QSizeF(width, height) * kPoints / kUnits, QPageSize::Point, {}, QPageSize::ExactMatch));
        pdf.setPageMargins(QMarginsF());
        painter.begin(&pdf);
        painter.scale(kDotsPerUnit, kDotsPerUnit);
        draw();
    }
    return bytes;
}

} // namespace bask
