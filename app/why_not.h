#pragma once
// Why a verb of the run, or another action of the window, is not possible now: its button, key or tip shows
// this instead of doing nothing.

#include "app/actions.h"
#include "app/run_forecast.h"

#include <QString>

#include <optional>

namespace bask {

/// Returns one translated sentence that names what to do first; empty if `allows(snapshot, verb)`.
QString whyNot(const Snapshot& snapshot, Verb verb);

/// Returns what Reset waits for of a source that heated though its heat is off; empty if that is not why.
QString unaskedWait(const Snapshot& snapshot, TemperatureUnit unit);
/// Returns what to do in which order while the robot's place is not sure, as the engine accepts it.
QString placeSteps(const Snapshot& snapshot);

/// Returns the verb that a remedy of the engine asks for; empty for one that has to be waited for.
std::optional<Verb> remedyVerb(MessageCode remedy);

/// Returns one translated sentence about why a run has no prediction; empty if it has one.
QString whyNoForecast(RunForecast::Missing missing);

/// Return one translated sentence; empty if the action is possible.
QString whyNotAnother(const Snapshot& snapshot); ///< why no other experiment can be begun
QString whyNotHome(const Snapshot& snapshot);
QString whyNotEndRecording(const Snapshot& snapshot);
QString whyNotAcknowledge(const Snapshot& snapshot);
/// Returns the sentence for a program that has not recorded anything yet.
QString whyNotSaveSession();

} // namespace bask
