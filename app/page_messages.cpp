#include "app/page_messages.h"

#include "engine/recording/alarm_history.h"
#include "widgets/common/message_bar.h"

#include <QApplication>

#include <algorithm>
#include <utility>

namespace bask {

PageMessages::PageMessages(MessageBar& bar, std::chrono::milliseconds longest,
                           std::chrono::milliseconds written)
    : m_bar(bar), m_longest(longest), m_longestWritten(written) {
    m_age.setSingleShot(true);
    m_age.callOnTimeout([this] { dropOld(); });
}

/// The sentence has its time from now on.
void PageMessages::age(const QString& sentence, std::chrono::milliseconds longest) {
    m_forATime = sentence;
    m_age.start(longest);
}

/// Not under the pointer: somebody reads it, or copies it. Nor with the keyboard in what was written: one of
/// its buttons is about to be pressed.
void PageMessages::dropOld() {
    if (m_bar.sentence() != m_forATime)
        return;
    const bool hasKeyboard = m_forATime == m_written && m_bar.isAncestorOf(QApplication::focusWidget());
    if (m_bar.underMouse() || hasKeyboard)
        m_age.start();
    else
        m_bar.clear();
}

void PageMessages::showProblem(const QString& sentence) {
    m_bar.say(MessageBar::Kind::Problem, sentence);
}

void PageMessages::showNote(const QString& sentence) {
    m_bar.say(MessageBar::Kind::Note, sentence);
}

void PageMessages::showBriefly(const QString& note) {
    age(note, m_longest);
    showNote(note);
}

void PageMessages::showWritten(const QString& sentence, const QString& open, const QString& other) {
    m_written = sentence;
    age(sentence, m_longestWritten);
    m_bar.ask(sentence, open, other);
}

void PageMessages::clear() {
    m_bar.clear();
}

void PageMessages::showOfEdit(const QString& note) {
    m_ofEdit = note;
    showBriefly(note);
}

void PageMessages::dropOfEdit() {
    if (m_bar.sentence() == m_ofEdit)
        m_bar.clear();
}

void PageMessages::showRefusal(const QString& sentence) {
    m_ofEdit = sentence;
    age(sentence, m_longest);
    showProblem(sentence);
}

void PageMessages::showRefusal(const QString& text, const Snapshot& snapshot, const Message& refusal) {
    m_refusalSaid = text;
    m_refusal = refusal;
    m_isOfReason = false;
    m_refusedIn = snapshot.state;
    showRefusal(text);
}

void PageMessages::dropRefusal() {
    for (QString* said : {&m_refusalSaid, &m_ofMoment})
        if (const QString text = std::exchange(*said, {}); !text.isEmpty() && m_bar.sentence() == text)
            m_bar.clear();
}

void PageMessages::keepRefusal(const Snapshot& snapshot) {
    if (m_refusalSaid.isEmpty())
        return;
    // The reason of a hot object is told anew with each reading.
    const bool isReason = std::ranges::any_of(
        snapshot.reasons, [this](const Message& reason) { return isSameAlarm(reason, m_refusal); });
    m_isOfReason = m_isOfReason || isReason;
    if (snapshot.state != m_refusedIn || (m_isOfReason && !isReason))
        dropRefusal();
}

void PageMessages::dropWritten(RunState state) {
    const bool isArmedNow = state == RunState::Armed && m_state != RunState::Armed;
    m_state = state;
    if (isArmedNow && !m_written.isEmpty() && m_bar.sentence() == m_written)
        m_bar.clear();
}

void PageMessages::showWhile(const QString& text, RunState state) {
    m_ofMoment = text;
    m_refusedIn = state;
    age(text, m_longest);
    showProblem(text);
}

bool PageMessages::keepWhile(const QString& text, RunState state) {
    if (m_ofMoment.isEmpty() || m_bar.sentence() != m_ofMoment)
        return false;
    if (text.isEmpty() || state != m_refusedIn) {
        m_bar.clear();
        return false;
    }
    if (text != m_ofMoment) {
        m_ofMoment = m_forATime = text; // other words, not more time
        showProblem(text);
    }
    return true;
}

} // namespace bask
