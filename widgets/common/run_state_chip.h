#pragma once
// The chip in the state bar: the run's state as word, icon and colour; clicking it lists each reason with its
// remedy.

#include "engine/runtime/snapshot.h"

#include <QAbstractButton>
#include <QStringList>

class QMenu;
class QPainter;

namespace bask {

/// Returns the priority of an alarm whose mark and colour a state has: that of the gravest of its reasons
/// that is an alarm, its own if that is 0; 0 for the normal states.
int statePriority(RunState state, int gravest = 0);

/// Shows only what the engine reported. Object names: "runStateChip", its menu "runStateReasons" with one
/// action for each reason (its text is the reason); what cannot be chosen there does nothing and is not
/// enabled.
class RunStateChip : public QAbstractButton {
    Q_OBJECT
public:
    explicit RunStateChip(QWidget* parent = nullptr);

    /// `reasons`: translated sentences, each with its remedy; `gravest`: see statePriority. It is repainted
    /// only if something changed.
    void setState(RunState state, const QStringList& reasons, int gravest = 0);
    /// Shows that the state is not known: nothing that was reported earlier is shown as current.
    void setUnknown(const QString& reason);
    /// Sets a short line under the word; empty for none.
    void setCaption(const QString& caption);
    /// Sets what to do now, and the verb that does it; null where none does. It is a line under the reasons
    /// with the verb's own action below.
    void setRemedy(const QString& remedy, QAction* verb);
    /// Sets what is said where there is no reason, in place of the state's own sentence; empty: that one.
    void setExplanation(const QString& explanation);
    /// Sets additional notes under the reasons: not counted and not selectable.
    void setNotes(const QStringList& notes);
    /// Narrow: a long word takes two lines. As otherwise, the width is the same for all states.
    void setCompact(bool isCompact);
    RunState state() const { return m_state; }
    bool isUnknown() const { return m_isUnknown; }
    const QString& caption() const { return m_caption; }
    const QStringList& reasons() const { return m_reasons; }
    QMenu* reasonsMenu() const { return m_menu; }
    static QString unknownWord(); ///< of a state that is not known

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    /// A reason was chosen in the list; the window shows the page where it can be corrected.
    void reasonActivated(int index);

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void retranslateUi();
    QString word() const;                                       ///< word of the state
    bool paintWord(QPainter& painter, const QRect& room) const; ///< returns whether the caption has room
    QAction* addLine(const QString& line, bool isSelectable = false); ///< adds a line to the menu
    void openMenu();

    RunState m_state = RunState::Idle;
    bool m_isUnknown = false;
    QStringList m_reasons;
    int m_gravest = 0; ///< priority of the gravest reason
    QString m_caption;
    QString m_remedy;
    QAction* m_verb = nullptr; ///< of the remedy
    QString m_explanation;
    QStringList m_notes;
    bool m_isCompact = false;
    QMenu* m_menu = nullptr;
};

} // namespace bask
