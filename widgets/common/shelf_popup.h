#pragma once
// Shelves an alarm for a time: a field for the reason and a button for each time, in a frame that closes when
// anything else is clicked.

#include <QFrame>

#include <array>

class QLabel;
class QLineEdit;
class QPushButton;

namespace bask {

/// Object names: "shelfPopup", "shelfReason", "shelve.5", "shelve.15", "shelve.30", "shelve.60" (minutes).
class ShelfPopup : public QFrame {
    Q_OBJECT

public:
    static constexpr std::array kTimes_min{5, 15, 30, 60};

    explicit ShelfPopup(QWidget* parent);

    /// Opens above `beside` for an alarm that can be shelved for at most `longest_s`.
    void open(quint64 id, double longest_s, const QWidget& beside);

signals:
    /// Sent with a non-empty reason.
    void shelveRequested(quint64 id, double for_s, const QString& reason);

protected:
    void changeEvent(QEvent* event) override;

private:
    void showPossible();
    void retranslateUi();

    quint64 m_id = 0;
    double m_longest_s = 0.0;
    QLabel* m_explanation;
    QLineEdit* m_reason;
    std::array<QPushButton*, kTimes_min.size()> m_times{};
};

} // namespace bask
