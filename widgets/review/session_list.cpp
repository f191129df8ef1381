#include "widgets/review/session_list.h"

#include "engine/base/message_code.h"
#include "widgets/common/display.h"
#include "widgets/common/elided_label.h"
#include "widgets/common/message_bar.h"
#include "widgets/common/theme.h"
#include "widgets/review/run_differences.h"
#include "widgets/review/two_line_delegate.h"
#include "widgets/review/verification_words.h"

#include <QDateTime>
#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QMenu>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <string>
#include <utility>

namespace bask {
namespace {

enum ListColumn {
    kDate,
    kRunName,
    kOutcome,
    kDuration,
    kOperator,
    kSample,
    kRig,
    kTags,
    kListController, ///< shown before the tags
    kListColumns
};
/// In settings.
constexpr std::array<const char*, kListColumns> kSortNames{
    "recorded", "run", "outcome", "duration", "operator", "sample", "rig", "tags", "controller"};
const QString kDescending = QStringLiteral(" descending");
constexpr int kMinWidth = 260; // px
constexpr int kSortRole = Qt::UserRole;
constexpr int kPathRole = Qt::UserRole + 1;
constexpr int kSearchRole = Qt::UserRole + 2;

/// Sorted by what the texts stand for; those that are alike the newest first, whatever the order.
class Row : public QTreeWidgetItem {
public:
    using QTreeWidgetItem::QTreeWidgetItem;
    bool operator<(const QTreeWidgetItem& other) const override {
        const int column = treeWidget()->sortColumn();
        if (const int order = compared(column, other); order != 0)
            return order < 0;
        const int age = compared(kDate, other);
        return treeWidget()->header()->sortIndicatorOrder() == Qt::AscendingOrder ? age > 0 : age < 0;
    }

private:
    int compared(int column, const QTreeWidgetItem& other) const {
        const QVariant mine = data(column, kSortRole), its = other.data(column, kSortRole);
        if (mine.typeId() == QMetaType::Double) {
            const double a = mine.toDouble(), b = its.toDouble();
            return a < b ? -1 : a > b ? 1 : 0;
        }
        const QString a = mine.toString(), b = its.toString();
        return a == b ? 0 : QString::localeAwareCompare(a, b); // of a year's outcomes most are the same
    }
};

QString text(const std::string& utf8) {
    return QString::fromStdString(utf8);
}

QString joined(const std::vector<std::string>& texts, const QString& separator) {
    QStringList list;
    for (const std::string& one : texts)
        list << text(one);
    return list.join(separator);
}

/// Why a run cannot be read, or not all of it; null: nothing is known to be wrong.
const Error* problemOf(const SessionHeader& session) {
    return session.error ? &*session.error : session.damage ? &*session.damage : nullptr;
}

bool isListedDamaged(const SessionHeader& session) {
    const Error* problem = problemOf(session);
    return problem != nullptr && problem->code() == MessageCode::SessionDamaged;
}

std::vector<std::string> withoutEmpty(std::vector<std::string> texts) {
    std::erase(texts, std::string());
    return texts;
}

} // namespace

SessionList::SessionList(QWidget* parent)
    : QWidget(parent), m_search(new QLineEdit(this)), m_folder(new QPushButton(this)),
      m_alarms(new QPushButton(this)), m_tree(new QTreeWidget(this)), m_cells(new TwoLineDelegate(this)),
      m_count(new ElidedLabel(this)), m_message(new MessageBar(this)), m_tagsLabel(new QLabel(this)),
      m_tags(new QLineEdit(this)), m_open(new QPushButton(this)), m_compare(new QPushButton(this)) {
    m_search->setObjectName(QStringLiteral("sessionSearch"));
    m_search->setClearButtonEnabled(true);
    m_folder->setObjectName(QStringLiteral("sessionFolder"));
    m_alarms->setObjectName(QStringLiteral("sessionAlarms"));
    m_count->setObjectName(QStringLiteral("sessionCount"));
    m_message->setObjectName(QStringLiteral("sessionMessage"));
    m_tags->setObjectName(QStringLiteral("sessionTags"));
    m_tags->setMaxLength(400);
    m_tagsLabel->setBuddy(m_tags);
    m_open->setObjectName(QStringLiteral("sessionOpen"));
    m_compare->setObjectName(QStringLiteral("sessionCompare"));
    m_tree->setObjectName(QStringLiteral("sessionTree"));
    m_tree->setColumnCount(kListColumns);
    m_tree->setItemDelegate(m_cells);
    m_tree->setRootIsDecorated(false);
    m_tree->setUniformRowHeights(true);
    m_tree->setAlternatingRowColors(true);
    m_tree->setAllColumnsShowFocus(true);
    m_tree->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_tree->setSortingEnabled(true);
    m_tree->sortByColumn(kDate, Qt::DescendingOrder);
    m_tree->header()->setStretchLastSection(true);
    m_tree->header()->moveSection(kListController, kTags);
    for (const ListColumn column :
         {kOutcome, kDuration, kListController}) // never cut short; titles are, before them
        m_tree->header()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
    m_tree->setContextMenuPolicy(Qt::CustomContextMenu);
    m_tree->setMinimumHeight(110);

    auto* top = new QHBoxLayout;
    top->addWidget(m_search, 1);
    top->addWidget(m_folder);
    top->addWidget(m_alarms);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_count, 1);
    buttons->addWidget(m_compare);
    buttons->addWidget(m_open);
    auto* bottom = new QHBoxLayout;
    bottom->addWidget(m_tagsLabel);
    bottom->addWidget(m_tags, 1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    layout->addLayout(top);
    layout->addWidget(m_tree, 1);
    layout->addStrut(kMinWidth); // wider where the words need it
    layout->addLayout(buttons);
    layout->addLayout(bottom);

    connect(m_search, &QLineEdit::textChanged, this, &SessionList::search);
    connect(m_folder, &QPushButton::clicked, this, &SessionList::folderRequested);
    connect(m_alarms, &QPushButton::clicked, this, &SessionList::alarmsRequested);
    connectTree();
    connect(m_tags, &QLineEdit::editingFinished, this, &SessionList::takeTags);
    connect(m_message, &MessageBar::actionClicked, this, [this] {
        if (const SessionHeader* session = selected())
            return emit closeRequested(text(session->path));
        m_search->clear(); // nothing was found
        m_search->setFocus();
    });
    retranslate();
}

void SessionList::connectTree() {
    connect(m_tree, &QTreeWidget::currentItemChanged, this, [this] {
        showSelected();
        if (const SessionHeader* session = selected())
            emit selectionChanged(text(session->path));
    });
    connect(m_tree, &QTreeWidget::itemSelectionChanged, this, &SessionList::showSelected);
    const auto open = [this] {
        if (const SessionHeader* session = selected(); session != nullptr && !session->error)
            emit sessionChosen(text(session->path));
    };
    connect(m_tree, &QTreeWidget::itemActivated, this, open);
    connect(m_open, &QPushButton::clicked, this, open);
    connect(m_compare, &QPushButton::clicked, this, &SessionList::overlay);
    connect(m_tree, &QTreeWidget::customContextMenuRequested, this, &SessionList::showMenu);
    connect(m_tree->header(), &QHeaderView::sortIndicatorChanged, this,
            [this] { emit sortingChanged(sorting()); });
}

QStringList SessionList::tagsOf(const QString& text) {
    QStringList tags;
    for (const QString& part : text.split(u','))
        if (const QString tag = part.simplified(); !tag.isEmpty() && !tags.contains(tag))
            tags << tag;
    return tags;
}

void SessionList::setFolder(const QString& folder) {
    m_folderPath = folder;
    retranslate();
}

void SessionList::setReading() {
    m_isReading = true;
    search();
}

void SessionList::setSessions(std::vector<SessionHeader> sessions) {
    m_sessions = std::move(sessions);
    m_isReading = false;
    showRows();
    emit sessionsChanged();
}

void SessionList::setRecording(const QString& path) {
    if (path == m_recording)
        return;
    m_recording = path;
    showRows();
}

bool SessionList::isDamaged(const std::string& path) const {
    const QFileInfo file(text(path));
    return std::ranges::any_of(m_sessions, [&](const SessionHeader& session) {
        const QFileInfo listed(text(session.path));
        return isListedDamaged(session) && listed.fileName() == file.fileName() && listed == file;
    });
}

void SessionList::setOpened(const QString& path) {
    m_opened = path;
    for (int k = 0; k < m_tree->topLevelItemCount(); ++k) {
        QTreeWidgetItem* row = m_tree->topLevelItem(k);
        markOpened(row);
        if (isOpened(row))
            m_tree->setCurrentItem(row);
    }
    fitNames();
    showSelected();
}

void SessionList::setTemperatureUnit(TemperatureUnit unit) {
    if (unit == m_unit)
        return;
    m_unit = unit;
    showRows();
}

QString SessionList::sorting() const {
    const QHeaderView& header = *m_tree->header();
    const auto column = static_cast<std::size_t>(header.sortIndicatorSection());
    return QLatin1String(kSortNames.at(column)) +
           (header.sortIndicatorOrder() == Qt::DescendingOrder ? kDescending : QString());
}

void SessionList::setSorting(const QString& sorting) {
    const bool isDescending = sorting.endsWith(kDescending);
    const QString name = isDescending ? sorting.chopped(kDescending.size()) : sorting;
    const auto found =
        std::ranges::find(kSortNames, name, [](const char* each) { return QLatin1String(each); });
    if (found != kSortNames.end())
        m_tree->sortByColumn(static_cast<int>(found - kSortNames.begin()),
                             isDescending ? Qt::DescendingOrder : Qt::AscendingOrder);
}

std::vector<SessionHeader> SessionList::listed() const {
    std::set<std::string> paths;
    for (int k = 0; k < m_tree->topLevelItemCount(); ++k)
        if (!m_tree->isRowHidden(k, {}))
            paths.insert(m_tree->topLevelItem(k)->data(0, kPathRole).toString().toStdString());
    std::vector<SessionHeader> out;
    std::ranges::copy_if(m_sessions, std::back_inserter(out),
                         [&](const SessionHeader& each) { return paths.contains(each.path); });
    return out;
}

bool SessionList::isOpened(const QTreeWidgetItem* row) const {
    return !m_opened.isEmpty() && row->data(0, kPathRole).toString() == m_opened;
}

void SessionList::markOpened(QTreeWidgetItem* row) const {
    const bool is = isOpened(row);
    if (row->font(kRunName).bold() == is)
        return; // of thousands, all but two
    QFont bold = m_tree->font();
    bold.setBold(is);
    row->setFont(kRunName, bold);
    row->setData(kDate, Qt::AccessibleDescriptionRole, is ? tr("Open on this page") : QString());
}

bool SessionList::isRecording(const std::string& path) const {
    const QFileInfo file(text(path)), recording(m_recording);
    // Only the same name is looked up on the disk.
    return !m_recording.isEmpty() && file.fileName() == recording.fileName() && file == recording;
}

void SessionList::showRows() {
    const SessionHeader* before = selected();
    const std::string chosen = before != nullptr ? before->path : m_opened.toStdString();
    const QStringList others = chosenPaths();
    const QSignalBlocker quiet(m_tree);
    const int dateWidth = m_tree->columnWidth(kDate);
    const bool isFirst = m_tree->topLevelItemCount() == 0;
    m_tree->setSortingEnabled(false);
    m_tree->clear();
    QTreeWidgetItem* current = nullptr;
    QList<QTreeWidgetItem*> rows;
    const std::vector<QString> differences = runDifferences(m_sessions, m_unit);
    bool areTwoLines = false;
    for (std::size_t i = 0; i < m_sessions.size(); ++i) {
        rows << new Row;
        fillRow(rows.back(), m_sessions[i], differences[i]);
        areTwoLines = areTwoLines || rows.back()->data(kRunName, TwoLineDelegate::kDetailRole).isValid();
        if (m_sessions[i].path == chosen)
            current = rows.back();
    }
    m_cells->setTwoLines(areTwoLines);
    m_tree->addTopLevelItems(rows);
    m_tree->setSortingEnabled(true);
    if (current != nullptr)
        m_tree->setCurrentItem(current);
    for (QTreeWidgetItem* row : rows)
        if (others.contains(row->data(0, kPathRole).toString()))
            row->setSelected(true);
    if (isFirst)
        for (const ListColumn column : {kDate, kRunName, kOperator, kSample, kRig})
            m_tree->resizeColumnToContents(column);
    else
        m_tree->setColumnWidth(kDate, dateWidth);
    const auto hide = [&](ListColumn column, auto isSaid) {
        m_tree->setColumnHidden(column, std::ranges::none_of(m_sessions, isSaid));
    };
    hide(kOperator, [](const SessionHeader& each) { return !each.labels.operatorName.empty(); });
    hide(kSample,
         [](const SessionHeader& each) { return !each.labels.sample.empty() || !each.labels.batch.empty(); });
    std::set<std::string> controllers;
    for (const SessionHeader& each : m_sessions)
        controllers.insert(each.controller);
    controllers.erase(std::string()); // of a file that cannot be read
    m_tree->setColumnHidden(kListController, controllers.size() < 2);
    fitNames();
    search();
}

/// Titles get what the other columns leave.
void SessionList::fitNames() {
    for (int column = 0; column < m_tree->columnCount(); ++column) // larger text, another language
        m_tree->setColumnWidth(
            column, std::max(m_tree->columnWidth(column), m_tree->header()->sectionSizeHint(column)));
    int others = 0;
    for (const ListColumn column : {kDate, kOutcome, kDuration})
        others += m_tree->columnWidth(column);
    if (!m_cells->hasTwoLines()) { // what tells runs apart comes before the rest, which is scrolled to
        others += m_tree->header()->minimumSectionSize() + 40; // tags
        for (const ListColumn column : {kOperator, kSample, kRig, kListController})
            others += m_tree->columnWidth(column);
    }
    const int wanted = static_cast<const QAbstractItemView*>(m_tree)->sizeHintForColumn(kRunName) + 8;
    const int room = m_tree->viewport()->width() - others;
    m_tree->setColumnWidth(kRunName,
                           std::max(std::min(wanted, room), m_tree->header()->sectionSizeHint(kRunName)));
}

void SessionList::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fitNames();
}

const QIcon& SessionList::outcomeIcon(Outcome outcome, int priority) {
    QIcon& icon = m_icons[{outcome, priority}];
    if (icon.isNull()) {
        icon.addPixmap(outcomePixmap(outcome, isDark(this), 16, devicePixelRatioF(), priority));
        icon.addPixmap(outcomePixmap(outcome, true, 16, devicePixelRatioF(), priority),
                       QIcon::Selected); // on its ground
    }
    return icon;
}

void SessionList::fillRow(QTreeWidgetItem* row, const SessionHeader& session, const QString& differences) {
    const QDateTime date = recordedAt(session);
    const QString file = QFileInfo(text(session.path)).fileName();
    const Outcome outcome = listedOutcome(session);
    const QString given = session.error ? QString() : givenName(session), title = text(session.title);
    const QString name = listedName(session);
    const QString detail =
        joined(withoutEmpty({given.isEmpty() ? std::string() : session.title, differences.toStdString()}),
               QStringLiteral(" \u00b7 "));
    const QString tags = joined(session.tags, QStringLiteral(", "));
    const QString who = text(session.labels.operatorName);
    const QString sample =
        joined(withoutEmpty({session.labels.sample, session.labels.batch}), QStringLiteral(" / "));
    const QString rig = session.error ? QString() : session.simulated ? tr("SIMULATED") : tr("LIVE");
    const QString controller = session.error ? QString() : listedController(session);
    const QString word = outcome == Outcome::Other ? text(session.outcome) : outcomeWord(outcome);
    const bool hasTime = !session.error && session.samples > 0;
    const QStringList texts{formatDate(date),
                            name,
                            word,
                            hasTime ? formatDuration(session.length_s()) : kNoValue,
                            who,
                            sample,
                            rig,
                            tags,
                            controller};
    const QVariant keys[] = {static_cast<double>(date.toMSecsSinceEpoch()),
                             name,
                             word,
                             hasTime ? session.length_s() : -1.0,
                             who,
                             sample,
                             rig,
                             tags,
                             controller};
    for (int column = 0; column < kListColumns; ++column) {
        row->setText(column, texts[column]);
        row->setData(column, kSortRole, keys[column]);
        row->setToolTip(column, text(session.path));
    }
    for (const ListColumn column : {kRunName, kOutcome, kOperator, kSample, kRig, kTags, kListController})
        if (!texts[column].isEmpty())
            row->setToolTip(column, texts[column]);
    if (!detail.isEmpty()) {
        const QString both = name + u'\n' + detail;
        row->setData(kRunName, TwoLineDelegate::kDetailRole, detail);
        row->setData(kRunName, Qt::AccessibleTextRole, both);
        row->setToolTip(kRunName, both);
    }
    row->setTextAlignment(kDuration, Qt::AlignRight | Qt::AlignVCenter);
    showOutcome(row, session);
    row->setData(0, kPathRole, text(session.path));
    markOpened(row);
    QStringList all = texts;
    all << file << title << detail << joined(session.notes, QStringLiteral("\n"));
    for (const ListedObject& object : session.objects)
        all << text(object.name) << text(object.material);
    row->setData(0, kSearchRole, all.join(u'\n').toCaseFolded());
}

Outcome SessionList::listedOutcome(const SessionHeader& session) const {
    return isListedDamaged(session)        ? Outcome::Damaged
           : problemOf(session) != nullptr ? Outcome::Unreadable
           : session.alteration            ? Outcome::Altered
           : isRecording(session.path)     ? Outcome::Recording
                                           : outcomeOf(session.outcome);
}

/// In italics as long as nobody knows whether it is what was recorded.
void SessionList::showOutcome(QTreeWidgetItem* row, const SessionHeader& session) {
    const Error* problem = problemOf(session);
    const Outcome outcome = listedOutcome(session);
    const bool isUnsure =
        problem == nullptr && !session.alteration && !session.isVerified && outcome != Outcome::Recording;
    const QString word =
        outcome == Outcome::Fault ? outcomeWord(outcome, session.endPriority) : row->text(kOutcome);
    row->setIcon(kOutcome, outcomeIcon(outcome, session.endPriority));
    QFont font = m_tree->font();
    font.setItalic(isUnsure);
    row->setFont(kOutcome, font);
    row->setToolTip(kOutcome, problem != nullptr   ? sentenceText(problem->message)
                              : session.alteration ? verificationText(*session.alteration)
                              : isUnsure
                                  ? word + u'\n' +
                                        tr("Not verified: nobody has looked yet whether the recording is "
                                           "as it was made.")
                                  : word);
    row->setData(kOutcome, Qt::AccessibleTextRole,
                 isUnsure                    ? tr("%1, not verified", "an outcome").arg(word)
                 : outcome == Outcome::Fault ? QVariant(word)
                                             : QVariant());
}

void SessionList::setVerified(const std::string& path) {
    const auto session = std::ranges::find(m_sessions, path, &SessionHeader::path);
    if (session == m_sessions.end() || std::exchange(session->isVerified, true))
        return;
    for (int k = 0; k < m_tree->topLevelItemCount(); ++k)
        if (QTreeWidgetItem* row = m_tree->topLevelItem(k); row->data(0, kPathRole).toString() == text(path))
            return showOutcome(row, *session);
}

/// Rows that have every word of the search somewhere.
void SessionList::search() {
    const QStringList words = m_search->text().simplified().toCaseFolded().split(u' ', Qt::SkipEmptyParts);
    m_found = 0;
    for (int k = 0; k < m_tree->topLevelItemCount(); ++k) {
        const QString all = m_tree->topLevelItem(k)->data(0, kSearchRole).toString();
        const bool isFound =
            std::ranges::all_of(words, [&](const QString& word) { return all.contains(word); });
        m_tree->setRowHidden(k, {}, !isFound); // a row's own setHidden() looks for its place among all
        m_found += isFound ? 1 : 0;
    }
    const auto count = static_cast<int>(m_sessions.size());
    if (m_isReading)
        m_count->setText(tr("Reading the folder\u2026"));
    else if (count == 0)
        m_count->setText(tr("No recorded runs in this folder."));
    else if (m_found < count)
        m_count->setText(tr("%1 of %n session(s)", nullptr, count).arg(m_found));
    else
        m_count->setText(tr("%n session(s)", nullptr, count));
    showSelected();
}

/// None that the search has hidden: nobody sees what would be changed.
const SessionHeader* SessionList::selected() const {
    const QTreeWidgetItem* row = m_tree->currentItem();
    if (row == nullptr || row->isHidden())
        return nullptr;
    const std::string path = row->data(0, kPathRole).toString().toStdString();
    const auto found = std::ranges::find(m_sessions, path, &SessionHeader::path);
    return found != m_sessions.end() ? &*found : nullptr;
}

/// The selected runs that can be read, from the top of the list.
QStringList SessionList::chosenPaths() const {
    QStringList paths;
    for (int k = 0; k < m_tree->topLevelItemCount(); ++k) {
        const QTreeWidgetItem* row = m_tree->topLevelItem(k);
        if (!row->isSelected() || row->isHidden())
            continue;
        const QString path = row->data(0, kPathRole).toString();
        const auto found = std::ranges::find(m_sessions, path.toStdString(), &SessionHeader::path);
        if (found != m_sessions.end() && !found->error)
            paths << path;
    }
    return paths;
}

void SessionList::overlay() {
    QStringList paths = chosenPaths();
    if (m_opened.isEmpty() && paths.size() > 1) {
        const QString first = paths.takeFirst();
        return emit comparisonRequested(first, paths);
    }
    if (const SessionHeader* session = selected(); session != nullptr && paths.isEmpty())
        paths << text(session->path); // the keyboard is on it
    if (paths.size() > 1)
        paths.removeAll(m_opened); // selected together with those that go over it
    for (const QString& path : paths)
        emit compareRequested(path);
}

void SessionList::showSelected() {
    const SessionHeader* session = selected();
    const bool isReadable = session != nullptr && !session->error;
    const bool isOn = isReadable && isRecording(session->path);
    const Error* problem = session != nullptr ? problemOf(*session) : nullptr;
    const bool hasEnd = isReadable && problem == nullptr && !isOn && !session->outcome.empty();
    m_open->setEnabled(isReadable);
    m_compare->setEnabled(isReadable && (!m_opened.isEmpty() || chosenPaths().size() > 1));
    m_tags->setEnabled(hasEnd);
    m_tagsLabel->setEnabled(hasEnd);
    const QString path = session != nullptr ? text(session->path) : QString();
    const QString tags = session != nullptr ? joined(session->tags, QStringLiteral(", ")) : QString();
    if (path != m_tagsOf || !m_tags->hasFocus()) { // not while somebody types
        m_tagsOf = path;
        m_tags->setText(tags);
    }
    if (session == nullptr && m_found == 0 && !m_sessions.empty())
        return m_message->say(MessageBar::Kind::Note,
                              tr("No run matches \"%1\".").arg(m_search->text().simplified()),
                              tr("Show all runs"), false);
    if (session == nullptr)
        return m_message->clear();
    if (problem != nullptr)
        return m_message->say(
            MessageBar::Kind::Problem,
            QStringLiteral("%1: %2").arg(QFileInfo(path).fileName(), sentenceText(problem->message)), {},
            false);
    if (session->alteration)
        return m_message->say(
            MessageBar::Kind::Problem,
            QStringLiteral("%1: %2").arg(QFileInfo(path).fileName(), verificationText(*session->alteration)),
            {}, false);
    if (isOn)
        return m_message->say(MessageBar::Kind::Note, tr("This run is being recorded now."), {}, false);
    if (!session->outcome.empty())
        return m_message->clear();
    const QString saved = tr("%n sample(s)", nullptr, static_cast<int>(session->samples));
    m_message->say(MessageBar::Kind::Note,
                   tr("The recording has no end: Bask or the computer went down. Saved: %1, until %2 after "
                      "Start; at most the last %3 s before it went down are missing.")
                       .arg(saved, formatDuration(session->end_s), QLocale().toString(kMaxLost_s)),
                   tr("Close it properly"), false);
}

/// What can be done with the selected run, and what the runs are sorted by: also for who has no mouse.
void SessionList::showMenu(const QPoint& at) {
    delete findChild<QMenu*>(QStringLiteral("sessionMenu"));
    auto* menu = new QMenu(this);
    menu->setObjectName(QStringLiteral("sessionMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    if (const SessionHeader* session = selected(); session != nullptr && !session->error) {
        const QString path = text(session->path);
        menu->addAction(tr("&Open"), this, [this, path] { emit sessionChosen(path); });
        menu->addAction(tr("O&verlay"), this, &SessionList::overlay)->setEnabled(m_compare->isEnabled());
        menu->addAction(tr("Open as &new experiment"), this,
                        [this, path] { emit experimentRequested(path); });
        menu->addSeparator();
    }
    fillSorting(*menu->addMenu(tr("&Sort by")));
    menu->popup(m_tree->viewport()->mapToGlobal(at));
}

/// A second choice of the same turns the order round, as a second click on a heading does.
void SessionList::fillSorting(QMenu& menu) {
    menu.setObjectName(QStringLiteral("sessionSorting"));
    const QHeaderView& header = *m_tree->header();
    for (int place = 0; place < kListColumns; ++place) {
        const int column = header.logicalIndex(place);
        const bool isOn = column == header.sortIndicatorSection();
        const bool isDescending =
            isOn ? header.sortIndicatorOrder() == Qt::AscendingOrder : column == kDate || column == kDuration;
        QAction* entry = menu.addAction(m_tree->headerItem()->text(column), this, [=, this] {
            m_tree->sortByColumn(column, isDescending ? Qt::DescendingOrder : Qt::AscendingOrder);
        });
        entry->setCheckable(true);
        entry->setChecked(isOn);
    }
}

void SessionList::takeTags() {
    if (m_tagsOf.isEmpty())
        return;
    const std::string path = m_tagsOf.toStdString();
    const auto session = std::ranges::find(m_sessions, path, &SessionHeader::path);
    if (session == m_sessions.end())
        return;
    const QStringList tags = tagsOf(m_tags->text());
    std::vector<std::string> wanted;
    for (const QString& tag : tags)
        wanted.push_back(tag.toStdString());
    if (wanted == session->tags)
        return;
    session->tags = wanted; // what was asked for; the folder is read again after it was written
    emit tagsEdited(m_tagsOf, tags);
}

void SessionList::retranslate() {
    m_search->setPlaceholderText(tr("Search names, experiments, operators, samples, notes, tags"));
    m_search->setToolTip(
        tr("Finds the runs that have every word in what the list shows, or among objects, materials "
           "and notes."));
    m_search->setAccessibleName(tr("Search the recorded runs"));
    m_folder->setText(tr("Folder\u2026"));
    m_folder->setToolTip(m_folderPath.isEmpty() ? tr("Choose the folder whose runs are listed")
                                                : tr("The runs listed are in %1").arg(m_folderPath));
    m_alarms->setText(tr("Alarms\u2026"));
    m_alarms->setToolTip(tr("Which alarms the listed runs had, how often and when"));
    m_icons.clear();
    m_tree->setHeaderLabels({tr("Recorded"), tr("Run"), tr("Outcome"), tr("Duration"), tr("Operator"),
                             tr("Sample / batch"), tr("Rig"), tr("Tags"), tr("Controller")});
    m_tree->headerItem()->setToolTip(
        kOutcome,
        tr("What each run told at its end; in italics until its recording was verified: a short one "
           "while nothing else is to be done, a long one when it is opened. Damage of its file is "
           "found when the run is selected, too. All of it is listed until the file changes or Bask "
           "is closed."));
    m_tree->headerItem()->setToolTip(
        kDuration, tr("From Start to Stop, STOP or the engine's end of the run. What is recorded after it, "
                      "until all is away or cold, does not count."));
    m_tree->setAccessibleName(tr("Recorded runs"));
    m_tagsLabel->setText(tr("Tags"));
    m_tags->setPlaceholderText(tr("with commas"));
    m_tags->setAccessibleName(tr("Tags of the selected run, with commas"));
    m_tags->setToolTip(tr("Kept in the session file. A recording without an end has to be closed first."));
    m_open->setText(tr("Open"));
    m_open->setAccessibleName(tr("Open the selected run"));
    m_compare->setText(tr("Overlay"));
    m_compare->setAccessibleName(tr("Lay the selected runs over the open one"));
    m_compare->setToolTip(
        tr("Draws the selected runs over the one that is open, all from their Start. Without "
           "an open one, select several (Ctrl and click): the first of them is opened."));
    m_count->setPalette(captionPalette(palette()));
    showRows();
}

void SessionList::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
        retranslate();
    QWidget::changeEvent(event);
}

} // namespace bask
