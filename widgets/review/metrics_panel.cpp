#include "widgets/review/metrics_panel.h"

#include "widgets/common/metric_words.h"
#include "widgets/common/theme.h"
#include "widgets/review/object_table.h"

#include <QEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace bask {
namespace {

constexpr int kNameWidth = 150; // px; longer names are elided, their tool-tips have them whole

} // namespace

MetricsPanel::MetricsPanel(QWidget* parent)
    : QWidget(parent), m_table(new QTableWidget(0, 1, this)), m_details(new QLabel(this)) {
    m_table->setObjectName(QStringLiteral("metricsTable"));
    styleObjectTable(*m_table);
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    m_table->setMinimumHeight(80);
    m_table->verticalHeader()->setDefaultSectionSize(m_table->fontMetrics().height() + 6);
    m_table->installEventFilter(this);
    m_details->setObjectName(QStringLiteral("metricsDetails"));
    m_details->setTextFormat(Qt::RichText);
    m_details->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 4);
    layout->setSpacing(4);
    layout->addWidget(m_table, 1);
    layout->addWidget(m_details);
    connect(m_details, &QLabel::linkActivated, this, &MetricsPanel::detailsRequested);
    refresh();
}

void MetricsPanel::setMetrics(const QStringList& names, RunMetrics metrics) {
    m_names = names;
    m_metrics = std::move(metrics);
    refresh();
}

void MetricsPanel::clear() {
    setMetrics({}, {});
}

void MetricsPanel::setTemperatureUnit(TemperatureUnit unit) {
    m_unit = unit;
    refresh();
}

void MetricsPanel::refresh() {
    m_table->setAccessibleName(tr("Metrics of the run"));
    m_details->setText(
        QStringLiteral("<a href=\"#\" style=\"color:%1\">%2</a>")
            .arg(accentColor(isDark(this)).name(), tr("How these numbers are defined").toHtmlEscaped()));
    const auto objects = static_cast<int>(m_metrics.objects.size());
    m_table->clearSpans();
    m_table->setColumnCount(objects + 1);
    m_table->setRowCount(objects > 0 ? static_cast<int>(kObjectMetrics.size() + kRunMetrics.size()) : 0);
    auto* corner = new QTableWidgetItem(tr("Metric"));
    corner->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_table->setHorizontalHeaderItem(0, corner);
    m_table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Interactive);
    for (int i = 0; i < objects; ++i)
        m_table->setHorizontalHeaderItem(
            i + 1, new QTableWidgetItem(QIcon(seriesSwatch(i, isDark(this), {20, 12}, devicePixelRatioF())),
                                        m_names.value(i)));
    const auto put = [this](int row, int column, const QString& text, Qt::Alignment side,
                            const QString& definition) {
        auto* item = new QTableWidgetItem(text);
        item->setTextAlignment(side | Qt::AlignVCenter);
        item->setToolTip(QStringLiteral("<b>%1</b><br>%2")
                             .arg(m_table->item(row, 0) != nullptr && column > 0
                                      ? m_table->item(row, 0)->text().toHtmlEscaped()
                                      : text.toHtmlEscaped(),
                                  definition.toHtmlEscaped()));
        m_table->setItem(row, column, item);
    };
    if (objects == 0)
        return;
    int row = 0;
    for (const ObjectMetric metric : kObjectMetrics) {
        const QString definition = metricDefinition(metric, m_metrics.band_K, m_unit);
        put(row, 0, metricName(metric), Qt::AlignLeft, definition);
        for (int i = 0; i < objects; ++i)
            put(row, i + 1, metricText(metric, m_metrics, static_cast<std::size_t>(i), m_unit),
                Qt::AlignRight, definition);
        ++row;
    }
    for (const RunMetric metric : kRunMetrics) { // of the run as a whole: one value for all columns
        put(row, 0, metricName(metric), Qt::AlignLeft, metricDefinition(metric));
        put(row, 1, metricText(metric, m_metrics), Qt::AlignLeft, metricDefinition(metric));
        if (objects > 1)
            m_table->setSpan(row, 1, 1, objects);
        ++row;
    }
    m_table->resizeColumnToContents(0);
    m_table->setColumnWidth(0, std::min(m_table->columnWidth(0), kNameWidth));
}

bool MetricsPanel::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->matches(QKeySequence::Copy)) {
        copyTable(*m_table);
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

void MetricsPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
        refresh();
    QWidget::changeEvent(event);
}

} // namespace bask
