#pragma once
// The chip in the state bar: the run's state as word, icon and colour; clicking it lists each reason with its
// remedy.

#include "engine/runtime/snapshot.h"

#include <QAbstractButton>
#include <QStringList>

class QMenu;

namespace bask {

/// What it shows is what the engine reported. Object names: "runStateChip", its menu "runStateReasons" with
/// one action a reason (their text is the reason).
class RunStateChip : public QAbstractButton {
    Q_OBJECT
public:
    explicit RunStateChip(QWidget* parent = nullptr);

    /// `reasons`: translated sentences, each with its remedy. Nothing is repainted when nothing changed.
    void setState(RunState state, const QStringList& reasons);
    /// The engine does not tell a state: nothing of what it told last is shown as if it still were so.
    void setUnknown(const QString& reason);
    /// A short line under the word; empty: none.
    void setCaption(const QString& caption);
    /// What is worth knowing besides, under the reasons: not counted, not to be chosen.
    void setNotes(const QStringList& notes);
    /// Narrow: a long word is shortened. Its width is the same for all states, as it is otherwise.
    void setCompact(bool isCompact);
    RunState state() const { return m_state; }
    bool isUnknown() const { return m_isUnknown; }
    const QString& caption() const { return m_caption; }
    const QStringList& reasons() const { return m_reasons; }
    QMenu* reasonsMenu() const { return m_menu; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    /// A reason was chosen in the list; the window shows the page where it is put right.
    void reasonActivated(int index);

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void retranslateUi();
    QString word() const;                  ///< of the state
    QAction* addLine(const QString& line); ///< to the menu
    void openMenu();

    RunState m_state = RunState::Idle;
    bool m_isUnknown = false;
    QStringList m_reasons;
    QString m_caption;
    QStringList m_notes;
    bool m_isCompact = false;
    QMenu* m_menu = nullptr;
};

} // namespace bask
