// bask study view-factor: the paper's Appendix B repeated, its table and figures.

#include "app/commands/command_line.h"
#include "app/commands/progress.h"
#include "app/drawing/studies.h"
#include "app/drawing/view_factor_study_figures.h"
#include "app/studies/study_output.h"

#include <cstdio>

namespace bask {
namespace {

void printRow(const StudyRow& row) {
    std::string detail;
    if (row.elements > 0)
        detail = "n = " + std::to_string(row.elements);
    if (row.harmonics > 0)
        detail += "h = " + std::to_string(row.harmonics);
    if (row.points > 0)
        detail += ", " + std::to_string(row.points) + " points";
    if (row.tolerance > 0.0)
        detail += (detail.empty() ? "to " : ", to ") + formatNumber(row.tolerance, 1);
    std::printf("%-18s  %-18s  %.12f  %8.1e  %12.2f\n", studyMethodName(row.method), detail.c_str(),
                row.value, row.error, row.time_us);
}

/// The rows that tell the story: all would be over a hundred lines.
bool isInSummary(const StudyRow& row) {
    const bool isTypical = row.harmonics == 5 || row.harmonics == 10 || row.harmonics == 20;
    switch (row.method) {
    case StudyMethod::SurfaceIntegral:
        return row.elements == 20 || row.elements == 200 || row.elements == 2000 || row.elements == 20000;
    case StudyMethod::Fourier:
        return isTypical && (row.points == 32 || row.points == 128);
    case StudyMethod::SolverFourier:
        return isTypical;
    case StudyMethod::SolverOutline:
        return true;
    }
    return false;
}

void printSummary(const ViewFactorStudy& study) {
    std::printf("%-18s  %-18s  %-14s  %8s  %12s\n", "method", "", "view factor", "error", "time (us)");
    for (const StudyRow& row : study.rows)
        if (isInSummary(row))
            printRow(row);
    std::printf("exact %.12f; the paper's 0.764602 belongs to another bunny: compare trends, not values\n",
                study.exact);
}

} // namespace

int viewFactorStudyCommand(const ViewFactorRequest& request, const QString& folder) {
    const StudyNames names{"view_factor_study",
                           "Bask view-factor study",
                           {".csv", "_elements.png", "_harmonics.png", "_points.png", "_time.png"}};
    const auto files = studyFiles("study", folder, names);
    if (!files)
        return kExitBadInput;
    Progress progress(1.0);
    const auto study = runViewFactorStudy(request.maxElements, progress.share());
    progress.makeRoom();
    if (!study)
        return refuseStudy(study.error());
    std::vector<std::string> contents{studyCsv(*study)};
    for (const Figure& figure : viewFactorStudyFigures(*study))
        contents.push_back(figurePng(figure, QString::fromLatin1(names.mark)).toStdString());
    if (const auto written = writeFiles(*files, contents); !written)
        return refuseStudy(written.error());
    printSummary(*study);
    return kExitDone;
}

} // namespace bask
