#include "widgets/review/comparison_view.h"

#include "widgets/common/theme.h"
#include "widgets/review/object_table.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace bask {
namespace {

constexpr int kRowNameWidth = 260; // px; longer ones are elided, pointing at them tells the whole
constexpr int kRunWidth = 200;

QTableWidgetItem* rightItem(const QString& text, const QString& toolTip) {
    auto* item = new QTableWidgetItem(text);
    item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    item->setToolTip(toolTip);
    return item;
}

} // namespace

ComparisonView::ComparisonView(QWidget* parent)
    : QWidget(parent), m_caption(new QLabel(this)), m_references(new QComboBox(this)),
      m_copy(new QPushButton(this)), m_export(new QPushButton(this)), m_table(new QTableWidget(0, 1, this)),
      m_note(new QLabel(this)) {
    m_references->setObjectName(QStringLiteral("comparisonReference"));
    m_references->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_references->setMinimumContentsLength(18);
    m_caption->setBuddy(m_references);
    m_copy->setObjectName(QStringLiteral("comparisonCopy"));
    m_export->setObjectName(QStringLiteral("comparisonExport"));
    m_note->setObjectName(QStringLiteral("comparisonNote"));
    m_note->setWordWrap(true);
    m_table->setObjectName(QStringLiteral("comparisonTable"));
    styleObjectTable(*m_table);
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    m_table->setMinimumHeight(80);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Interactive);
    m_table->horizontalHeader()->setTextElideMode(Qt::ElideMiddle);
    QHeaderView& names = *m_table->verticalHeader(); // they stay in view beside many runs
    names.show();
    names.setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    names.setHighlightSections(false);
    names.setMaximumWidth(kRowNameWidth);
    names.setTextElideMode(Qt::ElideMiddle);
    names.setDefaultSectionSize(m_table->fontMetrics().height() + 6);
    m_table->installEventFilter(this);

    auto* top = new QHBoxLayout;
    top->addWidget(m_caption);
    top->addWidget(m_references);
    top->addStretch(1);
    top->addWidget(m_copy);
    top->addWidget(m_export);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 6, 0, 0);
    layout->setSpacing(4);
    layout->addLayout(top);
    layout->addWidget(m_note);
    layout->addWidget(m_table, 1);

    connect(m_references, &QComboBox::activated, this, [this] {
        m_reference = m_references->currentData().toString();
        refresh();
    });
    connect(m_copy, &QPushButton::clicked, this, &ComparisonView::copy);
    connect(m_export, &QPushButton::clicked, this, [this] {
        emit exportRequested(QString::fromStdString(comparisonCsv(m_runs, reference(), m_metrics)));
    });
    refresh();
}

void ComparisonView::setRuns(std::vector<ComparedRun> runs) {
    m_runs = std::move(runs);
    refresh();
}

void ComparisonView::setTemperatureUnit(TemperatureUnit unit) {
    m_unit = unit;
    refresh();
}

std::size_t ComparisonView::reference() const {
    const auto found = std::ranges::find(m_runs, m_reference, &ComparedRun::path);
    return found == m_runs.end() ? 0 : static_cast<std::size_t>(found - m_runs.begin());
}

void ComparisonView::refresh() {
    m_caption->setText(tr("Differences from"));
    m_references->setToolTip(tr("The run that the others are compared with"));
    m_copy->setText(tr("Copy"));
    m_copy->setToolTip(tr("Copy the table as text, for a spreadsheet or a letter"));
    m_export->setText(tr("Export (CSV)\u2026"));
    m_table->setAccessibleName(tr("Metrics of the runs that are laid over each other"));
    showReferences();
    showNote();
    m_metrics.clear();
    if (!m_runs.empty())
        m_metrics = compareMetrics(m_runs, reference(), m_unit);
    m_table->setColumnCount(0);
    m_table->setRowCount(static_cast<int>(m_metrics.size()));
    if (m_metrics.empty())
        return;
    const std::size_t base = reference();
    m_table->setColumnCount(static_cast<int>(2 * m_runs.size() - 1));
    int column = 0;
    for (std::size_t k = 0; k < m_runs.size(); ++k) {
        const ComparedRun& run = m_runs[k];
        m_table->setHorizontalHeaderItem(column++, rightItem(run.name, run.path));
        if (k != base)
            m_table->setHorizontalHeaderItem(column++,
                                             rightItem(differenceName(run, m_runs[base]),
                                                       tr("%1 less %2").arg(run.name, m_runs[base].name)));
    }
    for (int row = 0; row < m_table->rowCount(); ++row)
        showRow(row, m_metrics[static_cast<std::size_t>(row)]);
    QHeaderView& columns = *m_table->horizontalHeader();
    m_table->resizeColumnsToContents(); // once, not at each of the many cells
    for (int k = 0; k < column; ++k)
        columns.resizeSection(k, std::min(columns.sectionSize(k), kRunWidth));
}

void ComparisonView::showReferences() {
    const QSignalBlocker quiet(m_references);
    m_references->clear();
    for (const ComparedRun& run : m_runs)
        m_references->addItem(run.name, run.path);
    m_references->setCurrentIndex(m_runs.empty() ? -1 : static_cast<int>(reference()));
}

void ComparisonView::showRow(int row, const ComparedMetric& metric) {
    const QString name = metric.object.isEmpty()
                             ? metric.name
                             : QStringLiteral("%1 \u00b7 %2").arg(metric.name, metric.object);
    auto* header = new QTableWidgetItem(name);
    header->setToolTip(
        QStringLiteral("<b>%1</b><br>%2").arg(name.toHtmlEscaped(), metric.definition.toHtmlEscaped()));
    m_table->setVerticalHeaderItem(row, header);
    const std::size_t base = reference();
    int column = 0;
    for (std::size_t k = 0; k < metric.cells.size(); ++k) {
        m_table->setItem(row, column++, rightItem(metric.cells[k].text, metric.definition));
        if (k != base)
            m_table->setItem(row, column++, rightItem(metric.cells[k].difference, metric.definition));
    }
}

/// Why there are dashes in a whole column, and what does not compare.
void ComparisonView::showNote() {
    QStringList waited, failed;
    for (const ComparedRun& run : m_runs)
        if (!run.metrics)
            (run.isFailed ? failed : waited) << run.name;
    QStringList lines;
    if (!waited.isEmpty())
        lines << tr("Being computed from all samples: %1").arg(waited.join(QStringLiteral(", ")));
    if (!failed.isEmpty())
        lines << tr("No metrics, the recording cannot be read to its end: %1")
                     .arg(failed.join(QStringLiteral(", ")));
    if (const QStringList steps = unlikeSteps(m_runs, m_unit); !steps.isEmpty())
        lines << tr("The steps are not alike, so neither are times and overshoots: %1")
                     .arg(steps.join(QStringLiteral("; ")));
    if (const QString sources = unlikeSources(m_runs, m_unit); !sources.isEmpty())
        lines << tr("The source was not equally hot at Start: %1").arg(sources);
    m_note->setText(lines.join(u'\n'));
    m_note->setVisible(!lines.isEmpty());
    m_note->setPalette(captionPalette(palette()));
    m_export->setEnabled(waited.isEmpty() && m_runs.size() > 1);
    m_export->setToolTip(waited.isEmpty() ? tr("Write the numbers of this table for other programs")
                                          : tr("Once all metrics are computed"));
}

void ComparisonView::copy() {
    if (m_runs.empty())
        return;
    QApplication::clipboard()->setText(comparisonText(m_runs, reference(), m_metrics));
    emit copied(tr("Copied %n row(s)", nullptr, static_cast<int>(m_metrics.size())));
}

bool ComparisonView::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->matches(QKeySequence::Copy)) {
        copy();
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

void ComparisonView::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
        refresh();
    QWidget::changeEvent(event);
}

} // namespace bask
