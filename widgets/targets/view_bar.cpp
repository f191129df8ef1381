#include "widgets/targets/view_bar.h"

#include <QAction>
#include <QEvent>
#include <QHBoxLayout>
#include <QMenu>
#include <QPushButton>
#include <QToolButton>

namespace bask {

ViewBar::ViewBar(QWidget* parent)
    : QWidget(parent), m_top(new QToolButton(this)), m_side(new QToolButton(this)),
      m_isometric(new QToolButton(this)), m_export(new QPushButton(this)), m_picture(new QAction(this)),
      m_animation(new QAction(this)) {
    m_top->setObjectName("viewTop");
    m_side->setObjectName("viewSide");
    m_isometric->setObjectName("viewIsometric");
    m_export->setObjectName("exportMenu");
    m_picture->setObjectName("exportPicture");
    m_animation->setObjectName("exportAnimation");
    auto* menu = new QMenu(m_export);
    menu->addActions({m_picture, m_animation});
    m_export->setMenu(menu);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    for (QToolButton* button : {m_top, m_side, m_isometric}) {
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::StrongFocus);
        row->addWidget(button);
    }
    row->addStretch(1);
    row->addWidget(m_export);
    connect(m_top, &QToolButton::clicked, this, &ViewBar::topWanted);
    connect(m_side, &QToolButton::clicked, this, &ViewBar::sideWanted);
    connect(m_isometric, &QToolButton::clicked, this, &ViewBar::isometricWanted);
    connect(m_picture, &QAction::triggered, this, &ViewBar::pictureWanted);
    connect(m_animation, &QAction::triggered, this, &ViewBar::animationWanted);
    retranslate();
}

void ViewBar::setExports(bool picture, bool animation) {
    m_export->setEnabled(picture || animation);
    m_picture->setEnabled(picture);
    m_animation->setEnabled(animation);
}

void ViewBar::retranslate() {
    m_top->setText(tr("Top"));
    m_side->setText(tr("Side"));
    m_isometric->setText(tr("Isometric"));
    for (QToolButton* button : {m_top, m_side, m_isometric})
        button->setAccessibleName(tr("View: %1").arg(button->text()));
    m_export->setText(tr("Export"));
    m_picture->setText(tr("&Picture\u2026"));
    m_animation->setText(tr("&Animation\u2026"));
}

void ViewBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

} // namespace bask
