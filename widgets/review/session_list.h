#pragma once
// The recorded runs of a folder: searched, tagged, opened.

#include "engine/base/units.h"
#include "engine/recording/session_header.h"
#include "widgets/review/outcome_words.h"

#include <QIcon>
#include <QStringList>
#include <QWidget>

#include <map>
#include <vector>

class QLabel;
class QLineEdit;
class QMenu;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace bask {

class MessageBar;
class TwoLineDelegate;

/// A run is listed by its experiment, one whose file a person named by that name; under it is what tells runs
/// of one experiment apart. Reading and writing are the receiver's work. Object names: "sessionSearch",
/// "sessionFolder", "sessionAlarms", "sessionTree", "sessionCount", "sessionMessage", "sessionTags",
/// "sessionOpen", "sessionCompare", "sessionMenu" (of a row), "sessionSorting" (in it).
class SessionList : public QWidget {
    Q_OBJECT

public:
    explicit SessionList(QWidget* parent = nullptr);

    /// What is wrong with the selected run, or that none is found: in no layout, since it comes and goes.
    MessageBar* message() const { return m_message; }

    void setFolder(const QString& folder);
    /// The list is being read: the shown content may be old.
    void setReading();
    void setSessions(std::vector<SessionHeader> sessions);
    /// Lists a run as verified: its outcome is what was recorded.
    void setVerified(const std::string& path);
    /// Sets the file that is being recorded, if any.
    void setRecording(const QString& path);
    bool isRecording(const std::string& path) const;
    /// Returns whether a run is listed as damaged.
    bool isDamaged(const std::string& path) const;
    /// Sets the run on the page, on which others can be overlaid; empty for none. It is bold and selected.
    void setOpened(const QString& path);
    void setTemperatureUnit(TemperatureUnit unit);
    /// Sorts as sorting() of another list tells, such as "duration descending"; by an unknown word not at
    /// all.
    void setSorting(const QString& sorting);
    QString sorting() const;
    /// Returns the runs that the search has left.
    std::vector<SessionHeader> listed() const;

    /// Returns the comma-separated tags, each once.
    static QStringList tagsOf(const QString& text);

signals:
    void sessionChosen(const QString& path);
    void compareRequested(const QString& path);
    /// Several runs were selected while none is open: the first is to be opened, the others laid over it.
    void comparisonRequested(const QString& path, const QStringList& over);
    void folderRequested();
    void alarmsRequested(); ///< of the runs that are listed
    void tagsEdited(const QString& path, const QStringList& tags);
    /// Closing the interrupted recording was requested.
    void closeRequested(const QString& path);
    void selectionChanged(const QString& path); ///< a run was selected
    void sessionsChanged();                     ///< by setSessions()
    /// The experiment of a run was requested as a new one.
    void experimentRequested(const QString& path);
    /// A person has chosen what the runs are sorted by.
    void sortingChanged(const QString& sorting);

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void showRows();
    void fillRow(QTreeWidgetItem* row, const SessionHeader& session, const QString& differences);
    const QIcon& outcomeIcon(Outcome outcome, int priority);
    bool isOpened(const QTreeWidgetItem* row) const;
    void markOpened(QTreeWidgetItem* row) const;
    void showOutcome(QTreeWidgetItem* row, const SessionHeader& session);
    Outcome listedOutcome(const SessionHeader& session) const;
    void fitNames();
    void search();
    void showSelected();
    void showMenu(const QPoint& at);
    void fillSorting(QMenu& menu);
    void connectTree();
    void takeTags();
    void retranslate();
    const SessionHeader* selected() const;
    QStringList chosenPaths() const;
    void overlay();

    std::vector<SessionHeader> m_sessions;
    QString m_recording, m_opened;
    QString m_tagsOf; ///< the path that the text of m_tags is about
    QString m_folderPath;
    bool m_isReading = true;
    int m_found = 0; ///< runs that the search has left
    TemperatureUnit m_unit = TemperatureUnit::Celsius;
    std::map<std::pair<Outcome, int>, QIcon> m_icons; ///< with their priority, in the colours of the palette
    QLineEdit* m_search;
    QPushButton *m_folder, *m_alarms;
    QTreeWidget* m_tree;
    TwoLineDelegate* m_cells;
    QLabel* m_count;
    MessageBar* m_message;
    QLabel* m_tagsLabel;
    QLineEdit* m_tags;
    QPushButton *m_open, *m_compare;
};

} // namespace bask
