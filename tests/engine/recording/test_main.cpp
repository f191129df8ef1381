#include "tests/engine/recording/recording.h"

#include <QCoreApplication>

#include <gtest/gtest.h>

#include <string_view>

// Qt finds its SQL driver through the application object.
int main(int argc, char** argv) {
    QCoreApplication app(argc, argv);
    if (argc == 3 && std::string_view(argv[1]) == "--record-until-killed")
        return bask::test::recordUntilKilled(argv[2]);
    ::testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
