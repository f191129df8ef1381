#include "app/report/run_report.h"

#include "app/report/html_text.h"
#include "app/report/report_figures.h"
#include "app/report/report_record.h"
#include "app/report/report_setup.h"
#include "widgets/common/display.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QCoreApplication>
#include <QImage>
#include <QPainter>
#include <QPdfWriter>
#include <QTextDocument>
#include <QUrl>

namespace bask {
namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(bask::RunReport)
};

constexpr const char* kBrowserStyle = R"(
:root { color-scheme: light; }
body { font: 15px/1.5 "DejaVu Sans", "Segoe UI", "Helvetica Neue", Arial, sans-serif;
       color: #1c2024; background: #fff; max-width: 1100px; margin: 2.5rem auto; padding: 0 1.5rem; }
h1 { font-size: 1.8rem; line-height: 1.2; margin: 0 0 .25rem; }
h2 { font-size: 1.25rem; margin: 2.5rem 0 .5rem; padding-top: .9rem; border-top: 1px solid #d9dde1; }
h3 { font-size: 1rem; margin: 1.5rem 0 .25rem; }
p { max-width: 52rem; margin: .5rem 0; }
table { border-collapse: collapse; width: 100%; font-size: .85rem; font-variant-numeric: tabular-nums; margin: .75rem 0; }
th, td { text-align: left; vertical-align: top; padding: .35rem .6rem; border-bottom: 1px solid #e4e7ea;
         overflow-wrap: anywhere; }
th { border-bottom: 2px solid #98a0a8; overflow-wrap: normal; }
.number { text-align: right; }
td.name { color: #586069; width: 28%; }
img { width: 100%; height: auto; display: block; margin-top: 1rem; }
.quiet { color: #586069; }
.warning { color: #a4260c; font-weight: 600; }
.tag { display: inline-block; border: 2px solid #1c2024; padding: .1rem .6rem; margin-right: .4rem; font-weight: 700; letter-spacing: .05em; }
.tag.simulated { border-color: #a4260c; color: #a4260c; border-style: dashed; }
@media print {
  @page { size: A4; margin: 15mm; }
  body { font-size: 9.5pt; max-width: none; margin: 0; padding: 0; }
  h2, h3 { break-after: avoid; } tr, img { break-inside: avoid; }
}
)";

// What QTextDocument understands.
constexpr const char* kPaperStyle = R"(
h1 { font-size: 20px; }
h2 { font-size: 15px; margin-top: 18px; margin-bottom: 4px; }
h3 { font-size: 12px; margin-top: 12px; margin-bottom: 2px; }
p { margin-top: 4px; margin-bottom: 4px; }
table { margin-top: 5px; margin-bottom: 5px; }
th { border-bottom: 1px solid #586069; font-weight: 600; font-size: 9px; }
td { border-bottom: 1px solid #d9dde1; font-size: 9.5px; }
td.name { color: #586069; }
.quiet { color: #586069; }
.warning { color: #a4260c; font-weight: 600; }
.tag { font-weight: 700; font-size: 14px; }
.simulated { color: #a4260c; }
)";

// A page is laid out in units of 1/96 inch.
constexpr double kUnit = 96.0 / 25.4; // a millimetre
constexpr double kWidth = 180.0 * kUnit, kHeight = 257.0 * kUnit, kFoot = 10.0 * kUnit;

/// The report without its frame; figures are called "figure:stem".
QString body(const RunReportInput& input, bool isPaper) {
    const SessionRecord& session = input.session;
    const QString title = session.experiment.title.empty() ? Words::tr("Experiment without a title")
                                                           : QString::fromStdString(session.experiment.title);
    const QString tag = session.simulated ? Words::tr("SIMULATED") : Words::tr("LIVE");
    const QString said = session.simulated
                             ? Words::tr("The rig was simulated: these are not measurements of a real one.")
                             : Words::tr("Recorded on a real rig.");
    QString text = QStringLiteral("<h1>%1</h1>\n<p><span class=\"tag %2\">%3</span> %4</p>\n")
                       .arg(title.toHtmlEscaped(),
                            session.simulated ? QStringLiteral("simulated") : QStringLiteral("live"), tag,
                            said.toHtmlEscaped());
    text += summarySection(input) + metricsSection(session, input.unit);
    if (!session.samples.empty()) {
        text += QStringLiteral("<h2%1>%2</h2>\n")
                    .arg(isPaper ? QStringLiteral(" style=\"page-break-before:always\"") : QString(),
                         Words::tr("Traces and trajectories").toHtmlEscaped());
        for (const RunFigure figure : runFigures(session)) {
            const QString caption = runFigureCaption(figure, session, input.unit).toHtmlEscaped();
            text +=
                QStringLiteral("<div><img src=\"figure:%1\" alt=\"%2\"%3></div>\n<p class=\"quiet\">%2</p>\n")
                    .arg(QString::fromStdString(runFigureStem(figure)), caption,
                         isPaper ? QStringLiteral(" width=\"%1\"").arg(static_cast<int>(kWidth)) : QString());
        }
    }
    text += setupSection(session, input.unit) +
            feasibilitySection(session, lastTargets_K(session), input.verdict, input.unit) +
            calibrationSection(session) + eventsSection(session, input.unit) + originSection(input);
    return text;
}

class Paper {
public:
    explicit Paper(const RunReportInput& input) {
        QFont font;
        font.setFamilies(
            {QStringLiteral("DejaVu Sans"), font.family()}); // a CJK font's figures are not searchable
        font.setPixelSize(11);
        m_document.setDefaultFont(font);
        m_document.setUseDesignMetrics(true);
        m_document.setDocumentMargin(0.0);
        m_document.setDefaultStyleSheet(QString::fromLatin1(kPaperStyle));
        m_document.setPageSize({kWidth, kHeight});
        if (!input.session.samples.empty()) {
            const RunFigures figures(input.session, input.unit);
            for (const RunFigure figure : runFigures(input.session))
                m_document.addResource(
                    QTextDocument::ImageResource,
                    QUrl(QStringLiteral("figure:%1").arg(QString::fromStdString(runFigureStem(figure)))),
                    QImage::fromData(figures.draw(figure, FigureFormat::Png)));
        }
        m_document.setHtml(body(input, true));
    }

    void print(QPdfWriter& pdf, const QString& footer) {
        QPainter painter(&pdf);
        painter.scale(pdf.logicalDpiX() / 96.0, pdf.logicalDpiY() / 96.0);
        const int pages = m_document.pageCount();
        for (int page = 0; page < pages; ++page) {
            if (page > 0)
                pdf.newPage();
            painter.save();
            painter.translate(0.0, -page * kHeight);
            QAbstractTextDocumentLayout::PaintContext context;
            context.clip = QRectF(0.0, page * kHeight, kWidth, kHeight);
            context.palette.setColor(QPalette::Text, QColor(0x1c, 0x20, 0x24));
            painter.setClipRect(context.clip);
            m_document.documentLayout()->draw(&painter, context);
            painter.restore();
            QFont font = m_document.defaultFont();
            font.setPixelSize(9);
            painter.setFont(font);
            painter.setPen(QColor(0x58, 0x60, 0x69));
            const QRectF foot(0.0, kHeight, kWidth, kFoot);
            painter.drawText(foot, Qt::AlignLeft | Qt::AlignBottom, footer);
            painter.drawText(foot, Qt::AlignRight | Qt::AlignBottom,
                             Words::tr("page %1 of %2").arg(page + 1).arg(pages));
        }
    }

private:
    QTextDocument m_document;
};

QString footerOf(const SessionRecord& session) {
    const QString name = QString::fromStdString(session.path).section(u'/', -1);
    return session.simulated ? Words::tr("SIMULATED") + QStringLiteral(" \u00b7 ") + name : name;
}

} // namespace

QByteArray runReportHtml(const RunReportInput& input) {
    QString text = body(input, false);
    if (!input.session.samples.empty()) {
        const RunFigures figures(input.session, input.unit);
        for (const RunFigure figure : runFigures(input.session))
            text.replace(
                QStringLiteral("src=\"figure:%1\"").arg(QString::fromStdString(runFigureStem(figure))),
                QStringLiteral("src=\"data:image/png;base64,%1\"")
                    .arg(QString::fromLatin1(figures.draw(figure, FigureFormat::Png).toBase64())));
    }
    return (QStringLiteral(
                "<!DOCTYPE html>\n<html lang=\"%1\">\n<head>\n<meta charset=\"utf-8\">\n"
                "<meta name=\"generator\" content=\"%2\">\n"
                "<meta name=\"viewport\" content=\"width=device-width\">\n<title>%3</title>\n<style>")
                .arg(QString(input.language).replace(u'_', u'-'), QLatin1String(kReportMark),
                     footerOf(input.session).toHtmlEscaped()) +
            QString::fromLatin1(kBrowserStyle) + QStringLiteral("</style>\n</head>\n<body>\n") + text +
            QStringLiteral("</body>\n</html>\n"))
        .toUtf8();
}

QByteArray runReportPdf(const RunReportInput& input) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter pdf(&buffer);
    pdf.setCreator(QString::fromLatin1(kReportMark));
    pdf.setTitle(QString::fromStdString(input.session.experiment.title));
    pdf.setResolution(1200);
    pdf.setPageSize(QPageSize(QPageSize::A4));
    pdf.setPageMargins({15.0, 15.0, 15.0, 15.0}, QPageLayout::Millimeter);
    Paper(input).print(pdf, footerOf(input.session));
    return bytes;
}

} // namespace bask
