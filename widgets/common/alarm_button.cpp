#include "widgets/common/alarm_button.h"

#include "widgets/common/alarm_words.h"
#include "widgets/common/theme.h"

#include <QEvent>
#include <QPainter>
#include <QTextLayout>
#include <QTextOption>

#include <algorithm>
#include <utility>

namespace bask {
namespace {

constexpr int kMark = 18;
constexpr int kButtonPadding = 8;
constexpr int kMaxText = 420;
constexpr double kSmall = 0.82; // of two lines

} // namespace

AlarmButton::AlarmButton(QWidget* parent) : QAbstractButton(parent) {
    setObjectName(QStringLiteral("alarmButton"));
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
    setAttribute(Qt::WA_Hover);
    hide();
    connect(this, &QAbstractButton::clicked, this, [this] {
        if (m_shown != nullptr)
            emit alarmChosen(m_shown->alarm.id);
    });
}

void AlarmButton::setAlarms(const std::vector<Alarm>& alarms) {
    AlarmGroups groups = groupAlarms(alarms);
    if (groups == m_groups)
        return;
    m_groups = std::move(groups);
    m_shown = callingFirst(m_groups);
    retranslateUi();
    setVisible(m_shown != nullptr);
}

std::size_t AlarmButton::others() const {
    return m_groups.present.empty() ? 0 : m_groups.present.size() - 1;
}

bool AlarmButton::isCalling() const {
    return std::ranges::any_of(m_groups.present, &AlarmGroup::isCalling);
}

void AlarmButton::setTemperatureUnit(TemperatureUnit unit) {
    m_unit = unit;
    retranslateUi();
}

void AlarmButton::setStale(bool isStale) {
    m_isStale = isStale;
    retranslateUi();
}

void AlarmButton::retranslateUi() {
    if (m_shown == nullptr)
        return;
    const Alarm& alarm = m_shown->alarm;
    setText(alarmHeadline(alarm, m_unit));
    QString name = tr("Alarm of priority %1 (%2): %3")
                       .arg(QString::number(alarm.priority), alarmStateWords(alarm), text());
    if (others() > 0)
        name += u' ' + tr("%1 more.").arg(others());
    if (m_isStale)
        name += u' ' + tr("This may be old: the engine is not answering.");
    setAccessibleName(name);
    setToolTip(QStringLiteral("<qt>%1</qt>").arg(name.toHtmlEscaped()));
    updateGeometry();
    update();
}

QString AlarmButton::othersText() const {
    return others() > 0 ? QStringLiteral("+%1").arg(others()) : QString();
}

QFont AlarmButton::textFont() const {
    QFont shown = font();
    shown.setBold(isCalling());
    return shown;
}

QFont AlarmButton::smallFont() const {
    QFont small = textFont();
    small.setPointSizeF(font().pointSizeF() * kSmall);
    return small;
}

int AlarmButton::widthBesideText() const {
    const QString others = othersText();
    const int othersWidth =
        others.isEmpty() ? 0 : QFontMetrics(textFont()).horizontalAdvance(others) + kButtonPadding;
    return kButtonPadding + kMark + kButtonPadding + othersWidth + kButtonPadding;
}

int AlarmButton::widthWithoutText() const {
    QFont bold = font();
    bold.setBold(true);
    return kMark + 4 * kButtonPadding + QFontMetrics(bold).horizontalAdvance(QStringLiteral("+99"));
}

QSize AlarmButton::sizeHint() const {
    const QFontMetrics metrics(textFont());
    return {widthBesideText() + std::min(metrics.horizontalAdvance(text()) + 2, kMaxText),
            std::max({metrics.height() + 12, 2 * QFontMetrics(smallFont()).height() + 4, 30})};
}

QSize AlarmButton::minimumSizeHint() const {
    return {widthBesideText(), sizeHint().height()};
}

void AlarmButton::paintEvent(QPaintEvent*) {
    if (m_shown == nullptr)
        return;
    const Alarm& alarm = m_shown->alarm;
    const bool isOver = !m_shown->isActive();
    const bool dark = isDark(this);
    const bool isNew = isCalling() && !m_isStale;
    const QColor colour = isNew ? alarmColor(alarm.priority, dark) : secondaryText(dark);

    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QColor ground = colour;
    ground.setAlphaF((isNew ? 0.18f : 0.06f) + (underMouse() || isDown() ? 0.08f : 0.0f));
    painter.setBrush(ground);
    painter.setPen(QPen(hasFocus() ? accentColor(dark) : colour, hasFocus() ? 2.0 : 1.0));
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 6, 6);

    const QRect mark(kButtonPadding, (height() - kMark) / 2, kMark, kMark);
    painter.setOpacity(m_isStale ? 0.5 : 1.0);
    painter.drawPixmap(mark, alarmPixmap(alarm.priority, dark, kMark, devicePixelRatioF(), isOver));
    painter.setOpacity(1.0);
    painter.setFont(textFont());
    painter.setPen(m_isStale || isOver ? secondaryText(dark) : palette().color(QPalette::WindowText));
    const int left = mark.right() + 1 + kButtonPadding;
    const QRect room(left, 0, width() - widthBesideText(), height());
    if (room.width() > painter.fontMetrics().horizontalAdvance(QStringLiteral("MMM")))
        paintText(painter, room);
    painter.setFont(textFont());
    painter.drawText(QRect(0, 0, width() - kButtonPadding, height()), Qt::AlignVCenter | Qt::AlignRight,
                     othersText());
}

/// In two smaller lines where one does not hold it.
void AlarmButton::paintText(QPainter& painter, const QRect& room) const {
    if (painter.fontMetrics().horizontalAdvance(text()) <= room.width()) {
        painter.drawText(room, Qt::AlignVCenter | Qt::AlignLeft, text());
        return;
    }
    painter.setFont(smallFont());
    QTextLayout layout(text(), painter.font());
    QTextOption wrapped;
    wrapped.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    layout.setTextOption(wrapped);
    layout.beginLayout();
    QTextLine line = layout.createLine();
    line.setLineWidth(room.width());
    layout.endLayout();
    const QString first = text().left(line.textLength()).trimmed();
    const QString rest = text().mid(line.textLength());
    const QFontMetrics metrics = painter.fontMetrics();
    painter.drawText(room, Qt::AlignVCenter | Qt::AlignLeft,
                     first + u'\n' + metrics.elidedText(rest, Qt::ElideRight, room.width()));
}

void AlarmButton::changeEvent(QEvent* event) {
    QAbstractButton::changeEvent(event);
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::FontChange ||
        event->type() == QEvent::PaletteChange)
        retranslateUi();
}

} // namespace bask
