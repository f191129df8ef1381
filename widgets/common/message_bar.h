#pragma once
// One sentence inside a page, with up to two buttons: what was refused and why, or what can be undone.

#include <QFrame>

class QLabel;
class QPushButton;
class QToolButton;

namespace bask {

/// Hidden until it has something to say. Object names: "message", "messageAction", "messageOther",
/// "messageClose".
class MessageBar : public QFrame {
    Q_OBJECT

public:
    enum class Kind { Note, Problem };

    explicit MessageBar(QWidget* parent = nullptr);

    /// Shows a sentence; `action` adds a button with that label; if not `closable`, it stays until it is
    /// cleared.
    void say(Kind kind, const QString& sentence, const QString& action = {}, bool closable = true);
    /// Asks a question with a button for each answer; closing it postpones the answer.
    void ask(const QString& sentence, const QString& action, const QString& other);
    void clear();
    QString sentence() const;

signals:
    void actionClicked();
    void otherClicked();
    void closed(); ///< a person closed the bar

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void refresh();

    Kind m_kind = Kind::Note;
    QLabel* m_icon;
    QLabel* m_label;
    QPushButton *m_action, *m_other;
    QToolButton* m_close;
};

} // namespace bask
