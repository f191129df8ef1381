#pragma once
// Edit > Undo and Redo, on every page: what they would do, whether they are allowed now, and doing it.

#include "app/document.h"
#include "engine/runtime/snapshot.h"

#include <QObject>

class QAction;
class QWidget;

namespace bask {

/// An undo is an edit: during a run only targets and gains can be undone, and if it loosens a limit of a real
/// rig, a person is asked first ("undoQuestion"). In a field with unentered text, Ctrl+Z is the field's own.
class UndoActions : public QObject {
    Q_OBJECT

public:
    UndoActions(Document& document, QAction* undo, QAction* redo, QWidget* window);

    void setState(RunState state);
    /// Updates the texts in the window's language.
    void refresh();

    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    void undone(const bask::EditStep& step);
    void redone(const bask::EditStep& step);

private:
    void ask(bool back);
    void go(bool back);
    bool allows(const EditStep& step, bool back) const;
    void show(bool back, const QString& word, const QString& nothing);

    Document& m_document;
    QAction *m_undo, *m_redo;
    QWidget* m_window;
    RunState m_state = RunState::Idle;
};

/// Returns whether the engine accepts such an edit in that state.
bool allowsEdit(RunState state, EditScope scope);

} // namespace bask
