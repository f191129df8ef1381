// bask fit-contour: reads an outline, fits a Fourier contour and prints what the fit is worth.

#include "app/commands/command_line.h"
#include "app/commands/output_file.h"
#include "app/commands/parse_command.h"
#include "engine/shape/contour_import.h"
#include "engine/shape/fourier_contour.h"

#include <QCommandLineParser>

#include <nlohmann/json.hpp>

#include <cstdio>

namespace bask {
namespace {

struct Request {
    std::string path;
    ContourImportOptions import;
    int harmonics = 0;
    std::vector<OutputFile> outputs; ///< none or one
};

int refuse(const std::string& words) {
    std::fprintf(stderr, "bask fit-contour: %s\n", words.c_str());
    return kExitBadInput;
}

void setUp(QCommandLineParser& parser) {
    parser.setApplicationDescription(
        "Fits a Fourier contour to an outline, by least squares in its arc length, and prints\n"
        "area_mm2, perimeter_mm            of the fit,\n"
        "rms_mm, max_mm                    distance between outline and fit at equal arc length,\n"
        "outline_area_mm2, outline_perimeter_mm   of the outline itself.");
    parser.addOption({{"h", "help"}, "Displays this help."});
    parser.addOption(
        {"harmonics", "Number of harmonics, 1 to " + QString::number(kMaxHarmonics) + "; required.", "H"});
    parser.addOption(
        {"unit", "Unit of a list of points without one in its header: mm, cm, m or in.", "unit"});
    parser.addOption({"scale", "Scale of a picture, in pixels per mm.", "px_per_mm"});
    parser.addOption({{"o", "output"}, "Writes the fitted contour as JSON (metres).", "CONTOUR.json"});
    parser.addPositionalArgument(
        "FILE", "Outline: csv, txt or dat with x and y; png, jpg, bmp or tif of a silhouette.");
}

Result<Request> readRequest(const QCommandLineParser& parser) {
    Request request;
    request.path = parser.positionalArguments().front().toStdString();
    if (parser.isSet("output"))
        request.outputs = {{parser.value("output").toStdString(), "type", "a contour written by Bask"}};
    bool isNumber = false;
    request.harmonics = parser.value("harmonics").toInt(&isNumber);
    if (!isNumber)
        return Error{MessageCode::HarmonicsOutOfRange,
                     "--harmonics",
                     {parser.value("harmonics").toStdString(), "1", std::to_string(kMaxHarmonics)}};
    if (parser.isSet("unit")) {
        request.import.unit = lengthUnitFromName(parser.value("unit").toStdString());
        if (!request.import.unit)
            return Error{
                MessageCode::ValueUnknown, "--unit", {parser.value("unit").toStdString(), "mm, cm, m, in"}};
    }
    if (parser.isSet("scale")) {
        const double scale = parser.value("scale").toDouble(&isNumber);
        if (!isNumber)
            return Error{MessageCode::ScaleNotPositive, "--scale", {parser.value("scale").toStdString()}};
        request.import.scale_px_per_mm = scale;
    }
    return request;
}

Result<void> writeContour(const FourierContour& contour, const std::string& path) {
    nlohmann::ordered_json coefficients = nlohmann::ordered_json::array();
    for (int j = -contour.harmonics(); j <= contour.harmonics(); ++j)
        coefficients.push_back({j, contour.coefficient(j).real(), contour.coefficient(j).imag()});
    const nlohmann::ordered_json json{{"type", "fourier"}, {"coefficients", std::move(coefficients)}};
    return writeOutput(path, json.dump(1) + '\n');
}

void printFigures(const Contour& outline, const FourierFit& fit) {
    const auto print = [](const char* name, double value) { std::printf("%s %.9g\n", name, value); };
    print("area_mm2", fit.contour.area() * 1e6);
    print("perimeter_mm", fit.contour.perimeter() * 1e3);
    print("rms_mm", fit.rms_m * 1e3);
    print("max_mm", fit.max_m * 1e3);
    print("outline_area_mm2", contourArea(outline) * 1e6);
    print("outline_perimeter_mm", contourPerimeter(outline) * 1e3);
}

} // namespace

int fitContourCommand(const QStringList& arguments) {
    QCommandLineParser parser;
    setUp(parser);
    if (const auto code = parseCommand(parser, "fit-contour", arguments, 1))
        return *code;
    if (!parser.isSet("harmonics"))
        return refuse("--harmonics is needed. See bask fit-contour --help.");
    const auto request = readRequest(parser);
    if (!request)
        return refuse(describe(request.error()));

    if (const auto place = checkOutputs({request->path}, request->outputs); !place)
        return refuse(describe(place.error()));
    const auto outline = readContour(request->path, request->import);
    if (!outline)
        return refuse(describe(outline.error()));
    const auto fit = fitFourier(*outline, request->harmonics);
    if (!fit)
        return refuse(describe(fit.error()));
    if (fit->crossesItself)
        std::fprintf(stderr, "bask fit-contour: the fitted contour crosses itself; use more harmonics\n");
    for (const OutputFile& output : request->outputs)
        if (const auto written = writeContour(fit->contour, output.path); !written)
            return refuse(describe(written.error()));
    printFigures(*outline, *fit);
    return kExitDone;
}

} // namespace bask
