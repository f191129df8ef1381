#pragma once
// Whether sanitizers are compiled in: times and memory are then theirs, and no test can bound them.

namespace bask::test {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kIsSanitized = true;
#else
inline constexpr bool kIsSanitized = false;
#endif

} // namespace bask::test
