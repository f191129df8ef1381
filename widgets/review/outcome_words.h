#pragma once
// How a recorded run ended, as a word and a shape.

#include <QPixmap>
#include <QString>

#include <string>

namespace bask {

enum class Outcome {
    Settled,
    NotSettled,
    Stopped,
    EmergencyStop,
    Fault,
    Interrupted,
    Recording,
    Damaged,
    Altered,
    Unreadable,
    Other
};

/// Returns the outcome of the word in the file; an empty word means a recording without an end.
Outcome outcomeOf(const std::string& recorded);
/// Returns "Settled"; for Other the caller shows the word in the file.
QString outcomeWord(Outcome outcome);
/// Returns "Fault, by an alarm of priority 2"; the word alone with priority 0.
QString outcomeWord(Outcome outcome, int priority);
/// Grey, as all that is past. `priority`: of the alarm that ended the run in a fault, with whose mark it is
/// shown; 0: not known.
QPixmap outcomePixmap(Outcome outcome, bool dark, int size, double devicePixelRatio, int priority = 0);

} // namespace bask
