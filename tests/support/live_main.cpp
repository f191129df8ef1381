// main() of the tests against real time; links live in Qt's event loop.

#include "tests/support/judged_tests.h"

#include <QCoreApplication>

#include <gtest/gtest.h>

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    const QCoreApplication application(argc, argv);
    return bask::test::runJudgedTests();
}
