#pragma once
// A subcommand run in the test's own process: its exit code and what it wrote.

#include <gtest/gtest.h>

#include <QStringList>

#include <string>

namespace bask::test {

struct Captured {
    int code = 0;
    std::string out;
    std::string err;
};

template <class Command> Captured captured(const Command& command, const QStringList& arguments) {
    ::testing::internal::CaptureStdout();
    ::testing::internal::CaptureStderr();
    Captured result;
    result.code = command(arguments);
    result.out = ::testing::internal::GetCapturedStdout();
    result.err = ::testing::internal::GetCapturedStderr();
    return result;
}

} // namespace bask::test
