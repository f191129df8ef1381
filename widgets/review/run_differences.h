#pragma once
// What tells the runs of one experiment apart in a list.

#include "engine/base/units.h"
#include "engine/recording/session_header.h"

#include <QString>

#include <vector>

namespace bask {

/// Returns the name that a person gave to the file of a run, without its ending; empty if Bask named it.
QString givenName(const SessionHeader& session);

/// Returns for each run in which targets, controller, materials and emittances it differs from those of the
/// same title: "hand 55.0 °C · Adaptive". Where that, operator and sample tell nothing, the file's name.
/// Empty if no other has its title.
std::vector<QString> runDifferences(const std::vector<SessionHeader>& sessions, TemperatureUnit unit);

/// Returns the translated name of a recorded controller; one that is not known as it is in the file.
QString listedController(const SessionHeader& session);

} // namespace bask
