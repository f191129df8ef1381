#include "app/undo_actions.h"

#include "app/actions.h"
#include "engine/model/limits_widened.h"
#include "widgets/rig/way_up_question.h"

#include <QAction>
#include <QApplication>
#include <QDoubleSpinBox>
#include <QKeyEvent>
#include <QLineEdit>

namespace bask {
namespace {

const QString kQuestion = QStringLiteral("undoQuestion");

/// Text is being typed there, and the field can take it back itself.
bool undoesItself(const QObject* watched) {
    const auto* line = qobject_cast<const QLineEdit*>(watched);
    if (const auto* spin = qobject_cast<const QAbstractSpinBox*>(watched))
        line = spin->findChild<const QLineEdit*>();
    if (const auto* number = qobject_cast<const QDoubleSpinBox*>(watched))
        return number->cleanText() != number->textFromValue(number->value());
    return line == nullptr || line->isUndoAvailable() || line->isRedoAvailable();
}

} // namespace

bool allowsEdit(RunState state, EditScope scope) {
    switch (scope) {
    case EditScope::Targets:
        return state != RunState::Stopping;
    case EditScope::Controller:
        return true;
    case EditScope::Vision:
    case EditScope::All:
        break;
    }
    return allowsEdits(state);
}

/// In a run the engine refuses a target above its limit.
bool UndoActions::allows(const EditStep& step, bool back) const {
    return allowsEdit(m_state, step.edit.scope) &&
           (allowsEdits(m_state) || checkTargets(back ? *step.before : *step.after));
}

UndoActions::UndoActions(Document& document, QAction* undo, QAction* redo, QWidget* window)
    : QObject(window), m_document(document), m_undo(undo), m_redo(redo), m_window(window) {
    connect(m_undo, &QAction::triggered, this, [this] { ask(true); });
    connect(m_redo, &QAction::triggered, this, [this] { ask(false); });
    connect(&m_document, &Document::changed, this, [this] {
        dropQuestion(m_window, kQuestion); // it was about another experiment
        refresh();
    });
    qApp->installEventFilter(this);
    refresh();
}

void UndoActions::setState(RunState state) {
    if (state == m_state)
        return;
    m_state = state;
    if (!allowsEdits(state))
        dropQuestion(m_window, kQuestion);
    refresh();
}

void UndoActions::refresh() {
    show(true, tr("&Undo"), tr("Nothing to undo"));
    show(false, tr("&Redo"), tr("Nothing to redo"));
}

void UndoActions::show(bool back, const QString& word, const QString& nothing) {
    QAction* action = back ? m_undo : m_redo;
    const EditStep* step = back ? m_document.toUndo() : m_document.toRedo();
    QString text = word;
    QString tip = nothing;
    if (step != nullptr) {
        tip = editWords(step->edit, *step->before, *step->after);
        //: %1 is "Undo" or "Redo", %2 what: "Undo: move of bunny"
        text = tr("%1: %2").arg(word, QString(tip).replace(u'&', QStringLiteral("&&")));
        tip = tr("%1: %2").arg(QString(word).remove(u'&'), tip);
    }
    const bool allowed = step != nullptr && allows(*step, back);
    if (step != nullptr && !allowed)
        tip += u'\n' + tr("A run is armed or on. This can be changed once it has stopped.");
    action->setText(text);
    action->setToolTip(tip);
    action->setEnabled(allowed);
}

void UndoActions::ask(bool back) {
    const EditStep* step = back ? m_document.toUndo() : m_document.toRedo();
    if (step == nullptr || !allows(*step, back))
        return;
    const Experiment& wanted = back ? *step->before : *step->after;
    if ((!m_document.experiment().rig && !wanted.rig) || !widensLimits(m_document.experiment(), wanted))
        return go(back);
    askOnTheWayUp(m_window, kQuestion, tr("Raise a limit of the real rig"),
                  (back ? m_undo : m_redo)->toolTip() + QStringLiteral("\n\n") +
                      tr("This allows the rig more than now. Do robot, source, objects and sensors bear it?"),
                  tr("Raise the limit"), [this, back] { go(back); });
}

void UndoActions::go(bool back) {
    const EditStep* step = back ? m_document.toUndo() : m_document.toRedo();
    if (step == nullptr)
        return;
    const EditStep done = *step;
    if (back) {
        m_document.undo();
        emit undone(done);
    } else {
        m_document.redo();
        emit redone(done);
    }
}

bool UndoActions::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::ShortcutOverride)
        return false;
    const auto* key = static_cast<const QKeyEvent*>(event);
    if (!key->matches(QKeySequence::Undo) && !key->matches(QKeySequence::Redo))
        return false;
    if ((qobject_cast<QLineEdit*>(watched) == nullptr &&
         qobject_cast<QAbstractSpinBox*>(watched) == nullptr) ||
        undoesItself(watched))
        return false;
    event->ignore(); // or the field would take the key and do nothing with it
    return true;
}

} // namespace bask
