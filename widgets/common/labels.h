#pragma once
// Headings of parts of a page, and labels that show that something is not known, or old.

class QColor;
class QLabel;
class QWidget;

namespace bask {

/// Makes the label semi-bold and `scale` times as large.
void makeBold(QLabel* label, double scale = 1.0);
QLabel* boldLabel(QWidget* parent, double scale = 1.0);

/// Shows a text in the colour of unknown values with its mark, or removes both. Cheap if nothing changes.
void showUnknown(QLabel* mark, QLabel* text, bool isUnknown);
/// Greys a value that is older than it should be.
void showOld(QLabel* text, bool isOld);

} // namespace bask
