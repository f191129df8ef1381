#pragma once
// Subcommands without a window: figures on standard output, progress and messages on standard error.

#include <QStringList>

#include <optional>
#include <span>

namespace bask {

/// Exit codes of every subcommand. An output that cannot be written, also standard output, counts as bad
/// input.
enum ExitCode { kExitDone = 0, kExitFault = 1, kExitBadInput = 2, kExitNegative = 3 };

/// A subcommand; `run` gets the arguments after its name and returns an ExitCode. Null: it is in the program
/// `bask-draw`.
struct Subcommand {
    const char* name;
    const char* summary;
    int (*run)(const QStringList& arguments);
    bool drawsFigures = false; ///< runs on a QApplication off screen, with any display or none
    /// Does the work of one shard, which draws nothing; empty: the arguments ask for none.
    std::optional<int> (*runShard)(const QStringList& arguments) = nullptr;
};

/// Of the program that asks.
std::span<const Subcommand> subcommands();

int runExperimentCommand(const QStringList& arguments);
int feasibilityCommand(const QStringList& arguments);
int fitContourCommand(const QStringList& arguments);
int viewFactorCommand(const QStringList& arguments);
int fieldCommand(const QStringList& arguments);
int isosurfaceCommand(const QStringList& arguments);
int mergeCommand(const QStringList& arguments);
int studyCommand(const QStringList& arguments);
std::optional<int> studyShardCommand(const QStringList& arguments);
int reproduceCommand(const QStringList& arguments);
int identifyCommand(const QStringList& arguments);
int exportCommand(const QStringList& arguments);
int verifyCommand(const QStringList& arguments);
int reportCommand(const QStringList& arguments);
int detectMarkersCommand(const QStringList& arguments);
int calibrateCameraCommand(const QStringList& arguments);
int thermalFrameCommand(const QStringList& arguments);
int thermalPoseCommand(const QStringList& arguments);
int plateProfileCommand(const QStringList& arguments);
int makeBoardCommand(const QStringList& arguments);
int scanModbusCommand(const QStringList& arguments);
int checkDeviceCommand(const QStringList& arguments);
int simulateDeviceCommand(const QStringList& arguments);
int simulateRigCommand(const QStringList& arguments);

} // namespace bask
