#pragma once
// The grammar of path data: QtSvg draws damaged ones as far as it can, which is another shape.

#include <QStringView>

#include <optional>

namespace bask::svg {

/// Returns where path data (the attribute `d` of a path, SVG 1.1, 8.3.9) cannot be read any more; empty if
/// all can.
std::optional<qsizetype> damageOf(QStringView data);

} // namespace bask::svg
