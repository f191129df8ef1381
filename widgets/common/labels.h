#pragma once
// Labels that head a part of a page, and those that say that something is not known, or old.

class QColor;
class QLabel;
class QWidget;

namespace bask {

/// In semi-bold, `scale` times as large.
void makeBold(QLabel* label, double scale = 1.0);
QLabel* boldLabel(QWidget* parent, double scale = 1.0);

/// Gives a text the ink of what is not known, and shows its mark beside it; or takes both away. Cheap when it
/// is so already.
void showUnknown(QLabel* mark, QLabel* text, bool isUnknown);
/// Greys a value that is older than it should be.
void showOld(QLabel* text, bool isOld);

} // namespace bask
