// bask make-board: calibration boards and markers as PDF, to be printed at their size.

#include "app/commands/command_line.h"
#include "app/commands/output_file.h"
#include "app/commands/parse_command.h"
#include "app/studies/study_output.h"
#include "engine/base/message_code.h"
#include "engine/experiment/text_file.h"
#include "widgets/calibrate/board_sheet.h"

#include <QCommandLineParser>
#include <QFile>

#include <algorithm>
#include <iterator>
#include <vector>

namespace bask {
namespace {

constexpr const char* kMakeBoard = "make-board";

// An earlier sheet names its maker in the PDF's information, two bytes a letter.
Result<void> checkPlace(const std::string& path) {
    if (auto place = checkOutputs({}, {{path}}); !place)
        return place;
    QByteArray mark;
    for (const QChar letter : kSheetCreator)
        mark.append('\0').append(letter.toLatin1());
    QFile old(QString::fromStdString(path));
    if (old.exists() && old.size() > 0 && (!old.open(QIODevice::ReadOnly) || !old.readAll().contains(mark)))
        return Error{MessageCode::OutputForeign, path, {"a sheet written by Bask"}};
    return {};
}

} // namespace

int makeBoardCommand(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription(
        "Writes boards and markers as PDF, each on pages of its own and in its exact size when it is "
        "printed\n"
        "at 100 %, with its setting above and a ruler below: measure whether its 100 mm are 100 mm.\n"
        "Exit code: 0 done, 2 bad input or unwritable output.");
    parser.addOption({{"h", "help"}, "Displays this help."});
    parser.addOptions({{{"o", "output"}, "The sheet. Required.", "SHEET.pdf"},
                       {"paper", "A4, A3 or Letter, upright or across as the pattern fits.", "NAME", "A4"}});
    parser.addPositionalArgument(
        "BOARD",
        "chessboard:9x6:0.025 (inner corners, square in metres), "
        "charuco:5x7:0.04:0.02:6X6_250 (squares, square and marker in metres, "
        "dictionary) or marker:6X6_250:1-4,11:0.05 (dictionary, ids, side in metres).",
        "BOARD...");
    if (const auto code = parseCommand(parser, kMakeBoard, arguments, -1))
        return *code;
    if (!parser.isSet("output"))
        return refuse(kMakeBoard, QStringLiteral("-o SHEET.pdf is needed"));
    const QString paper = parser.value("paper");
    if (paper != "A4" && paper != "A3" && paper != "Letter")
        return refuse(kMakeBoard,
                      Error{MessageCode::ValueUnknown, "--paper", {paper.toStdString(), "A4, A3, Letter"}});
    const auto size = paper == "A4" ? QPageSize::A4 : paper == "A3" ? QPageSize::A3 : QPageSize::Letter;
    std::vector<BoardSheet> sheets;
    for (const QString& setting : parser.positionalArguments()) {
        auto some = boardSheets(setting.toStdString(), size);
        if (!some)
            return refuse(kMakeBoard, some.error());
        std::ranges::move(*some, std::back_inserter(sheets));
    }
    const std::string path = parser.value("output").toStdString();
    if (const auto place = checkPlace(path); !place)
        return refuse(kMakeBoard, place.error());
    if (const auto written = writeTextFile(path, sheetPdf(sheets).toStdString()); !written)
        return refuse(kMakeBoard, written.error());
    return kExitDone;
}

} // namespace bask
