#pragma once
// The first pass over an SVG drawing: its elements, and how <use> multiplies them.

#include "engine/base/result.h"
#include "engine/shape/svg_elements.h"

#include <QHash>
#include <QSet>

#include <string>
#include <vector>

namespace bask::svg {

struct Symbol {
    std::optional<Box> view;
    QString preserve;
};

/// What the second pass needs to know before it starts.
struct Survey {
    QString css;
    QSet<QString> paints; ///< ids of gradients and patterns
    QHash<QString, Symbol> symbols;
    std::vector<std::string> unread;
};

/// Surveys a drawing; refuses what Qt's readers cannot process, and what they would make another drawing of.
/// Errors: XmlBroken, XmlTooDeep, NotSvg, DrawingTooFull, SvgPathDamaged, SvgPointsDamaged, SvgLengthDamaged,
/// SvgTransformDamaged, SvgSizeUnusable, SvgUseOfItself, SvgUseOfNothing.
Result<Survey> survey(const QByteArray& bytes, const std::string& where);

} // namespace bask::svg
