#pragma once
// The exact version, so that a problem report can name it.

#include <QString>

namespace bask {

/// Returns "0.1.0 (a1b2c3d)"; without the revision if the source was not a checkout.
QString exactVersion();

} // namespace bask
