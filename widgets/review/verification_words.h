#pragma once
// Whether a recording is as it was recorded, in words.

#include "engine/recording/session_verify.h"

#include <QString>

namespace bask {

/// Whether what was recorded was changed afterwards; damage is another matter.
bool isAltered(const SessionVerdict& verdict);

/// Returns "Altered: table step, row 123, at 3:07; see bask verify", or "Intact: 4,213 rows, sealed, head
/// 3f2a91c0…".
QString verificationText(const SessionVerdict& verdict);

} // namespace bask
