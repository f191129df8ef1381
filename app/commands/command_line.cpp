#include "app/commands/command_line.h"

#include <array>

namespace bask {

std::span<const Subcommand> subcommands() {
    static constexpr std::array kSubcommands{
        Subcommand{"run", "run an experiment on the simulated rig, as fast as the machine goes",
                   runExperimentCommand},
        Subcommand{"fit-contour", "fit a Fourier contour to an outline", fitContourCommand},
        Subcommand{"view-factor", "view factors and gradients of a list of cases", viewFactorCommand},
        Subcommand{"export", "write a session's tables as CSV", exportCommand},
    };
    return kSubcommands;
}

} // namespace bask
