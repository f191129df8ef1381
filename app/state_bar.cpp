#include "app/state_bar.h"

#include "app/error_text.h"
#include "app/fault_words.h"
#include "app/icons.h"
#include "widgets/common/alarm_button.h"
#include "widgets/common/alarm_groups.h"
#include "widgets/common/device_words.h"
#include "widgets/common/display.h"
#include "widgets/common/elided_label.h"
#include "widgets/common/labels.h"
#include "widgets/common/run_label_words.h"
#include "widgets/common/run_state_chip.h"
#include "widgets/common/source_words.h"
#include "widgets/common/stop_button.h"

#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QStyle>
#include <QToolButton>

#include <algorithm>

namespace bask {
namespace {

constexpr int kMinWidth = 400; // of two rows when all is short
/// What gives way, one after the other, until the bar fits.
enum ShortPart {
    kWithoutSample = 1, ///< beside the operator
    kWithoutCaption,    ///< of the clock, gaps, and all but the initials of the operator
    kWithoutVerbIcons,  ///< the words are left
    kWithSmallWords,    ///< of the verbs
    kWithSmallTag,      ///< without its icon; SIMULATED stays a word. Chip and STOP are narrow, too
    kWithoutFirstWords, ///< of Arm, Start and Reset: icons again
    kWithoutVerbWords,  ///< of the others
    kWithoutClock,
    kInTwoRows, ///< the verbs below, small words again
    kShortParts ///< icons below
};
constexpr int kBarGap = 8, kPartGap = 9;  // px between neighbours, and more between parts
constexpr int kOperatorText = 100;        // about as wide as the clock with its caption
constexpr int kAlarmText = 70;            // of the gravest alarm, where the verbs have lost words anyway
constexpr double kTiny = 0.82;            // of the bar's letters
constexpr int kTagIcon = 18, kTagGap = 6; // px
constexpr int kTagWord = 76;              // px: a fault's name has some room also under a short word
constexpr int kVerbHeight = 38, kVerbHeightBelow = 32; // px

QFont scaled(QFont font, double by) {
    font.setPointSizeF(font.pointSizeF() * by);
    return font;
}

} // namespace

StateBar::StateBar(Actions& actions, QWidget* parent)
    : QFrame(parent), m_actions(actions), m_tag(new QFrame(this)), m_tagIcon(new QLabel(m_tag)),
      m_tagWord(new QLabel(m_tag)), m_faultWord(new ElidedLabel(m_tag)), m_chip(new RunStateChip(this)),
      m_clockCaption(new QLabel(this)), m_clock(new QLabel(this)), m_untilCold(new ElidedLabel(this)),
      m_operator(new QToolButton(this)), m_alarm(new AlarmButton(this)), m_emergency(new StopButton(this)) {
    setObjectName(QStringLiteral("stateBar"));
    m_tagGrid = new QGridLayout(m_tag);
    m_tagGrid->setContentsMargins(8, 1, 10, 1); // with the fault it is no higher than the chip
    m_tagGrid->setHorizontalSpacing(kTagGap);
    m_tagGrid->setVerticalSpacing(0);
    m_tagGrid->addWidget(m_tagIcon, 0, 0);
    m_tagGrid->addWidget(m_tagWord, 0, 1);
    m_tagGrid->addWidget(m_faultWord, 1, 0, 1, 2);
    m_tag->setObjectName(QStringLiteral("rigTag"));
    m_tagWord->setObjectName(QStringLiteral("tagWord"));
    m_faultWord->setObjectName(QStringLiteral("faultWord"));
    m_faultWord->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    m_faultWord->setFont(scaled(font(), kTiny));
    m_faultWord->hide();

    m_arm = makeButton(actions.verb(Verb::Arm), "armButton");
    m_start = makeButton(actions.verb(Verb::Start), "startButton");
    m_hold = makeButton(actions.verb(Verb::Hold), "holdButton");
    m_stop = makeButton(actions.verb(Verb::Stop), "stopRunButton");
    m_retreat = makeButton(actions.verb(Verb::Retreat), "retreatButton");
    m_reset = makeButton(actions.verb(Verb::Reset), "resetButton");
    for (QToolButton* button : {m_arm, m_start, m_hold, m_stop, m_retreat, m_reset})
        button->installEventFilter(this);

    m_clock->setObjectName(QStringLiteral("runClock"));
    m_clock->setFont(scaled(font(), 1.5));
    m_clock->setMinimumWidth(m_clock->fontMetrics().horizontalAdvance(QStringLiteral("00:00:00")));

    m_untilCold->setObjectName(QStringLiteral("untilCold"));
    m_untilCold->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    m_untilCold->setFont(scaled(font(), kTiny));
    m_untilCold->hide();

    m_operator->setObjectName(QStringLiteral("operatorButton"));
    m_operator->setAutoRaise(true);
    m_operator->setFont(scaled(font(), 0.9));
    m_operator->setFocusPolicy(Qt::StrongFocus);
    m_operator->hide();

    m_row = new QHBoxLayout;
    m_below = new QHBoxLayout;
    auto* rows = new QVBoxLayout(this);
    rows->addLayout(m_row);
    rows->addLayout(m_below);
    m_row->addWidget(m_tag);
    m_row->addWidget(m_chip);
    for (QSpacerItem*& gap : m_gaps)
        gap = new QSpacerItem(kPartGap, 0, QSizePolicy::Fixed, QSizePolicy::Minimum);
    m_row->addItem(m_gaps[0]);
    m_verbs = new QHBoxLayout;
    for (QToolButton* button : {m_arm, m_start, m_hold, m_stop, m_retreat, m_reset})
        m_verbs->addWidget(button);
    m_row->addLayout(m_verbs);
    m_row->addItem(m_gaps[1]);
    auto* clock = new QGridLayout; // the operator below takes no room from the verbs
    clock->setHorizontalSpacing(6);
    clock->setVerticalSpacing(0);
    clock->addWidget(m_clockCaption, 0, 0);
    clock->addWidget(m_clock, 0, 1);
    clock->addWidget(m_operator, 1, 0, 1, 2, Qt::AlignLeft);
    clock->addWidget(m_untilCold, 1, 0, 1, 2); // in the operator's place
    m_row->addLayout(clock);
    m_row->addItem(m_gaps[2]);
    m_row->addWidget(m_alarm);
    m_row->addStretch(1);
    m_row->addWidget(m_emergency);
    m_below->addStretch(1);

    connect(m_emergency, &StopButton::stopRequested, this, &StateBar::stopRequested);
    connect(m_alarm, &AlarmButton::alarmChosen, this, &StateBar::alarmChosen);
    connect(m_operator, &QToolButton::clicked, this, &StateBar::labelsRequested);
    connect(m_chip, &RunStateChip::reasonActivated, this, &StateBar::reasonActivated);
    retranslate();
    showTag();
    setAnswering(true);
}

QToolButton* StateBar::makeButton(QAction* action, const char* name) {
    auto* button = new QToolButton(this);
    button->setObjectName(QLatin1String(name));
    button->setDefaultAction(action);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setMinimumHeight(kVerbHeight);
    button->setFocusPolicy(Qt::StrongFocus);
    return button;
}

void StateBar::apply(const Snapshot& snapshot) {
    const QStringList faults = activeFaultWords(snapshot);
    if (snapshot.simulated != m_simulated || faults != m_faults) {
        m_simulated = snapshot.simulated;
        m_faults = faults;
        showTag();
    }
    m_state = snapshot.state;
    m_reasons = snapshot.reasons;
    m_placeSureAgain = placeSureAgainText(snapshot);
    m_gravest = gravestPriority(snapshot.reasons, snapshot.alarms);
    showChip();
    QAction* hold = m_actions.verb(snapshot.state == RunState::Holding ? Verb::Resume : Verb::Hold);
    if (m_hold->defaultAction() != hold) {
        // A tool button collects the actions it was given; its menu must not offer the old one.
        m_hold->removeAction(m_hold->defaultAction());
        m_hold->setDefaultAction(hold);
    }
    m_clock->setText(formatDuration(snapshot.runTime_s));
    sayWithText(m_clock, tr("Time since Start"));
    m_untilColdTip = snapshot.isRecordedUntilCold ? recordedUntilColdText(snapshot, m_unit) : QString();
    if (snapshot.labels != m_labels || m_untilCold->isHidden() == snapshot.isRecordedUntilCold) {
        m_labels = snapshot.labels;
        showLabels();
    }
    showUntilCold();
    m_alarm->setAlarms(snapshot.alarms);
    fit();
}

void StateBar::focusChip() {
    m_chip->setFocus(Qt::OtherFocusReason);
}

/// By the width and the language alone: an alarm or another state moves no verb.
void StateBar::fit() {
    QStringList shown{QString::number(width()), m_tagWord->text(), runLabelWords(m_labels)};
    for (const Verb verb :
         {Verb::Arm, Verb::Start, Verb::Hold, Verb::Resume, Verb::Stop, Verb::Retreat, Verb::Reset})
        shown << m_actions.verb(verb)->iconText();
    if (const QString now = shown.join(u'\n'); now != m_fitted) {
        m_fitted = now;
        int parts = 0;
        shorten(parts);
        while (parts < kShortParts && roomNeeded(parts) > width())
            shorten(++parts);
    }
}

/// With an alarm, also while there is none.
int StateBar::roomNeeded(int parts) const {
    for (QLayout* each : layout()->findChildren<QLayout*>())
        each->invalidate(); // of a part that has changed Qt tells the outermost alone
    const QHBoxLayout* const last = m_areTwoRows ? m_below : m_row;
    int room = last->minimumSize().width();
    if (!m_alarm->isHidden())
        room -= m_alarm->minimumSizeHint().width() + last->spacing();
    const bool hasAlarmText = parts >= kWithoutFirstWords && parts < kWithoutClock;
    room += last->spacing() + m_alarm->widthWithoutText() + (hasAlarmText ? kAlarmText : 0);
    if (m_areTwoRows)
        room = std::max(room, m_row->minimumSize().width());
    const QMargins margins = layout()->contentsMargins();
    return room + margins.left() + margins.right();
}

/// What is always in words stays in the upper one.
void StateBar::setTwoRows(bool areTwo) {
    if (areTwo == m_areTwoRows)
        return;
    m_areTwoRows = areTwo;
    QHBoxLayout *const from = areTwo ? m_row : m_below, *const to = areTwo ? m_below : m_row;
    from->removeItem(m_verbs);
    m_verbs->setParent(nullptr);
    from->removeWidget(m_alarm);
    to->insertLayout(areTwo ? 0 : to->indexOf(m_chip) + 2, m_verbs);
    to->insertWidget(areTwo ? 1 : to->indexOf(m_emergency) - 1, m_alarm);
}

/// Resume has Hold's place and pushes nothing aside.
void StateBar::reserveHold() {
    m_hold->setMinimumWidth(0);
    const auto width = [this](const QString& word) { // as the button reckons
        return m_hold->fontMetrics().size(Qt::TextShowMnemonic, word).width();
    };
    int more = 0;
    if (m_hold->toolButtonStyle() != Qt::ToolButtonIconOnly)
        for (const Verb verb : {Verb::Hold, Verb::Resume})
            more = std::max(more, width(m_actions.verb(verb)->iconText()) - width(m_hold->text()));
    m_hold->setMinimumWidth(m_hold->sizeHint().width() + more);
}

void StateBar::shorten(int parts) {
    const auto style = [parts](int withoutWords) {
        if (parts >= withoutWords && parts != kInTwoRows)
            return Qt::ToolButtonIconOnly;
        return parts >= kWithoutVerbIcons ? Qt::ToolButtonTextOnly : Qt::ToolButtonTextBesideIcon;
    };
    for (QToolButton* button : {m_arm, m_start, m_reset})
        button->setToolButtonStyle(style(kWithoutFirstWords));
    for (QToolButton* button : {m_hold, m_stop, m_retreat})
        button->setToolButtonStyle(style(kWithoutVerbWords));
    const int icon = parts < kWithoutClock ? 20 : 16;
    const QFont words = parts < kWithSmallWords ? font() : scaled(font(), kTiny);
    for (QToolButton* button : {m_arm, m_start, m_hold, m_stop, m_retreat, m_reset}) {
        button->setIconSize({icon, icon});
        button->setFont(words);
        button->setMinimumHeight(parts < kInTwoRows ? kVerbHeight : kVerbHeightBelow);
    }
    reserveHold();
    const bool isSmall = parts >= kWithSmallTag;
    m_tagIcon->setVisible(!isSmall);
    m_tagGrid->setColumnMinimumWidth(1, parts < kWithSmallWords ? kTagWord : 0);
    m_tagWord->setFont(isSmall ? scaled(font(), kTiny) : font());
    m_chip->setCompact(isSmall);
    m_emergency->setKeyShown(!isSmall);
    for (QSpacerItem* gap : m_gaps)
        gap->changeSize(isSmall ? 0 : kPartGap, 0, QSizePolicy::Fixed, QSizePolicy::Minimum);
    m_clockCaption->setVisible(parts < kWithoutCaption);
    const int gap = parts < kWithoutCaption ? kBarGap : kBarGap / 2;
    for (QHBoxLayout* row : {m_row, m_below, m_verbs})
        row->setSpacing(gap);
    setTwoRows(parts >= kInTwoRows);
    const int edge = m_areTwoRows ? 2 : 6;
    layout()->setSpacing(edge);
    layout()->setContentsMargins(gap + 2, edge, gap + 2, edge);
    m_clock->setVisible(parts < kWithoutClock);
    m_shortParts = parts;
    showFault();
    showLabels();
    showUntilCold();
}

QSize StateBar::minimumSizeHint() const {
    return {kMinWidth, QFrame::minimumSizeHint().height()};
}

bool StateBar::event(QEvent* event) {
    if (event->type() == QEvent::LayoutRequest) // of a language, say
        fit();
    return QFrame::event(event);
}

/// A button that is greyed hears no click, but what watches it does.
bool StateBar::eventFilter(QObject* watched, QEvent* event) {
    const auto* button = qobject_cast<QToolButton*>(watched);
    if (button != nullptr && !button->isEnabled() && event->type() == QEvent::MouseButtonPress)
        for (int i = 0; i < kVerbs; ++i)
            if (m_actions.verb(static_cast<Verb>(i)) == button->defaultAction())
                emit verbRefused(static_cast<Verb>(i));
    return QFrame::eventFilter(watched, event);
}

void StateBar::resizeEvent(QResizeEvent* event) {
    QFrame::resizeEvent(event);
    fit();
}

void StateBar::setAnswering(bool answering) {
    m_answering = answering;
    m_alarm->setStale(!answering);
    showChip();
}

void StateBar::setTemperatureUnit(TemperatureUnit unit) {
    m_unit = unit;
    m_alarm->setTemperatureUnit(unit);
    showChip();
}

void StateBar::showChip() {
    if (!m_answering) {
        m_chip->setUnknown(
            tr("The engine is not answering. The robot ends its step, and a heat source with a "
               "watchdog goes off by itself. Look at the rig, then close Bask and start it again."));
        return;
    }
    QStringList sentences;
    for (const Message& reason : m_reasons)
        sentences << (!m_placeSureAgain.isEmpty() && isAboutPlace(reason.code) ? m_placeSureAgain
                                                                               : sentence(reason));
    m_chip->setState(m_state, sentences, m_gravest);
}

/// In a narrow window the name alone, then the initials.
void StateBar::showLabels() {
    const QString words = runLabelWords(m_labels);
    const QString who = QString::fromStdString(m_labels.operatorName);
    const QString sample = QString::fromStdString(m_labels.sample.empty() ? m_labels.batch : m_labels.sample);
    QString text = who.isEmpty() ? sample : who;
    if (m_shortParts >= kWithoutCaption) {
        QString initials;
        for (const QString& part : text.split(u' ', Qt::SkipEmptyParts))
            initials += part[0];
        text = initials.left(3);
    } else if (m_shortParts < kWithoutSample && !who.isEmpty() && !sample.isEmpty()) {
        text += QStringLiteral(" · ") + sample;
    }
    text = m_operator->fontMetrics().elidedText(text, Qt::ElideRight, kOperatorText);
    m_operator->setText(text.replace(u'&', QStringLiteral("&&")));
    m_operator->setToolTip(words + u'\n' + tr("Click to change it."));
    m_operator->setAccessibleName(words);
    m_operator->setVisible(m_shortParts < kWithoutClock && !words.isEmpty() && m_untilColdTip.isEmpty());
}

void StateBar::showUntilCold() {
    m_untilCold->setText(m_shortParts < kWithoutCaption
                             ? tr("recorded until cold", "under the clock: the run has ended")
                             : tr("until cold", "the same where there is less room"));
    m_untilCold->setToolTip(m_untilColdTip);
    m_untilCold->setVisible(m_shortParts < kWithoutClock && !m_untilColdTip.isEmpty());
    const QString tip = tr("Time since Start");
    m_clock->setToolTip(m_untilColdTip.isEmpty() ? tip : tip + u'\n' + m_untilColdTip);
}

void StateBar::showTag() {
    const bool dark = isDark(this);
    const QColor colour = m_simulated ? secondaryText(dark) : accentColor(dark);
    m_tag->setStyleSheet(
        QStringLiteral("#rigTag { border: 2px %1 %2; border-radius: 5px; } "
                       "#rigTag QLabel { color: %2; font-weight: 600; }")
            .arg(m_simulated ? QStringLiteral("dashed") : QStringLiteral("solid"), colour.name()));
    QPalette tinted = palette();
    tinted.setColor(QPalette::ButtonText, colour);
    m_tagIcon->setPixmap(themedIcon(m_simulated ? QStringLiteral("simulated") : QStringLiteral("run"), tinted)
                             .pixmap(QSize(kTagIcon, kTagIcon), devicePixelRatio()));
    m_tagWord->setText(rigWord(m_simulated));
    QString tip = m_simulated ? tr("The rig is simulated: no device moves or heats.")
                              : tr("The rig is real: Start moves it and opens the heat.");
    if (!m_faults.isEmpty())
        tip +=
            u'\n' + tr("Simulated faults, which Tools > Simulate fault ends:") + u'\n' + m_faults.join(u'\n');
    m_tag->setToolTip(tip);
    m_faultWord->setToolTip(tip);
    showFault();
    m_tag->setAccessibleName((QStringList(m_tagWord->text()) + m_faults).join(QStringLiteral(", ")));
}

/// As much of the first one's name as the tag has room for: all are in its tip.
void StateBar::showFault() {
    m_faultWord->setVisible(!m_faults.isEmpty());
    if (m_faults.isEmpty())
        return;
    const QString others = m_faults.size() > 1 ? QStringLiteral(" +%1").arg(m_faults.size() - 1) : QString();
    const int between = m_tagIcon->isHidden() ? 0 : kTagIcon + kTagGap;
    const int wide = between + std::max(m_tagGrid->columnMinimumWidth(1), m_tagWord->sizeHint().width());
    const int room = wide - m_faultWord->fontMetrics().horizontalAdvance(others);
    m_faultWord->setText(m_faultWord->fontMetrics().elidedText(m_faults.front(), Qt::ElideRight, room) +
                         others);
}

void StateBar::retranslate() {
    m_clockCaption->setText(tr("Run"));
    sayWithText(m_clock, tr("Time since Start"));
    showLabels();
    showUntilCold();
    setAccessibleName(tr("State of the run"));
}

void StateBar::changeEvent(QEvent* event) {
    QFrame::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
        showTag();
        showChip();
    } else if (event->type() == QEvent::PaletteChange) {
        showTag();
    }
}

} // namespace bask
