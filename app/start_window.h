#pragma once
// The program with its window: applies settings and prints the timing of the start on request.

#include <QString>

namespace bask {

/// Runs the window until it is closed. `file` as in Dispatch. With BASK_TIMING=1 in the environment, "first
/// picture: N ms" is printed on standard error after the window was painted with its first experiment.
int runWindow(int& argc, char** argv, const QString& file);

} // namespace bask
