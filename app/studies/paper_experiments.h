#pragma once
// The paper's experiments as files: the figure of each, the paper's result, and the result expected here.

#include "engine/model/experiment.h"

#include <QString>
#include <QStringList>

#include <array>
#include <string>
#include <vector>

namespace bask {

/// How a run ended, judged by the plant's true temperatures.
enum class RunEnding {
    Settled,    ///< every object within the settled band until the end
    NotSettled, ///< at least one object outside at the end
    Compromise, ///< as NotSettled, and the controller reported that no pose holds all targets together
    Fault,
};
const char* runEndingName(RunEnding ending); ///< "settled", "not settled", "best compromise", "fault"

struct ExpectedEnding {
    RunEnding ending = RunEnding::Settled;
    std::string reason; ///< one sentence
    /// The run ends near the edge of the settled band: whether it is inside depends on a contour's last digit
    /// or on the processor. Settled and NotSettled are both expected, with every error below 1 K.
    bool atTheEdge = false;

    bool holds(RunEnding ended, double largestError_K) const;
    const char* name() const; ///< runEndingName, or "at the edge"
};

/// Index of the runs by the paper's controller, which is that of the file, and by the level servo.
inline constexpr std::size_t kByThePaper = 0, kByTheLevelServo = 1;

struct PaperExperiment {
    std::string name; ///< name of its file, without ".json"
    Experiment experiment;
    ExpectedEnding paper; ///< the paper's result, in its reason
    std::array<ExpectedEnding, 2> expected;
};

struct PaperFigure {
    std::string name, title;
    std::string paper;              ///< what the figure shows in the paper
    std::vector<std::string> plots; ///< what is drawn, see reproduction_figures.h
    std::vector<PaperExperiment> experiments;
    std::vector<std::string> with; ///< experiments of other figures that an overlay shows too
};

/// Reads expected.json in `folder` and the experiments that it names, beside it. `only` is the name of a
/// figure or of an experiment; empty for all. Errors: those of readExperiment; missing JSON entries; an
/// unknown name (with the known ones).
Result<std::vector<PaperFigure>> readPaperFigures(const std::string& folder, const std::string& only);

/// Copies the program's own files below `folder`. Returns the path for readPaperFigures.
Result<std::string> unpackPaperExperiments(const QString& folder);

} // namespace bask
