#pragma once
// The events and notes of a run, each with its time.

#include "engine/base/message.h"

#include <QList>
#include <QWidget>

class QTreeWidget;
class QTreeWidgetItem;

namespace bask {

/// Kind of a row; alarms show their priority as figure, shape and colour.
enum class EventKind { Event, Note, Alarm1, Alarm2, Alarm3 };
EventKind eventKind(MessageCode code);

/// Newest row last; it stays visible unless a person scrolled up. Object names: "eventList", its tree
/// "eventListTree".
class EventList : public QWidget {
    Q_OBJECT
public:
    explicit EventList(QWidget* parent = nullptr);

    /// Adds a row: `time_s` since Start, `text` already translated.
    void add(double time_s, const QString& text, EventKind kind = EventKind::Event);
    void clear();
    /// A row is selected by a single click, not only by Enter and a double click.
    void setChosenByClick();
    int count() const;
    QString textAt(int row) const;

signals:
    /// A row was chosen: plots can show that moment.
    void timeChosen(double time_s);

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslateUi();
    void decorate(QTreeWidgetItem* item) const;

    QTreeWidget* m_tree = nullptr;
};

} // namespace bask
