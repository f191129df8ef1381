#pragma once
// Light and dark palettes, the colours and dashes that tell objects apart, and the alarm colours.

#include <QColor>
#include <QPalette>
#include <QPen>
#include <QPixmap>

class QApplication;
class QWidget;

namespace bask {

enum class Theme {
    System, ///< light or dark as the desktop was when the program started
    Light,
    Dark,
};

/// Sets the Fusion style and the theme's palette; widgets are told by QEvent::PaletteChange.
void applyTheme(QApplication& application, Theme theme);
QPalette themePalette(bool dark);

/// Returns whether text is lighter than its background.
bool isDark(const QPalette& palette);
bool isDark(const QWidget* widget);

/// Returns the colour of object `index`: Okabe-Ito without the alarm hues, with lightness adapted to the
/// background. Repeats after 5.
QColor seriesColor(int index, bool dark);
/// Returns a paler one, for what is predicted: still 3:1 against the ground of plots.
QColor paleSeriesColor(int index, bool dark);
/// Dash pattern of object `index`, in pen widths; empty is a solid line. Repeats after 6.
QList<qreal> seriesDashes(int index);
/// Returns a pen with both.
QPen seriesPen(int index, bool dark, double width = 2.0);
/// A short sample of an object's line, `size` in device-independent pixels.
QPixmap seriesSwatch(int index, bool dark, QSize size, double devicePixelRatio);

/// Alarm colours; always shown with their shape and figure. Priority 1 red, 2 orange, 3 yellow.
QColor alarmColor(int priority, bool dark);
/// Edge of the mark, at least 3:1 on window and base: yellow on a light ground has a darker one, the others
/// their own colour.
QColor alarmEdgeColor(int priority, bool dark);
/// Ink of the figure on the mark.
QColor alarmInkColor(int priority, bool dark);
/// Returns a red triangle "1", orange diamond "2" or yellow circle "3"; for an alarm that is over, the grey
/// outline.
QPixmap alarmPixmap(int priority, bool dark, int size, double devicePixelRatio, bool isOver = false);

/// Unknown values are neither good nor bad and have their own colour and shape: an open violet square with a
/// question mark.
QColor unknownColor(bool dark);
QPixmap unknownPixmap(bool dark, int size, double devicePixelRatio);

/// Returns the mark of a message: an exclamation mark, with neither shape nor figure of an alarm.
QPixmap problemPixmap(bool dark, int size, double devicePixelRatio);

QColor accentColor(bool dark);   ///< running, selected, changed: a quiet blue
QColor secondaryText(bool dark); ///< captions; at least 4.5:1 on window and base
QColor hairline(bool dark);      ///< borders and grid lines

/// Returns `color` over `ground` with the given weight, opaque.
QColor mixed(const QColor& color, const QColor& ground, double weight);

/// Palette for captions of a widget, from its own palette.
QPalette captionPalette(const QPalette& palette);

} // namespace bask
