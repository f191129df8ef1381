#pragma once
// STOP: the big red button, which acts on press, and on F12 wherever the keyboard is in the program.

#include <QAbstractButton>

namespace bask {

/// Object name "stopButton"; its twins "stopTwin". A modal dialog keeps the mouse from every other window:
/// over the button stands a twin then, a window of the dialog's own, which does the same. Never asks for
/// confirmation and is never disabled by the program.
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
    StopButton(StopButton& original, QWidget* dialog);
    void standOver(QWidget* dialog);
    void retranslateUi();
};

} // namespace bask
