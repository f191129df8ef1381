#include "widgets/review/alarm_history_dialog.h"

#include "widgets/common/display.h"
#include "widgets/common/theme.h"
#include "widgets/review/run_differences.h"

#include <QApplication>
#include <QClipboard>
#include <QDateTime>
#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

namespace bask {
namespace {

enum PastColumn {
    kPastAlarm,
    kPastPriority,
    kPastRuns,
    kPastTimes,
    kPastActive,
    kPastLast,
    kPastLastRun,
    kPastColumns
};
enum PastRunColumn { kInDate, kInName, kInRig, kInTimes, kInActive, kInAt, kInColumns };
constexpr int kPastSortRole = Qt::UserRole;
constexpr int kPastPlaceRole = Qt::UserRole + 1; ///< of an alarm in the history
constexpr int kInPathRole = Qt::UserRole + 1;
constexpr int kInRaisedRole = Qt::UserRole + 2;
constexpr double kLongestRun_s = 1e5; ///< that is told from a longer one where alarms are sorted
constexpr int kPastMark = 16;
constexpr int kMaxListed = 30; ///< times of an alarm in a run; who wants more opens the run
constexpr int kMaxNamed = 5;   ///< files that cannot be read; a tip has all

/// To the second: several runs may begin in a minute.
QString pastDate(const QDateTime& date) {
    return date.toString(QStringLiteral("yyyy-MM-dd HH:mm:ss"));
}

/// A number by which alarms are sorted by when they were raised last: by the run, then by the time in it. No
/// date, since nobody knows when the run began after Arm, and a simulated one may have been faster.
double lastRaised(const SessionHeader& run, const AlarmInRun& in) {
    return static_cast<double>(recordedAt(run).toSecsSinceEpoch()) +
           std::clamp(in.spells.back().raised_s / kLongestRun_s, 0.0, 0.99);
}

/// Whether the last time that an alarm was raised is without a run; one in a run is later than its date.
bool isLastUnrecorded(const AlarmHistory& history, const PastAlarm& alarm) {
    return alarm.runs.empty() || (!alarm.withoutRun.empty() &&
                                  alarm.withoutRun.front().raised_s >
                                      lastRaised(history.runs[alarm.runs.front().run], alarm.runs.front()));
}

QDateTime unrecordedDate(const UnrecordedSpell& spell) {
    return QDateTime::fromMSecsSinceEpoch(std::llround(1e3 * spell.raised_s));
}

/// A number by which alarms are sorted: by priority, those of one by when they were raised, the latest first.
double gravity(int priority, double raised) {
    constexpr double kApart = 1e10; // more seconds than a date of the next two centuries has
    return priority * kApart - raised;
}

/// Sorted by what the texts stand for.
class PastRow : public QTreeWidgetItem {
public:
    using QTreeWidgetItem::QTreeWidgetItem;
    bool operator<(const QTreeWidgetItem& other) const override {
        const int column = treeWidget()->sortColumn();
        const QVariant mine = data(column, kPastSortRole), its = other.data(column, kPastSortRole);
        if (mine.typeId() == QMetaType::Double)
            return mine.toDouble() < its.toDouble();
        return QString::localeAwareCompare(mine.toString(), its.toString()) < 0;
    }

    void set(int column, const QString& text, double key) {
        setText(column, text);
        setData(column, kPastSortRole, key);
        setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    }
    void set(int column, const QString& text) {
        setText(column, text);
        setData(column, kPastSortRole, text);
        setToolTip(column, text);
    }
    void setDate(int column, const QDateTime& date, const SessionHeader& run) {
        setText(column, pastDate(date));
        setData(column, kPastSortRole, static_cast<double>(date.toMSecsSinceEpoch()));
        setToolTip(column, QString::fromStdString(run.path));
    }
    /// What has no end is before all that has one.
    void setActive(int column, const AlarmDuration& active) {
        const QString sum = formatDuration(active.sum_s);
        set(column,
            active.isAtLeast
                ? AlarmHistoryDialog::tr("at least %1", "a duration: minutes and seconds").arg(sum)
                : sum,
            std::isnan(active.sum_s) ? -1.0 : active.sum_s);
    }
};

QTreeWidget* pastTree(const char* name, int columns, int sortedBy, Qt::SortOrder order, QWidget* parent) {
    auto* tree = new QTreeWidget(parent);
    tree->setObjectName(QLatin1String(name));
    tree->setColumnCount(columns);
    tree->setRootIsDecorated(false);
    tree->setUniformRowHeights(true);
    tree->setAlternatingRowColors(true);
    tree->setAllColumnsShowFocus(true);
    tree->setIconSize({kPastMark, kPastMark});
    tree->setMinimumHeight(80);
    tree->setSortingEnabled(true);
    tree->sortByColumn(sortedBy, order);
    return tree;
}

/// Columns of names are as wide as a person makes them, the others as their content.
void fitPastColumns(QTreeWidget& tree) {
    const QHeaderView& header = *tree.header();
    const int name = 20 * tree.fontMetrics().averageCharWidth();
    for (int column = 0; column < tree.columnCount(); ++column)
        if (header.sectionResizeMode(column) == QHeaderView::Interactive)
            tree.setColumnWidth(column,
                                std::max({name, tree.columnWidth(column), header.sectionSizeHint(column)}));
}

std::size_t timesUnrecorded(const AlarmHistory& history) {
    return std::accumulate(
        history.alarms.begin(), history.alarms.end(), std::size_t{0},
        [](std::size_t sum, const PastAlarm& alarm) { return sum + alarm.withoutRun.size(); });
}

std::size_t runsWithAlarms(const AlarmHistory& history) {
    std::set<std::size_t> runs;
    for (const PastAlarm& alarm : history.alarms)
        for (const AlarmInRun& in : alarm.runs)
            runs.insert(in.run);
    return runs.size();
}

} // namespace

AlarmHistoryDialog::AlarmHistoryDialog(QWidget* parent)
    : QDialog(parent), m_filter(new QLineEdit(this)), m_summary(new QLabel(this)),
      m_alarms(pastTree("alarmHistoryAlarms", kPastColumns, kPastPriority, Qt::AscendingOrder, this)),
      m_runs(pastTree("alarmHistoryRuns", kInColumns, kInDate, Qt::DescendingOrder, this)),
      m_unread(new QLabel(this)), m_copy(new QPushButton(this)), m_open(new QPushButton(this)),
      m_close(new QPushButton(this)) {
    build();
    connect(m_filter, &QLineEdit::textChanged, this, &AlarmHistoryDialog::filter);
    connect(m_alarms, &QTreeWidget::currentItemChanged, this, &AlarmHistoryDialog::showRuns);
    connect(m_runs, &QTreeWidget::currentItemChanged, this, &AlarmHistoryDialog::enableOpen);
    connect(m_runs, &QTreeWidget::itemActivated, this, &AlarmHistoryDialog::openRun);
    connect(m_copy, &QPushButton::clicked, this, &AlarmHistoryDialog::copy);
    connect(m_open, &QPushButton::clicked, this, &AlarmHistoryDialog::openRun);
    connect(m_close, &QPushButton::clicked, this, &QDialog::reject);
    retranslate();
}

void AlarmHistoryDialog::build() {
    setObjectName(QStringLiteral("alarmHistoryDialog"));
    m_filter->setObjectName(QStringLiteral("alarmHistoryFilter"));
    m_filter->setClearButtonEnabled(true);
    m_summary->setObjectName(QStringLiteral("alarmHistorySummary"));
    m_unread->setObjectName(QStringLiteral("alarmHistoryUnread"));
    for (QLabel* label : {m_summary, m_unread}) {
        label->setWordWrap(true);
        label->setTextFormat(Qt::PlainText);
    }
    m_copy->setObjectName(QStringLiteral("alarmHistoryCopy"));
    m_open->setObjectName(QStringLiteral("alarmHistoryOpen"));
    m_close->setObjectName(QStringLiteral("alarmHistoryClose"));
    for (QPushButton* button : {m_copy, m_open, m_close})
        button->setAutoDefault(false); // Enter opens the selected run
    m_alarms->header()->setStretchLastSection(false);
    m_alarms->header()->setSectionResizeMode(kPastAlarm, QHeaderView::Stretch);
    for (const PastColumn column : {kPastPriority, kPastRuns, kPastTimes, kPastActive, kPastLast})
        m_alarms->header()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
    for (const PastRunColumn column : {kInDate, kInRig, kInTimes, kInActive})
        m_runs->header()->setSectionResizeMode(column, QHeaderView::ResizeToContents);

    auto* parts = new QSplitter(Qt::Vertical, this);
    parts->setChildrenCollapsible(false);
    parts->addWidget(m_alarms);
    parts->addWidget(m_runs);
    parts->setStretchFactor(0, 3);
    parts->setStretchFactor(1, 2);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_copy);
    buttons->addStretch(1);
    buttons->addWidget(m_open);
    buttons->addWidget(m_close);
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_filter);
    column->addWidget(m_summary);
    column->addWidget(parts, 1);
    column->addWidget(m_unread);
    column->addLayout(buttons);
    QSize size(900, 560);
    if (parentWidget() != nullptr)
        size = size.boundedTo(parentWidget()->window()->size());
    resize(size);
}

void AlarmHistoryDialog::setReading(int percent) {
    m_isReading = true;
    m_percent = percent;
    showSummary();
}

void AlarmHistoryDialog::setHistory(AlarmHistory history) {
    const Message before = chosen();
    {
        const QSignalBlocker quiet(m_alarms);
        m_alarms->clear(); // its rows are of the history before
    }
    m_history = std::move(history);
    m_isReading = false;
    showAlarms(before);
    showUnread();
}

/// The selected alarm, without one the sentence that is none.
Message AlarmHistoryDialog::chosen() const {
    const PastAlarm* alarm = selected();
    return alarm == nullptr ? Message{} : alarm->message();
}

/// Places in the history: a damaged file may have any number of names.
std::vector<std::size_t> AlarmHistoryDialog::shownAlarms() const {
    std::vector<std::size_t> places(m_history.alarms.size());
    std::iota(places.begin(), places.end(), std::size_t{0});
    if (places.size() > kMaxShown) {
        std::ranges::stable_sort(places, {},
                                 [&](std::size_t place) { return m_history.alarms[place].priority(); });
        places.resize(kMaxShown);
    }
    return places;
}

void AlarmHistoryDialog::showAlarms(const Message& chosen) {
    {
        const QSignalBlocker quiet(m_alarms);
        m_alarms->setSortingEnabled(false);
        m_alarms->clear();
        QTreeWidgetItem* current = nullptr;
        QList<QTreeWidgetItem*> rows;
        for (const std::size_t place : shownAlarms()) {
            rows << alarmRow(place);
            if (isSameAlarm(m_history.alarms[place].message(), chosen))
                current = rows.back();
        }
        m_alarms->addTopLevelItems(rows);
        m_alarms->setSortingEnabled(true);
        m_alarms->setCurrentItem(current);
        fitPastColumns(*m_alarms);
    }
    hideOthers();
    showRuns();
}

QTreeWidgetItem* AlarmHistoryDialog::alarmRow(std::size_t place) const {
    const PastAlarm& alarm = m_history.alarms[place];
    const bool isUnrecorded = isLastUnrecorded(m_history, alarm);
    const QString sentence = sentenceText(isUnrecorded ? alarm.withoutRun.front().message : alarm.message());
    auto* row = new PastRow;
    row->set(kPastAlarm, sentence);
    row->setData(kPastAlarm, kPastPlaceRole, QVariant::fromValue<qulonglong>(place));
    row->setData(kPastAlarm, Qt::AccessibleTextRole,
                 tr("Priority %1: %2").arg(alarm.priority()).arg(sentence));
    row->setIcon(kPastAlarm,
                 QIcon(alarmPixmap(alarm.priority(), isDark(this), kPastMark, devicePixelRatioF())));
    const double raised = isUnrecorded
                              ? alarm.withoutRun.front().raised_s
                              : lastRaised(m_history.runs[alarm.runs.front().run], alarm.runs.front());
    row->set(kPastPriority, QString::number(alarm.priority()), gravity(alarm.priority(), raised));
    row->set(kPastRuns, QString::number(alarm.runs.size()), static_cast<double>(alarm.runs.size()));
    row->set(kPastTimes, QString::number(alarm.times()), static_cast<double>(alarm.times()));
    row->setActive(kPastActive, alarm.active());
    if (isUnrecorded) {
        row->set(kPastLast, pastDate(unrecordedDate(alarm.withoutRun.front())));
        row->set(kPastLastRun, tr("No run"));
    } else {
        const AlarmInRun& in = alarm.runs.front();
        const SessionHeader& last = m_history.runs[in.run];
        row->set(kPastLast, tr("%1 + %2", "when a run was recorded, and the time in it")
                                .arg(pastDate(recordedAt(last)), formatDuration(in.spells.back().raised_s)));
        row->setToolTip(kPastLast, QString::fromStdString(last.path));
        row->set(kPastLastRun, tr("%1, %2", "a run: its name, and when it was recorded")
                                   .arg(listedName(last), pastDate(recordedAt(last))));
    }
    row->setData(kPastLast, kPastSortRole, raised);
    return row;
}

void AlarmHistoryDialog::filter() {
    const PastAlarm* before = selected();
    hideOthers();
    if (selected() != before)
        showRuns();
}

/// Leaves the alarms that have every word.
void AlarmHistoryDialog::hideOthers() {
    const QStringList words = m_filter->text().simplified().toCaseFolded().split(u' ', Qt::SkipEmptyParts);
    QTreeWidgetItem* first = nullptr;
    for (int k = 0; k < m_alarms->topLevelItemCount(); ++k) {
        QTreeWidgetItem* row = m_alarms->topLevelItem(k);
        const QString all = row->text(kPastAlarm).toCaseFolded();
        const bool isFound =
            std::ranges::all_of(words, [&](const QString& word) { return all.contains(word); });
        row->setHidden(!isFound);
        if (isFound && first == nullptr)
            first = row;
    }
    if (selected() == nullptr) {
        const QSignalBlocker quiet(m_alarms);
        m_alarms->setCurrentItem(first);
    }
    m_copy->setEnabled(first != nullptr);
    showSummary();
}

const PastAlarm* AlarmHistoryDialog::selected() const {
    const QTreeWidgetItem* row = m_alarms->currentItem();
    return row == nullptr || row->isHidden()
               ? nullptr
               : &m_history.alarms[row->data(kPastAlarm, kPastPlaceRole).toULongLong()];
}

void AlarmHistoryDialog::showRuns() {
    m_runs->setSortingEnabled(false);
    m_runs->clear();
    if (const PastAlarm* alarm = selected()) {
        QList<QTreeWidgetItem*> rows;
        for (const AlarmInRun& in : alarm->runs)
            rows << runRow(in);
        const std::size_t shown = std::min(alarm->withoutRun.size(), kMaxShown);
        for (std::size_t k = 0; k < shown; ++k)
            rows << unrecordedRow(alarm->withoutRun[k]);
        m_runs->addTopLevelItems(rows);
    }
    m_runs->setSortingEnabled(true);
    m_runs->setCurrentItem(m_runs->topLevelItem(0));
    enableOpen();
    fitPastColumns(*m_runs);
}

/// The path of the selected run; empty if none is, and for an alarm without one.
QString AlarmHistoryDialog::selectedPath() const {
    const QTreeWidgetItem* row = m_runs->currentItem();
    return row == nullptr ? QString() : row->data(kInDate, kInPathRole).toString();
}

void AlarmHistoryDialog::enableOpen() {
    m_open->setEnabled(!selectedPath().isEmpty());
}

QTreeWidgetItem* AlarmHistoryDialog::runRow(const AlarmInRun& in) const {
    const SessionHeader& run = m_history.runs[in.run];
    QStringList times;
    for (const AlarmSpell& spell : in.spells) {
        if (times.size() == kMaxListed) {
            times << QStringLiteral("\u2026");
            break;
        }
        times << formatDuration(spell.raised_s);
    }
    auto* row = new PastRow;
    row->setDate(kInDate, recordedAt(run), run);
    row->setData(kInDate, kInPathRole, QString::fromStdString(run.path));
    row->setData(kInDate, kInRaisedRole, in.spells.back().raised_s);
    row->set(kInName, listedName(run));
    row->set(kInRig, run.simulated ? tr("SIMULATED") : tr("LIVE"));
    row->set(kInTimes, QString::number(in.spells.size()), static_cast<double>(in.spells.size()));
    row->setActive(kInActive, in.active());
    row->set(kInAt, times.join(QStringLiteral(", ")));
    row->setData(kInAt, kPastSortRole, in.spells.front().raised_s);
    return row;
}

QTreeWidgetItem* AlarmHistoryDialog::unrecordedRow(const UnrecordedSpell& spell) const {
    auto* row = new PastRow;
    row->setText(kInDate, pastDate(unrecordedDate(spell)));
    row->setData(kInDate, kPastSortRole, 1e3 * spell.raised_s);
    row->set(kInName, tr("No run"));
    row->setToolTip(kInName, tr("Raised while nothing was recorded"));
    row->set(kInRig, spell.isLive ? tr("LIVE") : tr("SIMULATED"));
    row->set(kInTimes, QString::number(1), 1.0);
    row->setActive(kInActive, {spell.active_s});
    row->set(kInAt, kNoValue);
    row->setData(kInAt, kPastSortRole, -1.0); // before all that are since Start
    return row;
}

void AlarmHistoryDialog::showSummary() {
    const auto read = static_cast<int>(m_history.runs.size() - m_history.unreadable.size());
    const int rows = m_alarms->topLevelItemCount();
    if (m_isReading)
        m_summary->setText(tr("Reading the runs: %1 %").arg(m_percent));
    else if (m_history.runs.empty() && rows == 0)
        m_summary->setText(tr("The list has no run."));
    else if (rows == 0)
        m_summary->setText(tr("No alarm was raised in %n run(s).", nullptr, read));
    else if (selected() == nullptr)
        m_summary->setText(tr("No alarm matches \"%1\".").arg(m_filter->text().simplified()));
    else
        m_summary->setText(raisedWords(read));
}

QString AlarmHistoryDialog::raisedWords(int read) const {
    QString raised = tr("Alarms in %1 of %n run(s)", nullptr, read).arg(runsWithAlarms(m_history));
    if (const std::size_t times = timesUnrecorded(m_history); times > 0)
        raised = tr("%1, and %n time(s) while nothing was recorded", "%1: Alarms in 2 of 5 runs",
                    static_cast<int>(times))
                     .arg(raised);
    return m_history.alarms.size() <= kMaxShown
               ? raised
               : tr("%1. Only %2 of %3 alarms are shown, the gravest.", "%1: Alarms in 2 of 5 runs")
                     .arg(raised)
                     .arg(kMaxShown)
                     .arg(m_history.alarms.size());
}

void AlarmHistoryDialog::showUnread() {
    QStringList names, reasons;
    for (const std::size_t k : m_history.unreadable) {
        const SessionHeader& run = m_history.runs[k];
        const QString name = QFileInfo(QString::fromStdString(run.path)).fileName();
        reasons << name + QStringLiteral(": ") + sentenceText(run.error->message);
        if (names.size() < kMaxNamed)
            names << name;
        else if (names.size() == kMaxNamed)
            names << QStringLiteral("\u2026");
    }
    QStringList told;
    if (!names.isEmpty())
        told << tr("%n recording(s) could not be read: %1", nullptr, static_cast<int>(reasons.size()))
                    .arg(names.join(QStringLiteral(", ")));
    if (m_history.failure) {
        told << tr("The alarms that were raised while nothing was recorded could not be read.");
        reasons << QString::fromStdString(m_history.failure->where) + QStringLiteral(": ") +
                       sentenceText(m_history.failure->message);
    }
    if (m_history.damagedLines > 0)
        told << tr("%n line(s) with alarms that were raised while nothing was recorded could not be read.",
                   nullptr, static_cast<int>(m_history.damagedLines));
    m_unread->setVisible(!told.isEmpty());
    m_unread->setText(told.join(u'\n'));
    m_unread->setToolTip(reasons.join(u'\n'));
}

void AlarmHistoryDialog::openRun() {
    if (const QString path = selectedPath(); !path.isEmpty())
        emit runChosen(path, m_runs->currentItem()->data(kInDate, kInRaisedRole).toDouble());
}

/// The alarms that are shown, for a spreadsheet.
void AlarmHistoryDialog::copy() const {
    QStringList lines;
    const auto add = [&](const QTreeWidgetItem& row) {
        QStringList cells;
        for (int column = 0; column < kPastColumns; ++column)
            cells << row.text(column).simplified();
        lines << cells.join(u'\t');
    };
    add(*m_alarms->headerItem());
    for (int k = 0; k < m_alarms->topLevelItemCount(); ++k)
        if (!m_alarms->topLevelItem(k)->isHidden())
            add(*m_alarms->topLevelItem(k));
    QApplication::clipboard()->setText(lines.join(u'\n'));
}

void AlarmHistoryDialog::retranslate() {
    setWindowTitle(tr("Alarms of the listed runs"));
    m_filter->setPlaceholderText(tr("Filter the alarms"));
    m_filter->setToolTip(tr("Shows the alarms that have every word."));
    m_filter->setAccessibleName(m_filter->placeholderText());
    m_alarms->setHeaderLabels({tr("Alarm"), tr("Priority"), tr("Runs"), tr("Times"), tr("Active"),
                               tr("Last raised"), tr("Last run")});
    m_alarms->setAccessibleName(tr("Alarms"));
    m_alarms->headerItem()->setToolTip(kPastAlarm, tr("As it was raised the last time"));
    m_alarms->headerItem()->setToolTip(kPastRuns, tr("Number of runs in which it was raised"));
    m_alarms->headerItem()->setToolTip(kPastTimes, tr("How often it was raised"));
    m_alarms->headerItem()->setToolTip(
        kPastActive, tr("Time for which it was active, until it was over or reset. \"At least\": a recording "
                        "ended before it, or the end of one of its times is not known."));
    m_alarms->headerItem()->setToolTip(kPastPriority, tr("1 is the gravest"));
    m_alarms->headerItem()->setToolTip(kPastLast,
                                       tr("When the last run with it was recorded, and the time since Start "
                                          "when it was raised"));
    m_runs->setHeaderLabels(
        {tr("Recorded"), tr("Run"), tr("Rig"), tr("Times"), tr("Active"), tr("Raised at")});
    m_runs->setAccessibleName(tr("Runs of the selected alarm"));
    m_runs->headerItem()->setToolTip(kInDate, tr("Without a run, when the alarm was raised"));
    m_runs->headerItem()->setToolTip(kInAt, tr("Time since Start"));
    m_copy->setText(tr("Copy"));
    m_copy->setToolTip(tr("Copy the alarms as text, for a spreadsheet"));
    m_open->setText(tr("Open"));
    m_open->setAccessibleName(tr("Open the selected run"));
    m_open->setToolTip(tr("Opens the run at the moment when the alarm was last raised in it"));
    m_close->setText(tr("Close"));
    showAlarms(chosen());
    showUnread();
}

/// Another language comes by retranslate(), as another unit does.
void AlarmHistoryDialog::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange)
        showAlarms(chosen());
    QDialog::changeEvent(event);
}

} // namespace bask
