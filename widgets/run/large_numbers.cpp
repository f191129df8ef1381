#include "widgets/run/large_numbers.h"

#include "widgets/common/alarm_groups.h"
#include "widgets/common/alarm_words.h"
#include "widgets/common/device_words.h"
#include "widgets/common/display.h"
#include "widgets/common/run_state_chip.h"
#include "widgets/common/stop_button.h"
#include "widgets/common/theme.h"
#include "widgets/run/large_text.h"
#include "widgets/run/large_tile.h"

#include <QEvent>
#include <QPainter>
#include <QShortcut>

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

constexpr double kTopPart = 0.165, kRowPart = 0.05, kAlarmPart = 0.105, kGapPart = 0.011; // of the height
constexpr double kCountdownPart = 0.36;                      // of the alarm's line
constexpr double kStopPart = 0.27;                           // of the window's width
constexpr float kCallingGround = 0.18F, kSeenGround = 0.06F; // as on the state bar

} // namespace

LargeNumbers::LargeNumbers(QWidget* parent)
    : QWidget(parent, Qt::Window), m_rig(new LargeText("largeRig", Qt::AlignHCenter, this)),
      m_state(new LargeText("largeState", Qt::AlignLeft, this)),
      m_clock(new LargeText("largeClock", Qt::AlignRight, this)),
      m_source(new LargeText("largeSource", Qt::AlignLeft, this)),
      m_heat(new LargeText("largeHeat", Qt::AlignRight, this)),
      m_countdown(new LargeText("largeCountdown", Qt::AlignLeft, this)),
      m_alarm(new LargeText("largeAlarm", Qt::AlignLeft, this)), m_stop(new StopButton(this)) {
    setObjectName(QStringLiteral("largeNumbersWindow"));
    m_stop->setObjectName(QStringLiteral("largeStop"));
    setFocusPolicy(Qt::StrongFocus);
    setFocus(); // or Space would be for STOP
    QFont bold = font();
    bold.setBold(true);
    m_rig->setFont(bold);
    m_state->setFont(bold);
    m_countdown->setFont(bold);
    m_countdown->setWordWrap(true);
    m_alarm->setWordWrap(true);
    m_stop->setKeyShown(false);
    connect(m_stop, &StopButton::stopRequested, this, &LargeNumbers::stopRequested);
    auto* fill =
        new QShortcut(Qt::Key_F11, this, [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); });
    auto* end = new QShortcut(Qt::Key_Escape, this, [this] { closeOrShrink(); });
    for (QShortcut* key : {fill, end}) // Esc that is held would close the window with its STOP
        key->setAutoRepeat(false);
    setMinimumSize(480, 300);
    resize(960, 600);
    retranslate();
}

void LargeNumbers::apply(const Snapshot& snapshot, const std::vector<ShownObject>& objects,
                         TemperatureUnit unit) {
    m_isTold = true;
    m_last.simulated = snapshot.simulated;
    m_last.state = snapshot.state;
    m_last.runTime_s = snapshot.runTime_s;
    m_last.reasons = snapshot.reasons;
    m_last.alarms = snapshot.alarms;
    m_last.pending = snapshot.pending;
    m_last.source_K = snapshot.source_K;
    m_last.latest.source_K = snapshot.latest.source_K;
    m_last.sourceAge_s = snapshot.sourceAge_s;
    m_last.heat = snapshot.heat;
    m_last.isSourceManual = snapshot.isSourceManual;
    m_objects = objects;
    m_unit = unit;
    refresh();
}

void LargeNumbers::setAnswering(bool answering) {
    m_isAnswering = answering;
    refresh();
}

void LargeNumbers::refresh() {
    showState();
    showSource();
    showAlarm();
    showCountdown();
    showTiles();
}

void LargeNumbers::closeOrShrink() {
    if (isFullScreen())
        setWindowState(windowState() & ~Qt::WindowFullScreen);
    else
        close();
}

void LargeNumbers::showState() {
    if (m_isTold) {
        m_rig->setText(rigWord(m_last.simulated));
        m_clock->setText(tr("Run %1", "%1 is the time since Start").arg(formatDuration(m_last.runTime_s)));
    }
    m_state->setText(!m_isAnswering ? RunStateChip::unknownWord()
                     : m_isTold     ? runStateWord(m_last.state)
                                    : QString());
    m_state->setLook(m_isAnswering && m_isTold
                         ? LargeLook{.priority = statePriority(
                                         m_last.state, gravestPriority(m_last.reasons, m_last.alarms))}
                         : LargeLook{.isUnknown = !m_isAnswering});
    m_clock->setLook({.isGrey = !m_isAnswering});
    m_rig->setLook({.isGrey = m_last.simulated});
}

void LargeNumbers::showSource() {
    if (!m_isTold)
        return;
    const ShownHeat heat = shownHeat(m_last, m_isAnswering);
    m_source->setText(tr("Source %1", "%1 is its newest temperature").arg(sourceReadingText(m_last, m_unit)));
    m_source->setLook({.isGrey = !m_isAnswering || !m_last.source_K});
    m_heat->setText(asSentence(heatWord(heat)));
    const int priority = heatPriority(heat);
    m_heat->setLook(
        {.isUnknown = heat == ShownHeat::Unknown, .isAlarmInk = priority > 0, .priority = priority});
}

/// The gravest that still is so; that the engine is silent comes before it.
void LargeNumbers::showAlarm() {
    const bool dark = isDark(this);
    const AlarmGroups groups = groupAlarms(m_last.alarms);
    const std::vector<AlarmGroup>& alarms = groups.present;
    const AlarmGroup* const first = gravest(groups);
    const bool isAlarm = first != nullptr && first->isActive();
    QString words;
    LargeLook look;
    QColor ground;
    if (isAlarm) {
        const bool isCalling = std::ranges::any_of(alarms, &AlarmGroup::isCalling);
        words = alarmSentence(first->alarm, m_unit); // with what to do
        if (alarms.size() > 1)
            words += QStringLiteral(" (+%1)").arg(alarms.size() - 1);
        look.priority = first->alarm.priority;
        ground = isCalling ? alarmColor(first->alarm.priority, dark) : secondaryText(dark);
        ground.setAlphaF(isCalling ? kCallingGround : kSeenGround);
    }
    if (!m_isAnswering) {
        words =
            tr("The engine is not answering: what is shown is old.") + (isAlarm ? u' ' + words : QString());
        look = {.isUnknown = true};
        ground = unknownColor(dark);
        ground.setAlphaF(kCallingGround);
    }
    m_alarm->setText(words);
    m_alarm->setLook(look);
    if (ground != m_alarmGround) {
        m_alarmGround = ground;
        update();
    }
}

/// What the engine does next by itself, and when.
void LargeNumbers::showCountdown() {
    QString words;
    if (m_isAnswering && m_last.pending)
        words = tr("In %1 s: %2", "seconds, and what the engine does then")
                    .arg(std::max(0.0, std::ceil(m_last.pending->in_s)), 0, 'f', 0)
                    .arg(sentenceText(m_last.pending->action));
    const bool isOther = words.isEmpty() != m_countdown->text().isEmpty();
    m_countdown->setText(words);
    if (isOther)
        arrange();
}

void LargeNumbers::showTiles() {
    const std::size_t before = m_tiles.size();
    while (m_tiles.size() > m_objects.size()) {
        delete m_tiles.back();
        m_tiles.pop_back();
    }
    while (m_tiles.size() < m_objects.size()) {
        m_tiles.push_back(new LargeTile(static_cast<int>(m_tiles.size()), this));
        m_tiles.back()->show();
    }
    for (std::size_t i = 0; i < m_tiles.size(); ++i)
        m_tiles[i]->setShown(m_objects[i], m_unit);
    if (m_tiles.size() != before)
        arrange();
}

void LargeNumbers::arrange() {
    const int gap = std::max(4, qRound(kGapPart * height()));
    const QRect all = rect().adjusted(gap, gap, -gap, -gap);
    const int top = qRound(kTopPart * height()), row = qRound(kRowPart * height()),
              alarm = qRound(kAlarmPart * height()), stop = qRound(kStopPart * width());
    sizeStop({stop, top});
    m_stop->setGeometry(all.right() + 1 - stop, all.top(), stop, top);
    m_state->setGeometry(all.left(), all.top(), m_stop->x() - gap - all.left(), top);
    placeInRow(QRect(all.left(), all.top() + top + gap, all.width(), row), gap,
               {{m_rig, 0.2}, {m_clock, 0.2}, {m_source, 0.33}, {m_heat, 0.27}});
    m_rigFrame = m_rig->geometry();
    m_rig->setGeometry(m_rigFrame.adjusted(gap, gap / 2, -gap, -gap / 2));
    const QRect line = all.adjusted(gap, all.height() - alarm, -gap, 0);
    const int countdown = m_countdown->text().isEmpty() ? 0 : qRound(kCountdownPart * line.width());
    m_countdown->setGeometry(line.left(), line.top(), countdown, line.height());
    m_alarm->setGeometry(line.adjusted(countdown > 0 ? countdown + gap : 0, 0, 0, 0));
    arrangeTiles(all.adjusted(0, top + row + 2 * gap, 0, -alarm - gap), gap);
    update();
}

/// In the rows and columns that make the figures largest.
void LargeNumbers::arrangeTiles(const QRect& room, int gap) {
    const auto count = static_cast<int>(m_tiles.size());
    if (count == 0)
        return;
    const auto rowsFor = [count](int columns) { return (count + columns - 1) / columns; };
    const auto cellFor = [&](int columns) {
        const int rows = rowsFor(columns);
        return QSize((room.width() - (columns - 1) * gap) / columns,
                     (room.height() - (rows - 1) * gap) / rows);
    };
    int best = 1;
    for (int columns = 2; columns <= count; ++columns)
        if (m_tiles.front()->figureHeight(cellFor(columns)) > m_tiles.front()->figureHeight(cellFor(best)))
            best = columns;
    const QSize cell = cellFor(best);
    for (int i = 0; i < count; ++i)
        m_tiles[static_cast<std::size_t>(i)]->setGeometry(
            QRect(QPoint(room.left() + i % best * (cell.width() + gap),
                         room.top() + i / best * (cell.height() + gap)),
                  cell));
}

/// Its size follows from its font, not quite in proportion: from below in a few steps.
void LargeNumbers::sizeStop(QSize room) {
    QFont letters = font();
    letters.setPointSizeF(4.0);
    for (int step = 0; step < 5; ++step) {
        m_stop->setFont(letters);
        const QSize needed = m_stop->sizeHint();
        const double larger = std::min(static_cast<double>(room.width()) / needed.width(),
                                       static_cast<double>(room.height()) / needed.height());
        if (larger <= 1.0)
            break;
        letters.setPointSizeF(letters.pointSizeF() * larger);
    }
}

void LargeNumbers::retranslate() {
    setWindowTitle(tr("Bask: large numbers"));
    refresh();
}

void LargeNumbers::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    else if (event->type() == QEvent::PaletteChange)
        refresh();
    else if (event->type() == QEvent::FontChange)
        arrange();
}

void LargeNumbers::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (m_isTold) {
        const bool dark = isDark(this);
        const double frame = std::max(1.5, height() / 400.0);
        painter.setPen(m_last.simulated ? QPen(secondaryText(dark), frame, Qt::DashLine)
                                        : QPen(accentColor(dark), frame));
        painter.drawRoundedRect(QRectF(m_rigFrame).adjusted(1, 1, -1, -1), 5, 5);
    }
    if (m_alarmGround.isValid()) {
        const QRectF band = rect().adjusted(2, m_alarm->y(), -2, -2);
        painter.setPen(Qt::NoPen);
        painter.setBrush(m_alarmGround);
        painter.drawRoundedRect(band, 6, 6);
    }
}

void LargeNumbers::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    arrange();
}

} // namespace bask
