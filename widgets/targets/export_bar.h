#pragma once
// The progress of an export of an animation, and a button that cancels it.

#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;

namespace bask {

/// Hidden until progress is shown. Object names: "exportWord", "exportProgress", "exportCancel".
class ExportBar : public QWidget {
    Q_OBJECT

public:
    explicit ExportBar(QWidget* parent = nullptr);

    /// `done` 0 means still computing.
    void showProgress(int done, int of);

signals:
    void cancelled();

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();

    int m_done = 0;
    int m_of = 0;
    QLabel* m_word;
    QProgressBar* m_progress;
    QPushButton* m_cancel;
};

} // namespace bask
