#pragma once
// The questions before the window is closed during a run or a recipe, or while something is written.

#include <QStringList>

class QWidget;

namespace bask {

enum class Closing {
    Keep, ///< the window stays open, the run continues
    Stop, ///< the run ends first, with the heat off and a retreat
    Now,  ///< heat off, the robot stops where it is
};

/// Asks the person; Return and Escape end nothing. Object name: "closeQuestion", its buttons "closeStop" and
/// "closeNow". `isRunOn`: a run is on, or in its retreat; otherwise a recipe waits between its runs.
Closing askToClose(QWidget* window, bool isRunOn, bool isRecipeOn);

/// Asks whether to close although a run that has ended is still recorded; `why` says until when. Object name:
/// "recordingQuestion", its button "closeNow".
bool askToEndRecording(QWidget* window, const QString& why);

/// Asks whether to close although these files and folders are not written yet. Object name: "exportQuestion",
/// its button "closeAnyway".
bool askToLeaveExports(QWidget* window, const QStringList& places);

/// Tells that the engine has ended and a real source was not seen to go off. Object name: "heatLeft".
void tellHeatLeft(QWidget* window);

} // namespace bask
