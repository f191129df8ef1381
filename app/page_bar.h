#pragma once
// The buttons of the pages, beneath one another at the left edge of the window.

#include <QToolBar>

class QToolButton;

namespace bask {

/// Words under icons; where the window is too low for that smaller ones, then the words alone, then small
/// words: every page has its button, and is named, at every height. Object names: "navigation", its buttons
/// "page.<i>".
class PageBar : public QToolBar {
    Q_OBJECT
public:
    explicit PageBar(QWidget* parent = nullptr);

    /// Adds the page's button below the others.
    QToolButton* addPage(QAction* page);

protected:
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void fit();
    void shorten(int by);
    int heightNeeded() const;

    QList<QToolButton*> m_buttons;
    int m_shortBy = 0;
};

} // namespace bask
