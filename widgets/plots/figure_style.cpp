#include "widgets/plots/figure_style.h"

#include "widgets/common/marked_picture.h"
#include "widgets/common/theme.h"

#include <QBuffer>
#include <QPdfWriter>
#include <QSvgGenerator>
#include <QTextLayout>

#include <array>

namespace bask {
namespace {

constexpr int kBesideHead = 12;

/// Words in a row of their own, as high as they are; returns the height with the room to the next.
int addWords(QCustomPlot& plot, int row, const QString& text, const QFont& font, const QColor& color,
             Qt::Alignment side, int above, int below) {
    const int height =
        qCeil(QFontMetricsF(font).lineSpacing() * (1.0 + static_cast<double>(text.count(u'\n'))));
    auto* element = new QCPTextElement(&plot, text, font);
    element->setTextColor(color);
    element->setTextFlags(static_cast<int>(side) | Qt::TextWordWrap);
    element->setMargins({kBesideHead, above, kBesideHead, below});
    element->setMinimumSize(1, height);
    element->setMaximumSize(QWIDGETSIZE_MAX, height);
    plot.plotLayout()->insertRow(row);
    plot.plotLayout()->addElement(row, 0, element);
    return above + height + below + plot.plotLayout()->rowSpacing();
}

} // namespace

QFont figureFont(int size, bool bold) {
    QFont font;
    font.setPixelSize(size);
    font.setBold(bold);
    return font;
}

void styleAxis(QCPAxis* axis, const QString& label) {
    const QColor ink = themePalette(false).color(QPalette::Text);
    axis->setLabel(label);
    axis->setLabelFont(figureFont(kLabelLetters));
    axis->setTickLabelFont(figureFont(kSmallLetters));
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

int addHead(QCustomPlot& plot, const QString& title, const QString& note, int width) {
    const int room = width - 2 * kBesideHead;
    const QFont large = figureFont(kTitleLetters, true), small = figureFont(kSmallLetters);
    int height =
        addWords(plot, 0, inLines(title, large, room), large, themePalette(false).color(QPalette::Text),
                 Qt::AlignLeft, 10, note.isEmpty() ? 8 : 2);
    if (!note.isEmpty())
        height +=
            addWords(plot, 1, inLines(note, small, room), small, secondaryText(false), Qt::AlignLeft, 0, 8);
    return height;
}

int addCorner(QCustomPlot& plot, const QString& words, int width) {
    const QFont small = figureFont(kSmallLetters);
    return addWords(plot, 0, inLines(words, small, width - 2 * kBesideHead), small, secondaryText(false),
                    Qt::AlignRight, 6, 0);
}

void addLegend(QCustomPlot& plot, int columns) {
    auto* legend = plot.legend;
    legend->setVisible(true);
    legend->setFont(figureFont(kSmallLetters));
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

int figureUnits(double mm) {
    constexpr double kInch_mm = 25.4;
    return 2 * qRound(0.5 * kFigureUnits * mm / kInch_mm);
}

QSize figureUnits(QSize size_px) {
    return {2 * qRound(0.5 * size_px.width() / kFigureScale),
            2 * qRound(0.5 * size_px.height() / kFigureScale)};
}

QByteArray pictureOf(QCustomPlot& plot, QSize size, FigureFormat format, const QString& comment) {
    const int width = size.width(), height = size.height();
    if (format == FigureFormat::Png)
        return pngOf(plot.toPixmap(width, height, kFigureScale).toImage(), comment);
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
        svg.setResolution(qRound(kFigureUnits));
        svg.setSize(size);
        svg.setViewBox(QRect(0, 0, width, height));
        svg.setDescription(comment);
        painter.begin(&svg);
        draw();
    } else {
        constexpr int kDotsPerUnit = 12;
        QPdfWriter pdf(&buffer);
        pdf.setCreator(comment);
        pdf.setResolution(qRound(kFigureUnits) * kDotsPerUnit);
        pdf.setPageSize(QPageSize(0.5 * QSizeF(size), QPageSize::Point, {}, QPageSize::ExactMatch));
        pdf.setPageMargins(QMarginsF());
        painter.begin(&pdf);
        painter.scale(kDotsPerUnit, kDotsPerUnit);
        draw();
    }
    return bytes;
}

} // namespace bask
