#pragma once
// Before the window is closed over a run or a recipe.

class QWidget;

namespace bask {

enum class Closing {
    Keep, ///< the window stays, the run goes on
    Stop, ///< first the run ends, with the heat off and a retreat
    Now,  ///< heat off, the robot stands still where it is
};

/// Asks the person; by Return and Escape nothing is ended. Object name: "closeQuestion", its buttons
/// "closeStop" and "closeNow". `isRunOn`: also in its retreat; else a recipe waits between its runs.
Closing askToClose(QWidget* window, bool isRunOn, bool isRecipeOn);

/// The engine has ended, and a real source was not seen to go off. Object name: "heatLeft".
void tellHeatLeft(QWidget* window);

} // namespace bask
