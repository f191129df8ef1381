// bask export: a recorded session as files for other programs.

#include "app/commands/command_line.h"
#include "app/commands/parse_command.h"
#include "app/drawing/session_outputs.h"
#include "app/drawing/study_output.h"
#include "engine/recording/nexus_file.h"
#include "engine/recording/session_vtk.h"

#include <QCommandLineParser>

#include <array>
#include <cstdio>
#include <optional>

namespace bask {
namespace {

constexpr const char* kExport = "export";
constexpr std::array kKinds{"csv", "nexus", "vtk", "figures", "frames"};

using Files = Result<std::vector<std::string>>;

/// The tables are written as they are read; the other forms want the whole run.
Files exported(const QString& kind, const std::string& path, std::optional<SessionRecord>& session,
               const std::string& folder) {
    if (kind == QLatin1String("csv"))
        return exportSessionCsv(path, folder);
    if (kind == QLatin1String("frames"))
        return exportThermalFrames(path, folder);
    if (!session) {
        auto read = readSession(path);
        if (!read)
            return read.error();
        session = std::move(*read);
    }
    if (kind == QLatin1String("vtk"))
        return exportVtk(*session, folder);
    if (kind == QLatin1String("figures"))
        return exportFigures(*session, folder, TemperatureUnit::Celsius);
    const auto file = exportNexus(*session, folder);
    return file ? Files(std::vector{*file}) : file.error();
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
        {{"csv", "Tables with units in their headers, all digits; an empty field is not known.", "DIR"},
         {"nexus", "One HDF5 file in NeXus layout, *.nxs, with recorded thermal pictures.", "DIR"},
         {"vtk", "Trajectories, outlines over time and fields for ParaView: *.vtp, *.pvd, *.vti.", "DIR"},
         {"figures", "Traces and trajectories as PNG, SVG and PDF.", "DIR"},
         {"frames", "Recorded pictures of the thermal camera: TIFF of 16 bits, and times.csv.", "DIR"},
         {"language", "Of the figures: en, fr, zh_CN or zh_TW.", "CODE", "en"}});
    parser.addPositionalArgument("SESSION.bask", "The session; one that is being recorded will do.");
    if (const auto code = parseCommand(parser, kExport, arguments, 1))
        return *code;
    QStringList wanted;
    for (const char* kind : kKinds)
        if (!parser.value(kind).isEmpty())
            wanted << kind;
    if (wanted.isEmpty())
        return refuse(kExport, QStringLiteral("--csv, --nexus, --vtk, --figures or --frames DIR is needed"));
    Language language;
    if (const auto spoken = setLanguage(language, parser.value("language")); !spoken)
        return refuse(kExport, spoken.error());
    std::optional<SessionRecord> session;
    for (const QString& kind : wanted) {
        const auto files = exported(kind, parser.positionalArguments().front().toStdString(), session,
                                    parser.value(kind).toStdString());
        if (!files)
            return refuse(kExport, files.error());
        for (const std::string& file : *files)
            std::printf("%s\n", file.c_str());
    }
    return kExitDone;
}

} // namespace bask
