#include "app/drawing/reproduction_report.h"

#include "engine/base/units.h"
#include "engine/base/version.h"

#include <cmath>

namespace bask {
namespace {

constexpr const char* kStyle = R"(
:root { color-scheme: light; }
body { font: 16px/1.5 "DejaVu Sans", "Segoe UI", "Helvetica Neue", Arial, sans-serif; color: #1c2024; background: #fff;
       max-width: 1180px; margin: 2.5rem auto; padding: 0 1.5rem; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 0 0 .5rem; }
h2 { font-size: 1.3rem; margin: 3rem 0 .25rem; padding-top: 1rem; border-top: 1px solid #d9dde1; }
p { max-width: 50rem; margin: .5rem 0; }
.quiet { color: #586069; }
.wrap { overflow-x: auto; }
table { border-collapse: collapse; font-size: .82rem; font-variant-numeric: tabular-nums; width: 100%; }
th, td { text-align: left; vertical-align: top; padding: .35rem .6rem; border-bottom: 1px solid #e4e7ea; }
thead th { border-bottom: 2px solid #98a0a8; white-space: nowrap; }
tbody.pair { border-bottom: 2px solid #c9ced3; }
td.number, th.number { text-align: right; white-space: nowrap; }
td.name { font-weight: 600; }
.no { color: #a4260c; font-weight: 600; }
dl { margin: .75rem 0; max-width: 62rem; }
dt { font-weight: 600; margin-top: .6rem; }
dd { margin: 0 0 0 1.25rem; }
.pictures { display: grid; grid-template-columns: 1fr 1fr; gap: 1rem; margin: 1rem 0; align-items: start; }
.pictures img { width: 100%; height: auto; display: block; }
.wide { grid-column: 1 / -1; }
@media (max-width: 800px) { .pictures { grid-template-columns: 1fr; } }
@media print {
  @page { size: A4; margin: 14mm; }
  body { font-size: 10pt; max-width: none; margin: 0; padding: 0; }
  table { font-size: 7pt; } .wrap { overflow: visible; }
  th, td { padding: 1.5pt 4pt; }
  h2 { break-after: avoid; } tbody, dd, dt, .pictures > * { break-inside: avoid; }
}
)";

std::string escaped(const std::string& text) {
    return QString::fromStdString(text).toHtmlEscaped().toStdString();
}

std::string whole(double value) {
    return std::isfinite(value) ? formatNumber(std::round(value), 7) : "\u221e";
}

std::string cell(const std::string& text, const char* kind = "") {
    return std::string("<td") + (*kind != '\0' ? std::string(" class=\"") + kind + '"' : "") + '>' + text +
           "</td>";
}

std::string feasibilityWords(const JointVerdict& verdict) {
    return verdict.feasible ? "yes" : "no: " + describe(verdict.reason);
}

/// The controller's cells of the table.
std::string runCells(const ReproducedExperiment& experiment, std::size_t by) {
    const ReproducedRun& run = experiment.runs[by];
    std::string ending = runEndingName(run.ending);
    if (!experiment.asExpected(by))
        ending = "<span class=\"no\">" + ending + ", not as recorded</span>";
    std::string ratio = "\u2013";
    if (run.settling_s) {
        char text[32];
        std::snprintf(text, sizeof text, "%.2f", *run.settling_s / experiment.bound.bound_s);
        ratio = text;
    }
    return cell(run.controller.key()) + cell(ending) + cell(finalErrorWords(run), "number") +
           cell(run.settling_s ? whole(*run.settling_s) : "\u2013", "number") + cell(ratio, "number");
}

std::string tableRows(const ReproducedExperiment& experiment) {
    const auto tall = [](const std::string& text, const char* kind) {
        return std::string("<td rowspan=\"2\" class=\"") + kind + "\">" + text + "</td>";
    };
    return "<tbody class=\"pair\"><tr>" + tall(escaped(experiment.paper.name), "name") +
           tall(targetWords(experiment.paper.experiment), "") +
           tall(escaped(feasibilityWords(experiment.feasibility)), "") +
           tall(whole(experiment.bound.bound_s), "number") + runCells(experiment, kByThePaper) + "</tr><tr>" +
           runCells(experiment, kByTheLevelServo) + "</tr></tbody>\n";
}

std::string table(const std::vector<ReportFigure>& figures) {
    std::string text = "<div class=\"wrap\"><table><thead><tr><th>Experiment</th><th>Targets (\u00b0C)</th>"
                       "<th>Feasible</th><th class=\"number\">Bound (s)</th><th>Controller</th>"
                       "<th>Outcome</th><th class=\"number\">Final errors (K)</th>"
                       "<th class=\"number\">Settled (s)</th><th class=\"number\">\u00d7 bound</th>"
                       "</tr></thead>\n";
    for (const ReportFigure& figure : figures)
        for (const ReproducedExperiment* experiment : figure.experiments)
            text += tableRows(*experiment);
    return text + "</table></div>\n";
}

std::string summary(const std::vector<ReportFigure>& figures) {
    int all = 0, good = 0;
    std::string others;
    for (const ReportFigure& figure : figures)
        for (const ReproducedExperiment* experiment : figure.experiments)
            for (const std::size_t by : {kByThePaper, kByTheLevelServo}) {
                ++all;
                if (experiment->asExpected(by))
                    ++good;
                else
                    others += (others.empty() ? "" : ", ") + escaped(experiment->paper.name) + " (" +
                              experiment->runs[by].controller.key() + ")";
            }
    if (all == 0)
        return "";
    std::string text = "<p><strong>" + std::to_string(good) + " of " + std::to_string(all) +
                       " outcomes are as recorded.</strong>";
    return others.empty() ? text + "</p>\n" : text + " <span class=\"no\">Not: " + others + ".</span></p>\n";
}

std::string section(const ReportFigure& figure) {
    std::string text = "<section id=\"" + escaped(figure.figure->name) + "\"><h2>" +
                       escaped(figure.figure->title) + "</h2>\n<p class=\"quiet\">Figure \u201c" +
                       escaped(figure.figure->name) +
                       "\u201d. In the paper: " + escaped(figure.figure->paper) + "</p>\n";
    if (!figure.experiments.empty()) {
        text += "<dl>\n";
        for (const ReproducedExperiment* experiment : figure.experiments) {
            text += "<dt>" + escaped(experiment->paper.name) + "</dt>\n";
            for (const std::size_t by : {kByThePaper, kByTheLevelServo})
                text += std::string("<dd><em>") + experiment->runs[by].controller.key() +
                        "</em>: " + escaped(verdictWords(*experiment, by)) + "</dd>\n";
        }
        text += "</dl>\n";
    }
    text += "<div class=\"pictures\">\n";
    for (const ReportPicture& picture : figure.pictures)
        text += std::string("<img") + (picture.isWide ? " class=\"wide\"" : "") + " alt=\"" +
                escaped(picture.words.toStdString()) + "\" src=\"data:image/png;base64," +
                picture.png.toBase64().toStdString() + "\">\n";
    return text + "</div></section>\n";
}

} // namespace

std::string reproductionHtml(const std::vector<ReportFigure>& figures) {
    std::string text =
        std::string("<!DOCTYPE html>\n<html lang=\"en\">\n<!-- ") + kReproductionMark + ", version " +
        BASK_VERSION +
        " -->\n<head><meta charset=\"utf-8\"><title>Radiation-based thermal servoing: the experiments "
        "repeated</title>\n<meta name=\"viewport\" content=\"width=device-width, "
        "initial-scale=1\">\n<style>" +
        kStyle +
        "</style></head>\n<body>\n<h1>Radiation-based thermal servoing: the experiments repeated</h1>\n"
        "<p class=\"quiet\">Hu, Navarro-Alarcon, Cherubini, Li: On Radiation-Based Thermal Servoing: New "
        "Models, "
        "Controls and Experiments (arXiv 2012.13147). Simulated by Bask " BASK_VERSION ".</p>\n" +
        summary(figures);
    bool hasRuns = false;
    for (const ReportFigure& figure : figures)
        hasRuns = hasRuns || !figure.experiments.empty();
    if (hasRuns)
        text +=
            "<p>Each experiment ran twice on the simulated rig, with the same file and seed: by the "
            "paper\u2019s "
            "controller and by Bask\u2019s level servo. Settled: every object\u2019s true temperature stays "
            "within \u00b1" +
            formatNumber(kSettledBand_K, 2) +
            " K of its target (grey in the figures) until the run ends; \u201cSettled (s)\u201d is from when "
            "the "
            "last one does. \u201cBound\u201d: before this time no controller can have the slowest object "
            "there, "
            "since the robot has to travel and the object to warm up. \u201cFeasible\u201d: whether a pose "
            "of the workspace holds all targets, by search beforehand; if not, the reason. "
            "Final errors are true temperatures less targets.</p>\n" +
            table(figures);
    for (const ReportFigure& figure : figures)
        text += section(figure);
    return text + "</body></html>\n";
}

} // namespace bask
