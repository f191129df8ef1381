#pragma once
// STOP: the big red button, which acts on press, and on F12 wherever the keyboard is in the program.

#include <QAbstractButton>

namespace bask {

/// Object name "stopButton". Never asks for confirmation and is never disabled by the program.
class StopButton : public QAbstractButton {
    Q_OBJECT
public:
    explicit StopButton(QWidget* parent = nullptr);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    /// On press, not on release; also by F12, with a menu or a dialog open as well.
    void stopRequested();

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void retranslateUi();
};

} // namespace bask
