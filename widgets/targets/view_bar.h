#pragma once
// The scene's viewing directions and its export, as a row of buttons.

#include <QWidget>

class QAction;
class QPushButton;
class QToolButton;

namespace bask {

/// Object names: "viewTop", "viewSide", "viewIsometric", "exportMenu" with "exportPicture" and
/// "exportAnimation".
class ViewBar : public QWidget {
    Q_OBJECT

public:
    explicit ViewBar(QWidget* parent = nullptr);

    void setExports(bool picture, bool animation);

signals:
    void topWanted();
    void sideWanted();
    void isometricWanted();
    void pictureWanted();
    void animationWanted();

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();

    QToolButton* m_top;
    QToolButton* m_side;
    QToolButton* m_isometric;
    QPushButton* m_export;
    QAction* m_picture;
    QAction* m_animation;
};

} // namespace bask
