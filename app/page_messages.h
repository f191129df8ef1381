#pragma once
// What is said over the pages, and for how long.

#include "engine/runtime/snapshot.h"

#include <QString>

namespace bask {

class MessageBar;

class PageMessages {
public:
    explicit PageMessages(MessageBar& bar) : m_bar(bar) {}

    /// A sentence over the pages, until it is closed.
    void showProblem(const QString& sentence);
    void showNote(const QString& sentence);
    void clear();

    void showOfEdit(const QString& note); ///< gone with the next edit
    void dropOfEdit();
    void showRefusal(const QString& sentence); ///< gone with the next edit
    /// The engine's: gone with the next edit or command, and with the state or the reason that it is about.
    void showRefusal(const QString& sentence, const Snapshot& snapshot, const Message& refusal);
    /// Of the engine or of a verb: something else was asked for.
    void dropRefusal();
    /// What was refused for a state or a reason is not said any longer than that lasts.
    void keepRefusal(const Snapshot& snapshot);
    /// Gone as soon as keepWhile() says something else, or nothing.
    void showWhile(const QString& sentence);
    /// Changes or clears what showWhile() has said. False: it is shown no more.
    bool keepWhile(const QString& sentence);

private:
    MessageBar& m_bar;
    QString m_ofEdit;      ///< said last of the newest edit
    QString m_ofMoment;    ///< said for as long as it is so
    QString m_refusalSaid; ///< the engine's last one
    Message m_refusal;
    bool m_isOfReason = false; ///< it is one of the reasons for the state
    RunState m_refusedIn = RunState::Idle;
};

} // namespace bask
