#include "widgets/calibrate/verdict_box.h"

#include "widgets/calibrate/camera_result.h"
#include "widgets/common/floating_place.h"
#include "widgets/common/labels.h"
#include "widgets/common/theme.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

namespace bask {
namespace {

constexpr int kVerdictIcon = 20;

/// 0: no alarm.
int priorityOf(std::optional<Verdict> verdict) {
    return verdict == Verdict::Redo ? 2 : verdict == Verdict::Usable ? 3 : 0;
}

} // namespace

VerdictBox::VerdictBox(const QString& name, QWidget* parent)
    : QWidget(parent), m_icon(new QLabel(this)), m_verdict(boldLabel(this)), m_text(new QLabel(this)),
      m_use(new QPushButton(this)) {
    m_verdict->setObjectName(name + QStringLiteral("Verdict"));
    m_text->setObjectName(name + QStringLiteral("Text"));
    m_use->setObjectName(name + QStringLiteral("Use"));
    m_verdict->setProperty(kKeptFree_px, kWholeWidget_px);
    m_verdict->setWordWrap(true); // beside the button there is little room
    m_text->setWordWrap(true);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* head = new QHBoxLayout;
    head->addWidget(m_icon);
    head->addWidget(m_verdict, 1);
    head->addWidget(m_use);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(head);
    layout->addWidget(m_text);
}

void VerdictBox::showState(const QString& state, const QString& text) {
    m_judged.reset();
    m_verdict->setText(state);
    showText(text);
}

void VerdictBox::showVerdict(Verdict verdict, bool isUsed, const QStringList& lines) {
    m_judged = verdict;
    m_verdict->setText(isUsed ? tr("%1, in use").arg(verdictWord(verdict)) : verdictWord(verdict));
    showText(lines.join(QLatin1Char('\n')));
}

void VerdictBox::showText(const QString& text) {
    m_text->setText(text);
    m_text->setVisible(!text.isEmpty());
    showIcon();
}

void VerdictBox::showIcon() {
    const int priority = priorityOf(m_judged);
    m_icon->setVisible(priority > 0);
    if (priority > 0)
        m_icon->setPixmap(alarmPixmap(priority, isDark(this), kVerdictIcon, devicePixelRatio()));
}

void VerdictBox::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        showIcon();
}

} // namespace bask
