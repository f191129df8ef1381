// The table of subcommands, compiled for each of the two programs that share them.

#include "app/commands/command_line.h"

#include <array>

// With what draws figures or writes fields come VTK and the widgets: `bask` does not have them.
#ifdef BASK_DRAWS
#define DRAWN(command) command
#else
#define DRAWN(command) nullptr
#endif

namespace bask {

std::span<const Subcommand> subcommands() {
    static constexpr std::array kSubcommands{
        Subcommand{"run", "run an experiment on the simulated rig, or on its own one (--live)",
                   runExperimentCommand},
        Subcommand{"feasibility", "whether all targets of an experiment can be held together, and why not",
                   feasibilityCommand},
        Subcommand{"fit-contour", "fit a Fourier contour to an outline", fitContourCommand},
        Subcommand{"view-factor", "view factors and gradients of a list of cases", viewFactorCommand},
        Subcommand{"field", "view factors or steady temperatures on a grid of poses, for ParaView",
                   DRAWN(fieldCommand)},
        Subcommand{"isosurface", "where an object has a view factor or steady temperature, for ParaView",
                   DRAWN(isosurfaceCommand)},
        Subcommand{"study", "repeat the paper's study of view-factor methods: table and figures",
                   DRAWN(studyCommand), true, studyShardCommand},
        Subcommand{"merge", "the parts of a divided study or field, put together", DRAWN(mergeCommand), true},
        Subcommand{"reproduce",
                   "the paper's experiments, by its controllers and by the level servo: a report",
                   DRAWN(reproduceCommand), true},
        Subcommand{"identify", "heat rates of the objects of a recorded session, with standard errors",
                   identifyCommand},
        Subcommand{"export", "a session as CSV, NeXus (HDF5), VTK files or figures", DRAWN(exportCommand),
                   true},
        Subcommand{"verify", "whether a session is as it was recorded, and what was changed", verifyCommand},
        Subcommand{"report", "a session's report as HTML or PDF", DRAWN(reportCommand), true},
        Subcommand{"make-board", "calibration boards and markers to print, as PDF", DRAWN(makeBoardCommand),
                   true},
        Subcommand{"simulate-rig", "all devices of an experiment's rig, simulated on their ports",
                   simulateRigCommand},
        Subcommand{"calibrate-camera", "a camera's intrinsics from pictures of a board",
                   calibrateCameraCommand},
        Subcommand{"detect-markers", "the ArUco markers in a picture, with poses", detectMarkersCommand},
        Subcommand{"thermal-frame", "a frame of a thermal camera as temperatures, with statistics of regions",
                   thermalFrameCommand},
        Subcommand{"thermal-pose", "where a thermal camera is, from silhouettes of the held objects",
                   thermalPoseCommand},
        Subcommand{"plate-profile", "the temperature of a source over its radius, from thermal frames",
                   plateProfileCommand},
        Subcommand{"scan-modbus", "the Modbus units that answer at a port, and the profiles that fit",
                   scanModbusCommand},
        Subcommand{"check-device", "whether a program of your own keeps the rules of program drivers",
                   checkDeviceCommand},
        Subcommand{"simulate-device", "a robot, thermometer or heater that is not there, on a serial port",
                   simulateDeviceCommand},
    };
    return kSubcommands;
}

} // namespace bask
