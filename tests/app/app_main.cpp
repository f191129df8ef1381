// main() of the app's tests: the program's own start, with settings in a folder of their own.

#include "app/gui_watchdog.h"
#include "widgets/common/theme.h"

#include <QLocale>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <clocale>

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    const QTemporaryDir settings;
    qputenv("BASK_SETTINGS_DIR", settings.path().toLocal8Bit());
    qputenv("LANGUAGE", "en");
    qputenv("LC_ALL", "C.UTF-8");
    bask::MeasuredApplication application(argc, argv);
    std::setlocale(LC_NUMERIC, "C");
    QLocale::setDefault(QLocale::c());
    bask::applyTheme(application, bask::Theme::Light);
    return RUN_ALL_TESTS();
}
