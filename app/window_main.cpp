// `bask-window [option of Qt...] [-- FILE]`: what `bask` becomes where a window is wanted.

#include "app/start_window.h"
#include "engine/drivers/program_link.h"

#include <cstring>

int main(int argc, char** argv) {
    QString file;
    if (argc > 2 && std::strcmp(argv[argc - 2], "--") == 0) {
        file = QString::fromLocal8Bit(argv[argc - 1]);
        argc -= 2;
    }
    const int code = bask::runWindow(argc, argv, file);
    bask::ProgramLink::waitForAll();
    return code;
}
