#pragma once
// The study of the paper's Appendix B on Bask's own bunny: value, error and time of each method.

#include "engine/base/result.h"

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

/// One evaluation. What a method does not have is 0 or none.
struct StudyRow {
    StudyMethod method = StudyMethod::SurfaceIntegral;
    int elements = 0;       ///< of either face
    int harmonics = 0;      ///< of the object's outline
    int points = 0;         ///< Simpson's subintervals on either contour
    double tolerance = 0.0; ///< asked of the solver
    double value = 0.0;     ///< F21
    double error = 0.0;     ///< absolute, against the whole outline
    /// Absolute, against the exact value of the same truncated outline.
    std::optional<double> quadratureError = std::nullopt;
    double time_us = 0.0; ///< median
};

struct ViewFactorStudy {
    double exact = 0.0; ///< F21 of the whole outline, by the solver to 1e-12
    int corners = 0;    ///< of the outline
    std::vector<StudyRow> rows;
};

inline constexpr int kStudyMaxHarmonics = 20;
inline constexpr double kStudyRadius_m = 0.10;
inline constexpr double kStudyDistance_m = 0.05;

/// Runs the study with up to `maxElements` elements a face. Takes about (maxElements/20000)^2 times four
/// seconds.
Result<ViewFactorStudy> runViewFactorStudy(int maxElements);

/// The table as CSV, with what it is about in comment lines before the header.
std::string studyCsv(const ViewFactorStudy& study);

} // namespace bask
