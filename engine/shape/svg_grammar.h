#pragma once
// The grammars of path data, points and transforms: QtSvg draws damaged ones as far as it can read them,
// which is another shape.

#include <QStringView>

#include <optional>

namespace bask::svg {

/// Return where a text cannot be read any more; empty if all can. An empty text is whole.
/// Path data: the attribute `d` of a path (SVG 1.1, 8.3.9).
std::optional<qsizetype> pathDamage(QStringView data);
/// The attribute `points` of a polyline or polygon (9.7.1): pairs of numbers. A number without its partner is
/// damage.
std::optional<qsizetype> pointsDamage(QStringView points);
/// The attribute `transform` (7.6); also "none".
std::optional<qsizetype> transformDamage(QStringView transforms);

} // namespace bask::svg
