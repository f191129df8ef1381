// The thermal picture as a person meets it: what is drawn where, what is said, what keys and mouse do.

#include "widgets/thermal/thermal_picture_view.h"

#include "tests/widgets/thermal/thermal_scene.h"
#include "widgets/common/display.h"
#include "widgets/common/quantity_spin_box.h"
#include "widgets/common/theme.h"
#include "widgets/thermal/thermal_canvas.h"
#include "widgets/thermal/thermal_histogram_plot.h"

#include <QAbstractButton>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QElapsedTimer>
#include <QHelpEvent>
#include <QLabel>
#include <QTableWidget>
#include <QTest>
#include <QTextDocumentFragment>
#include <QToolTip>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <stdexcept>

namespace bask {
namespace {

enum LimitsChoice { kOfObjects, kOfPicture, kOfAPerson };
enum IsothermChoice { kNone, kAbove, kNear };

template <class Widget> Widget& child(const QWidget& parent, const char* name) {
    auto* found = parent.findChild<Widget*>(QLatin1String(name));
    if (found == nullptr)
        throw std::out_of_range(name);
    return *found;
}

int distance(const QColor& a, const QColor& b) {
    return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue());
}

double& pixelOf(ThermalPicture& picture, int column, int row) {
    return picture.T_K[static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width) +
                       static_cast<std::size_t>(column)];
}

/// 40 x 30 pixels of 293.15 K, a square of 313.15 K at (10, 5) to (19, 14) with its outline.
ThermalView squareScene() {
    ThermalPicture picture{40, 30, std::vector<double>(1200, 293.15)};
    ThermalObjectView object;
    for (int row = 5; row < 15; ++row)
        for (int column = 10; column < 20; ++column) {
            object.pixels.push_back(40 * row + column);
            pixelOf(picture, column, row) = 313.15;
        }
    object.outline_px = {{9.5, 4.5}, {19.5, 4.5}, {19.5, 14.5}, {9.5, 14.5}};
    object.T_K = 314.15;
    object.uncertainty_K = 0.25;
    object.spread_K = 0.6;
    ThermalView view;
    view.cameraName = "lepton-3.5";
    view.picture = std::make_shared<ThermalPicture>(picture);
    view.time_s = 3.0;
    view.objects = {object};
    return view;
}

struct Shown {
    ThermalPictureView view;
    ThermalCanvas& canvas = child<ThermalCanvas>(view, "thermalCanvas");
    QTableWidget& list = child<QTableWidget>(view, "thermalObjects");

    explicit Shown(const ThermalView& first = squareScene(), QSize size = QSize(900, 600)) {
        view.setNames(test::kThermalNames);
        view.setView(first);
        view.resize(size);
        view.show();
        QCoreApplication::processEvents();
    }
    QPoint placeOf(int column, int row) const { return canvas.pixelRect({column, row}).center().toPoint(); }
    QImage drawn() { return canvas.grab().toImage(); }
    QColor colourAt(int column, int row) { return drawn().pixelColor(placeOf(column, row)); }
    void choose(const char* box, int index) { child<QComboBox>(view, box).setCurrentIndex(index); }
};

// Catches a picture that is stretched or mirrored, and an outline that is shifted against it.
TEST(ThermalPictureView, ThePictureKeepsItsShapeAndTheOutlineLiesOnIt) {
    for (const bool smooth : {true, false}) {
        Shown shown;
        child<QCheckBox>(shown.view, "thermalSmooth").setChecked(smooth);
        const QRectF place = shown.canvas.pictureRect();
        EXPECT_NEAR(place.width() / place.height(), 40.0 / 30.0, 0.01);
        if (!smooth) {
            EXPECT_EQ(std::fmod(place.width(), 40.0), 0.0) << "whole pixels";
        }
        const QColor hot =
            QColor::fromRgb(thermalRgb(313.15, {ThermalPalette::Inferno, shown.view.limits(), {}}));
        EXPECT_EQ(shown.colourAt(18, 12), hot);
        EXPECT_NE(shown.colourAt(30, 20), hot);
        const QImage image = shown.drawn();
        const auto isOutline = [&](double column,
                                   double row) { // or beside it, since a line may lie between two
            const QRectF pixel = shown.canvas.pixelRect({0, 0});
            const QPoint at =
                (place.topLeft() + QPointF((column + 0.5) * pixel.width(), (row + 0.5) * pixel.height()))
                    .toPoint();
            for (const QPoint beside : {QPoint(0, 0), QPoint(-1, 0), QPoint(0, -1)})
                if (distance(image.pixelColor(at + beside), seriesColor(0, true)) < 90)
                    return true;
            return false;
        };
        EXPECT_TRUE(isOutline(9.5, 12.0));
        EXPECT_TRUE(isOutline(15.0, 14.5));
        EXPECT_FALSE(isOutline(8.5, 12.0) || isOutline(15.0, 13.5));
    }
}

// Catches limits that the hot plate or single pixels set, and limits of a person that are not kept.
TEST(ThermalPictureView, LimitsAreTheObjectsThePicturesOrOnesOwn) {
    ThermalView scene = squareScene();
    auto picture = *scene.picture;
    for (int column = 0; column < 40; ++column)
        pixelOf(picture, column, 29) = 480.0; // a hot plate: 3 % of the picture
    picture.T_K[0] = 1500.0;                  // and one odd pixel
    picture.T_K[static_cast<std::size_t>(scene.objects[0].pixels[0])] = 303.15;
    scene.picture = std::make_shared<ThermalPicture>(picture);
    Shown shown(scene);
    EXPECT_NEAR(shown.view.limits().min_K, 302.15, 1e-9); // 303.15 to 313.15, a tenth more on either side
    EXPECT_NEAR(shown.view.limits().max_K, 314.15, 1e-9);
    shown.choose("thermalLimits", kOfPicture);
    EXPECT_NEAR(shown.view.limits().min_K, 293.15, 1e-9);
    EXPECT_NEAR(shown.view.limits().max_K, 480.0, 1e-9);
    shown.choose("thermalLimits", kOfAPerson); // begins with what was shown
    auto& min = child<QuantitySpinBox>(shown.view, "thermalMin");
    auto& max = child<QuantitySpinBox>(shown.view, "thermalMax");
    ASSERT_TRUE(min.isVisible() && max.isVisible());
    EXPECT_NEAR(shown.view.limits().max_K, 480.0, 0.06);
    max.setValue(50.0);
    min.setValue(90.0);
    EXPECT_NEAR(shown.view.limits().max_K, 323.15, 1e-9);
    EXPECT_NEAR(shown.view.limits().min_K, 322.15, 1e-9) << "the limits stay apart";
    shown.view.setView(squareScene());
    EXPECT_NEAR(shown.view.limits().max_K, 323.15, 1e-9);
    shown.view.setTemperatureUnit(TemperatureUnit::Fahrenheit);
    EXPECT_NEAR(max.value(), 122.0, 1e-9);
    EXPECT_NEAR(shown.view.limits().max_K, 323.15, 1e-9);
}

// Catches an isotherm that marks other pixels than it says.
TEST(ThermalPictureView, TheIsothermMarksItsPixels) {
    Shown shown;
    const QColor mark = QColor::fromRgb(kIsothermRgb);
    EXPECT_FALSE(child<QuantitySpinBox>(shown.view, "thermalIsothermAt").isVisible());
    shown.choose("thermalIsotherm", kAbove);
    auto& at = child<QuantitySpinBox>(shown.view, "thermalIsothermAt");
    EXPECT_TRUE(at.isVisible());
    at.setValue(30.0);
    EXPECT_EQ(shown.colourAt(18, 12), mark);
    EXPECT_NE(shown.colourAt(30, 20), mark);
    shown.choose("thermalIsotherm", kNear);
    EXPECT_NE(shown.colourAt(18, 12), mark) << "10 K above";
    at.setValue(20.3);
    EXPECT_EQ(shown.colourAt(30, 20), mark) << "0.3 K below";
    shown.choose("thermalIsotherm", kNone);
    EXPECT_NE(shown.colourAt(30, 20), mark);
}

// Catches a spot that reads a neighbour, or cannot be removed.
TEST(ThermalPictureView, TheSpotTellsThePixelUnderTheMouse) {
    Shown shown;
    EXPECT_TRUE(shown.canvas.spotText().isEmpty());
    QTest::mouseMove(&shown.canvas, shown.placeOf(19, 14));
    EXPECT_EQ(shown.canvas.spotText(), QStringLiteral("40.0\u00a0°C at column 19, row 14, circle"));
    EXPECT_EQ(shown.canvas.accessibleDescription(), shown.canvas.spotText());
    QTest::mouseMove(&shown.canvas, shown.placeOf(20, 14));
    EXPECT_EQ(shown.canvas.spotText(), QStringLiteral("20.0\u00a0°C at column 20, row 14"));

    QTest::mouseClick(&shown.canvas, Qt::LeftButton, {}, shown.placeOf(12, 7));
    QTest::mouseMove(&shown.canvas, shown.placeOf(30, 20));
    EXPECT_EQ(shown.canvas.spot(), QPoint(12, 7)) << "pinned";
    shown.view.setTemperatureUnit(TemperatureUnit::Fahrenheit);
    EXPECT_TRUE(shown.canvas.spotText().startsWith(QStringLiteral("104.0\u00a0°F")));
    shown.drawn();
    ASSERT_EQ(shown.canvas.labelRects().size(), 2U) << "the spot's and the object's";
    EXPECT_FALSE(shown.canvas.labelRects()[0].intersects(shown.canvas.labelRects()[1]));

    QTest::mouseClick(&shown.canvas, Qt::LeftButton, {}, shown.placeOf(12, 7));
    EXPECT_FALSE(shown.canvas.isPinned());
    QTest::mouseClick(&shown.canvas, Qt::LeftButton, {}, shown.placeOf(12, 7));
    QTest::keyClick(&shown.canvas, Qt::Key_Escape);
    EXPECT_FALSE(shown.canvas.isPinned());
    QTest::mouseClick(&shown.canvas, Qt::LeftButton, {}, shown.placeOf(39, 29));
    shown.view.setView([] {
        ThermalView smaller = squareScene();
        smaller.picture =
            std::make_shared<ThermalPicture>(ThermalPicture{4, 3, std::vector<double>(12, 300.0)});
        return smaller;
    }());
    EXPECT_FALSE(shown.canvas.isPinned()) << "that pixel is no more";
}

// Catches a spot that needs a mouse.
TEST(ThermalPictureView, KeysMoveTheSpot) {
    Shown shown;
    QTest::keyClick(&shown.canvas, Qt::Key_Right);
    EXPECT_EQ(shown.canvas.spot(), QPoint(19, 14)) << "begins in the middle";
    QTest::keyClick(&shown.canvas, Qt::Key_Right);
    QTest::keyClick(&shown.canvas, Qt::Key_Up);
    QTest::keyClick(&shown.canvas, Qt::Key_Down, Qt::ShiftModifier);
    EXPECT_EQ(shown.canvas.spot(), QPoint(20, 23));
    QTest::keyClick(&shown.canvas, Qt::Key_Down, Qt::ShiftModifier);
    EXPECT_EQ(shown.canvas.spot(), QPoint(20, 29)) << "stays in the picture";
    QTest::keyClick(&shown.canvas, Qt::Key_Escape);
    EXPECT_FALSE(shown.canvas.spot());
}

// Catches numbers that are not the view's, without units, or shown although they are not known.
TEST(ThermalPictureView, TheListTellsReadingsAndReasons) {
    ThermalView scene = squareScene();
    ThermalObjectView hidden;
    hidden.reason = {MessageCode::ThermalFaceOutside, {}};
    scene.objects.push_back(hidden);
    Shown shown(scene);
    ASSERT_EQ(shown.list.rowCount(), 4);
    EXPECT_EQ(shown.list.item(0, 1)->text(), QStringLiteral("20.0 to 40.0\u00a0°C"));
    EXPECT_EQ(shown.list.item(1, 0)->text(), QStringLiteral("circle"));
    EXPECT_EQ(shown.list.item(1, 1)->text(), QStringLiteral("41.0\u00a0°C ± 0.5\u00a0K"));
    EXPECT_EQ(shown.list.item(1, 2)->text(), QStringLiteral("0.6\u00a0K"));
    EXPECT_TRUE(shown.list.item(2, 1)->text().startsWith(QStringLiteral("It is not in the picture")));
    EXPECT_EQ(shown.list.item(3, 1)->text(), QStringLiteral("\u2014")) << "not in the view";
    shown.view.setTemperatureUnit(TemperatureUnit::Fahrenheit);
    EXPECT_EQ(shown.list.item(1, 1)->text(), QStringLiteral("105.8\u00a0°F ± 0.9\u00a0°F"));
    scene.objects[1].T_K = 300.0;
    scene.objects[1].uncertainty_K = 0.3;
    shown.view.setView(scene);
    EXPECT_EQ(shown.list.item(2, 2)->text(), QStringLiteral("\u2014")) << "too few pixels to tell";
    EXPECT_TRUE(shown.list.item(2, 1)->text().startsWith(QStringLiteral("80.3\u00a0°F")));
    EXPECT_EQ(shown.list.columnSpan(2, 1), 1);
}

// Catches a part of an object that passes for the whole.
TEST(ThermalPictureView, TheListMarksObjectsThatArePartlyOutside) {
    ThermalView scene = squareScene();
    scene.objects[0].isPartlyOutside = true;
    Shown shown(scene);
    EXPECT_EQ(shown.list.item(1, 1)->text(), QStringLiteral("41.0\u00a0°C ± 0.5\u00a0K (part)"));
    EXPECT_TRUE(shown.list.item(1, 1)->toolTip().contains(QStringLiteral("outside of the picture")));
    shown.view.setView(squareScene());
    EXPECT_EQ(shown.list.item(1, 1)->text(), QStringLiteral("41.0\u00a0°C ± 0.5\u00a0K"));
    EXPECT_TRUE(shown.list.item(1, 1)->toolTip().isEmpty());
}

// Catches pictures that are left out without a word, or without the reason.
TEST(ThermalPictureView, TheStatusCountsWhatWasLeftOut) {
    ThermalView scene = squareScene();
    Shown shown(scene);
    EXPECT_FALSE(shown.view.statusText().contains(QStringLiteral("left out")));
    auto& line = child<QLabel>(shown.view, "thermalStatus");
    const auto tip = [&line] {
        line.resize(40, line.height()); // too narrow for all of it
        QHelpEvent help(QEvent::ToolTip, line.rect().center(), line.mapToGlobal(line.rect().center()));
        QApplication::sendEvent(&line, &help);
        return QToolTip::text();
    };
    EXPECT_EQ(tip().trimmed(), line.text()); // statusText() is of this moment: its age may be 10 ms more
    scene.leftOut = {2, Error{MessageCode::ThermalPictureConstant, "/tmp/run/b.raw"}};
    shown.view.setView(scene);
    EXPECT_TRUE(shown.view.statusText().contains(QStringLiteral("2 picture(s) left out")));
    EXPECT_TRUE(tip().startsWith(line.text()));
    EXPECT_TRUE(tip().contains(QStringLiteral("Left out last: b.raw: all pixels"))) << tip().toStdString();
    QToolTip::hideText();
}

// Catches an uncertainty that is rounded to nothing.
TEST(ThermalPictureView, SmallUncertaintiesHaveADigitMore) {
    EXPECT_EQ(formatReading(300.0, 0.02, TemperatureUnit::Kelvin),
              QStringLiteral("300.00\u00a0K ± 0.04\u00a0K"));
    EXPECT_EQ(formatReading(300.0, 0.002, TemperatureUnit::Kelvin),
              QStringLiteral("300.000\u00a0K ± 0.004\u00a0K"));
}

// Catches an object that looks as if it were read.
TEST(ThermalPictureView, AnUnreadObjectIsDashedAndSaysWhy) {
    const auto outlinePixels = [](const QImage& image) {
        int count = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                count += image.pixelColor(x, y) == seriesColor(0, true) ? 1 : 0;
        return count;
    };
    ThermalView scene = squareScene();
    Shown shown(scene);
    const int solid = outlinePixels(shown.drawn());
    scene.objects[0].T_K.reset();
    scene.objects[0].reason = {MessageCode::ThermalPixelsSaturated, {"20", "100"}};
    shown.view.setView(scene);
    EXPECT_LT(outlinePixels(shown.drawn()), 0.8 * solid);
    EXPECT_GT(outlinePixels(shown.drawn()), 0.3 * solid);
    const QPoint place = shown.placeOf(15, 10);
    QHelpEvent help(QEvent::ToolTip, place, shown.canvas.mapToGlobal(place));
    QApplication::sendEvent(&shown.canvas, &help);
    EXPECT_TRUE(QToolTip::text().contains(QStringLiteral("20 of its 100 pixels")))
        << QToolTip::text().toStdString();
    QToolTip::hideText();
}

// Catches labels over each other, cut off at the picture's edge, or of objects that are not seen.
TEST(ThermalPictureView, LabelsStayApartAndInThePicture) {
    ThermalView crowd = squareScene();
    const ThermalObjectView one = crowd.objects[0];
    for (int i = 1; i < 7; ++i) {
        crowd.objects.push_back(one);
        for (Eigen::Vector2d& point : crowd.objects.back().outline_px)
            point += Eigen::Vector2d(7.0 * (i % 3) - 12.0, 6.0 * (i % 2) - 4.0);
    }
    crowd.objects.push_back(one);
    for (Eigen::Vector2d& point : crowd.objects.back().outline_px)
        point.x() += 500.0; // far outside
    crowd.objects.push_back(one);
    crowd.objects.back().outline_px.clear();
    for (const QSize size : {QSize(1280, 800), QSize(900, 600), QSize(700, 240), QSize(560, 200)}) {
        Shown shown(crowd, size);
        shown.drawn();
        const auto& labels = shown.canvas.labelRects();
        EXPECT_LE(labels.size(), 7U);
        EXPECT_GE(labels.size(), 1U);
        for (std::size_t i = 0; i < labels.size(); ++i) {
            EXPECT_TRUE(shown.canvas.pictureRect().contains(labels[i]));
            for (std::size_t k = i + 1; k < labels.size(); ++k)
                EXPECT_FALSE(labels[i].intersects(labels[k])) << size.width();
        }
    }
}

// Catches a picture of the past that is taken for a live one.
TEST(ThermalPictureView, AProblemOrAnOldPictureIsToldOverIt) {
    Shown shown;
    EXPECT_TRUE(shown.view.sentence().isEmpty());
    const int before = shown.colourAt(18, 12).lightness();
    ThermalView lost = squareScene();
    lost.problem = {MessageCode::CameraLost, {"lepton-3.5", "unplugged"}};
    shown.view.setView(lost);
    EXPECT_TRUE(shown.view.sentence().contains(QStringLiteral("unplugged")));
    EXPECT_EQ(shown.canvas.accessibleDescription(), shown.view.sentence());
    EXPECT_LT(shown.colourAt(18, 12).lightness(), before);
    EXPECT_TRUE(shown.canvas.labelRects().empty());
    EXPECT_EQ(shown.list.item(1, 1)->text(), QStringLiteral("\u2014")) << "not the last number";

    ThermalView old = squareScene();
    old.age_s = 5.0;
    shown.view.setView(old);
    EXPECT_EQ(shown.view.sentence(), QStringLiteral("This picture is 5 s old."));
    old.age_s = ThermalPictureView::kOldAfter_s - 0.2;
    shown.view.setView(old);
    EXPECT_TRUE(shown.view.sentence().isEmpty());
    EXPECT_TRUE(
        QTest::qWaitFor([&] { return shown.list.item(1, 1)->text() == QStringLiteral("\u2014"); }, 3000))
        << "it grows old although no other comes";
    EXPECT_FALSE(shown.view.sentence().isEmpty());

    shown.view.setView({});
    EXPECT_EQ(shown.view.sentence(), QStringLiteral("The thermal camera has not given a picture yet."));
    EXPECT_TRUE(shown.view.statusText().isEmpty());
}

// Catches a replay that is hatched as if its camera had stopped.
TEST(ThermalPictureView, ARecordedPictureDoesNotGrowOld) {
    ThermalPictureView widget;
    widget.setRecorded();
    EXPECT_FALSE(widget.sentence().isEmpty());
    ThermalView view = test::thermalScene();
    view.age_s = 1000.0;
    widget.setView(view);
    EXPECT_EQ(widget.sentence(), QString());
    EXPECT_TRUE(widget.statusText().startsWith("taken at 0:12")) << widget.statusText().toStdString();
}

// Catches a line below the picture that leaves out what it is to tell.
TEST(ThermalPictureView, TheStatusTellsCameraSizeRateAndAge) {
    Shown shown;
    ThermalView next = squareScene();
    for (int k = 1; k < 5; ++k) {
        next.time_s = 3.0 + 0.125 * k;
        next.age_s = 0.21;
        shown.view.setView(next);
        shown.view.setView(next); // the same again
    }
    for (const char* part : {"lepton-3.5", "40 × 30", "8.0 pictures/s", "age 0.2"})
        EXPECT_TRUE(shown.view.statusText().contains(QString::fromUtf8(part)))
            << part << ": " << shown.view.statusText().toStdString();
}

// Catches pixels without a temperature that look like cold or hot ones, or spoil the limits.
TEST(ThermalPictureView, PixelsWithoutATemperatureHaveTheirOwnColours) {
    ThermalView scene = squareScene();
    auto picture = *scene.picture;
    const std::pair<int, double> odd[] = {{25, test::kInfinity}, {28, -test::kInfinity}, {31, test::kNaN}};
    for (const auto& [from, value] : odd)
        for (int column = from; column < from + 3; ++column)
            for (int row = 20; row < 23; ++row)
                pixelOf(picture, column, row) = value;
    scene.picture = std::make_shared<ThermalPicture>(picture);
    Shown shown(scene);
    child<QCheckBox>(shown.view, "thermalSmooth").setChecked(false);
    EXPECT_EQ(shown.colourAt(26, 21), QColor::fromRgb(kSaturatedRgb));
    EXPECT_EQ(shown.colourAt(29, 21), QColor::fromRgb(kBelowRgb));
    EXPECT_NE(shown.colourAt(32, 21), shown.colourAt(33, 21)) << "a chessboard";
    const auto legend = [&shown] {
        const QString text = child<QLabel>(shown.view, "thermalLegend").text();
        return QTextDocumentFragment::fromHtml(text).toPlainText().simplified(); // no-break spaces too
    };
    EXPECT_EQ(legend(), QStringLiteral("\u25a0 saturated 9 \u25a0 below range 9 \u25a8 no value 9"));
    QTest::mouseMove(&shown.canvas, shown.placeOf(26, 21));
    EXPECT_TRUE(shown.canvas.spotText().startsWith(QStringLiteral("saturated at")));
    shown.choose("thermalLimits", kOfPicture);
    EXPECT_TRUE(std::isfinite(shown.view.limits().min_K) && std::isfinite(shown.view.limits().max_K));
    shown.view.setView(squareScene());
    EXPECT_TRUE(legend().isEmpty());
}

// Catches sizes and contents that crash it.
TEST(ThermalPictureView, OddPicturesAreDrawn) {
    const auto of = [](int width, int height, double T_K) {
        ThermalView view = squareScene();
        const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
        view.picture =
            std::make_shared<ThermalPicture>(ThermalPicture{width, height, std::vector<double>(pixels, T_K)});
        return view;
    };
    Shown shown;
    for (const ThermalView& view : {of(1, 1, 300.0), of(1024, 768, 300.0), of(1024, 768, test::kNaN),
                                    of(3, 500, test::kInfinity), of(500, 2, -test::kInfinity)})
        for (const bool changed : {true, false, true}) {
            child<QCheckBox>(shown.view, "thermalZoom").setChecked(changed);
            child<QCheckBox>(shown.view, "thermalSmooth").setChecked(changed);
            shown.view.setView(view);
            QTest::mouseClick(&shown.canvas, Qt::LeftButton, {},
                              shown.canvas.pictureRect().center().toPoint());
            shown.view.grab();
            EXPECT_TRUE(shown.view.sentence().isEmpty());
        }
    ThermalView broken = of(8, 8, 300.0);
    broken.picture = std::make_shared<ThermalPicture>(ThermalPicture{9, 9, std::vector<double>(64, 300.0)});
    shown.view.setView(broken);
    shown.view.grab();
    EXPECT_FALSE(shown.view.sentence().isEmpty()) << "fewer pixels than its size says";
    ThermalView bare = squareScene();
    bare.objects.clear();
    shown.view.setNames({});
    shown.view.setView(bare);
    shown.view.grab();
    EXPECT_EQ(shown.list.rowCount(), 1);
    EXPECT_NEAR(shown.view.limits().max_K, 313.15, 1e-9) << "without objects the picture's limits";
}

// Catches a histogram of other pixels than the chosen object's.
TEST(ThermalPictureView, TheHistogramIsOfWhatIsChosen) {
    Shown shown;
    auto& plot = child<ThermalHistogramPlot>(shown.view, "thermalHistogram");
    EXPECT_TRUE(plot.title().startsWith(QStringLiteral("Whole picture: 1200")));
    shown.list.selectRow(1);
    EXPECT_TRUE(plot.title().startsWith(QStringLiteral("circle: 100")));
    EXPECT_EQ(plot.summary(), QStringLiteral("mean 40.00\u00a0°C"));
    shown.view.setTemperatureUnit(TemperatureUnit::Kelvin);
    EXPECT_TRUE(plot.summary().startsWith(QStringLiteral("mean 313.15\u00a0K")));
    shown.list.selectRow(2); // which the view does not have
    EXPECT_EQ(plot.title(), QStringLiteral("bunny"));
}

// Catches a zoom that cuts an object off, or follows each of its pixels.
TEST(ThermalPictureView, ZoomShowsTheObjectsLarge) {
    Shown shown;
    child<QCheckBox>(shown.view, "thermalZoom").setChecked(true);
    const QRect zoomed = shown.canvas.shownPixels();
    EXPECT_TRUE(zoomed.contains(QRect(9, 4, 12, 12)));
    EXPECT_LT(zoomed.width(), 34);
    EXPECT_EQ(shown.canvas.spot(), std::nullopt);
    QTest::mouseMove(&shown.canvas, shown.placeOf(12, 7));
    EXPECT_EQ(shown.canvas.spot(), QPoint(12, 7));
    ThermalView moved = squareScene();
    for (Eigen::Vector2d& point : moved.objects[0].outline_px)
        point += Eigen::Vector2d(1.0, 1.0);
    shown.view.setView(moved);
    EXPECT_EQ(shown.canvas.shownPixels(), zoomed);
    child<QCheckBox>(shown.view, "thermalZoom").setChecked(false);
    EXPECT_EQ(shown.canvas.shownPixels(), QRect(0, 0, 40, 30));
}

// Catches work for pictures that nobody sees.
TEST(ThermalPictureView, WhileHiddenItOnlyKeepsTheNewest) {
    Shown shown;
    shown.view.hide();
    ThermalView hot = squareScene();
    auto picture = *hot.picture;
    for (double& T_K : picture.T_K)
        T_K += 100.0;
    hot.picture = std::make_shared<ThermalPicture>(picture);
    shown.view.setView(hot);
    EXPECT_LT(shown.view.limits().max_K, 320.0);
    shown.view.show();
    EXPECT_GT(shown.view.limits().max_K, 400.0);
}

// Catches controls that a screen reader or a test cannot name.
TEST(ThermalPictureView, EveryControlHasAName) {
    Shown shown;
    shown.choose("thermalLimits", kOfAPerson);
    shown.choose("thermalIsotherm", kAbove);
    int named = 0;
    for (const QWidget* widget : shown.view.findChildren<QWidget*>()) {
        if (!(widget->focusPolicy() & Qt::TabFocus) || widget->inherits("QComboBoxListView") ||
            widget->objectName().startsWith(QStringLiteral("qt_")))
            continue;
        const auto* button = qobject_cast<const QAbstractButton*>(widget);
        EXPECT_TRUE(!widget->accessibleName().isEmpty() || (button != nullptr && !button->text().isEmpty()))
            << widget->objectName().toStdString() << " " << widget->metaObject()->className();
        EXPECT_FALSE(widget->objectName().isEmpty()) << widget->metaObject()->className();
        ++named;
    }
    EXPECT_GE(named, 10);
}

// Catches work that a camera of 25 pictures a second does not leave time for. The least of several, for other
// programs take their share.
TEST(ThermalPictureView, APictureTakesAFewMilliseconds) {
    for (const int enlarged : {1, 4}) { // 256 x 192 and 1024 x 768
        ThermalView scene = test::thermalScene();
        const ThermalPicture small = *scene.picture;
        ThermalPicture picture{enlarged * small.width, enlarged * small.height, {}};
        for (int row = 0; row < picture.height; ++row)
            for (int column = 0; column < picture.width; ++column)
                picture.T_K.push_back(small.at(column / enlarged, row / enlarged));
        scene.picture = std::make_shared<ThermalPicture>(picture);
        Shown shown(scene, QSize(1280, 800));
        QImage image(shown.canvas.size(), QImage::Format_ARGB32_Premultiplied);
        double set_ms = 1e9, paint_ms = 1e9, again_ms = 1e9;
        for (int k = 0; k < 20; ++k) {
            scene.time_s += 0.04;
            scene.objects[0].T_K = 312.0 + 0.1 * k;
            QElapsedTimer timer;
            timer.start();
            shown.view.setView(scene);
            set_ms = std::min(set_ms, 1e-6 * static_cast<double>(timer.nsecsElapsed()));
            for (double* least_ms : {&paint_ms, &again_ms}) {
                timer.start();
                shown.canvas.render(&image);
                *least_ms = std::min(*least_ms, 1e-6 * static_cast<double>(timer.nsecsElapsed()));
            }
        }
        std::printf("%d x %d: set in %.2f ms, painted in %.2f ms, again in %.2f ms\n", picture.width,
                    picture.height, set_ms, paint_ms, again_ms);
        if (enlarged == 1) {
            EXPECT_LT(set_ms + paint_ms, 40.0) << "7 ms on an idle machine";
        }
    }
}

// Keeps pictures in both themes, as large as on the Calibrate page and as low as on the Run page.
TEST(ThermalPictureView, Pictures) {
    const ThermalView scene = test::thermalScene();
    for (const bool dark : {false, true}) {
        applyTheme(*qApp, dark ? Theme::Dark : Theme::Light);
        ThermalPictureView view;
        view.setNames(test::kThermalNames);
        view.show();
        const auto keep = [&](const QString& what, QSize size) {
            view.resize(size);
            QCoreApplication::processEvents();
            EXPECT_TRUE(
                view.grab().save(QStringLiteral("thermal_%1_%2.png").arg(what, dark ? "dark" : "light")));
        };
        constexpr QSize kLarge(1280, 800), kLow(880, 240), kNarrow(560, 240);
        keep("none", kLow);
        view.setView(scene);
        keep("large", kLarge);
        keep("low", kLow);
        keep("narrow", kNarrow);
        view.setView(test::thermalScene(1.1));
        keep("far", kLow);
        child<QCheckBox>(view, "thermalZoom").setChecked(true);
        keep("zoomed", kLow);
        child<QCheckBox>(view, "thermalZoom").setChecked(false);

        ThermalView odd = scene;
        auto picture = *scene.picture;
        for (int row = 0; row < 24; ++row)
            for (int column = 0; column < 60; ++column)
                pixelOf(picture, column, row) = column < 20   ? test::kInfinity
                                                : column < 40 ? -test::kInfinity
                                                              : test::kNaN;
        odd.picture = std::make_shared<ThermalPicture>(picture);
        view.setView(odd);
        child<QComboBox>(view, "thermalLimits").setCurrentIndex(1);
        child<QComboBox>(view, "thermalIsotherm").setCurrentIndex(1);
        child<QTableWidget>(view, "thermalObjects").selectRow(2);
        auto& canvas = child<ThermalCanvas>(view, "thermalCanvas");
        view.resize(kLarge);
        QCoreApplication::processEvents();
        QTest::mouseClick(&canvas, Qt::LeftButton, {}, canvas.pixelRect({84, 121}).center().toPoint());
        QTest::mouseMove(&canvas, canvas.pixelRect({150, 90}).center().toPoint());
        keep("marked", kLarge);
        child<QComboBox>(view, "thermalLimits").setCurrentIndex(2);
        child<QComboBox>(view, "thermalPalette").setCurrentIndex(1);
        child<QCheckBox>(view, "thermalSmooth").setChecked(false);
        keep("marked_low", kNarrow);
        odd.problem = {MessageCode::CameraLost, {"thermal camera", "no answer from the device"}};
        view.setView(odd);
        keep("lost", kLarge);
        keep("lost_low", kLow);
    }
    applyTheme(*qApp, Theme::Light);
}

} // namespace
} // namespace bask
