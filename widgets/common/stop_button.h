#pragma once
// STOP: the large red button, which acts on press, and on F12 wherever the keyboard focus is in the program.

#include <QAbstractButton>

namespace bask {

/// Object name "stopButton"; its twins "stopTwin". A modal dialog blocks the mouse in all other windows: then
/// a twin, a window of the dialog, covers the button and does the same; each window's button has its own. It
/// never asks for confirmation and is never disabled by the program. It grows with its font.
class StopButton : public QAbstractButton {
    Q_OBJECT
public:
    explicit StopButton(QWidget* parent = nullptr);

    /// Whether its key is named beside the word; without it the word has more room.
    void setKeyShown(bool isShown);
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    /// Sent on press, not on release; also by F12, even with an open menu or dialog.
    void stopRequested();

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    StopButton(StopButton& original, QWidget* dialog);
    void standOver(QWidget* dialog);
    StopButton* twinOn(const QWidget* dialog) const; ///< null without one
    void retranslateUi();

    const StopButton* m_original = nullptr; ///< of a twin
    QString m_key = QStringLiteral("F12");
};

} // namespace bask
