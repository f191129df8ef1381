#include "app/command_dispatch.h"
#include "app/start_window.h"
#include "engine/drivers/program_link.h"

#include <cstdio>

namespace {

int runBask(int argc, char** argv) {
    const bask::Dispatch asked = bask::dispatch(argc, argv);
    if (asked.exitCode)
        return *asked.exitCode;
    if (const QString sentence = bask::missingDisplay(); !sentence.isEmpty()) {
        std::fprintf(stderr, "%s\n", qPrintable(sentence));
        return 1;
    }
    return bask::runWindow(argc, argv, asked.file);
}

} // namespace

int main(int argc, char** argv) {
    const int code = runBask(argc, argv);
    bask::ProgramLink::waitForAll();
    return code;
}
