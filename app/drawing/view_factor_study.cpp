#include "app/drawing/view_factor_study.h"

#include "app/studies/study_output.h"
#include "engine/base/hidden_folder.h"
#include "engine/radiation/paper_methods.h"
#include "engine/radiation/view_factor.h"
#include "engine/shape/contour_import.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <functional>

namespace bask {
namespace {

using SteadyTime = std::chrono::steady_clock;

/// Value of `evaluate` and the median time of one call (us): of seven batches of 0.2 ms, of three calls where
/// one takes longer, of one where it takes a second.
double timed(const std::function<double()>& evaluate, double& time_us) {
    const auto batch = [&](int calls) {
        double value = 0.0;
        const auto start = SteadyTime::now();
        for (int i = 0; i < calls; ++i)
            value = evaluate();
        const std::chrono::duration<double, std::micro> taken = SteadyTime::now() - start;
        return std::pair(value, taken.count() / calls);
    };
    const auto [value, first_us] = batch(1);
    std::vector<double> times{first_us};
    const int calls = std::clamp(static_cast<int>(200.0 / first_us), 1, 10000);
    const std::size_t repeats = first_us > 1e6 ? 1 : first_us > 1e4 ? 3 : 7;
    if (repeats > 1)
        times.clear(); // the first one warms the caches
    while (times.size() < repeats)
        times.push_back(batch(calls).second);
    std::ranges::nth_element(times, times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2));
    time_us = times[times.size() / 2];
    return value;
}

Result<Contour> bunny() {
    const auto folder = HiddenFolder::temporary();
    if (!folder)
        return folder.error();
    if (const auto copied = copyStudyFiles(QString::fromStdString(folder->path()), {"bunny_mm.csv"}); !copied)
        return copied.error();
    const auto outline = readContourCsv(folder->place("bunny_mm.csv"), LengthUnit::Millimetre);
    if (!outline)
        return outline.error();
    return centred(*outline);
}

class Study {
public:
    Study(Contour outline, int maxElements, const ShareDone& done)
        : m_share(done, costOfAll(maxElements)), m_outline(std::move(outline)), m_whole(m_outline) {
        m_X_SO.translation().z() = kStudyDistance_m;
        m_study.corners = static_cast<int>(m_outline.points_m.size());
        m_study.exact = exact(m_whole);
    }

    void surfaceIntegrals(int max) {
        for (int n : kElements)
            if (n <= max)
                add({.method = StudyMethod::SurfaceIntegral, .elements = n},
                    [&] { return discreteSurfaceIntegral(m_disk, m_outline, m_X_SO, n); });
    }

    void truncated(const FourierContour& contour, int harmonics) {
        const RadiatingContour object(contour);
        const double exactValue = exact(object);
        for (int points : kPoints)
            add(
                {.method = StudyMethod::Fourier, .harmonics = harmonics, .points = points},
                [&] { return simpsonViewFactor(m_disk, contour, m_X_SO, points); }, exactValue);
        addSolver({.method = StudyMethod::SolverFourier, .harmonics = harmonics, .tolerance = 1e-9}, object,
                  exactValue);
    }

    void solverOnOutline() {
        for (double tolerance : kTolerances)
            addSolver({.method = StudyMethod::SolverOutline, .tolerance = tolerance}, m_whole, std::nullopt);
    }

    const Contour& outline() const { return m_outline; }
    ViewFactorStudy take() { return std::move(m_study); }

private:
    static constexpr std::array kElements{10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000, 20000};
    static constexpr std::array kPoints{8, 16, 32, 64, 128, 256};
    static constexpr std::array kTolerances{1e-3, 1e-6, 1e-9, 1e-12};

    /// In pairs of elements; what is not a surface integral takes about as long as a hundred thousand.
    static double costOf(int elements) { return 1e5 + static_cast<double>(elements) * elements; }
    static double costOfAll(int maxElements) {
        double sum =
            costOf(0) * static_cast<double>(kStudyMaxHarmonics * (kPoints.size() + 1) + kTolerances.size());
        for (int n : kElements)
            sum += n <= maxElements ? costOf(n) : 0.0;
        return sum;
    }

    double exact(const RadiatingContour& object) const {
        return viewFactor(m_source, object, m_X_SO, {1e-12}).value;
    }

    void addSolver(const StudyRow& row, const RadiatingContour& object, std::optional<double> exactValue) {
        add(
            row, [&] { return viewFactor(m_source, object, m_X_SO, {row.tolerance}).value; }, exactValue);
    }

    void add(StudyRow row, const std::function<double()>& evaluate,
             std::optional<double> exactValue = std::nullopt) {
        row.value = timed(evaluate, row.time_us);
        row.error = std::abs(row.value - m_study.exact);
        if (exactValue)
            row.quadratureError = std::abs(row.value - *exactValue);
        m_study.rows.push_back(row);
        m_share.add(costOf(row.elements));
    }

    ShareCount m_share;
    const Disk m_disk{kStudyRadius_m};
    const RadiatingContour m_source{m_disk};
    Contour m_outline;
    RadiatingContour m_whole;
    Pose m_X_SO = Pose::Identity();
    ViewFactorStudy m_study;
};

std::string shortest(double number) {
    std::array<char, 32> digits{};
    return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr};
}

std::string orEmpty(int number) {
    return number == 0 ? std::string() : std::to_string(number);
}

} // namespace

const char* studyMethodName(StudyMethod method) {
    switch (method) {
    case StudyMethod::SurfaceIntegral:
        return "surface integral";
    case StudyMethod::Fourier:
        return "Fourier method";
    case StudyMethod::SolverOutline:
        return "Bask, outline";
    case StudyMethod::SolverFourier:
        return "Bask, Fourier";
    }
    return "";
}

Result<ViewFactorStudy> runViewFactorStudy(int maxElements, const ShareDone& done) {
    auto outline = bunny();
    if (!outline)
        return outline.error();
    Study study(std::move(*outline), maxElements, done);
    study.surfaceIntegrals(maxElements);
    for (int h = 1; h <= kStudyMaxHarmonics; ++h) {
        const auto fit = fitFourier(study.outline(), h);
        if (!fit)
            return fit.error();
        study.truncated(fit->contour, h);
    }
    study.solverOnOutline();
    return study.take();
}

std::string studyCsv(const ViewFactorStudy& study) {
    std::string text =
        "# Bask view-factor study: the paper's Appendix B (arXiv 2012.13147) on Bask's own bunny.\n"
        "# Object: outline of the bunny, " +
        std::to_string(study.corners) +
        " corners, 70 mm wide; source: disk of radius 10 cm; parallel, centroid over the centre, 5 cm "
        "apart.\n"
        "# Exact view factor of the outline: " +
        shortest(study.exact) +
        ". The paper's 0.764602 belongs to another bunny: compare trends, not values.\n"
        "# The exact value is Bask's own at a tolerance of 1e-12: the errors of its rows for the whole "
        "outline say nothing.\n"
        "# error: against the exact value. quadrature_error: against the exact value of the same truncated "
        "outline.\n"
        "# time_us: median of repeats; Bask's rows compute the six derivatives too, the others the value "
        "alone.\n"
        "method,elements_per_face,harmonics,quadrature_points,tolerance,view_factor,error,quadrature_error,"
        "time_us\n";
    for (const StudyRow& row : study.rows) {
        text += '"' + std::string(studyMethodName(row.method)) + "\"," + orEmpty(row.elements) + ',' +
                orEmpty(row.harmonics) + ',' + orEmpty(row.points) + ',' +
                (row.tolerance > 0.0 ? shortest(row.tolerance) : std::string()) + ',' + shortest(row.value) +
                ',' + shortest(row.error) + ',' +
                (row.quadratureError ? shortest(*row.quadratureError) : std::string()) + ',' +
                shortest(row.time_us) + '\n';
    }
    return text;
}

} // namespace bask
