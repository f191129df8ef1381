#pragma once
// What is too hot for a hand, and what is too hot to come from one.

namespace bask {

inline constexpr double kHandWarm_K = 30.0; ///< over the room: as much as a hand bears

/// No hand warms anything beyond 40 degC, K: a body has 37 degC, and a sensor may be 3 K wrong.
inline constexpr double kByHand_K = 313.15;

} // namespace bask
