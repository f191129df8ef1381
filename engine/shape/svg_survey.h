#pragma once
// The first pass over an SVG drawing: what there is, and what <use> makes of it.

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

/// What the second pass has to know before it begins.
struct Survey {
    QString css;
    QSet<QString> paints; ///< ids of gradients and patterns
    QHash<QString, Symbol> symbols;
    QSet<int> recursive; ///< numbers of `<use>` elements to leave out
    std::vector<std::string> unread;
};

/// Refuses what Qt's readers cannot take. Errors: XmlBroken, XmlTooDeep, NotSvg, DrawingTooFull.
Result<Survey> survey(const QByteArray& bytes, const std::string& where);

} // namespace bask::svg
