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

namespace bask {
namespace {

constexpr int kNameWidth = 190; // px; longer names are elided, pointing at them tells the whole

} // namespace

MetricsPanel::MetricsPanel(QWidget* parent)
    : QWidget(parent), m_table(new QTableWidget(0, 1, this)), m_details(new QLabel(this)) {
    m_table->setObjectName(QStringLiteral("metricsTable"));
    styleObjectTable(*m_table);
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    m_table->setMinimumHeight(80);
    QHeaderView& names = *m_table->verticalHeader(); // they stay in view beside many objects
    names.show();
    names.setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    names.setHighlightSections(false);
    names.setMaximumWidth(kNameWidth);
    names.setTextElideMode(Qt::ElideRight);
    names.setDefaultSectionSize(m_table->fontMetrics().height() + 6);
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
    m_table->setColumnCount(objects);
    const std::vector<ObjectMetric> metrics = objectMetrics(!m_metrics.trueObjects.empty());
    m_table->setRowCount(objects > 0 ? static_cast<int>(metrics.size() + kRunMetrics.size()) : 0);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    for (int i = 0; i < objects; ++i)
        m_table->setHorizontalHeaderItem(
            i, new QTableWidgetItem(QIcon(seriesSwatch(i, isDark(this), {20, 12}, devicePixelRatioF())),
                                    m_names.value(i)));
    if (objects == 0)
        return;
    int row = 0;
    const auto name = [&](const QString& text, const QString& definition) {
        auto* item = new QTableWidgetItem(text);
        item->setToolTip(
            QStringLiteral("<b>%1</b><br>%2").arg(text.toHtmlEscaped(), definition.toHtmlEscaped()));
        m_table->setVerticalHeaderItem(row, item);
    };
    const auto put = [&](int column, const QString& text, Qt::Alignment side, const QString& definition) {
        auto* item = new QTableWidgetItem(text);
        item->setTextAlignment(side | Qt::AlignVCenter);
        item->setToolTip(definition);
        m_table->setItem(row, column, item);
    };
    for (const ObjectMetric metric : metrics) {
        const QString definition = metricDefinition(metric, m_metrics.band_K, m_unit);
        name(metricName(metric), definition);
        for (int i = 0; i < objects; ++i)
            put(i, metricText(metric, m_metrics, static_cast<std::size_t>(i), m_unit), Qt::AlignRight,
                definition);
        ++row;
    }
    for (const RunMetric metric : kRunMetrics) { // of the run as a whole: one value for all columns
        name(metricName(metric), metricDefinition(metric));
        put(0, metricText(metric, m_metrics), Qt::AlignLeft, metricDefinition(metric));
        if (objects > 1)
            m_table->setSpan(row, 0, 1, objects);
        ++row;
    }
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
