// Sheets to be printed: what is drawn, saved and told about lengths, as a person would use the panel.

#include "tests/support/thread_time.h"
#include "widgets/calibrate/board_form.h"
#include "widgets/calibrate/sheet_panel.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <gtest/gtest.h>

namespace bask {
namespace {

struct SheetPanelTest : testing::Test {
    SheetPanel panel;
    QTemporaryDir folder;

    SheetPanelTest() {
        panel.resize(760, 520);
        panel.show();
    }
    template <class Widget> Widget* find(const char* name) {
        auto* widget = panel.findChild<Widget*>(name);
        EXPECT_NE(widget, nullptr) << name;
        return widget;
    }
    QString text(const char* name) { return find<QLabel>(name)->text(); }
    /// What a window that knows nothing else would see printed, grey at a place of the page in mm.
    int greyAt(double x_mm, double y_mm, QSizeF page_mm) {
        auto* preview = find<QWidget>("sheetPreview");
        const QImage image = preview->grab().toImage();
        const double scale =
            std::min((image.width() - 2) / page_mm.width(), (image.height() - 2) / page_mm.height());
        const QSizeF size = page_mm * scale;
        return qGray(image.pixel(static_cast<int>(0.5 * (image.width() - size.width()) + x_mm * scale),
                                 static_cast<int>(0.5 * (image.height() - size.height()) + y_mm * scale)));
    }
};

} // namespace

// Catches: a preview of another board or size than is printed: squares of 25 mm where the sheet has them.
TEST_F(SheetPanelTest, ShowsTheBoardToScale) {
    panel.setBoard({BoardKind::Chessboard, 9, 6, 0.025, 0.0, "", false});
    const QSizeF page(297.0, 210.0);
    const auto sheets = boardSheets("chessboard:9x6:0.025", QPageSize::A4);
    ASSERT_TRUE(sheets);
    const Eigen::Vector2d corner = sheets->front().corner_mm;
    for (int row = 0; row < 7; ++row)
        for (int column = 0; column < 10; ++column) {
            const int grey =
                greyAt(corner.x() + 25.0 * (column + 0.5), corner.y() + 25.0 * (row + 0.5), page);
            EXPECT_EQ(grey < 128, (row + column) % 2 == 0) << row << " " << column;
        }
    EXPECT_GT(greyAt(3.0, 100.0, page), 200); // paper
}

// Catches: a size or number that cannot be printed, saved all the same or shown without a word; the words
// that stay when it can.
TEST_F(SheetPanelTest, SaysWhatCannotBePrinted) {
    panel.setBoard({BoardKind::Chessboard, 9, 6, 0.1, 0.0, "", false});
    EXPECT_TRUE(text("sheetProblem").contains("A4")) << text("sheetProblem").toStdString();
    EXPECT_FALSE(find<QPushButton>("sheetSave")->isEnabled());
    panel.setBoard({BoardKind::Charuco, 5, 7, 0.025, 0.018, "4X4_50", false});
    EXPECT_EQ(text("sheetProblem"), "");
    EXPECT_TRUE(find<QPushButton>("sheetSave")->isEnabled());
    panel.setMarkers("4X4_50", {1, 2}, 0.05);
    for (const char* wrong : {"", "1-", "a", "3-1", "50", "1:2:3", "-1", "1,,2"}) {
        find<QLineEdit>("sheetIds")->setText(wrong);
        EXPECT_FALSE(find<QPushButton>("sheetSave")->isEnabled()) << wrong;
        EXPECT_NE(text("sheetProblem"), "") << wrong;
    }
}

// Catches: markers that do not fit on one page lost or laid over one another; one id twice.
TEST_F(SheetPanelTest, LaysMarkersOnAsManyPagesAsNeeded) {
    find<QComboBox>("sheetKind")->setCurrentIndex(1);
    QTest::keyClick(find<QLineEdit>("sheetIds"), Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(find<QLineEdit>("sheetIds"), "1-20, 11, 30");
    EXPECT_TRUE(text("sheetPages").contains("2")) << text("sheetPages").toStdString();
    // 190 x 263 mm, markers of 50 mm and 12.5 mm between: 3 x 4 on a page.
    const auto sheets = boardSheets("marker:6X6_250:1-20,11,30:0.05", QPageSize::A4);
    ASSERT_TRUE(sheets);
    ASSERT_EQ(sheets->size(), 2U);
    EXPECT_EQ(sheets->at(0).labels.size(), 12U);
    ASSERT_EQ(sheets->at(1).labels.size(), 9U);
    EXPECT_EQ(sheets->at(1).labels.back().text, "30");
    EXPECT_EQ(sheets->at(1).setting, "marker:6X6_250:13-20,30:0.05"); // which makes this page
}

// Catches: a true length the wrong way round or in another unit; one told before anything is measured; the
// markers of a ChArUco board left as they were.
TEST_F(SheetPanelTest, TellsTheTrueLengths) {
    panel.setBoard({BoardKind::Charuco, 5, 7, 0.025, 0.018, "4X4_50", false});
    EXPECT_FALSE(find<QPushButton>("sheetUse")->isEnabled());
    Board measured;
    QObject::connect(&panel, &SheetPanel::boardMeasured, [&](const Board& board) { measured = board; });
    auto* length = find<QDoubleSpinBox>("sheetMeasured");
    length->selectAll();
    QTest::keyClicks(length, "99.2");
    QTest::keyClick(length, Qt::Key_Return);
    EXPECT_TRUE(text("sheetTrue").contains("24.80\u00a0mm")) << text("sheetTrue").toStdString();
    QTest::mouseClick(find<QPushButton>("sheetUse"), Qt::LeftButton);
    EXPECT_NEAR(measured.square_m, 0.0248, 1e-9);
    EXPECT_NEAR(measured.marker_m, 0.018 * 0.992, 1e-9);
    EXPECT_EQ(measured.columns, 5);

    double side_m = 0.0;
    std::vector<int> ids;
    QObject::connect(&panel, &SheetPanel::markersMeasured,
                     [&](const std::string&, const std::vector<int>& which, double side) {
                         ids = which;
                         side_m = side;
                     });
    panel.setMarkers("6X6_250", {1, 2, 7}, 0.05);
    EXPECT_TRUE(text("sheetTrue").contains("49.60\u00a0mm")) << text("sheetTrue").toStdString();
    QTest::mouseClick(find<QPushButton>("sheetUse"), Qt::LeftButton);
    EXPECT_NEAR(side_m, 0.0496, 1e-9);
    EXPECT_EQ(ids, (std::vector{1, 2, 7}));
}

// Catches: a file that is not the sheet, and a failure to write it without a word.
TEST_F(SheetPanelTest, SavesThePdf) {
    panel.setBoard({BoardKind::Chessboard, 9, 6, 0.025, 0.0, "", false});
    QSignalSpy exported(&panel, &SheetPanel::exported);
    panel.saveTo(folder.filePath("sheet.pdf"));
    ASSERT_EQ(exported.count(), 1);
    EXPECT_EQ(exported[0][1].toStringList(), QStringList{folder.filePath("sheet.pdf")});
    QFile file(folder.filePath("sheet.pdf"));
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_EQ(file.read(5), "%PDF-");
    EXPECT_TRUE(text("sheetProblem").startsWith("Saved."));
    panel.saveTo(folder.filePath("no/such/folder.pdf"));
    EXPECT_TRUE(text("sheetProblem").contains("cannot be written")) << text("sheetProblem").toStdString();
    EXPECT_EQ(exported.count(), 1);
}

// Catches: typing that waits for the preview of a full board on A3: cells united one by one would take
// minutes.
TEST_F(SheetPanelTest, AFullBoardIsDrawnAtOnce) {
    find<QComboBox>("sheetPaper")->setCurrentIndex(1);
    const double before_s = test::threadTime_s();
    panel.setBoard({BoardKind::Charuco, 20, 28, 0.0135, 0.01, "6X6_1000", false});
    (void)find<QWidget>("sheetPreview")->grab();
    EXPECT_EQ(text("sheetProblem"), "");
    const double took_s = test::threadTime_s() - before_s;
    RecordProperty("ms", static_cast<int>(1e3 * took_s));
    EXPECT_LT(took_s, 1.0);
}

// Catches a board of a command line that the form shows as another.
TEST(BoardForm, ShowsWhatABoardMayBe) {
    BoardForm form;
    for (const Board& board :
         {Board{BoardKind::Chessboard, kMinBoardSide, kMaxBoardSide, kMinSquare_m, 0.0, "", false},
          Board{BoardKind::Chessboard, 9, 6, kMaxSquare_m, 0.0, "", false},
          Board{BoardKind::Charuco, 5, 7, 0.001, 0.0005, "4X4_50", false},
          Board{BoardKind::Charuco, 5, 7, 0.04, 0.01125, "4X4_50", true}}) {
        form.setBoard(board);
        const auto shown = form.board();
        ASSERT_TRUE(shown) << describe(shown.error());
        EXPECT_EQ(boardText(*shown), boardText(board));
    }
}

} // namespace bask
