#include "widgets/plots/trace_plot.h"

#include "engine/recording/recorded_session.h"

#include "tests/support/thread_time.h"
#include "tests/support/wait_for.h"

#include "widgets/common/language.h"
#include "widgets/common/theme.h"

#include <QApplication>
#include <QImage>
#include <QLabel>
#include <QPen>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QWheelEvent>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

using namespace bask;

namespace {

std::vector<TraceSample> warmUp(int samples, double period_s = 1.0, double start_s = 0.0) {
    std::vector<TraceSample> out;
    for (int k = 0; k < samples; ++k) {
        TraceSample sample;
        sample.time_s = start_s + period_s * (k + 1);
        for (int i = 0; i < 3; ++i) {
            ObjectSample object;
            object.target_K = 313.15;
            object.measured_K =
                313.15 - 15.0 * std::exp(-sample.time_s / (40.0 + 20.0 * i)) + 0.05 * std::sin(3.0 * k + i);
            object.rate_K_s = 0.01;
            object.viewFactor = 0.3 + 0.05 * i;
            object.lambda1 = 0.2;
            object.valid = true;
            sample.objects.push_back(object);
        }
        out.push_back(sample);
    }
    return out;
}

const QStringList kNames{QStringLiteral("circle"), QStringLiteral("bunny"), QStringLiteral("hand")};

QWidget* canvasOf(TracePlot& plot) {
    return plot.findChild<QWidget*>(QStringLiteral("tracePlotCanvas"));
}

void wheel(QWidget* target, int angle, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    const QPointF at(target->width() * 0.5, target->height() * 0.4);
    QWheelEvent event(at, target->mapToGlobal(at), {}, {0, angle}, Qt::NoButton, modifiers, Qt::NoScrollPhase,
                      false);
    QCoreApplication::sendEvent(target, &event);
}

/// Warms from 25 to 40 °C, settles at 200 s and goes on until 320 s.
PredictedRun predictedWarmUp() {
    PredictedRun run;
    for (int k = 0; k <= 160; ++k) {
        PredictedSample sample;
        sample.time_s = 2.0 * k;
        for (int i = 0; i < 3; ++i)
            sample.temperatures_K.push_back(313.15 - 15.0 * std::exp(-sample.time_s / (40.0 + 20.0 * i)));
        run.samples.push_back(sample);
    }
    run.settling_s = 200.0;
    return run;
}

/// The pens of lines in the order in which they are drawn; of measured ones only, or of all the others.
std::vector<QPen> pensOf(TracePlot& plot, bool measured) {
    std::vector<QPen> pens;
    for (const QObject* child : canvasOf(plot)->children())
        if (child->inherits("QCPGraph") && kNames.contains(child->property("name").toString()) == measured)
            pens.push_back(child->property("pen").value<QPen>());
    return pens;
}

struct ShownPlot {
    TracePlot plot;
    explicit ShownPlot(Quantity quantity = Quantity::Temperature) : plot(quantity) {
        plot.setObjects(kNames);
        plot.resize(800, 320);
        plot.show();
        QCoreApplication::processEvents();
    }
};

} // namespace

// Catches axes and cursors in the notation of the language before.
TEST(TracePlot, ItsNumbersFollowTheLanguage) {
    Language language;
    ShownPlot shown;
    shown.plot.append(warmUp(50));
    const QWidget* canvas = canvasOf(shown.plot);
    for (const char* code : {"fr", "en", "fr"}) {
        language.set(QLatin1String(code));
        const QString mark =
            QLatin1String(code) == QLatin1String("fr") ? QStringLiteral(",") : QStringLiteral(".");
        EXPECT_EQ(canvas->locale().decimalPoint(), mark);
        const QString readout = shown.plot.readout(30.0);
        EXPECT_TRUE(readout.contains(QRegularExpression(QStringLiteral("\\d\\%1\\d").arg(mark))))
            << readout.toStdString();
    }
}

// Catches samples lost between the engine and the trace, and a wrong unit.
TEST(TracePlot, ContainsEverySampleInTheDisplayUnit) {
    ShownPlot shown;
    const auto samples = warmUp(120);
    shown.plot.append({samples.begin(), samples.begin() + 50});
    shown.plot.append({samples.begin() + 50, samples.end()});
    ASSERT_EQ(shown.plot.seriesCount(), 3);
    EXPECT_EQ(shown.plot.seriesName(1), QStringLiteral("bunny"));
    const auto points = shown.plot.seriesPoints(1);
    ASSERT_EQ(points.size(), 120);
    EXPECT_NEAR(points[70].y(), samples[70].objects[1].measured_K - 273.15, 1e-9);
    EXPECT_EQ(shown.plot.valueAxisLabel(), QStringLiteral("Temperature (°C)"));

    shown.plot.setTemperatureUnit(TemperatureUnit::Fahrenheit);
    EXPECT_NEAR(shown.plot.seriesPoints(1)[70].y(), (samples[70].objects[1].measured_K - 273.15) * 1.8 + 32.0,
                1e-9);
    EXPECT_EQ(shown.plot.valueAxisLabel(), QStringLiteral("Temperature (°F)"));
    EXPECT_GT(shown.plot.visibleHighest(), 104.0) << "the target is in view";
    EXPECT_LT(shown.plot.visibleLowest(), 80.0);
}

// Catches the title of an axis that is cut where a plot is low.
TEST(TracePlot, TheTitleOfALowAxisIsItsUnit) {
    ShownPlot shown, speed(Quantity::Speed);
    for (TracePlot* plot : {&shown.plot, &speed.plot}) {
        plot->append(warmUp(20));
        EXPECT_TRUE(test::waitFor([&] { return plot->shownAxisLabel() == plot->valueAxisLabel(); }));
        plot->resize(800, 100);
        EXPECT_TRUE(test::waitFor([&] { return plot->shownAxisLabel() != plot->valueAxisLabel(); }));
    }
    EXPECT_EQ(shown.plot.shownAxisLabel(), QStringLiteral("°C"));
    EXPECT_EQ(speed.plot.shownAxisLabel(), QStringLiteral("%"));
}

// Catches a name in the ink of the theme before: black on black.
TEST(TracePlot, NamesOfTheRunsLinesFollowTheTheme) {
    ShownPlot shown(Quantity::Speed);
    shown.plot.append(warmUp(20));
    for (const Theme theme : {Theme::Dark, Theme::Light}) {
        applyTheme(*qApp, theme);
        QCoreApplication::processEvents();
        int seen = 0;
        for (const QObject* item : canvasOf(shown.plot)->children()) {
            if (!item->inherits("QCPItemText") ||
                item->property("text").toString() != TracePlot::tr("translation"))
                continue;
            ++seen;
            EXPECT_EQ(item->property("color").value<QColor>(),
                      themePalette(theme == Theme::Dark).color(QPalette::Text));
        }
        EXPECT_EQ(seen, 1);
    }
}

// Catches an invalid reading drawn as a value or as a line across the gap.
TEST(TracePlot, InvalidSamplesLeaveAGap) {
    ShownPlot shown;
    auto samples = warmUp(60);
    for (int k = 20; k < 40; ++k) {
        samples[static_cast<std::size_t>(k)].objects[0].valid = false;
        samples[static_cast<std::size_t>(k)].objects[0].measured_K = 0.0;
    }
    shown.plot.setSamples(samples);
    const auto points = shown.plot.seriesPoints(0);
    ASSERT_EQ(points.size(), 60);
    EXPECT_TRUE(std::isfinite(points[19].y()));
    EXPECT_TRUE(std::isnan(points[20].y()));
    EXPECT_TRUE(std::isnan(points[39].y()));
    EXPECT_GT(shown.plot.visibleLowest(), 10.0) << "the scale does not go to absolute zero";
    EXPECT_TRUE(shown.plot.readout(30.0).contains(QStringLiteral("circle \u2014")));
    EXPECT_FALSE(shown.plot.grab().isNull());
}

// Catches a zoomed view that is torn away by the next sample, and samples lost meanwhile.
TEST(TracePlot, ZoomingStopsFollowingAndLosesNothing) {
    ShownPlot shown;
    QSignalSpy follows(&shown.plot, &TracePlot::followLiveChanged);
    shown.plot.append(warmUp(200));
    EXPECT_TRUE(shown.plot.followsLive());
    EXPECT_DOUBLE_EQ(shown.plot.visibleTo_s(), 200.0);

    wheel(canvasOf(shown.plot), 120);
    EXPECT_FALSE(shown.plot.followsLive());
    ASSERT_EQ(follows.count(), 1);
    const double from_s = shown.plot.visibleFrom_s(), to_s = shown.plot.visibleTo_s();
    EXPECT_LT(to_s - from_s, 170.0);

    shown.plot.append(warmUp(40, 1.0, 200.0));
    EXPECT_DOUBLE_EQ(shown.plot.visibleFrom_s(), from_s);
    EXPECT_DOUBLE_EQ(shown.plot.visibleTo_s(), to_s);
    EXPECT_NEAR(shown.plot.behind_s(), 240.0 - to_s, 1e-9);
    EXPECT_EQ(shown.plot.seriesPoints(0).size(), 240);

    QTest::keyClick(&shown.plot, Qt::Key_End);
    EXPECT_TRUE(shown.plot.followsLive());
    EXPECT_DOUBLE_EQ(shown.plot.visibleTo_s(), 240.0);
    EXPECT_DOUBLE_EQ(shown.plot.behind_s(), 0.0);
}

TEST(TracePlot, DraggingStopsFollowing) {
    ShownPlot shown;
    shown.plot.append(warmUp(200));
    QWidget* canvas = canvasOf(shown.plot);
    const QPoint centre = canvas->rect().center();
    QTest::mousePress(canvas, Qt::LeftButton, Qt::NoModifier, centre);
    QTest::mouseMove(canvas, centre + QPoint(60, 0));
    QTest::mouseMove(canvas, centre + QPoint(120, 0));
    QTest::mouseRelease(canvas, Qt::LeftButton, Qt::NoModifier, centre + QPoint(120, 0));
    EXPECT_FALSE(shown.plot.followsLive());
    EXPECT_LT(shown.plot.visibleTo_s(), 200.0);
}

// Catches Ctrl+wheel (values) that turns the live view off or zooms time.
TEST(TracePlot, ValueZoomKeepsTime) {
    ShownPlot shown;
    shown.plot.append(warmUp(200));
    const double before = shown.plot.visibleHighest() - shown.plot.visibleLowest();
    wheel(canvasOf(shown.plot), 120, Qt::ControlModifier);
    EXPECT_TRUE(shown.plot.followsLive());
    EXPECT_LT(shown.plot.visibleHighest() - shown.plot.visibleLowest(), before);
}

TEST(TracePlot, FollowWindowShowsTheLastStretch) {
    ShownPlot shown;
    shown.plot.append(warmUp(200));
    shown.plot.setFollowWindow_s(60.0);
    EXPECT_DOUBLE_EQ(shown.plot.visibleFrom_s(), 140.0);
    EXPECT_DOUBLE_EQ(shown.plot.visibleTo_s(), 200.0);
}

TEST(TracePlot, QuantitiesAndTheirUnits) {
    ShownPlot shown(Quantity::Error);
    shown.plot.setSpeedLimits({0.02, 0.1});
    auto samples = warmUp(10);
    for (auto& sample : samples)
        sample.twist << 0.01, 0, 0, 0.1, 0, 0;
    shown.plot.setSamples(samples);
    EXPECT_EQ(shown.plot.valueAxisLabel(), QStringLiteral("Error (K)"));
    EXPECT_NEAR(shown.plot.seriesPoints(2)[4].y(), samples[4].objects[2].measured_K - 313.15, 1e-9);
    shown.plot.setQuantity(Quantity::Rate);
    EXPECT_NEAR(shown.plot.seriesPoints(2)[4].y(), 0.6, 1e-9) << "K/min";
    shown.plot.setQuantity(Quantity::Speed);
    ASSERT_EQ(shown.plot.seriesCount(), 2);
    EXPECT_NEAR(shown.plot.seriesPoints(0)[4].y(), 50.0, 1e-9) << "percent of the limit";
    EXPECT_NEAR(shown.plot.seriesPoints(1)[4].y(), 100.0, 1e-9);
    EXPECT_TRUE(shown.plot.readout(5.0).contains(QStringLiteral("1.00 cm/s")));
    shown.plot.setQuantity(Quantity::ViewFactor);
    EXPECT_NEAR(shown.plot.seriesPoints(1)[4].y(), 0.35, 1e-9);
}

// Catches a difference without its two values, one that is taken from where nothing was read, and a small one
// that is rounded away.
TEST(TracePlot, TwoCursorsTellBothValuesAndTheDifference) {
    ShownPlot shown;
    auto samples = warmUp(20);
    for (std::size_t k = 0; k < samples.size(); ++k) {
        samples[k].objects[0].measured_K = 294.15 + static_cast<double>(k);
        samples[k].objects[0].lambda1 = 0.01 * static_cast<double>(k + 1);
    }
    samples[2].objects[1].valid = false;
    shown.plot.setSamples(samples);
    const auto told = [&](double time_s, double pinned_s) { return shown.plot.readout(time_s, pinned_s); };
    EXPECT_TRUE(told(12.0, 4.0).startsWith(QStringLiteral("0:04.0 \u2192 0:12.0 (\u0394 +8.0\u00a0s)")))
        << told(12.0, 4.0).toStdString();
    EXPECT_TRUE(told(12.0, 4.0).contains(
        QStringLiteral("circle 24.0\u00a0\u00b0C \u2192 32.0\u00a0\u00b0C (\u0394 +8.0\u00a0K)")))
        << told(12.0, 4.0).toStdString();
    EXPECT_TRUE(told(2.0, 4.0).contains(QStringLiteral("(\u0394 \u22122.0\u00a0K)")))
        << told(2.0, 4.0).toStdString();
    EXPECT_TRUE(told(12.0, 3.0).contains(QStringLiteral("bunny \u2014 \u2192")));
    EXPECT_TRUE(shown.plot.readout(12.0).contains(QStringLiteral("circle 32.0")));
    EXPECT_FALSE(shown.plot.readout(12.0).contains(QStringLiteral("\u0394")));
    shown.plot.setQuantity(Quantity::Strength);
    EXPECT_TRUE(told(12.0, 4.0).contains(QStringLiteral("(\u0394 +0.08"))) << told(12.0, 4.0).toStdString();
}

// Catches 21.0 and 21.1 whose difference is told as +0.0, and times that are whole seconds beside tenths.
TEST(TracePlot, TheDifferenceOfTwoCursorsIsThatOfTheirNumbers) {
    ShownPlot shown;
    auto samples = warmUp(20);
    for (TraceSample& sample : samples) {
        sample.objects[0].measured_K = kelvinFromCelsius(21.04);
        sample.objects[0].lambda1 = 0.1204;
    }
    samples[12].time_s += 0.4;
    samples[12].objects[0].measured_K = kelvinFromCelsius(21.06);
    samples[12].objects[0].lambda1 = 0.1206;
    shown.plot.setSamples(samples);
    const QString told = shown.plot.readout(samples[12].time_s, samples[4].time_s);
    EXPECT_TRUE(told.startsWith(QStringLiteral("0:05.0 \u2192 0:13.4 (\u0394 +8.4\u00a0s)")))
        << told.toStdString();
    EXPECT_TRUE(told.contains(
        QStringLiteral("circle 21.04\u00a0\u00b0C \u2192 21.06\u00a0\u00b0C (\u0394 +0.02\u00a0K)")))
        << told.toStdString();
    shown.plot.setQuantity(Quantity::Strength);
    const QString strength = shown.plot.readout(samples[12].time_s, samples[4].time_s);
    EXPECT_TRUE(
        strength.contains(QStringLiteral("0.1204\u00a0K/s \u2192 0.1206\u00a0K/s (\u0394 +0.0002\u00a0K/s)")))
        << strength.toStdString();
}

// Catches a second quantity that is drawn on the scale or in the unit of the first, and one that is told by
// nothing but a colour.
TEST(TracePlot, ASecondQuantityHasAScaleAndAUnitOfItsOwn) {
    ShownPlot shown;
    const auto samples = warmUp(60);
    shown.plot.setSamples(samples);
    const double lowest = shown.plot.visibleLowest(), highest = shown.plot.visibleHighest();
    EXPECT_TRUE(shown.plot.rightAxisLabel().isEmpty());
    shown.plot.setRightQuantity(Quantity::ViewFactor);
    EXPECT_EQ(shown.plot.rightAxisLabel(), QStringLiteral("View factor"));
    EXPECT_EQ(shown.plot.valueAxisLabel(), QStringLiteral("Temperature (°C)"));
    EXPECT_DOUBLE_EQ(shown.plot.visibleLowest(), lowest);
    EXPECT_DOUBLE_EQ(shown.plot.visibleHighest(), highest);
    ASSERT_EQ(shown.plot.rightPoints(1).size(), 60);
    EXPECT_NEAR(shown.plot.rightPoints(1)[10].y(), 0.35, 1e-9);
    EXPECT_LT(shown.plot.rightLowest(), 0.3);
    EXPECT_GT(shown.plot.rightHighest(), 0.4);
    EXPECT_LT(shown.plot.rightHighest(), 0.5);
    EXPECT_TRUE(shown.plot.readout(10.0).contains(QStringLiteral("bunny \u25b8 0.350")))
        << shown.plot.readout(10.0).toStdString();
    EXPECT_TRUE(shown.plot.accessibleName().contains(QStringLiteral("View factor")));
    EXPECT_FALSE(shown.plot.grab().isNull());

    shown.plot.setRightQuantity(Quantity::Error);
    shown.plot.setTemperatureUnit(TemperatureUnit::Fahrenheit);
    EXPECT_NEAR(shown.plot.rightPoints(2)[4].y(), 1.8 * (samples[4].objects[2].measured_K - 313.15), 1e-9);
    EXPECT_TRUE(shown.plot.rightAxisLabel().startsWith(QStringLiteral("Error (")));
    shown.plot.clear();
    shown.plot.append(warmUp(3));
    EXPECT_EQ(shown.plot.rightPoints(0).size(), 3) << "in the next run, too";
    shown.plot.setQuantity(Quantity::Error);
    EXPECT_FALSE(shown.plot.rightQuantity()) << "once is enough";
    shown.plot.setRightQuantity(Quantity::Speed);
    shown.plot.setSpeedLimits({0.02, 0.1});
    EXPECT_EQ(shown.plot.rightAxisLabel(), QStringLiteral("Speed (% of limit)"));
    EXPECT_TRUE(shown.plot.readout(2.0).contains(QStringLiteral("translation \u25b8")));
    shown.plot.setRightQuantity(std::nullopt);
    EXPECT_TRUE(shown.plot.rightAxisLabel().isEmpty());
    EXPECT_TRUE(shown.plot.rightPoints(0).isEmpty());
}

TEST(TracePlot, MarkersAndClear) {
    ShownPlot shown;
    shown.plot.append(warmUp(20));
    shown.plot.addMarker(12.0, QStringLiteral("lamp moved"));
    shown.plot.addMarker(5.0, QStringLiteral("Started"));
    EXPECT_EQ(shown.plot.markerTexts(),
              QStringList({QStringLiteral("Started"), QStringLiteral("lamp moved")}));
    shown.plot.clear();
    EXPECT_TRUE(shown.plot.markerTexts().isEmpty());
    EXPECT_TRUE(shown.plot.seriesPoints(0).isEmpty());
    EXPECT_TRUE(shown.plot.followsLive());
    shown.plot.append(warmUp(3));
    EXPECT_EQ(shown.plot.seriesPoints(0).size(), 3) << "a new run begins at zero again";
}

// Catches words of markers that stand over the traces.
TEST(TracePlot, WordsOfMarkersStandAboveTheTraces) {
    ShownPlot shown;
    shown.plot.append(warmUp(100));
    QWidget* canvas = canvasOf(shown.plot);
    const auto pictureWith = [&](const QString& words) {
        shown.plot.clearMarkers();
        shown.plot.addMarker(30.0, words);
        shown.plot.redraw();
        return canvas->grab().toImage();
    };
    const QImage one = pictureWith(QStringLiteral("gggg")), other = pictureWith(QStringLiteral("MMMM"));
    ASSERT_EQ(one.size(), other.size());
    int lowest = -1;
    for (int y = 0; y < one.height(); ++y)
        for (int x = 0; x < one.width(); ++x)
            if (one.pixel(x, y) != other.pixel(x, y))
                lowest = y;
    EXPECT_GE(lowest, 0) << "they are drawn";
    EXPECT_LT(lowest, canvas->fontMetrics().height() + 6) << "in the strip above the traces";
    shown.plot.setMarkerTextsVisible(false);
    EXPECT_EQ(shown.plot.markerTexts(), QStringList{QStringLiteral("MMMM")});
    for (const QObject* child : canvas->children())
        if (child->property("text").toString() == QStringLiteral("MMMM")) {
            EXPECT_FALSE(child->property("clipToAxisRect").toBool());
        }
}

// Catches not-a-number and infinite values that spoil scales or crash the drawing.
TEST(TracePlot, OnlyNotANumber) {
    ShownPlot shown(Quantity::Strength);
    auto samples = warmUp(30);
    for (auto& sample : samples)
        for (auto& object : sample.objects)
            object.lambda1 = std::nan("");
    shown.plot.setSamples(samples);
    EXPECT_FALSE(shown.plot.grab().isNull());
    EXPECT_TRUE(std::isfinite(shown.plot.visibleHighest()));
}

// Catches a redraw that grows with the run's length: eight hours of three objects, drawn in well under a
// period.
TEST(TracePlot, EightHoursAreDrawnQuickly) {
    ShownPlot shown;
    shown.plot.setSamples(warmUp(30000));
    shown.plot.redraw();
    const double before_s = test::threadTime_s();
    constexpr int kFrames = 10;
    for (int i = 0; i < kFrames; ++i) {
        shown.plot.append(warmUp(1, 1.0, 30000.0 + i));
        shown.plot.redraw();
    }
    const double redraw_ms = 1e3 * (test::threadTime_s() - before_s) / kFrames;
    std::printf("redraw of 3 x 30000 samples: %.1f ms\n", redraw_ms);
    EXPECT_LT(redraw_ms, 150.0);
    const double drawn_s = test::threadTime_s();
    for (int i = 0; i < kFrames; ++i)
        shown.plot.append(warmUp(1, 1.0, 31000.0 + i));
    EXPECT_LT(test::threadTime_s() - drawn_s, 0.2) << "appending does not draw";
}

// Catches a recorded run that is drawn without its extremes, not read where one looks closely, or named
// wrongly.
TEST(TracePlot, ARecordedRunIsReadWhereItIsLookedAt) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath(QStringLiteral("run.bask")).toStdString();
    Experiment experiment;
    for (const QString& name : kNames) {
        ObjectSpec object;
        object.name = name.toStdString();
        object.shape = Disk{0.01};
        object.mounting[kX] = 0.05 * static_cast<double>(experiment.objects.size());
        experiment.objects.push_back(object);
    }
    auto samples = warmUp(30'000, 0.1);
    samples[20'000].objects[1].measured_K = 350.0; // one sample in fifty minutes
    {
        auto writer = SessionWriter::create(path, experiment, true, 0.5, SessionWriter::Earlier::Replaced);
        ASSERT_TRUE(writer) << describe(writer.error());
        for (const TraceSample& sample : samples)
            ASSERT_TRUE((*writer)->add(sample));
    }
    const auto run = RecordedSession::open(path);
    ASSERT_TRUE(run) << describe(run.error());
    ShownPlot shown;
    shown.plot.setRun(*run);
    shown.plot.redraw();
    EXPECT_EQ(shown.plot.seriesName(2), kNames[2]);
    EXPECT_NEAR(shown.plot.visibleTo_s(), 3000.0, 1e-6);
    EXPECT_GT(shown.plot.visibleHighest(), 350.0 - 273.15);
    EXPECT_FALSE((*run)->holds(20'000 / RecordedSession::kBlock)) << "the whole is drawn from the overview";

    shown.plot.setTimeRange(1990.0, 2010.0);
    shown.plot.redraw();
    EXPECT_TRUE((*run)->holds(20'000 / RecordedSession::kBlock));
    EXPECT_GT(shown.plot.visibleHighest(), 350.0 - 273.15);
    EXPECT_TRUE(shown.plot.readout(2000.1).contains(QStringLiteral("76.9")))
        << shown.plot.readout(2000.1).toStdString();
    EXPECT_EQ(shown.plot.seriesPoints(1).size(), 30'000);
    shown.plot.setTimeRange(100.0, 110.0);
    shown.plot.redraw();
    EXPECT_LT(shown.plot.visibleHighest(), 60.0);
}

// Catches a prediction that is not drawn before Start, in another unit, or over the measured lines.
TEST(TracePlot, APredictionStandsBehindTheMeasuredLines) {
    ShownPlot shown;
    EXPECT_TRUE(shown.plot.predictedPoints(0).isEmpty());
    shown.plot.setPrediction(predictedWarmUp());
    for (int i = 0; i < 3; ++i) {
        const auto points = shown.plot.predictedPoints(i);
        ASSERT_EQ(points.size(), 161) << i;
        EXPECT_EQ(points.front().x(), 0.0);
        EXPECT_NEAR(points.front().y(), 25.0, 1e-9);
        EXPECT_NEAR(points.back().y(), 40.0, 0.5);
    }
    EXPECT_DOUBLE_EQ(shown.plot.visibleTo_s(), 230.0) << "until a while after it has settled";
    EXPECT_LT(shown.plot.visibleLowest(), 25.0);
    EXPECT_GT(shown.plot.visibleHighest(), 40.0);
    shown.plot.redraw();
    EXPECT_FALSE(shown.plot.grab().isNull());

    shown.plot.append(warmUp(10));
    EXPECT_EQ(shown.plot.seriesPoints(0).size(), 10);
    EXPECT_DOUBLE_EQ(shown.plot.visibleTo_s(), 230.0) << "what is to come is seen";
    shown.plot.append(warmUp(300, 1.0, 10.0));
    EXPECT_DOUBLE_EQ(shown.plot.visibleTo_s(), 310.0);
    shown.plot.setTemperatureUnit(TemperatureUnit::Fahrenheit);
    EXPECT_NEAR(shown.plot.predictedPoints(0).front().y(), 77.0, 1e-9);

    QStringList order;
    for (const QObject* child : canvasOf(shown.plot)->children())
        if (child->inherits("QCPGraph"))
            order << (kNames.contains(child->property("name").toString()) ? QStringLiteral("measured")
                                                                          : QStringLiteral("behind"));
    ASSERT_EQ(order.count(QStringLiteral("measured")), 3);
    EXPECT_EQ(order.indexOf(QStringLiteral("measured")), order.lastIndexOf(QStringLiteral("behind")) + 1);
}

// Catches a prediction that looks like a measured line, or keeps the pens of the other theme.
TEST(TracePlot, APredictionIsThinDottedAndOfTheTheme) {
    ShownPlot shown;
    shown.plot.setPrediction(predictedWarmUp());
    QColor before;
    for (const bool dark : {false, true}) {
        shown.plot.setTheme(dark);
        const std::vector<QPen> behind = pensOf(shown.plot, false), measured = pensOf(shown.plot, true);
        ASSERT_GE(behind.size(), 3U);
        ASSERT_EQ(measured.size(), 3U);
        for (std::size_t i = 0; i < 3; ++i) {
            const QPen& pen = behind[behind.size() - 3 + i];
            EXPECT_LT(pen.widthF(), measured[i].widthF()) << i;
            EXPECT_NE(pen.dashPattern(), measured[i].dashPattern()) << i;
            EXPECT_EQ(pen.style(), Qt::CustomDashLine) << i;
            EXPECT_NE(pen.color(), measured[i].color()) << i << ": it is pale";
        }
        EXPECT_NE(behind.back().color(), before);
        before = behind.back().color();
        EXPECT_EQ(shown.plot.predictedPoints(2).size(), 161);
    }
}

// Catches a prediction that cannot be hidden, or outlives what it is about.
TEST(TracePlot, APredictionIsHiddenAndRemoved) {
    ShownPlot shown;
    shown.plot.setPrediction(predictedWarmUp());
    shown.plot.setPredictionVisible(false);
    EXPECT_TRUE(shown.plot.predictedPoints(0).isEmpty());
    EXPECT_DOUBLE_EQ(shown.plot.visibleTo_s(), 60.0);
    shown.plot.setPredictionVisible(true);
    EXPECT_EQ(shown.plot.predictedPoints(0).size(), 161);
    shown.plot.append(warmUp(5));
    shown.plot.clear(); // Arm
    EXPECT_EQ(shown.plot.predictedPoints(0).size(), 161);
    shown.plot.setPrediction({});
    EXPECT_TRUE(shown.plot.predictedPoints(0).isEmpty());
    shown.plot.setPrediction(predictedWarmUp());
    shown.plot.setObjects(kNames);
    EXPECT_TRUE(shown.plot.predictedPoints(0).isEmpty()) << "it was of other objects";

    shown.plot.setPrediction(predictedWarmUp());
    shown.plot.setQuantity(Quantity::Error);
    EXPECT_TRUE(shown.plot.predictedPoints(0).isEmpty());
    EXPECT_DOUBLE_EQ(shown.plot.visibleTo_s(), 230.0) << "in line with the plot of temperatures";
}

// Catches an endless empty axis in front of a run whose prediction does not settle.
TEST(TracePlot, APredictionThatDoesNotSettleLeavesTheAxisToTheRun) {
    ShownPlot shown;
    PredictedRun run = predictedWarmUp();
    run.settling_s.reset();
    shown.plot.setPrediction(run);
    EXPECT_DOUBLE_EQ(shown.plot.visibleTo_s(), 320.0);
    shown.plot.append(warmUp(100));
    EXPECT_DOUBLE_EQ(shown.plot.visibleTo_s(), 100.0);
}

// Catches pale lines that nothing names in a run, and a prediction that looks complete though it is not.
TEST(TracePlot, WordsSayWhatIsPredictedAndHowItEnds) {
    ShownPlot shown;
    PredictedRun run = predictedWarmUp();
    EXPECT_TRUE(shown.plot.predictionLabel().isEmpty());
    shown.plot.setPrediction(run);
    EXPECT_EQ(shown.plot.predictionLabel(), QStringLiteral("predicted"));
    shown.plot.append(warmUp(50));
    EXPECT_EQ(shown.plot.predictionLabel(), QStringLiteral("predicted"));
    shown.plot.setPredictionVisible(false);
    EXPECT_TRUE(shown.plot.predictionLabel().isEmpty());
    shown.plot.setPredictionVisible(true);
    shown.plot.clear(); // Arm
    EXPECT_EQ(shown.plot.predictionLabel(), QStringLiteral("predicted"));
    PredictedRun wide = run;
    for (PredictedSample& sample : wide.samples)
        sample.lowest_K = sample.highest_K = sample.temperatures_K;
    shown.plot.setPrediction(wide);
    EXPECT_EQ(shown.plot.predictionLabel(), QStringLiteral("predicted; band: other sensor noise only"));
    run.settling_s.reset();
    QStringList words;
    for (const PredictedEnd end : {PredictedEnd::Limit, PredictedEnd::Cut, PredictedEnd::Fault}) {
        run.end = end;
        shown.plot.setPrediction(run);
        EXPECT_FALSE(words.contains(shown.plot.predictionLabel()));
        EXPECT_TRUE(shown.plot.predictionLabel().startsWith(QStringLiteral("predicted")));
        words << shown.plot.predictionLabel();
        shown.plot.redraw();
    }
}

// Catches words that are not drawn, in a run or before, or are drawn without the lines.
TEST(TracePlot, TheWordsOfAPredictionAreDrawn) {
    ShownPlot shown;
    const auto pictureOf = [&](PredictedEnd end, int samples) {
        PredictedRun run = predictedWarmUp();
        run.end = end;
        shown.plot.clear();
        shown.plot.setPrediction(run);
        shown.plot.append(warmUp(samples));
        shown.plot.redraw();
        return shown.plot.grab().toImage();
    };
    const auto drawn = [&](int samples) { // by the other words, the same lines
        return pictureOf(PredictedEnd::Fault, samples) != pictureOf(PredictedEnd::Settled, samples);
    };
    EXPECT_TRUE(drawn(0));
    EXPECT_TRUE(drawn(100));
    shown.plot.setPredictionVisible(false);
    EXPECT_FALSE(drawn(100));
}

// Catches the predicted next run that is drawn through the traces of the last one, widens its axes, or does
// not come once these are gone.
TEST(TracePlot, APredictedNextRunWaitsForAnEmptyPlot) {
    ShownPlot shown;
    shown.plot.append(warmUp(100));
    const double lowest = shown.plot.visibleLowest();
    PredictedRun run = predictedWarmUp();
    run.samples.front().temperatures_K = {280.0, 280.0, 280.0};
    shown.plot.setPrediction(run);
    EXPECT_TRUE(shown.plot.predictedPoints(0).isEmpty());
    EXPECT_TRUE(shown.plot.predictionLabel().isEmpty());
    EXPECT_DOUBLE_EQ(shown.plot.visibleTo_s(), 100.0);
    EXPECT_DOUBLE_EQ(shown.plot.visibleLowest(), lowest);
    shown.plot.setTemperatureUnit(TemperatureUnit::Kelvin); // made anew
    EXPECT_TRUE(shown.plot.predictedPoints(0).isEmpty());
    shown.plot.clear(); // Arm
    EXPECT_EQ(shown.plot.predictedPoints(0).size(), 161);
    EXPECT_DOUBLE_EQ(shown.plot.visibleTo_s(), 230.0);
    shown.plot.append(warmUp(10));
    EXPECT_EQ(shown.plot.predictedPoints(0).size(), 161) << "from Start on it is of this run";
}

// Catches a person's zoom of the values that a prediction which comes or goes takes away.
TEST(TracePlot, APredictionLeavesTheZoomOfValues) {
    ShownPlot shown;
    wheel(canvasOf(shown.plot), 120, Qt::ControlModifier);
    const double lowest = shown.plot.visibleLowest(), highest = shown.plot.visibleHighest();
    shown.plot.setPrediction(predictedWarmUp());
    EXPECT_FALSE(shown.plot.predictedPoints(0).isEmpty());
    EXPECT_DOUBLE_EQ(shown.plot.visibleLowest(), lowest);
    shown.plot.setPrediction({});
    EXPECT_DOUBLE_EQ(shown.plot.visibleLowest(), lowest);
    EXPECT_DOUBLE_EQ(shown.plot.visibleHighest(), highest);
}

// Catches undefined behaviour where a name holds what once stood between the values.
TEST(TracePlot, PointingReadsNamesWithSeveralSpaces) {
    ShownPlot shown;
    shown.plot.setObjects({QStringLiteral("left   hand"), QStringLiteral("a   b   c"), QStringLiteral("x")});
    shown.plot.append(warmUp(50));
    shown.plot.redraw();
    QWidget* canvas = canvasOf(shown.plot);
    QTest::mouseMove(canvas, canvas->rect().center());
    const auto* told = canvas->findChild<QLabel*>(QStringLiteral("tracePlotReadout"));
    ASSERT_TRUE(test::waitFor([told] { return !told->text().isEmpty(); }));
    EXPECT_EQ(told->text().count(QStringLiteral("<br>")), 3) << told->text().toStdString();
    EXPECT_TRUE(shown.plot.readout(10.0).contains(QStringLiteral("a   b   c")));
}
