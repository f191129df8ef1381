#pragma once
// The messages above the pages, and how long each is shown.

#include "engine/runtime/snapshot.h"

#include <QString>
#include <QTimer>

#include <chrono>

namespace bask {

class MessageBar;

class PageMessages {
public:
    /// A refusal, or a note, is shown for so long at most, or as long as the pointer is on it: a sentence
    /// read twice.
    static constexpr std::chrono::milliseconds kRefusal{12'000};
    /// What was written is shown for longer: it has buttons.
    static constexpr std::chrono::milliseconds kWritten{20'000};

    explicit PageMessages(MessageBar& bar, std::chrono::milliseconds longest = kRefusal,
                          std::chrono::milliseconds written = kWritten);

    /// Shows a sentence above the pages until it is closed.
    void showProblem(const QString& sentence);
    void showNote(const QString& sentence);
    void showBriefly(const QString& note); ///< for kRefusal
    /// Shows that files were written, with a button that opens them and another one, for kWritten or until
    /// the rig is armed.
    void showWritten(const QString& sentence, const QString& open, const QString& other);
    void clear();

    void showOfEdit(const QString& note); ///< gone with the next edit, or after kRefusal
    void dropOfEdit();
    void showRefusal(const QString& sentence); ///< gone with the next edit, or after kRefusal
    /// Shows a refusal of the engine: it disappears with the next edit or command, when its state or reason
    /// ends, or after kRefusal.
    void showRefusal(const QString& sentence, const Snapshot& snapshot, const Message& refusal);
    /// Removes a refusal of the engine or of a verb, because something else was requested.
    void dropRefusal();
    /// Removes a refusal when its state or reason has ended.
    void keepRefusal(const Snapshot& snapshot);
    /// Removes what was written when the rig is armed: it lies over what is then to be seen.
    void dropWritten(RunState state);
    /// Shows a sentence in this state until keepWhile() gets an empty one or another state, or for kRefusal.
    void showWhile(const QString& sentence, RunState state);
    /// Updates or clears the sentence of showWhile(). Returns false if it is no longer shown.
    bool keepWhile(const QString& sentence, RunState state);

private:
    void age(const QString& sentence, std::chrono::milliseconds longest);
    void dropOld();

    MessageBar& m_bar;
    const std::chrono::milliseconds m_longest, m_longestWritten;
    QTimer m_age;
    QString m_forATime;    ///< what m_age is about
    QString m_written;     ///< the message of showWritten()
    QString m_ofEdit;      ///< the message about the newest edit
    QString m_ofMoment;    ///< the message of showWhile()
    QString m_refusalSaid; ///< the engine's last refusal
    Message m_refusal;
    bool m_isOfReason = false;             ///< it is one of the reasons of the state
    RunState m_refusedIn = RunState::Idle; ///< state of the newest refusal, of the engine or of a verb
    RunState m_state = RunState::Idle;     ///< the newest of dropWritten()
};

} // namespace bask
