#include "widgets/objects/import_panel.h"

#include "engine/shape/hausdorff.h"
#include "tests/support/longer_translator.h"
#include "tests/support/wait_for.h"
#include "widgets/common/message_bar.h"
#include "widgets/common/theme.h"
#include "widgets/objects/outline_picker.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace bask {
namespace {

const QString kData = QStringLiteral(BASK_TEST_DATA "/contours/");
const QString kBunny = QStringLiteral(BASK_EXAMPLES "/contours/bunny_1200.png");

struct ImportPanelTest : testing::Test {
    QTemporaryDir folder;
    ImportPanel panel;
    QSignalSpy wanted{&panel, &ImportPanel::attentionWanted};
    QSignalSpy refused{&panel, &ImportPanel::refused};
    std::vector<PickedOutline> accepted;

    ImportPanelTest() {
        QObject::connect(&panel, &ImportPanel::accepted, &panel,
                         [this](const QString&, const PickedOutline& picked) { accepted.push_back(picked); });
        panel.resize(1100, 600);
        panel.show();
        QApplication::processEvents();
    }
    template <class T> T* child(const char* name) {
        auto* found = panel.findChild<T*>(name);
        EXPECT_NE(found, nullptr) << name;
        return found;
    }
    QTreeWidget* list() { return child<QTreeWidget>("importOutlines"); }
    QPushButton* import() { return child<QPushButton>("importAccept"); }
    QString problem() { return child<MessageBar>("importProblem")->sentence(); }
    void type(const char* name, const QString& text) {
        auto* box = child<QDoubleSpinBox>(name);
        ASSERT_TRUE(box->isVisible()) << name;
        box->setFocus();
        box->selectAll();
        QTest::keyClicks(box, text);
        QTest::keyClick(box, Qt::Key_Tab);
    }
    void choose(const char* name, int index) { child<QComboBox>(name)->setCurrentIndex(index); }
    bool outlines(int count) {
        return test::waitFor([&] { return list()->topLevelItemCount() == count; });
    }
    bool ready() {
        return test::waitFor([&] { return import()->isEnabled(); });
    }
    const PickedOutline& imported() {
        EXPECT_TRUE(ready()) << problem().toStdString();
        QTest::mouseClick(import(), Qt::LeftButton);
        EXPECT_EQ(accepted.size(), 1U);
        return accepted.back();
    }
    /// Where the canvas shows a pixel of a picture that is fitted into it.
    QPoint at(const QSize& picture, double x, double y) {
        auto* picker = child<OutlinePicker>("importPicker");
        const double scale = std::min((picker->width() - 36.0) / picture.width(),
                                      (picker->height() - 36.0) / picture.height());
        return QPointF(0.5 * picker->width() + scale * (x + 0.5 - 0.5 * picture.width()),
                       0.5 * picker->height() + scale * (y + 0.5 - 0.5 * picture.height()))
            .toPoint();
    }
    void clickAt(const QSize& picture, double x, double y) {
        QTest::mouseClick(child<OutlinePicker>("importPicker"), Qt::LeftButton, {}, at(picture, x, y));
    }
    QString saved(const QImage& image, const QString& name = QStringLiteral("photo.png")) {
        image.save(folder.filePath(name));
        return folder.filePath(name);
    }
};

// A red disk of radius 100 px and a blue one of 60 on a grey ground, anti-aliased.
QImage twoDisks() {
    QImage image(900, 500, QImage::Format_RGB32);
    image.fill(QColor(190, 190, 190));
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(200, 30, 30));
    painter.drawEllipse(QPointF(250.0, 250.0), 100.0, 100.0);
    painter.setBrush(QColor(30, 40, 200));
    painter.drawEllipse(QPointF(650.0, 250.0), 60.0, 60.0);
    return image;
}

// Catches a list whose unit nobody knows taken for anything but what is answered.
TEST_F(ImportPanelTest, AListWithoutAUnitAsksForIt) {
    panel.open(kData + "bunny_tab_noheader.txt");
    ASSERT_TRUE(test::waitFor([&] { return wanted.count() == 1; }));
    ASSERT_TRUE(outlines(1)) << "it is shown all the same";
    EXPECT_FALSE(import()->isEnabled());
    EXPECT_TRUE(list()->topLevelItem(0)->text(1).endsWith("units"));
    auto* unit = child<QComboBox>("importUnit");
    unit->setCurrentIndex(unit->findText("cm"));
    ASSERT_TRUE(ready());
    const auto cm =
        readContour((kData + "bunny_tab_noheader.txt").toStdString(), {.unit = LengthUnit::Centimetre});
    ASSERT_TRUE(cm);
    EXPECT_EQ(imported().contour, *cm);
    EXPECT_FALSE(panel.isOpen());
}

// Catches questions where there are none.
TEST_F(ImportPanelTest, WhatLeavesNothingToAskIsAcceptedAtOnce) {
    panel.open(kData + "svg/bunny_mm.svg");
    ASSERT_TRUE(test::waitFor([&] { return accepted.size() == 1; }));
    EXPECT_EQ(wanted.count(), 0);
    EXPECT_GT(contourArea(accepted[0].contour), 0.0);
    EXPECT_FALSE(panel.isOpen());
    panel.open(QStringLiteral(BASK_EXAMPLES "/contours/gear.svg"));
    ASSERT_TRUE(test::waitFor([&] { return accepted.size() == 2; }));
    EXPECT_EQ(accepted[1].holes.size(), 1U) << "a hole is no question";
    EXPECT_EQ(wanted.count(), 0);
}

// Catches a drawing of several outlines of which one is taken silently, and a choice that is not heeded.
TEST_F(ImportPanelTest, OneOfSeveralOutlinesIsPicked) {
    const QString path = kData + "dxf/square_and_circle_mm.dxf";
    const auto file = readOutlines(path.toStdString(), {});
    ASSERT_TRUE(file);
    ASSERT_GE(file->outlines.size(), 2U);
    panel.open(path);
    ASSERT_TRUE(outlines(static_cast<int>(file->outlines.size())));
    EXPECT_EQ(wanted.count(), 1);
    EXPECT_EQ(list()->currentIndex().row(), 0);
    list()->setCurrentItem(list()->topLevelItem(1));
    EXPECT_TRUE(child<QLabel>("importChosen")->text().contains("2"));
    EXPECT_NEAR(contourArea(imported().contour), file->outlines[1].area_m2(), 1e-12);
}

// Catches a picture that is imported at a scale nobody gave, and a ruler's length that is not heeded.
TEST_F(ImportPanelTest, AKnownLengthGivesThePictureItsScale) {
    panel.open(kBunny);
    EXPECT_EQ(wanted.count(), 1) << "a picture has its questions";
    ASSERT_TRUE(outlines(1));
    EXPECT_FALSE(import()->isEnabled());
    EXPECT_TRUE(list()->topLevelItem(0)->text(1).endsWith("px"));
    // The ruler begins across the outline: its box is as wide as is typed.
    type("importLength", "50");
    const Contour contour = imported().contour;
    double min_m = 1.0, max_m = -1.0;
    for (const auto& p : contour.points_m) {
        min_m = std::min(min_m, p.x());
        max_m = std::max(max_m, p.x());
    }
    EXPECT_NEAR(max_m - min_m, 0.05, 1e-5);
}

// Catches "answer the question above" where there are fields and no question, and a field without its unit.
TEST_F(ImportPanelTest, TheMissingLengthIsAskedForByItsField) {
    const auto asked = [this] { return child<QLabel>("importChosen")->text().toStdString(); };
    panel.open(kBunny);
    ASSERT_TRUE(outlines(1));
    EXPECT_EQ(asked(), "Its true size is not known yet: type the length of the ruler above.");
    EXPECT_EQ(child<QDoubleSpinBox>("importLength")->text().toStdString(), "\u2014 mm");
    const auto asksFor = [&](const char* words) {
        return test::waitFor([&] { return asked().ends_with(words); });
    };
    choose("importScaleMethod", 1);
    EXPECT_TRUE(asksFor("type the scale above.")) << asked();
    choose("importScaleMethod", 2);
    EXPECT_TRUE(asksFor("type the side of the marker\u2019s square above.")) << asked();
    panel.open(kData + "bunny_tab_noheader.txt");
    EXPECT_TRUE(asksFor("choose the unit above.")) << asked();
}

// Catches clicks that miss the picture's pixels, and ends that cannot be dragged.
TEST_F(ImportPanelTest, TheRulersEndsAreClickedAndDragged) {
    const QImage image = twoDisks();
    panel.open(saved(image));
    ASSERT_TRUE(outlines(2));
    QTest::mouseClick(child<QPushButton>("importMeasure"), Qt::LeftButton);
    clickAt(image.size(), 100.0, 100.0);
    clickAt(image.size(), 500.0, 400.0); // 500 px
    EXPECT_FALSE(child<QPushButton>("importMeasure")->isChecked());
    type("importLength", "50");
    ASSERT_TRUE(ready());
    clickAt(image.size(), 650.0, 250.0); // the blue disk
    EXPECT_EQ(list()->currentIndex().row(), 1);
    auto* picker = child<OutlinePicker>("importPicker");
    QTest::mousePress(picker, Qt::LeftButton, {}, at(image.size(), 500.0, 400.0));
    QTest::mouseMove(picker, at(image.size(), 200.0, 200.0));
    QTest::mouseMove(picker, at(image.size(), 100.0, 350.0)); // 250 px now
    QTest::mouseRelease(picker, Qt::LeftButton, {}, at(image.size(), 100.0, 350.0));
    ASSERT_TRUE(test::waitFor([&] { return list()->topLevelItem(1)->text(1).startsWith("24"); }))
        << list()->topLevelItem(1)->text(1).toStdString();
    EXPECT_EQ(list()->currentIndex().row(), 1) << "the choice stays";
    const double radius_m = 60.0 * 50e-3 / 250.0;
    EXPECT_NEAR(contourArea(imported().contour), std::numbers::pi * radius_m * radius_m,
                0.03 * std::numbers::pi * radius_m * radius_m); // a click hits to two pixels
}

// Catches a colour that is taken beside the pointer, or not used.
TEST_F(ImportPanelTest, AColourClickedTellsTheObject) {
    const QImage image = twoDisks();
    panel.open(saved(image));
    ASSERT_TRUE(outlines(2));
    child<QCheckBox>("importByColour")->click();
    EXPECT_TRUE(child<QPushButton>("importPickColour")->isChecked()) << "a click on the picture picks";
    clickAt(image.size(), 650.0, 250.0);
    ASSERT_TRUE(outlines(1)) << problem().toStdString();
    choose("importScaleMethod", 1);
    type("importScale", "10");
    EXPECT_NEAR(contourArea(imported().contour), std::numbers::pi * 36e-6, 0.01 * std::numbers::pi * 36e-6);
}

// Catches a marker that does not scale, and a wrong dictionary that leaves the operator without a word.
TEST_F(ImportPanelTest, AMarkerGivesThePictureItsScale) {
    QImage image(900, 600, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    constexpr const char* kRows[] = {"000000", "010110", "001010",
                                     "000110", "000100", "000000"}; // 0 of 4X4_50
    for (int row = 0; row < 6; ++row)
        for (int column = 0; column < 6; ++column)
            if (kRows[row][column] == '0')
                painter.fillRect(60 + 40 * column, 60 + 40 * row, 40, 40, Qt::black);
    painter.fillRect(500, 200, 240, 120, QColor(60, 60, 60));
    painter.end();
    panel.open(saved(image));
    choose("importScaleMethod", 2);
    type("importMarkerSide", "40");
    ASSERT_TRUE(ready()) << problem().toStdString();
    ASSERT_EQ(list()->topLevelItemCount(), 1) << "the marker is no object";
    choose("importDictionary", child<QComboBox>("importDictionary")->findText("6X6_250"));
    ASSERT_TRUE(test::waitFor([&] { return !problem().isEmpty(); }));
    EXPECT_FALSE(import()->isEnabled());
    choose("importDictionary", child<QComboBox>("importDictionary")->findText("4X4_50"));
    ASSERT_TRUE(ready());
    EXPECT_NEAR(contourArea(imported().contour), 0.04 * 0.02, 0.015 * 0.04 * 0.02); // steps of a whole pixel
}

// Catches Enter in the list that imports twice, the second time what is no longer there.
TEST_F(ImportPanelTest, EnterInTheListImportsOnce) {
    panel.open(kData + "dxf/square_and_circle_mm.dxf");
    ASSERT_TRUE(ready());
    QTest::keyClick(list(), Qt::Key_Return);
    EXPECT_EQ(accepted.size(), 1U);
    EXPECT_FALSE(panel.isOpen());
}

// Catches an outline that is imported in the scale before, while the file is read in the new one.
TEST_F(ImportPanelTest, NothingIsImportedWhileAnAnswerIsUnderWay) {
    panel.open(saved(twoDisks()));
    ASSERT_TRUE(outlines(2));
    choose("importScaleMethod", 1);
    type("importScale", "1");
    ASSERT_TRUE(ready());
    child<QDoubleSpinBox>("importScale")->setValue(10.0);
    list()->setCurrentItem(list()->topLevelItem(1));
    EXPECT_FALSE(import()->isEnabled());
    EXPECT_NEAR(contourArea(imported().contour), std::numbers::pi * 36e-6, 0.01 * std::numbers::pi * 36e-6);
}

// Catches a ruler that is drawn in one place and measures in another, when its second end is not clicked.
TEST_F(ImportPanelTest, ARulerLeftHalfLaidIsTheOneThatCounts) {
    const QImage image = twoDisks();
    panel.open(saved(image));
    ASSERT_TRUE(outlines(2));
    type("importLength", "50");
    ASSERT_TRUE(ready());
    QTest::mouseClick(child<QPushButton>("importMeasure"), Qt::LeftButton);
    clickAt(image.size(), 100.0, 100.0);
    auto* picker = child<OutlinePicker>("importPicker");
    const QPointF end = at(image.size(), 500.0, 400.0); // 500 px
    QMouseEvent move(QEvent::MouseMove, end, picker->mapToGlobal(end), Qt::NoButton, Qt::NoButton, {});
    QApplication::sendEvent(picker, &move);
    QTest::mouseClick(child<QPushButton>("importMeasure"), Qt::LeftButton); // never mind
    const double radius_m = 100.0 * 50e-3 / 500.0;
    EXPECT_NEAR(contourArea(imported().contour), std::numbers::pi * radius_m * radius_m,
                0.03 * std::numbers::pi * radius_m * radius_m);
}

// Catches a drawing whose size cannot be corrected, and one that is too large told only after the import.
TEST_F(ImportPanelTest, ADrawingsWidthCanBeTyped) {
    panel.open(kData + "svg/leaf_maple_mdi.svg"); // px: its size is a guess
    ASSERT_TRUE(outlines(1));
    ASSERT_TRUE(ready());
    const auto asItSays = readOutlines((kData + "svg/leaf_maple_mdi.svg").toStdString(), {});
    ASSERT_TRUE(asItSays);
    const double width_mm = child<QDoubleSpinBox>("importWidth")->value();
    type("importWidth", "5000");
    ASSERT_TRUE(test::waitFor([&] { return !problem().isEmpty(); }));
    EXPECT_FALSE(import()->isEnabled()) << "five metres";
    type("importWidth", "60");
    ASSERT_TRUE(ready());
    const double expected_m2 = asItSays->outlines[0].area_m2() * std::pow(60.0 / width_mm, 2);
    EXPECT_NEAR(contourArea(imported().contour), expected_m2, 1e-3 * expected_m2); // three digits are shown
}

// Catches a picture of which nothing is offered since one thing in it touches the border.
TEST_F(ImportPanelTest, WhatTouchesTheBorderIsLeftOutAndTold) {
    panel.open(kData + "coins.png");
    ASSERT_TRUE(test::waitFor([&] { return list()->topLevelItemCount() > 5; })) << problem().toStdString();
    EXPECT_TRUE(child<QLabel>("importWarnings")->text().contains("border"));
}

// Catches an Escape that loses the import where it was to end the picking, or that is not heard.
TEST_F(ImportPanelTest, EscapeEndsTheToolFirst) {
    panel.activateWindow();
    panel.open(saved(twoDisks()));
    ASSERT_TRUE(outlines(2));
    QTest::mouseClick(child<QPushButton>("importMeasure"), Qt::LeftButton);
    QTest::keyClick(list(), Qt::Key_Escape);
    EXPECT_TRUE(panel.isOpen());
    EXPECT_FALSE(child<QPushButton>("importMeasure")->isChecked());
    QTest::keyClick(list(), Qt::Key_Escape);
    EXPECT_FALSE(panel.isOpen());
}

// Catches a file forgotten that answers late, and the old file's outlines under the new one.
TEST_F(ImportPanelTest, CancelForgetsTheFile) {
    panel.open(kBunny);
    QTest::keyClick(&panel, Qt::Key_Escape);
    EXPECT_FALSE(panel.isOpen());
    panel.open(kData + "svg/cog_hole_mdi.svg");
    ASSERT_TRUE(test::waitFor([&] { return wanted.count() == 2; }));
    EXPECT_EQ(list()->topLevelItemCount(), 2);
    EXPECT_TRUE(list()->topLevelItem(1)->text(0).contains("hole"));
    EXPECT_TRUE(accepted.empty());
}

// Catches a broken file behind a panel in which nothing can mend it.
TEST_F(ImportPanelTest, WhatNoAnswerMendsIsRefused) {
    for (const char* name :
         {"svg/bad_truncated.svg", "dxf/no_entities.dxf", "bad_nan_row.csv", "empty.png"}) {
        const auto before = refused.count();
        panel.open(kData + name);
        ASSERT_TRUE(test::waitFor([&] { return refused.count() > before; })) << name;
        EXPECT_FALSE(panel.isOpen());
    }
    // The largest silhouette runs out of the picture: a colour may still tell the object.
    panel.open(kData + "hand_photo_border.jpg");
    ASSERT_TRUE(test::waitFor([&] { return !problem().isEmpty(); }));
    EXPECT_TRUE(panel.isOpen());
}

// Catches clipped text and colours that do not follow the theme; leaves pictures to be looked at.
TEST_F(ImportPanelTest, PictureInBothThemes) {
    for (const bool dark : {false, true}) {
        applyTheme(*qApp, dark ? Theme::Dark : Theme::Light);
        panel.open(saved(twoDisks()));
        ASSERT_TRUE(outlines(2));
        QApplication::processEvents();
        EXPECT_TRUE(panel.grab().save(dark ? "import_dark.png" : "import_light.png"));
        panel.open(kData + "svg/footprints_arcs.svg");
        ASSERT_TRUE(outlines(12));
        QApplication::processEvents();
        EXPECT_TRUE(panel.grab().save(dark ? "import_drawing_dark.png" : "import_drawing_light.png"));
    }
    applyTheme(*qApp, Theme::Light);
}

} // namespace
} // namespace bask
