#include "app/page_bar.h"

#include <QEvent>
#include <QLayout>
#include <QToolButton>

namespace bask {
namespace {

/// What gives way, one after the other, until the buttons fit.
enum ShortBy { kSmallIcons = 1, kWithoutIcons, kLowButtons, kSmallWords };
constexpr int kWidth = 76, kHeight = 60; // px, of a button with all
constexpr int kIcon = 26, kSmallIcon = 18, kTight = 2;
constexpr double kSmall = 0.82; // of the bar's letters

} // namespace

PageBar::PageBar(QWidget* parent) : QToolBar(parent) {
    setObjectName(QStringLiteral("navigation"));
    setMovable(false);
    setFloatable(false);
    setContextMenuPolicy(Qt::PreventContextMenu);
    shorten(0);
}

QToolButton* PageBar::addPage(QAction* page) {
    addAction(page);
    auto* button = qobject_cast<QToolButton*>(widgetForAction(page));
    button->setObjectName(QStringLiteral("page.%1").arg(m_buttons.size()));
    button->setFocusPolicy(Qt::TabFocus);
    m_buttons << button;
    shorten(m_shortBy);
    return button;
}

void PageBar::shorten(int by) {
    m_shortBy = by;
    const int icon = by < kSmallIcons ? kIcon : kSmallIcon;
    setIconSize({icon, icon});
    setToolButtonStyle(by < kWithoutIcons ? Qt::ToolButtonTextUnderIcon : Qt::ToolButtonTextOnly);
    QFont words = font();
    if (by >= kSmallWords)
        words.setPointSizeF(words.pointSizeF() * kSmall);
    for (QToolButton* button : std::as_const(m_buttons)) {
        button->setFont(words);
        button->setMinimumSize(kWidth, by < kSmallIcons ? kHeight : 0);
        const bool isLow = by >= kLowButtons; // no more than the line of its words
        button->setMaximumHeight(isLow ? button->fontMetrics().height() + kTight : QWIDGETSIZE_MAX);
    }
}

int PageBar::heightNeeded() const {
    const QMargins margins = layout()->contentsMargins();
    int height = margins.top() + margins.bottom();
    for (const QToolButton* button : m_buttons)
        height += std::min(button->maximumHeight(),
                           std::max(button->minimumHeight(), button->sizeHint().height())) +
                  layout()->spacing();
    return height;
}

void PageBar::fit() {
    const int before = m_shortBy;
    int by = 0;
    shorten(by);
    while (by < kSmallWords && heightNeeded() > height())
        shorten(++by);
    if (by != before)
        updateGeometry();
}

bool PageBar::event(QEvent* event) {
    const bool isDone = QToolBar::event(event);
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::FontChange)
        fit();
    return isDone;
}

void PageBar::resizeEvent(QResizeEvent* event) {
    QToolBar::resizeEvent(event);
    fit();
}

} // namespace bask
