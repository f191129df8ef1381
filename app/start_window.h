#pragma once
// The program with its window: settings applied, timing of the start printed when asked.

#include <QString>

namespace bask {

/// Runs the window to its end. `file` as in Dispatch. With BASK_TIMING=1 in the environment "first picture: N
/// ms" goes to standard error once the window has been painted with its first experiment.
int runWindow(int& argc, char** argv, const QString& file);

} // namespace bask
