#pragma once
// How evenly a heat source radiates, in words.

#include "engine/model/experiment.h"

#include <QString>

namespace bask {

/// Returns "even", or how many parts or points of a profile the source has and how strongly they radiate, as
/// the experiment assumes it.
QString evennessText(const Experiment& experiment);

} // namespace bask
