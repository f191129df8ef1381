#pragma once
// How runs are named in a list, and what tells those of one experiment apart.

#include "engine/base/units.h"
#include "engine/recording/session_header.h"

#include <QDateTime>
#include <QString>

#include <vector>

namespace bask {

/// Returns the name that a person gave to the file of a run, without its ending; empty if Bask named it.
QString givenName(const SessionHeader& session);

/// Returns the name by which a run is listed: the one that a person gave, else the title, else the file.
QString listedName(const SessionHeader& session);

/// Returns when a run was recorded, in local time; of a file that does not say, when it was changed.
QDateTime recordedAt(const SessionHeader& session);

/// Returns for each run in which targets, controller, materials and emittances it differs from those of the
/// same title: "hand 55.0 °C · Adaptive", with all its objects where these are not the same. Where that,
/// operator and sample tell nothing, the file's name. Empty if no other has its title.
std::vector<QString> runDifferences(const std::vector<SessionHeader>& sessions, TemperatureUnit unit);

/// Returns for each of a few runs what tells it from the others, in the words of the list: its name, its
/// differences from those of its title, operator, sample, batch and rig, as far as they differ. Where nothing
/// does, the file's name.
std::vector<QString> runKeys(const std::vector<SessionHeader>& sessions, TemperatureUnit unit);

/// Returns the translated name of a recorded controller; one that is not known as it is in the file.
QString listedController(const SessionHeader& session);

} // namespace bask
