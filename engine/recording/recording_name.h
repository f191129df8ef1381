#pragma once
// The names that Bask gives to recordings.

#include <cstdint>
#include <string>

namespace bask {

/// Returns "20260314T092653Z", the time in UTC, and for the further ones of that second "20260314T092653Z-2".
std::string recordingStem(std::int64_t unixTime_s, int number = 1);

/// Returns whether a file's name, without its ending, is one of those: nobody chose it.
bool isRecordingStem(const std::string& stem);

} // namespace bask
