// bask fit-contour: reads the outlines of a file, fits a Fourier contour to one and prints what the fit is
// worth.

#include "app/commands/command_line.h"
#include "app/commands/fit_contour_report.h"
#include "app/commands/output_file.h"
#include "app/commands/parse_command.h"
#include "app/commands/progress.h"
#include "engine/base/message_code.h"
#include "engine/base/whole_file.h"
#include "engine/shape/outline_formats.h"
#include "engine/shape/shape.h"

#include <nlohmann/json.hpp>

#include <QCommandLineParser>
#include <QFile>

#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace bask {
namespace {

struct FitContourArguments {
    std::string path;
    ContourImportOptions import;
    std::optional<std::size_t> pick;
    int harmonics = 0;        ///< 0: the fewest within the tolerance
    double tolerance_m = 0.0; ///< of the automatic number
    std::string contourPath, previewPath;
};

void warn(const Message& message) {
    std::fprintf(stderr, "bask fit-contour: %s\n", describe(message).c_str());
}

void setUp(QCommandLineParser& parser) {
    parser.setApplicationDescription(
        "Fits a Fourier contour to an outline, by least squares in its arc length, and prints\n"
        "area_mm2, perimeter_mm            of the fit,\n"
        "net_area_mm2                      holes counted off,\n"
        "rms_mm, max_mm                    distance between outline and fit at equal arc length,\n"
        "hausdorff_mm                      the same whatever the arc length, both ways,\n"
        "harmonics, area_error             of the fit; its area over the outline's, less one,\n"
        "outline_area_mm2, outline_perimeter_mm   of the outline itself.\n\n"
        "--json also gives outline and holes in mm as the file has them, and coefficients and holes_m in\n"
        "metres about the centroid, as experiments take them.\n\n"
        "A picture needs a scale: --scale, --known-length or --marker-size.");
    parser.addOption({{"h", "help"}, "Displays this help."});
    parser.addOption({"list", "Prints the file's outlines as a JSON array, the largest first, and ends."});
    parser.addOption({"pick", "Takes the outline of this index in the list; default: the largest.", "N"});
    parser.addOption({"harmonics",
                      "Number of harmonics, 1 to " + QString::number(kMaxHarmonics) +
                          ", or auto: the fewest within --tolerance; required.",
                      "H"});
    parser.addOption(
        {"tolerance", "Largest Hausdorff distance between outline and fit for --harmonics auto.", "mm"});
    parser.addOption({"unit", "Unit of a list or drawing that names none: mm, cm, m or in.", "unit"});
    parser.addOption({"factor", "Makes a list's or drawing's outlines so many times as large.", "F"});
    parser.addOption({"scale", "Scale of a picture, in pixels per mm.", "px_per_mm"});
    parser.addOption(
        {"known-length",
         "Scale of a picture: two of its points, in pixels from the upper left corner, and their "
         "distance in mm.",
         "x1,y1,x2,y2,mm"});
    parser.addOption({"marker-size",
                      "Scale of a picture, its perspective too: side of an ArUco marker that lies beside the "
                      "objects, in mm.",
                      "mm"});
    parser.addOption({"marker-dictionary", "Dictionary of the marker; default: 4X4_50.", "name"});
    parser.addOption({"colour", "Colour of the objects in a picture, as #rrggbb.", "colour"});
    parser.addOption(
        {"colour-tolerance", "Largest distance in CIE Lab from --colour; default: found by Otsu.", "dE"});
    parser.addOption({"json", "Prints the fit as JSON instead."});
    parser.addOption({{"o", "output"}, "Writes the fitted contour as JSON (metres).", "CONTOUR.json"});
    parser.addOption({"preview", "Writes a picture of outline and fit over a grid of 10 mm.", "FILE.png"});
    const auto endings = [](OutlineKind kind) { return QString::fromStdString(outlineEndings(kind)); };
    parser.addPositionalArgument(
        "FILE",
        QStringLiteral("Outlines: drawing (%1), list of x and y (%2) or picture of silhouettes (%3).")
            .arg(endings(OutlineKind::Drawing), endings(OutlineKind::List), endings(OutlineKind::Picture)));
}

/// Numbers of an option, separated by commas, as many as are wanted.
Result<std::vector<double>> numbersOf(const QCommandLineParser& parser, const char* option, int wanted) {
    std::vector<double> numbers;
    for (const QString& part : parser.value(option).split(u',')) {
        bool isNumber = false;
        numbers.push_back(part.toDouble(&isNumber));
        if (!isNumber || !std::isfinite(numbers.back()))
            numbers.clear();
    }
    if (static_cast<int>(numbers.size()) != wanted)
        return Error{
            MessageCode::ValueUnknown,
            std::string("--") + option,
            {parser.value(option).toStdString(), std::to_string(wanted) + " number(s), with commas"}};
    return numbers;
}

Result<double> positiveOf(const QCommandLineParser& parser, const char* option) {
    const auto number = numbersOf(parser, option, 1);
    if (!number)
        return number.error();
    if (!(number->front() > 0.0))
        return Error{
            MessageCode::ValueNotPositive, std::string("--") + option, {parser.value(option).toStdString()}};
    return number->front();
}

Result<void> readColour(const QCommandLineParser& parser, ContourImportOptions& options) {
    if (!parser.isSet("colour"))
        return parser.isSet("colour-tolerance")
                   ? Result<void>(Error{MessageCode::ValueUnknown, "--colour", {"", "#rrggbb"}})
                   : Result<void>();
    const QString text = parser.value("colour");
    bool isHex = false;
    const uint rgb = text.mid(1).toUInt(&isHex, 16);
    if (!isHex || text.size() != 7 || text[0] != u'#')
        return Error{MessageCode::ValueUnknown, "--colour", {text.toStdString(), "#rrggbb"}};
    const auto part = [&](int shift) { return static_cast<std::uint8_t>(rgb >> shift & 0xFFU); };
    options.colour = PickedColour{{part(16), part(8), part(0)}, {}};
    if (parser.isSet("colour-tolerance")) {
        const auto tolerance = positiveOf(parser, "colour-tolerance");
        if (!tolerance)
            return tolerance.error();
        options.colour->tolerance = *tolerance;
    }
    return {};
}

Result<void> readMarker(const QCommandLineParser& parser, ContourImportOptions& options) {
    if (!parser.isSet("marker-size"))
        return parser.isSet("marker-dictionary")
                   ? Result<void>(Error{MessageCode::ValueUnknown, "--marker-size", {"", "a length in mm"}})
                   : Result<void>();
    const auto size_mm = positiveOf(parser, "marker-size");
    if (!size_mm)
        return size_mm.error();
    options.marker = ReferenceMarker{.side_m = *size_mm * 1e-3};
    if (parser.isSet("marker-dictionary"))
        options.marker->dictionary = parser.value("marker-dictionary").toStdString();
    return {};
}

Result<ContourImportOptions> readImport(const QCommandLineParser& parser) {
    ContourImportOptions options;
    if (parser.isSet("unit")) {
        options.unit = lengthUnitFromName(parser.value("unit").toStdString());
        if (!options.unit)
            return Error{
                MessageCode::ValueUnknown, "--unit", {parser.value("unit").toStdString(), "mm, cm, m, in"}};
    }
    if (parser.isSet("factor")) {
        const auto factor = positiveOf(parser, "factor");
        if (!factor)
            return factor.error();
        options.factor = *factor;
    }
    if (parser.isSet("scale")) {
        bool isNumber = false;
        options.scale_px_per_mm = parser.value("scale").toDouble(&isNumber);
        if (!isNumber)
            return Error{MessageCode::ScaleNotPositive, "--scale", {parser.value("scale").toStdString()}};
    }
    if (parser.isSet("known-length")) {
        const auto n = numbersOf(parser, "known-length", 5);
        if (!n)
            return n.error();
        options.knownLength = KnownLength{{(*n)[0], (*n)[1]}, {(*n)[2], (*n)[3]}, (*n)[4] * 1e-3};
    }
    if (const auto marker = readMarker(parser, options); !marker)
        return marker.error();
    if (const auto colour = readColour(parser, options); !colour)
        return colour.error();
    return options;
}

Result<void> readFit(const QCommandLineParser& parser, FitContourArguments& request) {
    const QString harmonics = parser.value("harmonics");
    if (harmonics == QLatin1String("auto")) {
        if (!parser.isSet("tolerance"))
            return Error{MessageCode::ValueUnknown,
                         "--tolerance",
                         {"", "a length in mm, which --harmonics auto needs"}};
        const auto tolerance_mm = positiveOf(parser, "tolerance");
        if (!tolerance_mm)
            return tolerance_mm.error();
        request.tolerance_m = *tolerance_mm * 1e-3;
        return {};
    }
    bool isNumber = false;
    request.harmonics = harmonics.toInt(&isNumber);
    if (!isNumber || request.harmonics < 1 || request.harmonics > kMaxHarmonics)
        return Error{MessageCode::HarmonicsOutOfRange,
                     "--harmonics",
                     {harmonics.toStdString(), "1", std::to_string(kMaxHarmonics)}};
    return {};
}

Result<FitContourArguments> readFitContourArguments(const QCommandLineParser& parser) {
    FitContourArguments request;
    request.path = parser.positionalArguments().front().toStdString();
    auto import = readImport(parser);
    if (!import)
        return import.error();
    request.import = std::move(*import);
    if (parser.isSet("list"))
        return request;
    if (const auto fit = readFit(parser, request); !fit)
        return fit.error();
    if (parser.isSet("pick")) {
        bool isNumber = false;
        request.pick = parser.value("pick").toULongLong(&isNumber);
        if (!isNumber)
            return Error{MessageCode::ValueUnknown,
                         "--pick",
                         {parser.value("pick").toStdString(), "an index of --list, from 0"}};
    }
    return request;
}

/// A picture of the user's own is no preview, and is not replaced.
Result<void> checkPlaces(const QCommandLineParser& parser, FitContourArguments& request) {
    std::vector<OutputFile> outputs;
    if (parser.isSet("output")) {
        request.contourPath = parser.value("output").toStdString();
        outputs.push_back({request.contourPath, "type", "a contour written by Bask"});
    }
    if (parser.isSet("preview")) {
        request.previewPath = parser.value("preview").toStdString();
        outputs.push_back({request.previewPath});
    }
    if (auto place = checkOutputs({request.path}, outputs); !place || !parser.isSet("preview"))
        return place;
    QFile old(parser.value("preview"));
    if (old.exists() && old.size() > 0 &&
        (!old.open(QIODevice::ReadOnly) || !old.read(1024).contains(kPreviewMark)))
        return Error{MessageCode::OutputForeign, request.previewPath, {"a preview written by Bask"}};
    return {};
}

void printFigures(const PickedOutline& picked, const FourierFit& fit) {
    const auto print = [](const char* name, double value) { std::printf("%s %.9g\n", name, value); };
    print("area_mm2", fit.contour.area() * 1e6);
    print("net_area_mm2", shapeArea(shapeOfFit(fit, picked.holes)) * 1e6);
    print("perimeter_mm", fit.contour.perimeter() * 1e3);
    print("rms_mm", fit.rms_m * 1e3);
    print("max_mm", fit.max_m * 1e3);
    print("hausdorff_mm", fit.hausdorff_m * 1e3);
    print("harmonics", fit.contour.harmonics());
    print("area_error", fit.areaError);
    print("outline_area_mm2", contourArea(picked.contour) * 1e6);
    print("outline_perimeter_mm", contourPerimeter(picked.contour) * 1e3);
}

int list(const FitContourArguments& request) {
    const auto file = readOutlines(request.path, request.import);
    if (!file)
        return refuse("fit-contour", file.error());
    for (const Message& warning : file->warnings)
        warn(warning);
    std::printf("%s\n", outlineList(*file).dump(1).c_str());
    return kExitDone;
}

Result<FourierFit> fitAsAsked(const Contour& outline, const FitContourArguments& request) {
    if (request.harmonics > 0)
        return fitFourier(outline, request.harmonics);
    Progress progress(1.0, {}, Progress::Total::AtMost);
    return fitFourierWithin(outline, request.tolerance_m, progress.share());
}

int fitAndReport(const FitContourArguments& request, bool asJson) {
    const auto file = readOutlines(request.path, request.import);
    if (!file)
        return refuse("fit-contour", file.error());
    auto picked = pickOutline(*file, request.pick, request.path);
    if (!picked)
        return refuse("fit-contour", picked.error());
    const Contour& outline = picked->contour;
    const auto fit = fitAsAsked(outline, request);
    if (!fit)
        return refuse("fit-contour", fit.error());
    if (fit->crossesItself)
        picked->warnings.push_back({MessageCode::SeriesLoops, {}});
    if (!checkHoles(shapeOfFit(*fit, picked->holes)))
        picked->warnings.push_back({MessageCode::FitCutsHoles, {}});
    for (const Message& warning : picked->warnings)
        warn(warning);
    const std::string report = fitReport(*picked, *fit, file->unit).dump(1) + '\n';
    std::vector<WholeFile> files;
    if (!request.contourPath.empty())
        files.push_back({request.contourPath, report});
    try {
        if (!request.previewPath.empty())
            files.push_back({request.previewPath, fitPreview(*picked, *fit)});
    } catch (const std::runtime_error&) { // a part of the program is not there, which has been said
        return kExitFault;
    }
    if (const auto written = writeWholeFiles(files); !written)
        return refuse("fit-contour", written.error());
    if (asJson)
        std::printf("%s", report.c_str());
    else
        printFigures(*picked, *fit);
    return kExitDone;
}

/// What does nothing for a file of this kind, or beside the other options.
std::optional<int> refuseIdleOptions(const QCommandLineParser& parser) {
    const bool isFit = !parser.isSet("list");
    constexpr const char* kOfAFit = "is for a fit; --list only prints the file's outlines";
    constexpr const char* kOfAPicture = "is for pictures; lists and drawings have their unit";
    constexpr const char* kOfAColour = "is for pictures; lists and drawings have no colours";
    constexpr const char* kOfADrawing = "is for lists and drawings; a picture has a scale";
    const OutlineFormat* const format = outlineFormatOf(parser.positionalArguments().front().toStdString());
    const bool isKnown = format != nullptr, isPicture = isKnown && format->kind == OutlineKind::Picture;
    return refuseIdle(parser, "fit-contour",
                      {{"harmonics", isFit, kOfAFit},
                       {"tolerance", isFit, kOfAFit},
                       {"tolerance", parser.value("harmonics") == QLatin1String("auto"),
                        "is for --harmonics auto; a given number of harmonics has no tolerance"},
                       {"pick", isFit, kOfAFit},
                       {"json", isFit, "is for a fit; --list prints JSON anyway"},
                       {"scale", !isKnown || isPicture, kOfAPicture},
                       {"known-length", !isKnown || isPicture, kOfAPicture},
                       {"marker-size", !isKnown || isPicture, kOfAPicture},
                       {"marker-dictionary", !isKnown || isPicture, kOfAPicture},
                       {"colour", !isKnown || isPicture, kOfAColour},
                       {"colour-tolerance", !isKnown || isPicture, kOfAColour},
                       {"unit", !isPicture, kOfADrawing},
                       {"factor", !isPicture, kOfADrawing}});
}

} // namespace

int fitContourCommand(const QStringList& arguments) {
    QCommandLineParser parser;
    setUp(parser);
    if (const auto code = parseCommand(parser, "fit-contour", arguments, 1))
        return *code;
    const bool isList = parser.isSet("list");
    if (isList && (parser.isSet("output") || parser.isSet("preview")))
        return refuse("fit-contour", QStringLiteral("--list writes no file"));
    if (!isList && !parser.isSet("harmonics"))
        return refuse("fit-contour", QStringLiteral("--harmonics is needed"));
    if (const auto code = refuseIdleOptions(parser))
        return *code;
    auto request = readFitContourArguments(parser);
    if (!request)
        return refuse("fit-contour", request.error());
    if (const auto places = checkPlaces(parser, *request); !places)
        return refuse("fit-contour", places.error());
    return isList ? list(*request) : fitAndReport(*request, parser.isSet("json"));
}

} // namespace bask
