#pragma once
// Headings of parts of a page, labels that show that something is not known, or old, and what a screen reader
// says of a value.

class QColor;
class QComboBox;
class QLabel;
class QString;
class QWidget;

namespace bask {

/// Makes the label semi-bold and `scale` times as large.
void makeBold(QLabel* label, double scale = 1.0);
QLabel* boldLabel(QWidget* parent, double scale = 1.0);

/// Shows a text in the colour of unknown values with its mark, or removes both. Cheap if nothing changes.
void showUnknown(QLabel* mark, QLabel* text, bool isUnknown);
/// The same with the colour and the mark of an alarm of this priority.
void showAlarmed(QLabel* mark, QLabel* text, int priority);
/// Greys a value that is older than it should be.
void showOld(QLabel* text, bool isOld);

/// Makes a screen reader say what the label's text is of, and the text: with a name alone it says the name
/// and not the value. To be called whenever either has changed.
void sayWithText(QLabel* label, const QString& what);
/// Makes a screen reader say what is chosen, or typed, here. Where AT-SPI is spoken a choice's name is its
/// value; what it is for is said by the label whose buddy it is, or by this.
void nameChoice(QComboBox* choice, const QString& what);

} // namespace bask
