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
    Unreadable,
    Other
};

/// Of what stands in the file; empty is a recording without its end.
Outcome outcomeOf(const std::string& recorded);
/// "Settled"; that of Other is the word in the file, which the caller has.
QString outcomeWord(Outcome outcome);
QPixmap outcomePixmap(Outcome outcome, bool dark, int size, double devicePixelRatio);

} // namespace bask
