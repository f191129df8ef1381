#pragma once
// Icons, examples and translations inside the binary.

namespace bask {

/// Makes ":/icons" and ":/i18n" known. Needed once, since a static library's resources are not
/// found by themselves.
void initResources();

} // namespace bask
