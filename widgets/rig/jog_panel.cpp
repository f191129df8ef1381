#include "widgets/rig/jog_panel.h"

#include "engine/base/message_code.h"
#include "widgets/common/device_words.h"
#include "widgets/common/display.h"
#include "widgets/common/labels.h"
#include "widgets/common/number_field.h"
#include "widgets/rig/coordinate_words.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QToolButton>

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

constexpr std::array kSteps_mm{0.1, 1.0, 10.0};
constexpr std::array kSteps_deg{0.1, 1.0, 5.0};
constexpr int kUsualSpeed_percent = 25;
constexpr int kButton = 34;

} // namespace

JogPanel::JogPanel(QWidget* parent)
    : QWidget(parent), m_stepLabel(new QLabel(this)), m_speedLabel(new QLabel(this)),
      m_goLabel(new QLabel(this)), m_problem(new QLabel(this)), m_placeMark(new QLabel(this)),
      m_placeLabel(new QLabel(this)), m_stepLength(new QComboBox(this)), m_stepAngle(new QComboBox(this)),
      m_speed(numberField(this, QStringLiteral("jogSpeed"), 1.0, 100.0, 0, QStringLiteral("\u00a0%"))),
      m_go(new QPushButton(this)), m_take(new QPushButton(this)), m_home(new QPushButton(this)),
      m_clear(new QPushButton(this)) {
    m_stepLength->setObjectName("stepLength");
    m_stepAngle->setObjectName("stepAngle");
    m_go->setObjectName("goToPose");
    m_take->setObjectName("takePose");
    m_home->setObjectName("homeRobot");
    m_clear->setObjectName("clearAlarm");
    m_problem->setObjectName("robotProblem");
    m_problem->setWordWrap(true);
    m_problem->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_problem->hide();
    m_placeLabel->setObjectName("robotPlace");
    m_placeLabel->setWordWrap(true);
    auto* place = new QHBoxLayout;
    place->setSpacing(6);
    place->addWidget(m_placeMark, 0, Qt::AlignTop);
    place->addWidget(m_placeLabel, 1);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    layout->addLayout(place);
    layout->addWidget(m_problem);
    layout->addWidget(buildSteps());
    layout->addWidget(buildRows());
    layout->addWidget(buildButtons());

    m_repeat.setInterval(kRepeat_ms);
    connect(&m_repeat, &QTimer::timeout, this, &JogPanel::repeat);
    connect(m_go, &QPushButton::clicked, this, &JogPanel::goToPose);
    connect(m_take, &QPushButton::clicked, this, &JogPanel::takePose);
    connect(m_home, &QPushButton::clicked, this, &JogPanel::homeWanted);
    connect(m_clear, &QPushButton::clicked, this, [this] { emit commandWanted(ClearRobotAlarm{}); });
    setLimits(RobotLimits());
    retranslate();
}

QWidget* JogPanel::buildSteps() {
    auto* part = new QWidget(this);
    for (std::size_t i = 0; i < kSteps_mm.size(); ++i) {
        m_stepLength->addItem(QString());
        m_stepAngle->addItem(QString());
    }
    m_stepLength->setCurrentIndex(1);
    m_stepAngle->setCurrentIndex(1);
    m_speed->setValue(kUsualSpeed_percent);
    m_stepLabel->setBuddy(m_stepLength);
    m_speedLabel->setBuddy(m_speed);
    auto* row = new QHBoxLayout(part);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_stepLabel);
    row->addWidget(m_stepLength);
    row->addWidget(m_stepAngle);
    row->addStretch(1);
    row->addWidget(m_speedLabel);
    row->addWidget(m_speed);
    return part;
}

QWidget* JogPanel::buildRows() {
    auto* part = new QWidget(this);
    auto* grid = new QGridLayout(part);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(5);
    grid->setVerticalSpacing(4);
    grid->setColumnStretch(1, 1);
    grid->addWidget(m_goLabel, 0, 6);
    for (int k = 0; k < 6; ++k) {
        Row& row = m_rows[static_cast<std::size_t>(k)];
        row.name = new QLabel(coordinateWord(k), part);
        row.at = new QLabel(part);
        row.at->setObjectName(coordinateObjectName("at", k));
        row.at->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        row.holdDown = holdButton(k, -1);
        row.stepDown = stepButton(k, -1);
        row.stepUp = stepButton(k, 1);
        row.holdUp = holdButton(k, 1);
        row.goTo = new NumberField(part);
        row.goTo->setObjectName(coordinateObjectName("goTo", k));
        row.goTo->setDecimals(2);
        row.goTo->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        row.goTo->setSuffix(coordinateSymbol(k));
        int column = 0;
        for (QWidget* widget : std::initializer_list<QWidget*>{row.name, row.at, row.holdDown, row.stepDown,
                                                               row.stepUp, row.holdUp, row.goTo})
            grid->addWidget(widget, k + 1, column++);
    }
    return part;
}

QWidget* JogPanel::buildButtons() {
    auto* part = new QWidget(this);
    auto* row = new QHBoxLayout(part);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_home);
    row->addWidget(m_clear);
    row->addStretch(1);
    row->addWidget(m_take);
    row->addWidget(m_go);
    return part;
}

QToolButton* JogPanel::stepButton(int coordinate, int direction) {
    auto* button = new QToolButton(this);
    button->setObjectName(coordinateObjectName(direction < 0 ? "stepDown" : "stepUp", coordinate));
    button->setText(direction < 0 ? QString(QChar(0x2212)) : QStringLiteral("+"));
    button->setMinimumSize(kButton, kButton);
    button->setFocusPolicy(Qt::StrongFocus);
    connect(button, &QToolButton::clicked, this,
            [this, coordinate, direction] { step(coordinate, direction); });
    return button;
}

QToolButton* JogPanel::holdButton(int coordinate, int direction) {
    auto* button = new QToolButton(this);
    button->setObjectName(coordinateObjectName(direction < 0 ? "holdDown" : "holdUp", coordinate));
    button->setText(direction < 0 ? QStringLiteral("\u25c0") : QStringLiteral("\u25b6"));
    button->setMinimumSize(kButton, kButton);
    button->setFocusPolicy(Qt::StrongFocus);
    connect(button, &QToolButton::pressed, this,
            [this, button, coordinate, direction] { hold(button, coordinate, direction); });
    connect(button, &QToolButton::released, this, &JogPanel::letGo);
    return button;
}

void JogPanel::setLimits(const RobotLimits& limits) {
    m_limits = limits;
    for (int k = 0; k < 6; ++k) {
        Row& row = m_rows[static_cast<std::size_t>(k)];
        const bool isFree = limits.free[static_cast<std::size_t>(k)];
        for (QWidget* part : std::initializer_list<QWidget*>{row.name, row.at, row.holdDown, row.stepDown,
                                                             row.stepUp, row.holdUp, row.goTo})
            part->setVisible(isFree);
        row.goTo->setRange(shownCoordinate(k, limits.lower[k]), shownCoordinate(k, limits.upper[k]));
        row.goTo->setSingleStep(k < kThetaX ? 5.0 : 1.0);
    }
    m_isPoseTaken = false;
}

void JogPanel::apply(const Snapshot& snapshot, bool mayMove) {
    m_at = snapshot.latest.coordinates;
    m_isMoving = snapshot.isMoving;
    m_mayMove = mayMove;
    m_alarm = snapshot.robotAlarm;
    m_place = snapshot.place;
    m_placeAge_s = snapshot.placeAge_s;
    if (!m_isMoving)
        m_goal.reset();
    m_mayHome = allowsHome(snapshot);
    if (!m_mayMove)
        letGo();
    if (!m_isPoseTaken && m_at.allFinite() && !snapshot.latest.objects.empty())
        takePose();
    for (int k = 0; k < 6; ++k) {
        QLabel* at = m_rows[static_cast<std::size_t>(k)].at;
        if (const QString text = coordinateReadout(k, m_at[k]); at->text() != text)
            at->setText(text);
    }
    showPlace();
    showEnabled();
}

void JogPanel::showPlace() {
    const bool isUnknown = m_place == PlaceState::Unknown;
    const QString text = !isUnknown ? QString()
                         : std::isfinite(m_placeAge_s)
                             ? tr("Place UNKNOWN. What stands below is %1.").arg(formatAge(m_placeAge_s))
                             : tr("Place UNKNOWN: the robot has not told it yet.");
    if (text != m_placeLabel->text())
        m_placeLabel->setText(text);
    m_placeLabel->setVisible(isUnknown);
    showUnknown(m_placeMark, m_placeLabel, isUnknown);
    for (const Row& row : m_rows)
        showOld(row.at, m_place != PlaceState::Sure);
}

void JogPanel::showEnabled() {
    for (const Row& row : m_rows)
        for (QWidget* part :
             std::initializer_list<QWidget*>{row.holdDown, row.stepDown, row.stepUp, row.holdUp, row.goTo})
            part->setEnabled(m_mayMove);
    m_go->setEnabled(m_mayMove);
    m_take->setEnabled(m_mayMove);
    m_home->setEnabled(m_mayHome);
    const bool isTrouble = m_alarm.code != MessageCode::None || m_place == PlaceState::Unsure;
    m_clear->setEnabled(isTrouble);
    const bool isOfPlace =
        m_place == PlaceState::Unsure && (m_alarm.code == MessageCode::None || isAboutPlace(m_alarm.code));
    m_clear->setText(isOfPlace ? tr("Confirm its place") : tr("Clear alarm"));
    const Message problem = m_place != PlaceState::Unsure || m_alarm.code != MessageCode::None
                                ? m_alarm
                                : Message{MessageCode::RobotPlaceUnsure, {}};
    const QString text = sentenceText(problem);
    if (text != m_problem->text())
        m_problem->setText(text);
    m_problem->setVisible(!text.isEmpty());
}

void JogPanel::step(int coordinate, int direction) {
    // Two quick clicks are two steps.
    Vector6d goal = m_goal.value_or(m_at);
    const auto size =
        static_cast<std::size_t>((coordinate < kThetaX ? m_stepLength : m_stepAngle)->currentIndex());
    goal[coordinate] += direction * coordinateFromShown(coordinate, coordinate < kThetaX ? kSteps_mm[size]
                                                                                         : kSteps_deg[size]);
    m_goal = goal;
    emit commandWanted(MoveTo{goal});
}

void JogPanel::hold(QToolButton* button, int coordinate, int direction) {
    m_held = button;
    m_heldCoordinate = coordinate;
    m_heldDirection = direction;
    m_repeat.start();
    repeat();
}

void JogPanel::repeat() {
    if (m_held == nullptr || !m_held->isDown() || !m_held->isEnabled())
        return letGo();
    const double share = 0.01 * m_speed->value() * m_heldDirection;
    Jog jog;
    if (m_heldCoordinate < kThetaX)
        jog.twist[m_heldCoordinate] = share * m_limits.maxSpeed_m_s;
    else
        jog.twist.tail<3>() =
            share * m_limits.maxRotation_rad_s * rotationAxes(m_at).col(m_heldCoordinate - kThetaX);
    emit commandWanted(jog);
}

void JogPanel::letGo() {
    if (m_held == nullptr)
        return;
    m_held = nullptr;
    m_repeat.stop();
    if (m_mayMove) // else the engine has taken the robot already, and would refuse
        emit commandWanted(Jog{});
}

void JogPanel::takePose() {
    m_isPoseTaken = true;
    for (int k = 0; k < 6; ++k)
        m_rows[static_cast<std::size_t>(k)].goTo->setValue(shownCoordinate(k, m_at[k]));
}

void JogPanel::goToPose() {
    Vector6d goal = m_at;
    for (int k = 0; k < 6; ++k)
        if (m_limits.free[static_cast<std::size_t>(k)])
            // A limit is shown rounded.
            goal[k] = std::clamp(coordinateFromShown(k, m_rows[static_cast<std::size_t>(k)].goTo->value()),
                                 m_limits.lower[k], m_limits.upper[k]);
    m_goal.reset();
    emit commandWanted(MoveTo{goal});
}

void JogPanel::retranslate() {
    const QLocale locale;
    for (std::size_t i = 0; i < kSteps_mm.size(); ++i) {
        const auto text = [&locale](double step, int coordinate) {
            return locale.toString(step, 'g', 3) + coordinateSymbol(coordinate);
        };
        m_stepLength->setItemText(static_cast<int>(i), text(kSteps_mm[i], kX));
        m_stepAngle->setItemText(static_cast<int>(i), text(kSteps_deg[i], kThetaX));
    }
    m_stepLabel->setText(tr("Step"));
    nameChoice(m_stepLength, tr("Step along an axis"));
    nameChoice(m_stepAngle, tr("Step about an axis"));
    m_speedLabel->setText(tr("Speed while held"));
    m_speed->setToolTip(tr("Of the largest speed that the robot's limits allow"));
    m_speed->setAccessibleName(m_speedLabel->text());
    m_goLabel->setText(tr("Go to"));
    for (int k = 0; k < 6; ++k) {
        const Row& row = m_rows[static_cast<std::size_t>(k)];
        const QString word = coordinateWord(k);
        const auto say = [](QWidget* part, const QString& text) {
            part->setToolTip(text);
            part->setAccessibleName(text);
        };
        say(row.stepDown, tr("One step of %1 down").arg(word));
        say(row.stepUp, tr("One step of %1 up").arg(word));
        say(row.holdDown, tr("%1 downwards for as long as this is held").arg(word));
        say(row.holdUp, tr("%1 upwards for as long as this is held").arg(word));
        row.goTo->setAccessibleName(tr("%1 to go to").arg(word));
    }
    m_go->setText(tr("Go"));
    m_go->setToolTip(tr("Move to these coordinates; Hold (F7) ends it"));
    m_take->setText(tr("Here"));
    m_take->setToolTip(tr("Put in where the robot is"));
    m_home->setText(tr("Home"));
    m_home->setToolTip(tr("The robot seeks its switches to know its place: it moves"));
    m_clear->setToolTip(tr("After you have seen to it: the robot is where it says. Nothing moves."));
    showPlace();
    showEnabled();
}

void JogPanel::hideEvent(QHideEvent* event) {
    letGo();
    QWidget::hideEvent(event);
}

bool JogPanel::event(QEvent* event) {
    if (event->type() == QEvent::WindowDeactivate)
        letGo();
    return QWidget::event(event);
}

void JogPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        showPlace();
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

} // namespace bask
