#include "widgets/common/message_bar.h"

#include "widgets/common/theme.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QToolButton>

namespace bask {

MessageBar::MessageBar(QWidget* parent)
    : QFrame(parent), m_icon(new QLabel(this)), m_label(new QLabel(this)), m_action(new QPushButton(this)),
      m_other(new QPushButton(this)), m_close(new QToolButton(this)) {
    m_label->setObjectName("message");
    m_label->setWordWrap(true);
    m_label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_action->setObjectName("messageAction");
    m_other->setObjectName("messageOther");
    m_close->setObjectName("messageClose");
    m_close->setAutoRaise(true);
    m_close->setText(QString(QChar(0x2715)));

    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(14, 7, 8, 7);
    layout->addWidget(m_icon);
    layout->addWidget(m_label, 1);
    layout->addWidget(m_action);
    layout->addWidget(m_other);
    layout->addWidget(m_close);
    connect(m_action, &QPushButton::clicked, this, &MessageBar::actionClicked);
    connect(m_other, &QPushButton::clicked, this, &MessageBar::otherClicked);
    connect(m_close, &QToolButton::clicked, this, [this] {
        clear();
        emit closed();
    });
    // A click leaves the focus where it is: with the bar it would go to a part of the page, which is brought
    // into view, and the page jumps under the pointer.
    for (QAbstractButton* button : std::initializer_list<QAbstractButton*>{m_action, m_other, m_close})
        button->setFocusPolicy(Qt::TabFocus);
    refresh();
    hide();
}

void MessageBar::say(Kind kind, const QString& sentence, const QString& action, bool closable) {
    m_kind = kind;
    m_label->setText(sentence);
    m_action->setText(action);
    m_action->setVisible(!action.isEmpty());
    m_other->hide();
    m_close->setVisible(closable);
    refresh();
    show();
}

void MessageBar::ask(const QString& sentence, const QString& action, const QString& other) {
    say(Kind::Note, sentence, action);
    m_other->setText(other);
    m_other->show();
}

void MessageBar::clear() {
    m_label->clear();
    hide();
}

QString MessageBar::sentence() const {
    return isHidden() ? QString() : m_label->text();
}

void MessageBar::refresh() {
    m_close->setAccessibleName(tr("Close the message"));
    m_close->setToolTip(tr("Close the message"));
    m_icon->setVisible(m_kind == Kind::Problem);
    m_icon->setPixmap(problemPixmap(isDark(this), 18, devicePixelRatioF()));
    setAccessibleName(m_kind == Kind::Problem ? tr("Problem") : tr("Note"));
    update();
}

void MessageBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
        refresh();
    QFrame::changeEvent(event);
}

void MessageBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const bool dark = isDark(this);
    const QColor tone = m_kind == Kind::Problem ? alarmColor(3, dark) : accentColor(dark);
    const QColor ground = palette().color(QPalette::Window);
    painter.setPen(mixed(tone, ground, 0.5));
    painter.setBrush(mixed(tone, ground, dark ? 0.16 : 0.12));
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4.0, 4.0);
    painter.setPen(Qt::NoPen);
    painter.setBrush(tone);
    painter.drawRoundedRect(QRectF(0.0, 0.0, 4.0, height()), 2.0, 2.0);
}

} // namespace bask
