// main() of tests that need a QApplication: GoogleTest inside one, with the house's theme.

#include "widgets/common/theme.h"

#include <QApplication>
#include <QLocale>

#include <gtest/gtest.h>

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    QLocale::setDefault(QLocale::c());
    QApplication application(argc, argv);
    bask::applyTheme(application, bask::Theme::Light);
    return RUN_ALL_TESTS();
}
