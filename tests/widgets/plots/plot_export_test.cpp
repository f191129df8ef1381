// What a plot shows of several runs: under its cursors, as a figure for print, as a table.

#include "engine/recording/recorded_session.h"
#include "widgets/plots/plot_table.h"
#include "widgets/plots/trace_plot.h"

#include <QFile>
#include <QImage>
#include <QRegularExpression>
#include <QSet>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

using namespace bask;

namespace {

const QStringList kExported{QStringLiteral("circle"), QStringLiteral("bunny")};

/// Warms from 20 degC, the second object by twice as much.
std::vector<TraceSample> warming(int count, double rate_K_s) {
    std::vector<TraceSample> out;
    for (int k = 1; k <= count; ++k) {
        TraceSample sample;
        sample.time_s = k;
        for (int i = 0; i < 2; ++i) {
            ObjectSample object;
            object.target_K = 313.15;
            object.measured_K = 293.15 + rate_K_s * (i + 1) * k;
            object.viewFactor = 0.25;
            object.valid = k != 3 || i != 1;
            sample.objects.push_back(object);
        }
        out.push_back(sample);
    }
    return out;
}

class PlotExport : public testing::Test {
protected:
    QTemporaryDir folder;
    TracePlot plot;

    PlotExport() { plot.resize(800, 320); }

    std::shared_ptr<RecordedSession> recorded(const QString& name, const std::vector<TraceSample>& samples) {
        Experiment experiment;
        for (const QString& object : kExported) {
            ObjectSpec spec;
            spec.name = object.toStdString();
            spec.shape = Disk{0.01};
            spec.mounting[kX] = 0.05 * static_cast<double>(experiment.objects.size());
            experiment.objects.push_back(spec);
        }
        const std::string path = folder.filePath(name + QStringLiteral(".bask")).toStdString();
        {
            auto writer =
                SessionWriter::create(path, experiment, true, 0.5, SessionWriter::Earlier::Replaced);
            EXPECT_TRUE(writer);
            for (const TraceSample& sample : samples)
                EXPECT_TRUE((*writer)->add(sample));
        }
        return RecordedSession::open(path).value();
    }
    /// Morning of 20 s, over it evening of 30 s.
    void showTwoRuns() {
        plot.setRun(recorded(QStringLiteral("morning"), warming(20, 0.5)));
        plot.addOverlay(QStringLiteral("B"), recorded(QStringLiteral("evening"), warming(30, 0.25)));
    }
    QString svg() const {
        return QString::fromUtf8(
            plot.figure(QStringLiteral("of now"), FigureFormat::Svg, QStringLiteral("mark")));
    }
    /// Dash patterns of its lines.
    static QSet<QString> dashesIn(const QString& svg) {
        static const QRegularExpression kDashes(QStringLiteral("stroke-dasharray=\"([^\"]+)\""));
        QSet<QString> out;
        for (auto found = kDashes.globalMatch(svg); found.hasNext();)
            out << found.next().captured(1);
        return out;
    }
    QList<QStringList> table() const {
        QList<QStringList> rows;
        const QString text =
            QString::fromStdString(plotTableCsv(plot.table(QStringLiteral("mark")), {}).value());
        EXPECT_TRUE(text.endsWith(u'\n'));
        for (const QString& row : text.split(u'\n', Qt::SkipEmptyParts))
            rows << row.split(u',');
        return rows;
    }
};

} // namespace

// Catches a figure whose size on paper depends on the kind of file, or is not the chosen one, and letters
// that change with it.
TEST_F(PlotExport, AFigureHasOneSizeOnPaper) {
    static const QRegularExpression kSvgSize(
        QStringLiteral("<svg width=\"([\\d.]+)mm\" height=\"([\\d.]+)mm\"")),
        kPage(QStringLiteral("/MediaBox \\[0 0 ([\\d.]+) ([\\d.]+)\\]"));
    showTwoRuns();
    for (const double width_mm : {kOneColumn_mm, kTwoColumns_mm, 120.0}) {
        const auto drawn = [&](FigureFormat format) {
            return plot.figure({}, format, QStringLiteral("mark"), {width_mm});
        };
        const QImage png = QImage::fromData(drawn(FigureFormat::Png), "PNG");
        const QSizeF pixels = 1e3 * QSizeF(png.size()) / png.dotsPerMeterX();
        EXPECT_NEAR(pixels.width(), width_mm, 0.2);
        const QString drawing = QString::fromUtf8(drawn(FigureFormat::Svg));
        const auto svgSize = kSvgSize.match(drawing);
        ASSERT_TRUE(svgSize.hasMatch()) << drawing.left(200).toStdString();
        EXPECT_NEAR(svgSize.captured(1).toDouble(), pixels.width(), 0.1);
        EXPECT_NEAR(svgSize.captured(2).toDouble(), pixels.height(), 0.1);
        const auto page = kPage.match(QString::fromLatin1(drawn(FigureFormat::Pdf)));
        ASSERT_TRUE(page.hasMatch());
        EXPECT_NEAR(page.captured(1).toDouble() * 25.4 / 72.0, pixels.width(), 0.1);
        EXPECT_NEAR(page.captured(2).toDouble() * 25.4 / 72.0, pixels.height(), 0.1);
        EXPECT_TRUE(drawing.contains(QStringLiteral("font-size=\"14\""))) << "7 points: two units each";
    }
}

// Catches a simulated run that a figure without its heading passes off as a real one.
TEST_F(PlotExport, WithoutItsHeadingAFigureTellsThatItIsSimulated) {
    showTwoRuns();
    plot.addMarker(5.0, QStringLiteral("Settled"));
    const auto drawn = [&](bool hasHeading) {
        return QString::fromUtf8(
            plot.figure({}, FigureFormat::Svg, QStringLiteral("mark"), {kTwoColumns_mm, hasHeading}));
    };
    const QString with = drawn(true), without = drawn(false);
    EXPECT_TRUE(with.contains(QStringLiteral(">Temperatures<")));
    EXPECT_TRUE(with.contains(QStringLiteral("1 Settled (A)"))) << "of which run it is";
    EXPECT_FALSE(without.contains(QStringLiteral(">Temperatures<")));
    EXPECT_FALSE(without.contains(QStringLiteral("Settled")));
    EXPECT_EQ(without.count(QStringLiteral("SIMULATED")), 1);
    EXPECT_TRUE(without.contains(QStringLiteral("A morning \u00b7 circle"))) << "the key stays";
}

// Catches a key that begins with the run on top, or does not call the runs by what tells them apart.
TEST_F(PlotExport, TheKeyCallsTheRunsByTheirNamesInTheirOrder) {
    showTwoRuns();
    plot.setRunNames({QStringLiteral("Model-based"), QStringLiteral("Level servo")});
    const QString named = svg();
    const qsizetype own = named.indexOf(QStringLiteral(">A Model-based \u00b7 circle<")),
                    over = named.indexOf(QStringLiteral(">B Level servo \u00b7 circle<"));
    EXPECT_GE(own, 0);
    EXPECT_GT(over, own) << "A before B";
    EXPECT_TRUE(named.contains(QStringLiteral("B Level servo (evening, SIMULATED)")))
        << "the heading has the file";
    EXPECT_EQ(table()[0][0], QStringLiteral("A morning: time (s)")) << "a table calls them by their files";
}

// Catches a figure that lacks the runs laid over the open one, their names, or dashes to tell them apart.
TEST_F(PlotExport, AFigureHasAllRunsWithTheirNames) {
    showTwoRuns();
    const QString two = svg();
    for (const char* name : {"A morning \u00b7 circle", "A morning \u00b7 bunny", "B evening \u00b7 circle",
                             "B evening \u00b7 bunny", "SIMULATED", "Temperature"})
        EXPECT_TRUE(two.contains(QString::fromUtf8(name))) << name;
    EXPECT_FALSE(two.contains(QStringLiteral("of now")));
    plot.addOverlay(QStringLiteral("C"), recorded(QStringLiteral("night"), warming(25, 0.4)));
    const QString three = svg();
    EXPECT_TRUE(three.contains(QStringLiteral("C night \u00b7 bunny")));
    EXPECT_GT(dashesIn(three).size(), dashesIn(two).size()) << "each run has dashes of its own";
    plot.clearOverlays();
    EXPECT_FALSE(svg().contains(QStringLiteral("evening")));
    EXPECT_GT(dashesIn(two).size(), 1);
}

// Catches a legend of many runs that leaves the lines no room.
TEST_F(PlotExport, AFigureGrowsWithItsLegend) {
    const auto height = [&] {
        return QImage::fromData(plot.figure({}, FigureFormat::Png, QStringLiteral("mark")), "PNG").height();
    };
    plot.setRun(recorded(QStringLiteral("morning"), warming(20, 0.5)));
    const int one = height();
    const QString longName(40, u'w'); // one column
    for (const char* mark : {"B", "C", "D", "E"})
        plot.addOverlay(QLatin1String(mark), recorded(longName + QLatin1String(mark), warming(20, 0.5)));
    EXPECT_GE(height(), one + 150);
}

// Catches two of the overlaid runs that have the same dashes, or a continuous line as the open run has.
TEST(OverlayDashes, TellRunsApart) {
    for (int i = 0; i < 4; ++i) {
        EXPECT_FALSE(TracePlot::overlayDashes(i).isEmpty());
        for (int j = 0; j < i; ++j)
            EXPECT_NE(TracePlot::overlayDashes(i), TracePlot::overlayDashes(j));
    }
}

// Catches a figure without the second quantity, or without its scale.
TEST_F(PlotExport, AFigureHasTheRightAxis) {
    plot.setRun(recorded(QStringLiteral("morning"), warming(20, 0.5)));
    const QString without = svg();
    EXPECT_FALSE(without.contains(QStringLiteral("View factor")));
    plot.setRightQuantity(Quantity::ViewFactor);
    const QString with = svg();
    EXPECT_GE(with.count(QStringLiteral("View factor")), 2) << "in the title and at the axis";
    EXPECT_GT(dashesIn(with).size(), dashesIn(without).size()) << "groups of dots";
}

// Catches marked moments that are lost, or whose words cannot be found from their numbers.
TEST_F(PlotExport, MomentsAreNumberedAndNamed) {
    plot.setObjects(kExported);
    plot.append(warming(100, 0.1));
    plot.addMarker(20.0, QStringLiteral("lamp moved"));
    plot.addMarker(70.0, QStringLiteral("door open"));
    const QString whole = svg();
    EXPECT_TRUE(whole.contains(QStringLiteral("1 lamp moved")));
    EXPECT_TRUE(whole.contains(QStringLiteral("2 door open")));
    EXPECT_TRUE(whole.contains(QStringLiteral("of now"))) << "which run a live one is";
    EXPECT_FALSE(whole.contains(QStringLiteral("without a number")));
    plot.addMarker(70.5, QStringLiteral("door shut"));
    plot.addMarker(71.0, QStringLiteral("lamp off"));
    EXPECT_TRUE(svg().contains(QStringLiteral("2 more without a number"))) << "too close to the door's";
    plot.setTimeRange(50.0, 100.0);
    const QString later = svg();
    EXPECT_FALSE(later.contains(QStringLiteral("lamp moved"))) << "it is not shown";
    EXPECT_TRUE(later.contains(QStringLiteral("1 door open")));
}

// Catches hours with many digits at a minute late in a run.
TEST_F(PlotExport, TheUnitOfTimeIsOfWhatIsShown) {
    plot.setObjects(kExported);
    plot.append(warming(20000, 1e-4));
    EXPECT_TRUE(svg().contains(QStringLiteral("Time since Start (h)")));
    plot.setTimeRange(19000.0, 19060.0);
    EXPECT_TRUE(svg().contains(QStringLiteral("Time since Start (s)")));
}

// Catches a legend that does not say what the dashed line and the grey band are.
TEST_F(PlotExport, TheLegendNamesTargetAndBand) {
    plot.setObjects(kExported);
    plot.append(warming(20, 0.5));
    for (const Quantity quantity : {Quantity::Temperature, Quantity::Error}) {
        plot.setQuantity(quantity);
        EXPECT_TRUE(svg().contains(QStringLiteral(">target<")));
        EXPECT_TRUE(svg().contains(QStringLiteral("band of \u00b10.5")));
    }
    plot.setQuantity(Quantity::ViewFactor);
    EXPECT_FALSE(svg().contains(QStringLiteral("target")));
}

// Catches a format that cannot be read, and an empty plot that breaks the drawing.
TEST_F(PlotExport, FiguresAreOfTheirFormats) {
    EXPECT_TRUE(plot.isEmpty());
    EXPECT_FALSE(plot.figure({}, FigureFormat::Svg, {}).isEmpty());
    showTwoRuns();
    EXPECT_FALSE(plot.isEmpty());
    const QImage image = QImage::fromData(plot.figure({}, FigureFormat::Png, QStringLiteral("mark")), "PNG");
    EXPECT_EQ(image.text(QStringLiteral("Description")), QStringLiteral("mark"));
    EXPECT_TRUE(plot.figure({}, FigureFormat::Pdf, {}).startsWith("%PDF"));
}

// Catches a table without the overlaid runs, with times of one beside values of another, or with numbers that
// are not those of the recording.
TEST_F(PlotExport, ATableHasAllRunsBesideEachOther) {
    showTwoRuns();
    plot.setRightQuantity(Quantity::ViewFactor);
    const QList<QStringList> rows = table();
    ASSERT_EQ(rows.size(), 31);
    EXPECT_EQ(rows[0],
              QStringList({"A morning: time (s)", "A morning: circle measured (degC)",
                           "A morning: bunny measured (degC)", "A morning: circle target (degC)",
                           "A morning: bunny target (degC)", "A morning: circle view factor (1)",
                           "A morning: bunny view factor (1)", "B evening: time (s)",
                           "B evening: circle measured (degC)", "B evening: bunny measured (degC)", "mark"}));
    EXPECT_EQ(rows[10].mid(0, 8), QStringList({"10", "25", "30", "40", "40", "0.25", "0.25", "10"}));
    EXPECT_DOUBLE_EQ(rows[10][8].toDouble(), 22.5);
    EXPECT_EQ(rows[3][2], QString()) << "an invalid reading";
    EXPECT_EQ(rows[25].mid(0, 7), QStringList({"", "", "", "", "", "", ""})) << "the shorter run is over";
    EXPECT_EQ(rows[25][7], QStringLiteral("25"));
}

// Catches a table of a long live run that takes extremes, or a part of what is shown, for its samples.
TEST_F(PlotExport, ATableOfALongLiveRunSaysWhereItIsCut) {
    std::vector<TraceSample> samples = warming(42000, 1e-4);
    const std::vector<TraceSample> last(samples.end() - 1000, samples.end());
    samples.resize(samples.size() - 1000);
    plot.setObjects(kExported);
    plot.append(samples);
    plot.setTimeRange(0.0, 42000.0);
    EXPECT_FALSE(plot.table({}).isCut);
    plot.append(last); // the oldest are dropped
    EXPECT_TRUE(plot.table({}).isCut);
    plot.setTimeRange(20000.0, 42000.0);
    const PlotTable later = plot.table({});
    EXPECT_FALSE(later.isCut);
    EXPECT_EQ(later.runs[0].times_s.size(), 22001u);
}

// Catches a table that reads a recording while the window waits, or hides that it cannot be read.
TEST_F(PlotExport, ATableIsReadWhenItIsMade) {
    showTwoRuns();
    const PlotTable shown = plot.table(QStringLiteral("mark"));
    EXPECT_TRUE(shown.runs[0].times_s.empty());
    EXPECT_TRUE(plotTableCsv(shown, {}).ok());
    ASSERT_TRUE(QFile::remove(folder.filePath(QStringLiteral("evening.bask"))));
    EXPECT_FALSE(plotTableCsv(shown, {}).ok());
}

// Catches a table of what is not shown, and names of runs where there is but one.
TEST_F(PlotExport, ATableIsOfTheShownTime) {
    plot.setObjects(kExported);
    plot.setQuantity(Quantity::Error);
    plot.setTemperatureUnit(TemperatureUnit::Fahrenheit);
    plot.append(warming(20, 0.5));
    plot.setTimeRange(5.0, 10.0);
    const QList<QStringList> rows = table();
    ASSERT_EQ(rows.size(), 7);
    EXPECT_EQ(rows[0], QStringList({"time (s)", "circle error (K)", "bunny error (K)", "mark"}));
    EXPECT_EQ(rows[1][0], QStringLiteral("5"));
    EXPECT_DOUBLE_EQ(rows[1][1].toDouble(), -17.5) << "kelvin, whatever the screen shows";
    EXPECT_EQ(rows[6][0], QStringLiteral("10"));
}

// Catches cursors that read the open run only, or values of a run that was over by then.
TEST_F(PlotExport, CursorsReadEachRun) {
    showTwoRuns();
    const auto told = [&](double time_s, std::optional<double> pinned_s) {
        return plot.readout(time_s, pinned_s).replace(QChar(0x00a0), u' ').split(QStringLiteral("   "));
    };
    const QStringList both = told(10.0, 4.0);
    ASSERT_EQ(both.size(), 5) << both.join('|').toStdString();
    EXPECT_EQ(both[1], QStringLiteral("circle A 22.0 \u00b0C \u2192 25.0 \u00b0C (\u0394 +3.0 K)"));
    EXPECT_EQ(both[2], QStringLiteral("bunny A 24.0 \u00b0C \u2192 30.0 \u00b0C (\u0394 +6.0 K)"));
    EXPECT_EQ(both[3], QStringLiteral("circle B 21.0 \u00b0C \u2192 22.5 \u00b0C (\u0394 +1.5 K)"));
    EXPECT_EQ(both[4], QStringLiteral("bunny B 22.0 \u00b0C \u2192 25.0 \u00b0C (\u0394 +3.0 K)"));
    const QStringList later = told(28.0, std::nullopt);
    ASSERT_EQ(later.size(), 5);
    EXPECT_EQ(later[0], QStringLiteral("0:28")) << "the longer run has that moment";
    EXPECT_EQ(later[1], QStringLiteral("circle A \u2014"));
    EXPECT_EQ(later[3], QStringLiteral("circle B 27.0 \u00b0C"));
    plot.clearOverlays();
    EXPECT_EQ(told(10.0, std::nullopt)[1], QStringLiteral("circle 25.0 \u00b0C"));
}
