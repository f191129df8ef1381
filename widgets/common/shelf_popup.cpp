#include "widgets/common/shelf_popup.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScreen>

#include <algorithm>

namespace bask {
namespace {

constexpr int kPopupWidth = 340;
constexpr int kMaxLetters = 120;

} // namespace

ShelfPopup::ShelfPopup(QWidget* parent)
    : QFrame(parent, Qt::Popup), m_explanation(new QLabel(this)), m_reason(new QLineEdit(this)) {
    setObjectName(QStringLiteral("shelfPopup"));
    setFrameShape(QFrame::StyledPanel);
    setFixedWidth(kPopupWidth);
    m_explanation->setWordWrap(true);
    m_reason->setObjectName(QStringLiteral("shelfReason"));
    m_reason->setMaxLength(kMaxLetters);
    auto* row = new QHBoxLayout;
    for (std::size_t i = 0; i < m_times.size(); ++i) {
        m_times[i] = new QPushButton(this);
        m_times[i]->setObjectName(QStringLiteral("shelve.%1").arg(kTimes_min[i]));
        m_times[i]->setAutoDefault(false);
        m_times[i]->setMinimumWidth(0);
        row->addWidget(m_times[i], 1);
        connect(m_times[i], &QPushButton::clicked, this, [this, i] {
            emit shelveRequested(m_id, 60.0 * kTimes_min[i], m_reason->text().trimmed());
            close();
        });
    }
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_explanation);
    column->addWidget(m_reason);
    column->addLayout(row);
    connect(m_reason, &QLineEdit::textChanged, this, &ShelfPopup::showPossible);
    connect(m_reason, &QLineEdit::returnPressed, m_times.front(), qOverload<>(&QWidget::setFocus));
    retranslateUi();
}

void ShelfPopup::open(quint64 id, double longest_s, const QWidget& beside) {
    m_id = id;
    m_longest_s = longest_s;
    m_reason->clear();
    showPossible();
    adjustSize();
    const QRect room = beside.screen()->availableGeometry();
    QPoint at = beside.mapToGlobal(QPoint(beside.width() - width(), -height() - 2));
    at.setX(std::clamp(at.x(), room.left(), std::max(room.left(), room.right() - width())));
    at.setY(std::max(at.y(), room.top()));
    move(at);
    show();
    m_reason->setFocus();
}

void ShelfPopup::showPossible() {
    const bool isSaid = !m_reason->text().trimmed().isEmpty();
    for (std::size_t i = 0; i < m_times.size(); ++i) {
        const bool isShort = 60.0 * kTimes_min[i] <= m_longest_s;
        m_times[i]->setEnabled(isSaid && isShort);
        m_times[i]->setToolTip(isShort ? QString()
                                       : tr("An alarm of priority 1 is shelved for a shorter time."));
    }
}

void ShelfPopup::retranslateUi() {
    m_explanation->setText(
        tr("Put this alarm aside for a time. It comes back by itself, and the engine goes on "
           "watching and acting."));
    m_reason->setPlaceholderText(tr("Why? (needed)"));
    m_reason->setAccessibleName(tr("Why the alarm is shelved"));
    for (std::size_t i = 0; i < m_times.size(); ++i) {
        m_times[i]->setText(tr("%1 min").arg(kTimes_min[i]));
        m_times[i]->setAccessibleName(tr("Shelve for %1 min").arg(kTimes_min[i]));
    }
    showPossible();
}

void ShelfPopup::changeEvent(QEvent* event) {
    QFrame::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslateUi();
}

} // namespace bask
