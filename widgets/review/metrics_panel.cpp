#include "widgets/review/metrics_panel.h"

#include "widgets/common/metric_words.h"
#include "widgets/common/theme.h"
#include "widgets/review/object_table.h"

#include <QEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QScrollBar>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <vector>

namespace bask {
namespace {

constexpr double kNameShare = 0.36; ///< of the width at most, where the columns need the rest
constexpr int kRowGap = 6;

/// Of an object's numbers: in one line, and with each word on a line of its own.
struct ColumnWidth {
    int whole = 0;
    int least = 0;
};

int widestWord(const QFontMetrics& metrics, const QString& text) {
    int widest = 0;
    for (const QString& word : text.split(u' '))
        widest = std::max(widest, metrics.horizontalAdvance(word));
    return widest;
}

int wrappedHeight(const QFontMetrics& metrics, const QString& text, int width) {
    return metrics.boundingRect(0, 0, width, 1'000'000, Qt::TextWordWrap, text).height();
}

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
    names.setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter | Qt::Alignment(Qt::TextWordWrap));
    names.setHighlightSections(false);
    names.setTextElideMode(Qt::ElideNone);
    m_table->setWordWrap(true);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    m_table->horizontalHeader()->setMinimumSectionSize(1);
    m_table->installEventFilter(this);
    m_details->setObjectName(QStringLiteral("metricsDetails"));
    m_details->setTextFormat(Qt::RichText);
    m_details->setWordWrap(true);
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
    fit();
}

void MetricsPanel::fit() {
    const int objects = m_table->columnCount(), rows = m_table->rowCount();
    QHeaderView& names = *m_table->verticalHeader();
    const QFontMetrics letters = m_table->fontMetrics(), nameLetters = names.fontMetrics();
    const int margin = 2 * (style()->pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, m_table) + 1) + 1;
    const int nameMargin = 2 * style()->pixelMetric(QStyle::PM_HeaderMargin, nullptr, &names) + 2;
    int wholeName = 0, shortName = 0;
    for (int row = 0; row < rows; ++row) {
        const QString name = m_table->verticalHeaderItem(row)->text();
        wholeName = std::max(wholeName, nameLetters.horizontalAdvance(name) + nameMargin);
        shortName = std::max(shortName, widestWord(nameLetters, name) + nameMargin);
    }
    const int ofObjects = rows - static_cast<int>(kRunMetrics.size());
    std::vector<ColumnWidth> widths;
    int needed = wholeName;
    for (int column = 0; column < objects && rows > 0; ++column) {
        const int heading = m_table->horizontalHeader()->sectionSizeHint(column);
        ColumnWidth width{heading, heading};
        for (int row = 0; row < ofObjects; ++row) {
            const QString text = m_table->item(row, column)->text();
            width.whole = std::max(width.whole, letters.horizontalAdvance(text) + margin);
            width.least = std::max(width.least, widestWord(letters, text) + margin);
        }
        needed += width.whole;
        widths.push_back(width);
    }
    if (widths.empty())
        return;
    const int room =
        m_table->width() - 2 * m_table->frameWidth() - m_table->verticalScrollBar()->sizeHint().width();
    int nameWidth = wholeName;
    if (needed > room)
        nameWidth = std::clamp(static_cast<int>(kNameShare * room), shortName, wholeName);
    names.setFixedWidth(nameWidth);
    for (int column = 0; column < objects; ++column) {
        const ColumnWidth& width = widths[static_cast<std::size_t>(column)];
        m_table->setColumnWidth(
            column, needed <= room ? width.whole
                                   : std::clamp((room - nameWidth) / objects, width.least, width.whole));
    }
    for (int row = 0; row < rows; ++row) {
        int height =
            wrappedHeight(nameLetters, m_table->verticalHeaderItem(row)->text(), nameWidth - nameMargin);
        for (int column = 0; column < objects && row < ofObjects; ++column)
            height = std::max(height, wrappedHeight(letters, m_table->item(row, column)->text(),
                                                    m_table->columnWidth(column) - margin));
        m_table->setRowHeight(row, height + kRowGap);
    }
}

bool MetricsPanel::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->matches(QKeySequence::Copy)) {
        copyTable(*m_table);
        return true;
    }
    if (event->type() == QEvent::Resize)
        fit();
    return QWidget::eventFilter(watched, event);
}

void MetricsPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
        refresh();
    QWidget::changeEvent(event);
}

} // namespace bask
