// `bask detect-markers`, `bask calibrate-camera` and `bask make-board`: their files, figures, words and exit
// codes.

#include "app/commands/command_line.h"
#include "engine/base/message_code.h"
#include "engine/calibration/board_finder.h"
#include "engine/calibration/camera_file.h"
#include "tests/engine/calibration/calibration_samples.h"
#include "tests/support/captured_command.h"
#include "widgets/calibrate/board_sheet.h"

#include <QFile>
#include <QImage>
#include <QPainter>
#include <QTemporaryDir>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <map>
#include <sstream>

namespace bask {
namespace {

using Json = nlohmann::json;
using test::Captured;

QString marker(const char* name) {
    return QString::fromStdString(test::markersPath(name));
}

QStringList images(const std::vector<std::string>& paths) {
    QStringList list;
    for (const std::string& path : paths)
        list << QString::fromStdString(path);
    return list;
}

void write(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(bytes);
}

/// A PNG whose header promises 20,000 x 20,000 pixels.
QByteArray hugePng() {
    QByteArray bytes = QByteArray::fromHex("89504e470d0a1a0a0000000d4948445200004e2000004e200800000000");
    return bytes + QByteArray(64, '\0');
}

std::map<std::string, double> figures(const std::string& out) {
    std::map<std::string, double> result;
    std::istringstream lines(out);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream in(line);
        std::string name;
        double value = 0.0;
        if (in >> name >> value)
            result[name] = value;
    }
    return result;
}

class CalibrationCommands : public ::testing::Test {
protected:
    QString path(const char* name) const { return m_folder.filePath(name); }

    QTemporaryDir m_folder;
};

using DetectMarkers = CalibrationCommands;
using CalibrateCamera = CalibrationCommands;
using MakeBoard = CalibrationCommands;

Captured detect(const QStringList& arguments) {
    return test::captured(detectMarkersCommand, arguments);
}
Captured calibrate(const QStringList& arguments) {
    return test::captured(calibrateCameraCommand, arguments);
}
Captured make(const QStringList& arguments) {
    return test::captured(makeBoardCommand, arguments);
}

QImage chessboard(int side, int square) {
    QImage image(side, side, QImage::Format_Grayscale8);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            image.scanLine(y)[x] = (x / square + y / square) % 2 == 0 ? 0 : 255;
    return image;
}

// -- detect-markers --------------------------------------------------------------------------------------

// Catches: a file that is not what the issue says; --json that says something else than standard output.
TEST_F(DetectMarkers, WritesIdsCornersAndPoses) {
    const QStringList arguments{
        marker("singlemarkersoriginal.jpg"), "--dictionary", "DICT_6X6_250", "--size", "0.05", "--camera",
        marker("tutorial_camera_params.yml")};
    const Captured printed = detect(arguments);
    EXPECT_EQ(printed.code, kExitDone) << printed.err;
    for (int k = 0; k < 2; ++k) { // the second time over its own
        const Captured written = detect(arguments + QStringList{"--json", path("m.json")});
        EXPECT_EQ(written.code, kExitDone) << written.err;
        EXPECT_EQ(written.out, "");
    }
    EXPECT_EQ(test::textOf(path("m.json").toStdString()), printed.out);
    const Json markers = Json::parse(printed.out)["markers"];
    std::vector<int> ids;
    for (const Json& one : markers) {
        ids.push_back(one["id"]);
        ASSERT_EQ(one["corners"].size(), 4U);
        EXPECT_EQ(one["corners"][3].size(), 2U);
        EXPECT_EQ(one["rvec"].size(), 3U);
        EXPECT_GT(one["tvec"][2], 0.6); // by the camera's other user between 0.68 and 0.91 m away
        EXPECT_LT(one["tvec"][2], 0.95);
        EXPECT_GT(one["second"]["reprojection_px"], one["reprojection_px"]);
        EXPECT_TRUE(one["ambiguous"].is_boolean());
    }
    EXPECT_EQ(ids, (std::vector<int>{23, 40, 62, 98, 124, 203}));
}

TEST_F(DetectMarkers, TakesADictionaryFile) {
    const Captured outcome =
        detect({marker("diamondmarkers.png"), "--dictionary", marker("tutorial_dict.yml")});
    EXPECT_EQ(outcome.code, kExitDone) << outcome.err;
    const Json markers = Json::parse(outcome.out)["markers"];
    EXPECT_EQ(markers.size(), 12U);
    EXPECT_FALSE(markers[0].contains("tvec")) << "no size, no pose";
}

// Catches: silence where there is no marker.
TEST_F(DetectMarkers, NoneIsANegativeVerdict) {
    const Captured outcome = detect({marker("marker23.png"), "--dictionary", "6X6_250"});
    EXPECT_EQ(outcome.code, kExitNegative);
    EXPECT_EQ(Json::parse(outcome.out), Json::parse(R"({"markers": []})"));
    EXPECT_NE(outcome.err.find("light margin"), std::string::npos) << outcome.err;
}

// Catches: a search of minutes, or one that takes all memory, and a word that does not say what is so.
TEST_F(DetectMarkers, ACrowdedPictureHasNoScaleAndItIsSaid) {
    for (const int square : {1, 32}) {
        ASSERT_TRUE(chessboard(4000, square).save(path("crowded.png")));
        const Captured outcome = test::captured(
            fitContourCommand, {path("crowded.png"), "--harmonics", "5", "--marker-size", "40"});
        EXPECT_EQ(outcome.code, kExitBadInput) << square;
        EXPECT_NE(outcome.err.find("too many quadrangles"), std::string::npos) << square << outcome.err;
        EXPECT_EQ(outcome.out, "") << square;
    }
}

// Catches: a crash, or a word that does not say what is wrong.
TEST_F(DetectMarkers, RefusesInWords) {
    const QString picture = marker("singlemarkersoriginal.jpg"),
                  camera = marker("tutorial_camera_params.yml");
    write(path("empty.png"), {});
    write(path("huge.png"), hugePng());
    write(path("text.png"), "no picture at all");
    QFile whole(picture);
    ASSERT_TRUE(whole.open(QIODevice::ReadOnly));
    write(path("cut.jpg"), whole.readAll().first(40'000));
    write(path("notes.json"), "{\"notes\": 1}");
    ASSERT_TRUE(chessboard(2000, 16).save(path("crowded.png"))); // 15 000 squares: a minute, once
    ASSERT_TRUE(chessboard(4000, 1).save(path("fine.png")));     // it took all memory, once
    const std::pair<QStringList, const char*> cases[] = {
        {{path("crowded.png"), "--dictionary", "6X6_250"}, "too many quadrangles"},
        {{path("fine.png"), "--dictionary", "6X6_250"}, "too many quadrangles"},
        {{picture}, "--dictionary is needed"},
        {{}, "1 argument expected"},
        {{picture, "--dictionary", "9X9_1"}, "is not known; known: 4X4_100"},
        {{picture, "--dictionary", path("gone.yml")}, "no such file"},
        {{picture, "--dictionary", camera}, "\"nmarkers\" is missing"},
        {{picture, "--dictionary", "6X6_250", "--size", "0.05"}, "both --size and --camera"},
        {{picture, "--dictionary", "6X6_250", "--size", "50", "--camera", camera}, "allowed: 0.001 to 10 m"},
        {{picture, "--dictionary", "6X6_250", "--size", "0.05", "--camera", picture},
         "\"camera_matrix/data\" is missing"},
        {{marker("403.jpg"), "--dictionary", "5X5_1000", "--size", "0.145", "--camera",
          marker("tutorial_camera_charuco.yml")},
         "calibrated with pictures of 640 x 480 pixels, this one has 1280 x 960"},
        {{path("gone.png"), "--dictionary", "6X6_250"}, "no such file"},
        {{path("empty.png"), "--dictionary", "6X6_250"}, "the file is empty"},
        {{path("text.png"), "--dictionary", "6X6_250"}, "not a picture"},
        {{path("cut.jpg"), "--dictionary", "6X6_250"}, "damaged"},
        {{path("huge.png"), "--dictionary", "6X6_250"}, "400 megapixels, more than the 64 megapixels"},
        {{picture, "--dictionary", "6X6_250", "--json", path("notes.json")}, "is not a list of markers"},
        {{picture, "--dictionary", "6X6_250", "--json", picture}, "also an input"},
    };
    for (const auto& [arguments, words] : cases) {
        const Captured outcome = detect(arguments);
        EXPECT_EQ(outcome.code, kExitBadInput) << words;
        EXPECT_NE(outcome.err.find(words), std::string::npos) << words << "\n" << outcome.err;
        EXPECT_EQ(outcome.out, "") << words;
    }
    EXPECT_EQ(test::textOf(path("notes.json").toStdString()), "{\"notes\": 1}");
}

TEST_F(DetectMarkers, APictureOfOnePixelHasNone) {
    QImage(1, 1, QImage::Format_Grayscale8).save(path("one.png"));
    EXPECT_EQ(detect({path("one.png"), "--dictionary", "6X6_250"}).code, kExitNegative);
}

// -- calibrate-camera ------------------------------------------------------------------------------------

// Catches: figures that are not those of the file; a published calibration that is missed; views that are
// left out unsaid.
TEST_F(CalibrateCamera, WritesTheCameraOfTheChessboards) {
    write(path("empty.png"), {});
    write(path("huge.png"), hugePng());
    QStringList arguments{"--board",
                          "chessboard:9x6:0.025",
                          "-o",
                          path("cam.yml"),
                          "--ros",
                          path("ros.yaml"),
                          path("empty.png"),
                          path("huge.png"),
                          marker("pal_marker26_margin.jpg")};
    for (int k = 0; k < 2; ++k) { // the second time over its own
        const Captured outcome = calibrate(arguments + images(test::chessboardViews()));
        ASSERT_EQ(outcome.code, kExitDone) << outcome.err;
        EXPECT_NE(outcome.err.find("empty.png: the file is empty"), std::string::npos) << outcome.err;
        EXPECT_NE(outcome.err.find("huge.png: the file has 400 megapixels"), std::string::npos);
        EXPECT_NE(outcome.err.find("margin.jpg: no chessboard of 9 x 6"), std::string::npos);
        auto figure = figures(outcome.out);
        EXPECT_EQ(figure["views"], 13);
        EXPECT_LE(figure["rms_px"], 0.45);
        EXPECT_NEAR(figure["fx_px"], 535.9, 5.359);
        EXPECT_GT(figure["fx_px_deviation"], 0.0);
        EXPECT_LT(figure["fx_px_deviation"], 3.0);
        EXPECT_LT(figure["held_out_px"], 0.45);
        EXPECT_NEAR(figure["held_out_mm"], figure["held_out_px"] * 600.0 / figure["fx_px"], 1e-3);
        const auto camera = readCamera(path("cam.yml").toStdString()),
                   ros = readCamera(path("ros.yaml").toStdString());
        ASSERT_TRUE(camera);
        ASSERT_TRUE(ros) << describe(ros.error());
        EXPECT_NEAR(camera->fx, figure["fx_px"], 1e-5);
        EXPECT_EQ(ros->fx, camera->fx);
        EXPECT_EQ(ros->distortion, camera->distortion);
        EXPECT_EQ(camera->views.size(), 13U);
        EXPECT_EQ(camera->deviations.size(), 9U);
        EXPECT_EQ(camera->width, 640);
    }
    EXPECT_TRUE(test::textOf(path("cam.yml").toStdString()).starts_with("%YAML:1.0\n---\ncamera_matrix:"));
}

TEST_F(CalibrateCamera, WritesTheCameraOfTheCharucoBoards) {
    const Captured outcome =
        calibrate(QStringList{"--board", "charuco:5x7:0.04:0.02:DICT_6X6_250", "-o", path("cam.yml")} +
                  images(test::charucoViews()));
    ASSERT_EQ(outcome.code, kExitDone) << outcome.err;
    auto figure = figures(outcome.out);
    EXPECT_NEAR(figure["fx_px"], 452.511, 0.02 * 452.511);
    EXPECT_NEAR(figure["fy_px"], 456.767, 0.02 * 456.767);
}

// Catches: a wrong setting that gives a camera all the same, or a complaint that does not name the right one.
TEST_F(CalibrateCamera, AWrongBoardIsSaid) {
    const auto chess = images(test::chessboardViews()).first(6), charuco = images(test::charucoViews());
    const std::tuple<const char*, const char*, QStringList> cases[] = {
        {"chessboard:8x6:0.025", "chessboard:9x6:0.025", chess},
        {"charuco:7x5:0.04:0.02:6X6_250", "charuco:5x7:0.04:0.02:6X6_250", charuco},
        {"charuco:5x7:0.04:0.02:4X4_50", "charuco:5x7:0.04:0.02:6X6_50", charuco},
        {"charuco:5x7:0.04:0.03:6X6_250", "charuco:5x7:0.04:0.02:6X6_250", charuco},
    };
    for (const auto& [set, seen, pictures] : cases) {
        const Captured outcome = calibrate(QStringList{"--board", set, "-o", path("cam.yml")} + pictures);
        EXPECT_EQ(outcome.code, kExitNegative) << set;
        const std::string words = std::string("the pictures show the board ") + seen + ", not " + set;
        EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
        EXPECT_FALSE(QFile::exists(path("cam.yml")));
    }
}

// Catches: pictures of another size mixed in.
TEST_F(CalibrateCamera, PicturesOfAnotherSizeAreLeftOut) {
    const auto chess = images(test::chessboardViews()).first(4);
    QImage(chess[0])
        .scaled(320, 240, Qt::IgnoreAspectRatio, Qt::SmoothTransformation)
        .save(path("small.png"));
    const Captured outcome = calibrate(
        QStringList{"--board", "chessboard:9x6:0.025", "-o", path("cam.yml"), path("small.png")} + chess);
    EXPECT_EQ(outcome.code, kExitDone) << outcome.err;
    EXPECT_NE(outcome.err.find("small.png: the picture has 320 x 240 pixels, the others 640 x 480"),
              std::string::npos)
        << outcome.err;
    EXPECT_EQ(figures(outcome.out)["views"], 4);
}

TEST_F(CalibrateCamera, RefusesInWords) {
    const auto chess = images(test::chessboardViews());
    write(path("notes.yml"), "notes: 1\n");
    write(path("empty.png"), {});
    const QString board = "chessboard:9x6:0.025";
    const std::tuple<QStringList, int, const char*> cases[] = {
        {{"--board", board, "-o", path("c.yml")}, kExitBadInput, "at least 1 argument expected"},
        {{"-o", path("c.yml"), chess[0]}, kExitBadInput, "--board and -o are needed"},
        {{"--board", board, chess[0]}, kExitBadInput, "--board and -o are needed"},
        {{"--board", "chessboard", "-o", path("c.yml"), chess[0]}, kExitBadInput, "is no board"},
        {{"--board", board, "-o", path("notes.yml"), chess[0]}, kExitBadInput, "is not a camera file"},
        {{"--board", board, "-o", chess[0], chess[0]}, kExitBadInput, "also an input"},
        {{"--board", board, "-o", path("c.yml"), "--coefficients", "6", chess[0]},
         kExitBadInput,
         "known: 5, 8"},
        {{"--board", board, "-o", path("c.yml"), "--distance", "nan", chess[0]},
         kExitBadInput,
         "allowed: 0 to 100 m"},
        {{"--board", board, "-o", path("c.yml"), path("empty.png")}, kExitBadInput, "the file is empty"},
        {{"--board", board, "-o", path("c.yml"), chess[0], chess[1]},
         kExitNegative,
         "2 pictures that can be used are too few"},
        {{"--board", board, "-o", path("c.yml"), chess[3], chess[3], chess[3]},
         kExitNegative,
         "the board is held in nearly the same direction"},
    };
    for (const auto& [arguments, code, words] : cases) {
        const Captured outcome = calibrate(arguments);
        EXPECT_EQ(outcome.code, code) << words;
        EXPECT_NE(outcome.err.find(words), std::string::npos) << words << "\n" << outcome.err;
        EXPECT_FALSE(QFile::exists(path("c.yml"))) << words;
    }
}

// -- make-board ------------------------------------------------------------------------------------------

constexpr double kDots_mm = 300.0 / 25.4;

GreyPicture painted(const BoardSheet& sheet) {
    const QSizeF size = sheet.page.fullRect().size() * kDots_mm;
    QImage image(qRound(size.width()), qRound(size.height()), QImage::Format_Grayscale8);
    image.fill(Qt::white);
    QPainter painter(&image);
    paintSheet(painter, kDots_mm, sheet);
    painter.end();
    GreyPicture picture{image.width(), image.height(), {}};
    for (int y = 0; y < image.height(); ++y)
        picture.values.insert(picture.values.end(), image.constScanLine(y),
                              image.constScanLine(y) + image.width());
    return picture;
}

/// The drawing of a PDF's first page.
std::string firstPage(const std::string& pdf) {
    for (std::size_t at = pdf.find("stream\n"); at != std::string::npos; at = pdf.find("stream\n", at + 1)) {
        const std::size_t begin = at + 7, end = pdf.find("endstream", begin);
        if (end == std::string::npos)
            break;
        QByteArray packed = QByteArray::fromHex("00100000"); // a size to begin with
        packed.append(pdf.data() + begin, static_cast<qsizetype>(end - begin));
        if (const std::string text = qUncompress(packed).toStdString();
            text.find(" cm\n") != std::string::npos)
            return text;
    }
    return {};
}

// Catches: a sheet on which Bask does not find its own board, or of another size: the same painting as the
// PDF's at 300 dpi; every corner lies where its millimetres say, ruler and letters disturb nothing.
TEST_F(MakeBoard, BoardsAreFoundInTheirSize) {
    for (const char* text : {"chessboard:9x6:0.025", "chessboard:5x7:0.025",
                             "charuco:5x7:0.025:0.0175:4X4_50", "charuco:5x6:0.03:0.02:6X6_250:legacy"}) {
        const auto sheet = boardSheets(text, QPageSize::A4);
        ASSERT_TRUE(sheet) << describe(sheet.error());
        const Board board = *parseBoard(text);
        const GreyPicture picture = painted(sheet->front());
        const auto view = findBoard(picture, board, text);
        ASSERT_TRUE(view) << describe(view.error());
        ASSERT_EQ(static_cast<int>(view->corners.size()), cornerCount(board)) << text;
        const double first_m = board.kind == BoardKind::Chessboard ? board.square_m : 0.0;
        const bool isTurned = view->corners_px.front().y() > view->corners_px.back().y();
        for (std::size_t k = 0; k < view->corners.size(); ++k) {
            const int corner = isTurned ? cornerCount(board) - 1 - view->corners[k] : view->corners[k];
            const Eigen::Vector2d at_m = cornerOf(board, corner) + Eigen::Vector2d(first_m, first_m);
            const Eigen::Vector2d at_px = ((sheet->front().corner_mm + 1e3 * at_m) * kDots_mm).array() -
                                          0.5; // pixel centres at whole numbers
            EXPECT_LT((view->corners_px[k] - at_px).norm(), 0.2) << text << " " << corner;
        }
    }
}

TEST_F(MakeBoard, MarkersAreFoundInTheirSize) {
    const auto sheet = boardSheets("marker:6X6_250:23:0.05", QPageSize::A4);
    ASSERT_TRUE(sheet) << describe(sheet.error());
    const auto markers = findMarkers(painted(sheet->front()), {"6X6_250"});
    ASSERT_EQ(markers.size(), 1U);
    EXPECT_EQ(markers[0].id, 23);
    EXPECT_NEAR(markers[0].side_px(), 50.0 * kDots_mm, 0.2);
}

// Catches: markers of one page that overlap, lack their light margin or are not those that were asked for;
// letters that spoil one.
TEST_F(MakeBoard, SeveralMarkersAreFoundOnOnePage) {
    const auto sheets = boardSheets("marker:6X6_250:1-4, 11:0.06", QPageSize::Letter);
    ASSERT_TRUE(sheets) << describe(sheets.error());
    ASSERT_EQ(sheets->size(), 1U);
    std::vector<int> ids;
    for (const FoundMarker& marker : findMarkers(painted(sheets->front()), {"6X6_250"})) {
        ids.push_back(marker.id);
        EXPECT_NEAR(marker.side_px(), 60.0 * kDots_mm, 0.2);
    }
    std::ranges::sort(ids);
    EXPECT_EQ(ids, (std::vector{1, 2, 3, 4, 11}));
}

// Catches: a PDF on paper of another size, or scaled: the page's box in points, and the units of its content,
// which are dots of 1200 to the inch.
TEST_F(MakeBoard, WritesPagesOfTheirSize) {
    for (int k = 0; k < 2; ++k) // the second time over its own
        ASSERT_EQ(make({"chessboard:9x6:0.025", "marker:4X4_50:7:0.06", "-o", path("s.pdf")}).code,
                  kExitDone);
    const std::string pdf = test::textOf(path("s.pdf").toStdString());
    EXPECT_TRUE(pdf.starts_with("%PDF-"));
    EXPECT_NE(pdf.find("/Count 2"), std::string::npos);
    ASSERT_EQ(make({"marker:4X4_50:1-14:0.06", "--paper", "Letter", "-o", path("m.pdf")}).code, kExitDone);
    const std::string many = test::textOf(path("m.pdf").toStdString());
    EXPECT_NE(many.find("/Count 3"), std::string::npos);
    EXPECT_NE(many.find("0 0 612.000000 792.000000"), std::string::npos);
    EXPECT_NE(pdf.find("0 0 842.000000 595.000000"), std::string::npos);
    EXPECT_NE(pdf.find("0 0 595.000000 842.000000"), std::string::npos);
    // The first upper side that is drawn: "0.06 0 0 -0.06 0 595 cm" and then "x y m", "x y l".
    double scale = 0.0, fromX = 0.0, fromY = 0.0, toX = 0.0, toY = 0.0;
    const std::string content = firstPage(pdf);
    ASSERT_EQ(std::sscanf(content.c_str() + content.find('\n'), "%lf", &scale), 1);
    const std::size_t side = content.find("/GSa gs\n", content.find("scn"));
    ASSERT_NE(side, std::string::npos);
    ASSERT_EQ(std::sscanf(content.c_str() + side, "/GSa gs %lf %lf m %lf %lf l", &fromX, &fromY, &toX, &toY),
              4);
    EXPECT_NEAR((toX - fromX) * scale / 72.0 * 25.4, 25.0, 1e-3);
    EXPECT_EQ(fromY, toY);
    ASSERT_EQ(make({"charuco:5x7:0.04:0.02:6X6_250", "--paper", "A3", "-o", path("a3.pdf")}).code, kExitDone);
    EXPECT_NE(test::textOf(path("a3.pdf").toStdString()).find("0 0 842.000000 1191.000000"),
              std::string::npos);
}

TEST_F(MakeBoard, RefusesInWords) {
    write(path("other.pdf"), "%PDF-1.4 of somebody else");
    const std::pair<QStringList, const char*> cases[] = {
        {{}, "at least 1 argument expected"},
        {{"chessboard:9x6:0.025"}, "-o SHEET.pdf is needed"},
        {{"chess", "-o", path("s.pdf")}, "is no board"},
        {{"marker:6X6_250:23", "-o", path("s.pdf")}, "is no marker"},
        {{"marker:6X6_250:x:0.05", "-o", path("s.pdf")}, "is no marker"},
        {{"marker:9X9:1:0.05", "-o", path("s.pdf")}, "is not known"},
        {{"marker:6X6_250:250:0.05", "-o", path("s.pdf")}, "allowed: 0 to 249"},
        {{"marker:6X6_250:1:nan", "-o", path("s.pdf")}, "allowed: 0.001 to 1 m"},
        {{"charuco:5x7:0.04:0.02:6X6_250", "-o", path("s.pdf")}, "A4 has room for 190 x 263 mm"},
        {{"chessboard:9x6:0.025", "--paper", "A5", "-o", path("s.pdf")}, "known: A4, A3, Letter"},
        {{"chessboard:9x6:0.025", "-o", path("other.pdf")}, "is not a sheet written by Bask"},
    };
    for (const auto& [arguments, words] : cases) {
        const Captured outcome = make(arguments);
        EXPECT_EQ(outcome.code, kExitBadInput) << words;
        EXPECT_NE(outcome.err.find(words), std::string::npos) << words << "\n" << outcome.err;
        EXPECT_FALSE(QFile::exists(path("s.pdf"))) << words;
    }
}

} // namespace
} // namespace bask
