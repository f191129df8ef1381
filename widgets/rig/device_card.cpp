#include "widgets/rig/device_card.h"

#include "engine/base/message_code.h"
#include "widgets/common/display.h"
#include "widgets/common/theme.h"
#include "widgets/rig/check_mark.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QPushButton>

#include <algorithm>

namespace bask {
namespace {

constexpr int kMark = 16;

CheckMark markOf(LinkState link) {
    switch (link) {
    case LinkState::Live:
        return CheckMark::Tick;
    case LinkState::Lost:
        return CheckMark::Cross;
    case LinkState::Opening:
        return CheckMark::Waiting;
    case LinkState::Closed:
        break;
    }
    return CheckMark::None;
}

void setText(QLabel* label, const QString& text) {
    if (label->text() != text)
        label->setText(text);
    label->setVisible(!text.isEmpty());
}

} // namespace

DeviceCard::DeviceCard(DeviceRole role, QWidget* parent)
    : QWidget(parent), m_role(role), m_title(new QLabel(this)), m_driver(new QLabel(this)),
      m_mark(new QLabel(this)), m_word(new QLabel(this)), m_age(new QLabel(this)),
      m_problem(new QLabel(this)), m_accept(new QPushButton(this)), m_setUp(new QPushButton(this)),
      m_remove(new QPushButton(this)) {
    const auto name = [role](const char* part) {
        return QStringLiteral("%1.%2").arg(QLatin1String(part), QLatin1String(roleName(role)));
    };
    setObjectName(name("card"));
    m_driver->setObjectName(name("driver"));
    m_word->setObjectName(name("state"));
    m_age->setObjectName(name("age"));
    m_problem->setObjectName(name("problem"));
    m_accept->setObjectName(name("accept"));
    m_accept->hide();
    m_setUp->setObjectName(name("setUp"));
    m_remove->setObjectName(name("remove"));
    QFont bold = font();
    bold.setWeight(QFont::DemiBold);
    m_title->setFont(bold);
    m_word->setFont(bold);
    m_mark->setFixedSize(kMark, kMark);
    m_driver->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred); // paths can be long
    for (QLabel* label : {m_driver, m_problem}) {
        label->setWordWrap(true);
        label->setTextFormat(Qt::PlainText); // a file's
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    }

    auto* state = new QHBoxLayout;
    state->setSpacing(6);
    state->addWidget(m_mark);
    state->addWidget(m_word);
    state->addStretch(1);
    auto* layout = new QGridLayout(this);
    layout->setContentsMargins(10, 6, 8, 6);
    layout->setVerticalSpacing(3);
    layout->addWidget(m_title, 0, 0);
    layout->addLayout(state, 0, 1);
    layout->addWidget(m_setUp, 0, 2);
    layout->addWidget(m_remove, 0, 3);
    layout->addWidget(m_driver, 1, 0, 1, 4);
    layout->addWidget(m_age, 2, 0, 1, 4);
    layout->addWidget(m_problem, 3, 0, 1, 4);
    layout->addWidget(m_accept, 4, 0, 1, 4, Qt::AlignLeft);
    layout->setColumnStretch(1, 1);
    connect(m_accept, &QPushButton::clicked, this, [this] {
        if (m_isProgram)
            emit confirmWanted(m_role);
        else
            emit acceptWanted(m_role);
    });
    connect(m_setUp, &QPushButton::clicked, this, [this] { emit setUpWanted(m_role); });
    connect(m_remove, &QPushButton::clicked, this, [this] { emit removeWanted(m_role); });
    retranslate();
}

void DeviceCard::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(hairline(isDark(this)));
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4.0, 4.0);
}

void DeviceCard::setRig(const std::optional<RigSpec>& rig) {
    m_rig = rig;
    m_state.reset();
    showDevice();
}

void DeviceCard::setState(const std::optional<RigDeviceState>& state) {
    m_state = state;
    showState();
}

void DeviceCard::setEditable(bool editable) {
    m_editable = editable;
    m_accept->setEnabled(editable);
    m_setUp->setEnabled(editable);
    m_remove->setEnabled(editable);
}

void DeviceCard::showDevice() {
    const bool isThere = m_rig && hasDevice(*m_rig, m_role);
    QString text;
    if (isThere) {
        text = driverText(*m_rig, m_role);
        if (const QString port = portText(*m_rig, m_role); !port.isEmpty())
            text += QStringLiteral(" \u00b7 ") + port;
    }
    setText(m_driver, text);
    m_driver->setToolTip(text);
    m_setUp->setVisible(m_rig.has_value());
    m_setUp->setText(isThere ? tr("Change…") : tr("Set up…"));
    m_setUp->setAccessibleName(roleWord(m_role) + QStringLiteral(", ") + m_setUp->text());
    m_remove->setVisible(isThere);
    m_remove->setAccessibleName(roleWord(m_role) + QStringLiteral(", ") + m_remove->text());
    showState();
}

void DeviceCard::showState() {
    const bool isThere = m_rig && hasDevice(*m_rig, m_role);
    QString word, age, problem;
    if (!m_rig) {
        word = tr("Simulated");
    } else if (!isThere) {
        word = tr("None");
    } else if (m_state) {
        const DeviceStatus& status = m_state->status;
        word = linkWord(status.link);
        if (status.link == LinkState::Live && !status.identity.empty())
            word += QStringLiteral(": ") + QString::fromStdString(status.identity);
        if (const QString text = ageText(m_state->age_s); !text.isEmpty())
            age = tr("%1 ago").arg(text);
        if (status.link == LinkState::Live && status.rate_Hz > 0.0)
            age += QStringLiteral(", ") + tr("%1 Hz").arg(QLocale().toString(status.rate_Hz, 'f', 1));
        problem = sentenceText(status.problem);
        if (status.discarded > 0)
            age += (age.isEmpty() ? QString() : QStringLiteral(", ")) +
                   tr("%n answer(s) discarded", nullptr, status.discarded);
    } else {
        word = tr("Not in use yet");
    }
    setText(m_word, word);
    setText(m_age, age);
    showAgeTip();
    setText(m_problem, problem);
    showAccept(isThere && m_state ? m_state->status.problem.code : MessageCode::None);
    showMark();
}

void DeviceCard::showAgeTip() {
    QString tip = tr("Age of its newest answer, answers a second, and answers that nobody can read or "
                     "that were not asked for");
    if (m_state && m_state->status.lastDiscarded.code != MessageCode::None)
        tip += u'\n' + tr("The last of them: %1").arg(messageText(m_state->status.lastDiscarded));
    m_age->setToolTip(tip);
}

void DeviceCard::showAccept(MessageCode problem) {
    m_isProgram = problem == MessageCode::ProgramNotConfirmed;
    m_accept->setText(m_isProgram ? tr("Confirm…") : tr("This is the one"));
    m_accept->setToolTip(
        m_isProgram ? tr("Look at what would be started, and allow it on this computer")
                    : tr("Use the device that answers now, and remember it instead of the one before"));
    m_accept->setAccessibleName(roleWord(m_role) + QStringLiteral(", ") + m_accept->text());
    m_accept->setVisible(m_isProgram || problem == MessageCode::DeviceExchanged);
}

void DeviceCard::showMark() {
    const bool isThere = m_rig && hasDevice(*m_rig, m_role);
    const CheckMark mark = !m_rig               ? CheckMark::Tick
                           : isThere && m_state ? markOf(m_state->status.link)
                                                : CheckMark::None;
    if (m_shownMark == static_cast<int>(mark))
        return;
    m_shownMark = static_cast<int>(mark);
    m_mark->setPixmap(checkMarkPixmap(mark, isDark(this), kMark, devicePixelRatioF()));
}

void DeviceCard::retranslate() {
    m_title->setText(roleWord(m_role));
    int widest = 0; // the states stand under each other
    for (const DeviceRole role : kDeviceRoles)
        widest = std::max(widest, m_title->fontMetrics().horizontalAdvance(roleWord(role)));
    m_title->setMinimumWidth(widest + kMark);
    m_remove->setText(tr("Remove"));
    setAccessibleName(roleWord(m_role));
    showDevice();
}

void DeviceCard::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    if (event->type() == QEvent::PaletteChange) {
        m_shownMark = -1;
        showMark();
    }
}

} // namespace bask
