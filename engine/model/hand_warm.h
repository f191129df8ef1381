#pragma once
// What is too hot for a hand.

namespace bask {

inline constexpr double kHandWarm_K = 30.0; ///< over the room: as much as a hand bears

} // namespace bask
