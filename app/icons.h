#pragma once
// Bask's own line icons, drawn in the text colour of the palette.

#include <QIcon>
#include <QPalette>
#include <QString>

namespace bask {

/// Returns the icon :/icons/NAME.svg with its black replaced by the palette's button text, normal and
/// disabled.
QIcon themedIcon(const QString& name, const QPalette& palette);

} // namespace bask
