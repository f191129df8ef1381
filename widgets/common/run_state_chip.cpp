#include "widgets/common/run_state_chip.h"

#include "widgets/common/display.h"
#include "widgets/common/theme.h"

#include <QEvent>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QStyleOption>
#include <QWidgetAction>

#include <algorithm>
#include <array>

namespace bask {
namespace {

constexpr int kIcon = 16;
constexpr int kPadding = 10;
constexpr int kArrow = 14;
constexpr int kHeight = 38;      // of the buttons beside it
constexpr int kMaxCompact = 150; // px
constexpr int kReasonWidth = 420;
constexpr double kCaptionSize = 0.82;

constexpr std::array kStates{RunState::Idle,    RunState::NotReady, RunState::Ready,   RunState::Armed,
                             RunState::Running, RunState::Holding,  RunState::Settled, RunState::Stopping,
                             RunState::Stopped, RunState::Fault};

QColor inkColor(RunState state, bool dark) {
    switch (state) {
    case RunState::Armed:
    case RunState::Running:
    case RunState::Settled:
        return accentColor(dark);
    default:
        return secondaryText(dark);
    }
}

void drawStateIcon(QPainter& painter, RunState state, const QRectF& box, const QColor& ink) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const QPointF c = box.center();
    const double r = box.width() / 2.0 - 1.0;
    QPen pen(ink, 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
    switch (state) {
    case RunState::Armed: // ring with a dot: loaded, waiting
        painter.setPen(pen);
        painter.drawEllipse(c, r, r);
        painter.setBrush(ink);
        painter.drawEllipse(c, r * 0.25, r * 0.25);
        break;
    case RunState::Running: // play
        painter.setPen(Qt::NoPen);
        painter.setBrush(ink);
        painter.drawPolygon(
            QPolygonF{c + QPointF(-0.65 * r, -r), c + QPointF(r, 0), c + QPointF(-0.65 * r, r)});
        break;
    case RunState::Ready:
    case RunState::Settled: // tick
        painter.setPen(pen);
        painter.drawPolyline(QPolygonF{c + QPointF(-0.8 * r, 0.05 * r), c + QPointF(-0.2 * r, 0.65 * r),
                                       c + QPointF(0.9 * r, -0.7 * r)});
        break;
    case RunState::Stopping:
    case RunState::Stopped: // square
        painter.setPen(pen);
        if (state == RunState::Stopped)
            painter.setBrush(ink);
        painter.drawRect(QRectF(c.x() - 0.65 * r, c.y() - 0.65 * r, 1.3 * r, 1.3 * r));
        break;
    default: // ring: nothing on
        painter.setPen(pen);
        painter.drawEllipse(c, r * 0.85, r * 0.85);
        break;
    }
    painter.restore();
}

QString chipText(RunState state, qsizetype reasons) {
    const QString word = runStateWord(state);
    return reasons > 0 ? QStringLiteral("%1 (%2)").arg(word).arg(reasons) : word;
}

} // namespace

int statePriority(RunState state, int gravest) {
    switch (state) {
    case RunState::Fault:
        return gravest > 0 ? gravest : 1;
    case RunState::Holding:
        return gravest > 0 ? gravest : 2;
    case RunState::NotReady:
        return gravest > 0 ? gravest : 3;
    default:
        return 0;
    }
}

RunStateChip::RunStateChip(QWidget* parent) : QAbstractButton(parent), m_menu(new QMenu(this)) {
    setObjectName(QStringLiteral("runStateChip"));
    m_menu->setObjectName(QStringLiteral("runStateReasons"));
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setAttribute(Qt::WA_Hover);
    connect(this, &QAbstractButton::clicked, this, &RunStateChip::openMenu);
    retranslateUi();
}

void RunStateChip::setState(RunState state, const QStringList& reasons, int gravest) {
    if (state == m_state && reasons == m_reasons && gravest == m_gravest && !m_isUnknown)
        return;
    m_isUnknown = false;
    m_state = state;
    m_reasons = reasons;
    m_gravest = gravest;
    retranslateUi();
}

void RunStateChip::setUnknown(const QString& reason) {
    if (m_isUnknown && m_reasons == QStringList{reason})
        return;
    m_isUnknown = true;
    m_reasons = {reason};
    m_caption.clear();
    retranslateUi();
}

void RunStateChip::setCaption(const QString& caption) {
    if (caption == m_caption)
        return;
    m_caption = caption;
    retranslateUi();
}

void RunStateChip::setRemedy(const QString& remedy, QAction* verb) {
    if (remedy == m_remedy && verb == m_verb)
        return;
    m_remedy = remedy;
    m_verb = verb;
    retranslateUi();
}

void RunStateChip::setExplanation(const QString& explanation) {
    if (explanation == m_explanation)
        return;
    m_explanation = explanation;
    retranslateUi();
}

void RunStateChip::setNotes(const QStringList& notes) {
    if (notes == m_notes)
        return;
    m_notes = notes;
    retranslateUi();
}

void RunStateChip::setCompact(bool isCompact) {
    if (isCompact == m_isCompact)
        return;
    m_isCompact = isCompact;
    updateGeometry();
}

QString RunStateChip::unknownWord() {
    return tr("UNKNOWN", "state of the run");
}

QString RunStateChip::word() const {
    return m_isUnknown ? unknownWord() : chipText(m_state, m_reasons.size());
}

void RunStateChip::retranslateUi() {
    setText(word());
    const QString explanation = m_isUnknown               ? m_reasons.first()
                                : m_explanation.isEmpty() ? runStateExplanation(m_state)
                                                          : m_explanation;
    const QString remedy = m_isUnknown ? QString() : m_remedy;
    QStringList tips{explanation};
    if (!remedy.isEmpty())
        tips << remedy;
    if (!m_caption.isEmpty())
        tips << m_notes;
    if (!m_isUnknown)
        tips << tr("Click for the reasons and what to do.");
    setToolTip(tips.join(QLatin1Char('\n')));
    setAccessibleName(tr("State of the run: %1")
                          .arg(m_caption.isEmpty() ? text() : text() + QStringLiteral(", ") + m_caption));
    QStringList said = m_reasons.isEmpty() ? QStringList{explanation} : m_reasons;
    if (!remedy.isEmpty())
        said << remedy;
    setAccessibleDescription(said.join(QLatin1Char('\n')));

    m_menu->clear();
    const QStringList lines = m_reasons.isEmpty() ? QStringList{explanation} : m_reasons;
    for (int i = 0; i < lines.size(); ++i) {
        QAction* action =
            addLine(m_reasons.size() > 1 ? QStringLiteral("%1.  %2").arg(i + 1).arg(lines[i]) : lines[i],
                    !m_reasons.isEmpty() && !m_isUnknown);
        action->setText(lines[i]);
        if (action->isEnabled())
            connect(action, &QAction::triggered, this, [this, i] { emit reasonActivated(i); });
    }
    if (!remedy.isEmpty()) {
        m_menu->addSeparator();
        addLine(remedy);
        if (m_verb != nullptr)
            m_menu->addAction(m_verb);
    }
    if (!m_notes.isEmpty())
        m_menu->addSeparator();
    for (const QString& note : m_notes)
        addLine(note);
    updateGeometry();
    update();
}

QAction* RunStateChip::addLine(const QString& line, bool isSelectable) {
    auto* action = new QWidgetAction(m_menu);
    action->setText(line);
    auto* label = new QLabel(line);
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    label->setMargin(8);
    label->setFixedWidth(kReasonWidth);
    label->setMinimumHeight(label->heightForWidth(kReasonWidth));
    if (!isSelectable) { // to be read all the same
        QPalette ink = label->palette();
        ink.setColor(QPalette::Disabled, QPalette::WindowText,
                     ink.color(QPalette::Active, QPalette::WindowText));
        label->setPalette(ink);
    }
    action->setDefaultWidget(label);
    action->setEnabled(isSelectable);
    m_menu->addAction(action);
    return action;
}

void RunStateChip::openMenu() {
    m_menu->popup(mapToGlobal(QPoint(0, height() + 2)));
}

/// Wide enough for every state, so that the bar does not jump when the state changes.
QSize RunStateChip::sizeHint() const {
    QFont bold = font();
    bold.setBold(true);
    const QFontMetrics metrics(bold);
    int widest = metrics.horizontalAdvance(unknownWord());
    for (RunState state : kStates)
        widest =
            std::max(widest, metrics.horizontalAdvance(chipText(state, state == RunState::NotReady ? 9 : 0)));
    const int whole = widest + kIcon + 3 * kPadding + kArrow;
    return {m_isCompact ? std::min(whole, kMaxCompact) : whole, std::max(2 * metrics.height() + 4, kHeight)};
}

void RunStateChip::paintEvent(QPaintEvent*) {
    const bool dark = isDark(this);
    const int priority = m_isUnknown ? 0 : statePriority(m_state, m_gravest);
    const bool fault = m_isUnknown || m_state == RunState::Fault;
    const QColor signal = m_isUnknown    ? unknownColor(dark)
                          : priority > 0 ? alarmColor(priority, dark)
                                         : inkColor(m_state, dark);

    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QColor ground = signal;
    ground.setAlphaF(fault ? 0.22f : priority > 0 ? 0.14f : 0.09f);
    if (underMouse() || isDown())
        ground.setAlphaF(ground.alphaF() + 0.08f);
    painter.setBrush(ground);
    painter.setPen(QPen(hasFocus() ? accentColor(dark) : signal, fault || hasFocus() ? 2.0 : 1.0));
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 6, 6);

    const QRect icon(kPadding, (height() - kIcon) / 2, kIcon, kIcon);
    if (m_isUnknown)
        painter.drawPixmap(icon, unknownPixmap(dark, kIcon, devicePixelRatioF()));
    else if (priority > 0)
        painter.drawPixmap(icon, alarmPixmap(priority, dark, kIcon, devicePixelRatioF()));
    else
        drawStateIcon(painter, m_state, icon, signal);

    painter.setPen(palette().color(QPalette::WindowText));
    const int left = icon.right() + 1 + kPadding - 2;
    const QRect room(left, 0, width() - left - kPadding - kArrow + 4, height());
    if (paintWord(painter, room)) {
        QFont small = font();
        small.setPointSizeF(font().pointSizeF() * kCaptionSize);
        painter.setFont(small);
        const QRect below = room.adjusted(0, height() / 2, kArrow, -2);
        painter.drawText(below, Qt::AlignVCenter | Qt::AlignLeft,
                         painter.fontMetrics().elidedText(m_caption, Qt::ElideRight, below.width()));
    }

    painter.setPen(QPen(secondaryText(dark), 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    const QPointF arrow(width() - kPadding - 5, height() / 2.0 + 1.5);
    painter.drawPolyline(QPolygonF{arrow + QPointF(-4, -3), arrow, arrow + QPointF(4, -3)});
}

/// Never cut: the count of reasons gives way, which the list shows, then the caption, which the tip says.
bool RunStateChip::paintWord(QPainter& painter, const QRect& room) const {
    const bool hasCaption = !m_caption.isEmpty();
    QFont bold = font();
    bold.setBold(true);
    painter.setFont(bold);
    const QString whole = m_isUnknown ? text() : runStateWord(m_state);
    for (const QString& line : {text(), whole})
        if (painter.fontMetrics().horizontalAdvance(line) <= room.width()) {
            painter.drawText(hasCaption ? room.adjusted(0, 2, 0, -height() / 2 + 1) : room,
                             Qt::AlignVCenter | Qt::AlignLeft, line);
            return hasCaption;
        }
    bold.setPointSizeF(font().pointSizeF() * kCaptionSize);
    painter.setFont(bold);
    painter.drawText(room, Qt::AlignVCenter | Qt::AlignLeft | Qt::TextWordWrap, whole);
    return false;
}

void RunStateChip::changeEvent(QEvent* event) {
    QAbstractButton::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslateUi();
    else if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        update();
}

} // namespace bask
