#pragma once
// What dialogs have around their own parts: margins, and a row of buttons at the end.

#include <QString>

class QDialog;
class QDialogButtonBox;
class QPushButton;
class QVBoxLayout;
class QWidget;

namespace bask {

/// Makes the column in which a dialog has its parts.
QVBoxLayout* dialogColumn(QDialog& dialog);

struct DialogButtons {
    QDialogButtonBox* box;
    QPushButton *take, *cancel;
};
/// Whether a click on `button` made a NumberField of the dialog refuse what was typed. Tells it once.
bool takeRefusalBy(const QWidget* button, const QDialog& dialog);
/// Ends the dialog's column with a button that accepts it, its default, and Cancel. A click that makes a
/// NumberField of the dialog refuse what was typed does not accept it.
DialogButtons addDialogButtons(QDialog& dialog, const QString& take);

} // namespace bask
