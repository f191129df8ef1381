#pragma once
// The study of the paper's Appendix B on Bask's own bunny: value, error and time of each method.

#include "engine/base/result.h"
#include "engine/base/share_done.h"

#include <optional>
#include <string>
#include <vector>

namespace bask {

enum class StudyMethod {
    SurfaceIntegral, ///< the paper's comparison: discrete surface integral
    Fourier,         ///< the paper's method: Simpson on the double contour integral of truncated outlines
    SolverOutline,   ///< Bask's solver on the whole outline, value and gradient
    SolverFourier,   ///< Bask's solver on the truncated outlines, value and gradient
};
const char* studyMethodName(StudyMethod method);

/// One evaluation. Values that a method does not have are 0 or empty.
struct StudyRow {
    StudyMethod method = StudyMethod::SurfaceIntegral;
    int elements = 0;       ///< number of elements of each face
    int harmonics = 0;      ///< number of harmonics of the object's outline
    int points = 0;         ///< number of Simpson's subintervals on each contour
    double tolerance = 0.0; ///< tolerance of the solver
    double value = 0.0;     ///< F21
    double error = 0.0;     ///< absolute error, relative to the whole outline's value
    /// Absolute error, relative to the exact value of the same truncated outline.
    std::optional<double> quadratureError = std::nullopt;
    double time_us = 0.0; ///< median of the time
};

struct ViewFactorStudy {
    double exact = 0.0; ///< F21 of the whole outline, by the solver to 1e-12
    int corners = 0;    ///< number of corners of the outline
    std::vector<StudyRow> rows;
};

inline constexpr int kStudyMaxHarmonics = 20;
inline constexpr double kStudyRadius_m = 0.10;
inline constexpr double kStudyDistance_m = 0.05;

/// Runs the study with up to `maxElements` elements a face. Takes about (maxElements/20000)^2 times four
/// seconds; `done` is told the share.
Result<ViewFactorStudy> runViewFactorStudy(int maxElements, const ShareDone& done = {});

/// Returns the table as CSV, with a description in comment lines before the header.
std::string studyCsv(const ViewFactorStudy& study);

} // namespace bask
