#include "widgets/common/countdown_bar.h"

#include "widgets/common/alarm_words.h"
#include "widgets/common/display.h"
#include "widgets/common/labels.h"
#include "widgets/common/theme.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

constexpr int kCountdownMark = 20;
constexpr double kSecondAgain_s = 1.5; ///< a countdown that jumps up by more than this is a new one

} // namespace

CountdownBar::CountdownBar(QWidget* parent)
    : QFrame(parent), m_mark(new QLabel(this)), m_text(boldLabel(this, 1.15)), m_cause(new QLabel(this)) {
    setObjectName(QStringLiteral("countdownBar"));
    m_text->setObjectName(QStringLiteral("countdown"));
    m_cause->setObjectName(QStringLiteral("countdownCause"));
    for (QLabel* label : {m_text, m_cause})
        label->setWordWrap(true);
    auto* words = new QVBoxLayout;
    words->setSpacing(1);
    words->addWidget(m_text);
    words->addWidget(m_cause);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(14, 6, 12, 9);
    row->setSpacing(10);
    row->addWidget(m_mark, 0, Qt::AlignVCenter);
    row->addLayout(words, 1);
    hide();
}

void CountdownBar::setPending(const std::optional<PendingAction>& pending) {
    if (pending && (!m_pending || pending->action != m_pending->action ||
                    pending->cause != m_pending->cause || pending->in_s > m_pending->in_s + kSecondAgain_s))
        m_from_s = pending->in_s;
    if (pending && (!m_pending || pending->cause.code != m_pending->cause.code))
        m_mark->clear(); // it has the cause's priority
    m_pending = pending;
    refresh();
    setVisible(pending.has_value());
}

void CountdownBar::setTemperatureUnit(TemperatureUnit unit) {
    m_unit = unit;
    refresh();
}

void CountdownBar::refresh() {
    if (!m_pending)
        return;
    const QString text = tr("In %1 s, unless the cause is gone: %2")
                             .arg(std::max(0.0, std::ceil(m_pending->in_s)), 0, 'f', 0)
                             .arg(sentenceText(m_pending->action));
    const QString cause = tr("Cause: %1").arg(sentenceText(m_pending->cause, m_unit));
    if (text != m_text->text())
        m_text->setText(text);
    if (cause != m_cause->text())
        m_cause->setText(cause);
    setAccessibleName(cause);
    if (m_mark->pixmap().isNull())
        m_mark->setPixmap(alarmPixmap(priority(), isDark(this), kCountdownMark, devicePixelRatioF()));
    update();
}

void CountdownBar::changeEvent(QEvent* event) {
    QFrame::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        m_mark->clear();
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::LanguageChange)
        refresh();
}

int CountdownBar::priority() const {
    return m_pending ? std::max(1, alarmPriority(m_pending->cause.code)) : 1;
}

/// The line at its foot shortens as the time goes.
void CountdownBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const bool dark = isDark(this);
    const QColor tone = alarmColor(priority(), dark), ground = palette().color(QPalette::Window);
    painter.setPen(mixed(tone, ground, 0.6));
    painter.setBrush(mixed(tone, ground, dark ? 0.18 : 0.10));
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4.0, 4.0);
    if (!m_pending || m_from_s <= 0.0)
        return;
    const double left = std::clamp(m_pending->in_s / m_from_s, 0.0, 1.0);
    painter.setPen(Qt::NoPen);
    painter.setBrush(tone);
    painter.drawRoundedRect(QRectF(1.0, height() - 4.0, left * (width() - 2.0), 3.0), 1.5, 1.5);
}

} // namespace bask
