// bask export: a recorded session as files for other programs.

#include "app/commands/command_line.h"
#include "app/commands/parse_command.h"
#include "app/commands/progress.h"
#include "app/drawing/session_outputs.h"
#include "app/studies/study_output.h"
#include "engine/recording/nexus_file.h"
#include "engine/recording/session_verify.h"
#include "engine/recording/session_vtk.h"

#include <QCommandLineParser>

#include <array>
#include <cstdio>
#include <optional>

namespace bask {
namespace {

constexpr const char* kExport = "export";
constexpr double kAfterRecord = 0.5; // of the work of one form
constexpr std::array kKinds{"csv", "nexus", "vtk", "figures", "frames"};

using Files = Result<std::vector<std::string>>;

/// How what is asked for is written.
struct Ways {
    CsvDigits digits = CsvDigits::Meaningful;
    FigureLayout layout;
};

/// The tables are written as they are read; the other forms want the whole run.
Files exported(const QString& kind, const std::string& path, std::optional<SessionRecord>& session,
               const std::string& folder, const Ways& ways, const ShareDone& done) {
    if (kind == QLatin1String("csv"))
        return exportSessionCsv(path, folder, done, ways.digits);
    if (kind == QLatin1String("frames"))
        return exportThermalFrames(path, folder, done);
    const double begin = session ? 0.0 : kAfterRecord;
    if (!session) {
        auto read = readSession(path, partOf(done, 0.0, kAfterRecord));
        if (!read)
            return read.error();
        session = std::move(*read);
        session->verification = verificationOf(path);
    }
    const ShareDone rest = partOf(done, begin, 1.0);
    if (kind == QLatin1String("vtk"))
        return exportVtk(*session, folder, {}, rest);
    if (kind == QLatin1String("figures"))
        return exportFigures(*session, folder, TemperatureUnit::Celsius, ways.layout, rest);
    const auto file = exportNexus(*session, folder, rest);
    return file ? Files(std::vector{*file}) : file.error();
}

/// All of them, or those before the first that failed.
Result<void> exportAll(const QStringList& kinds, const QCommandLineParser& parser, const Ways& ways,
                       std::vector<std::string>& files) {
    Progress progress(static_cast<double>(kinds.size()));
    const std::string path = parser.positionalArguments().front().toStdString();
    std::optional<SessionRecord> session;
    double done = 0.0;
    for (const QString& kind : kinds) {
        const auto some = exported(kind, path, session, parser.value(kind).toStdString(), ways,
                                   [&](double share) { progress.tell(done + share); });
        if (!some)
            return some.error();
        files.insert(files.end(), some->begin(), some->end());
        done += 1.0;
    }
    return {};
}

} // namespace

int exportCommand(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription(
        "Writes a recorded session for other programs, in one or more forms, each into its folder, whole or\n"
        "not at all. Folders are made if they are not there. Prints the names of the files written.\n"
        "Exit code: 0 done, 2 bad input or unwritable output.");
    parser.addOption({{"h", "help"}, "Displays this help."});
    parser.addOptions(
        {{"csv",
          "traces.csv, a row a sample, and all tables, with the digits that mean something;\n"
          "units are in the headers, an empty field is not known.",
          "DIR"},
         {"all-digits", "All digits of the numbers."},
         {"nexus", "One HDF5 file in NeXus layout, *.nxs, with recorded thermal pictures.", "DIR"},
         {"vtk", "Trajectories, outlines over time and fields for ParaView: *.vtp, *.pvd, *.vti.", "DIR"},
         {"figures", "Traces and trajectories as PNG, SVG and PDF, each of one size on paper.", "DIR"},
         {"figure-width",
          QStringLiteral("Of the figures on paper, %1 to %2; one column of a journal has about %3.")
              .arg(kNarrowest_mm)
              .arg(kWidest_mm)
              .arg(kOneColumn_mm),
          "MM", QString::number(kTwoColumns_mm)},
         {"no-heading", "Figures without title and note; \"SIMULATED\" stands in the corner then."},
         {"frames", "Recorded pictures of the thermal camera: TIFF of 16 bits, and times.csv.", "DIR"},
         {"language", "Of the figures: en, fr, zh_CN or zh_TW.", "CODE", "en"}});
    parser.addPositionalArgument("SESSION.bask", "The session; one that is being recorded will do.");
    if (const auto code = parseCommand(parser, kExport, arguments, 1))
        return *code;
    QStringList wanted;
    for (const char* kind : kKinds) {
        if (parser.isSet(kind))
            wanted << kind;
        if (parser.isSet(kind) && parser.value(kind).isEmpty())
            return refuse(kExport, QStringLiteral("--%1: the name of its folder is empty").arg(kind));
    }
    if (wanted.isEmpty())
        return refuse(kExport, QStringLiteral("--csv, --nexus, --vtk, --figures or --frames DIR is needed"));
    if (const auto code = refuseIdle(parser, kExport,
                                     {{"all-digits", parser.isSet("csv"), "is for --csv"},
                                      {"figure-width", parser.isSet("figures"), "is for --figures"},
                                      {"no-heading", parser.isSet("figures"), "is for --figures"},
                                      {"language", parser.isSet("figures"),
                                       "is for --figures; the other forms have no words in a language"}}))
        return *code;
    Ways ways;
    ways.digits = parser.isSet("all-digits") ? CsvDigits::All : CsvDigits::Meaningful;
    ways.layout.hasHeading = !parser.isSet("no-heading");
    bool isNumber = false;
    ways.layout.width_mm = parser.value("figure-width").toDouble(&isNumber);
    if (!isNumber || !(ways.layout.width_mm >= kNarrowest_mm && ways.layout.width_mm <= kWidest_mm))
        return refuse(kExport, QStringLiteral("--figure-width: \"%1\" is not a width of %2 to %3 mm")
                                   .arg(parser.value("figure-width"))
                                   .arg(kNarrowest_mm)
                                   .arg(kWidest_mm));
    Language language;
    if (const auto spoken = setLanguage(language, parser.value("language")); !spoken)
        return refuse(kExport, spoken.error());
    std::vector<std::string> files;
    const auto done = exportAll(wanted, parser, ways, files);
    for (const std::string& file : files)
        std::printf("%s\n", file.c_str());
    return done ? kExitDone : refuse(kExport, done.error());
}

} // namespace bask
