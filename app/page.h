#pragma once
// The window's pages, in the order of work.

namespace bask {

enum class Page { Rig, Objects, Calibrate, Targets, Run, Review };

} // namespace bask
