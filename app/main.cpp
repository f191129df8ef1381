// `bask`: the subcommands, and the door to the window, which is a program of its own, as are the subcommands
// that draw. What a command does not use, the window's views above all, is not loaded with it.

#include "app/command_dispatch.h"
#include "engine/drivers/program_link.h"

int main(int argc, char** argv) {
    const bask::Dispatch asked = bask::dispatch(argc, argv);
    if (!asked.exitCode)
        return bask::becomeWindow(argv[0], asked);
    bask::ProgramLink::waitForAll();
    return *asked.exitCode;
}
