// `bask-draw SUBCOMMAND`: what `bask` becomes for a subcommand that draws figures or writes fields.

#include "app/command_dispatch.h"
#include "app/commands/command_line.h"
#include "app/resources.h"
#include "engine/drivers/program_link.h"

#include <QApplication>
#include <QLocale>

namespace {

std::unique_ptr<QCoreApplication> makeDrawing(char** argv) {
    static int onlyProgram = 1; // a QApplication would take -platform and the like for itself
    qputenv("QT_QPA_PLATFORM", "offscreen");
    auto application = std::make_unique<QApplication>(onlyProgram, argv);
    bask::initResources(); // a report's languages
    QLocale::setDefault(QLocale::c());
    return application;
}

} // namespace

int main(int argc, char** argv) {
    const bask::Dispatch asked = bask::dispatch(argc, argv, makeDrawing);
    bask::ProgramLink::waitForAll();
    return asked.exitCode.value_or(bask::kExitBadInput); // the window is not for this program
}
