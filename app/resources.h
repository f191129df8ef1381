#pragma once
// Icons, examples and translations inside the binary.

namespace bask {

/// Registers ":/icons" and ":/i18n". Call it once, since the resources of a static library are not found
/// without it.
void initResources();

} // namespace bask
