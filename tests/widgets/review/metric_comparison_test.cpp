#include "widgets/review/comparison_view.h"

#include "widgets/common/language.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QElapsedTimer>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTest>
#include <limits>

#include <gtest/gtest.h>

#include <utility>

namespace bask {
namespace {

/// A settled object with a step of 15 K.
ObjectMetrics settled(double final_degC, double settling_s) {
    ObjectMetrics object;
    object.target_K = 313.15;
    object.step_K = 15.0;
    object.final_K = kelvinFromCelsius(final_degC);
    object.settling_s = object.settledFrom_s = settling_s;
    object.rise_s = 30.0;
    object.overshoot_K = 0.0;
    object.steadyError_K = 0.02;
    object.pathLength_m = 0.1;
    return object;
}

ComparedRun comparedRun(const QString& mark,
                        const std::vector<std::pair<const char*, ObjectMetrics>>& objects) {
    RunMetrics metrics;
    metrics.samples = 100;
    metrics.duration_s = 200.0;
    ComparedRun run{mark, mark + QStringLiteral(" run"), QStringLiteral("/runs/%1.bask").arg(mark), {}};
    for (const auto& [name, object] : objects) {
        run.objects << QString::fromUtf8(name);
        metrics.objects.push_back(object);
    }
    run.metrics = metrics;
    return run;
}

/// Two runs: the second has the objects in another order, one that the first lacks, and lacks one.
std::vector<ComparedRun> twoRuns() {
    ObjectMetrics unsettled = settled(39.7, 0.0);
    unsettled.settling_s.reset();
    return {comparedRun("A", {{"circle", settled(40.0, 62.0)},
                              {"hand", settled(40.1, 70.0)},
                              {"cup", settled(40.0, 50.0)}}),
            comparedRun(
                "B", {{"ring", settled(40.0, 55.0)}, {"hand", unsettled}, {"circle", settled(40.3, 58.0)}})};
}

const ComparedMetric& row(const std::vector<ComparedMetric>& metrics, const char* name, const char* object) {
    for (const ComparedMetric& metric : metrics)
        if (metric.name == QLatin1String(name) && metric.object == QLatin1String(object))
            return metric;
    ADD_FAILURE() << name << " of " << object;
    static const ComparedMetric kNone{{}, {}, {}, {}, {{}, {}, {}}};
    return kNone;
}

std::string plain(QString text) {
    return text.replace(QChar(0x00a0), u' ').toStdString();
}

} // namespace

// Catches objects that are matched by their place, and a difference without sign or unit, or of the wrong
// sign.
TEST(MetricComparison, MatchesObjectsByTheirNames) {
    const auto metrics = compareMetrics(twoRuns(), 0, TemperatureUnit::Celsius);
    ASSERT_EQ(metrics.size(), 8U * 4U + 5U) << "a row for each metric and object";
    const ComparedMetric& settling = row(metrics, "Settling time", "circle");
    EXPECT_EQ(plain(settling.cells[0].text), "62.0 s");
    EXPECT_EQ(plain(settling.cells[1].text), "58.0 s");
    EXPECT_EQ(plain(settling.cells[1].difference), "\u22124.0 s");
    EXPECT_TRUE(settling.cells[0].difference.isEmpty()) << "it is the reference";
    const ComparedMetric& last = row(metrics, "Final", "circle");
    EXPECT_EQ(plain(last.cells[1].text), "40.30 °C");
    EXPECT_EQ(plain(last.cells[1].difference), "+0.30 K");
    EXPECT_EQ(plain(row(metrics, "Path length", "hand").cells[1].difference), "0.0 mm");
    EXPECT_EQ(plain(row(metrics, "Overshoot", "circle").cells[1].text), "none");
    EXPECT_EQ(plain(row(metrics, "Overshoot", "circle").cells[1].difference), "0.00 K");
    EXPECT_EQ(plain(row(metrics, "Duration of control", "").cells[1].difference), "0.0 s");
    const auto fahrenheit = compareMetrics(twoRuns(), 0, TemperatureUnit::Fahrenheit);
    EXPECT_EQ(plain(row(fahrenheit, "Final", "circle").cells[1].difference), "+0.54 °F");
}

// Catches times and overshoots that are compared as if the tasks were the same, and a step that does not say
// when its target was set.
TEST(MetricComparison, TellsStepsThatAreNotAlike) {
    std::vector<ComparedRun> runs = twoRuns();
    EXPECT_TRUE(unlikeSteps(runs, TemperatureUnit::Celsius).isEmpty());
    runs[1].metrics->objects[2].step_K = 15.9; // "circle": within twice the band
    EXPECT_TRUE(unlikeSteps(runs, TemperatureUnit::Celsius).isEmpty());
    runs[1].metrics->objects[2].step_K = -20.0;
    runs[1].metrics->objects[2].from_s = 120.0;
    const QStringList told = unlikeSteps(runs, TemperatureUnit::Celsius);
    ASSERT_EQ(told.size(), 1);
    EXPECT_EQ(plain(told.front()).substr(0, 8), "circle: ");
    EXPECT_NE(plain(told.front()).find("A +15.0 K"), std::string::npos) << plain(told.front());
    EXPECT_NE(plain(told.front()).find("B \u221220.0 K at 120 s"), std::string::npos) << plain(told.front());
    const auto metrics = compareMetrics(runs, 0, TemperatureUnit::Celsius);
    EXPECT_EQ(plain(row(metrics, "Step", "circle").cells[0].text), "+15.0 K");
    EXPECT_EQ(plain(row(metrics, "Step", "circle").cells[1].text), "\u221220.0 K at 120 s");
    EXPECT_EQ(unlikeSources(runs, TemperatureUnit::Celsius), QString()) << "not known";
    runs[0].metrics->first.source_K = kelvinFromCelsius(200.0);
    runs[1].metrics->first.source_K = kelvinFromCelsius(197.0);
    EXPECT_EQ(unlikeSources(runs, TemperatureUnit::Celsius), QString());
    runs[1].metrics->first.source_K = kelvinFromCelsius(31.0);
    EXPECT_EQ(plain(unlikeSources(runs, TemperatureUnit::Celsius)), "A 200 °C, B 31 °C");
    runs[1].metrics->objects[2].step_K.reset();
    EXPECT_TRUE(unlikeSteps(runs, TemperatureUnit::Celsius).isEmpty()) << "not known";
    EXPECT_EQ(row(compareMetrics(runs, 0, TemperatureUnit::Celsius), "Step", "circle").cells[1].text,
              QStringLiteral("start unknown"));
}

// Catches a number that is made up for what a run does not have.
TEST(MetricComparison, WhatARunLacksIsADash) {
    auto runs = twoRuns();
    const auto metrics = compareMetrics(runs, 0, TemperatureUnit::Celsius);
    const QString dash(QChar(0x2014));
    EXPECT_EQ(row(metrics, "Settling time", "cup").cells[1].text, dash);
    EXPECT_EQ(row(metrics, "Settling time", "cup").cells[1].difference, dash);
    EXPECT_EQ(row(metrics, "Settling time", "ring").cells[0].text, dash);
    EXPECT_EQ(plain(row(metrics, "Settling time", "ring").cells[1].text), "55.0 s");
    EXPECT_EQ(row(metrics, "Settling time", "ring").cells[1].difference, dash);
    EXPECT_EQ(row(metrics, "Settling time", "hand").cells[1].text, "not settled") << "as on the page Metrics";
    EXPECT_EQ(row(metrics, "Settling time", "hand").cells[1].difference, dash);
    runs[1].metrics.reset(); // not computed yet
    const auto waiting = compareMetrics(runs, 0, TemperatureUnit::Celsius);
    EXPECT_EQ(waiting.size(), metrics.size());
    EXPECT_EQ(row(waiting, "Final", "circle").cells[1].text, dash);
    EXPECT_EQ(row(waiting, "Duration of control", "").cells[1].text, dash);
}

// Catches numbers by readings and by the truth that cannot be told apart, and a run without a truth that is
// given one.
TEST(MetricComparison, TruthStandsBesideTheReadings) {
    auto runs = twoRuns();
    runs[0].metrics->trueObjects = runs[0].metrics->objects;
    runs[0].metrics->trueObjects[0].final_K = kelvinFromCelsius(39.6);
    const auto metrics = compareMetrics(runs, 0, TemperatureUnit::Celsius);
    EXPECT_EQ(metrics.size(), 13U * 4U + 5U);
    EXPECT_EQ(plain(row(metrics, "Final", "circle").cells[0].text), "40.00 °C");
    const ComparedMetric& truth = row(metrics, "Final, true", "circle");
    EXPECT_EQ(plain(truth.cells[0].text), "39.60 °C");
    EXPECT_EQ(truth.cells[1].text, "not known");
    EXPECT_EQ(truth.nameInFiles, "true final (degC)");
    EXPECT_NEAR(truth.cells[0].value.value(), 39.6, 1e-9);
    EXPECT_FALSE(truth.cells[1].value || truth.cells[1].differenceBy);
}

// Catches a file that cannot be read as a table, or has its numbers rounded or in the window's unit.
TEST(MetricComparison, IsExportedAsNumbers) {
    auto runs = twoRuns();
    runs[1].name = "B evening, late";
    runs[0].metrics->objects[1].steadyDeviation_K = 0.0625;
    const auto metrics = compareMetrics(runs, 0, TemperatureUnit::Fahrenheit);
    const QStringList lines = QString::fromStdString(comparisonCsv(runs, 0, metrics)).split('\n');
    ASSERT_EQ(lines.size(), 8 * 4 + 5 + 1 + 2)
        << "with one of standard deviations and a header, ending in a line break";
    EXPECT_EQ(lines[0].toStdString(), "metric,object,A run,\"B evening, late\",B - A");
    EXPECT_TRUE(lines.contains("final (degC),circle,40,40.3,0.3")) << lines.join('\n').toStdString();
    EXPECT_TRUE(lines.contains("settling time (s),hand,70,,"));
    EXPECT_TRUE(lines.contains("settling time (s),ring,,55,"));
    EXPECT_TRUE(lines.contains("path length (m),circle,0.1,0.1,0"));
    EXPECT_TRUE(lines.contains("rotation of the end-effector (rad),,0,0,0"));
    EXPECT_TRUE(lines.join('\n').contains(
        "\nsteady-state error (K),hand,0.02,0.02,0\nsteady-state error s.d. (K),hand,0.062,,\n"))
        << lines.join('\n').toStdString();
    EXPECT_TRUE(lines[0].startsWith(QLatin1String(kComparisonMark)));
}

// Catches a printed difference that is not that of the printed values.
TEST(MetricComparison, DifferencesAreThoseOfTheNumbersBesideThem) {
    double period_s = 1.0;
    const auto shown = [&](double a_s, double b_s, double c_s) {
        std::vector<ComparedRun> runs{comparedRun("A", {{"circle", settled(40.0, a_s)}}),
                                      comparedRun("B", {{"circle", settled(40.0, b_s)}}),
                                      comparedRun("C", {{"circle", settled(40.0, c_s)}})};
        for (ComparedRun& run : runs)
            run.metrics->period_s = period_s;
        const ComparedMetric metric =
            row(compareMetrics(runs, 0, TemperatureUnit::Celsius), "Settling time", "circle");
        return plain(metric.cells[0].text + u'|' + metric.cells[1].text + u'|' + metric.cells[1].difference +
                     u'|' + metric.cells[2].difference);
    };
    EXPECT_EQ(shown(60.04, 60.06, 60.04), "60.0 s|60.1 s|+0.1 s|0.0 s") << "one sample a second";
    EXPECT_EQ(shown(60.0, 61.5, 60.1), "60.0 s|61.5 s|+1.5 s|+0.1 s");
    period_s = 0.1;
    EXPECT_EQ(shown(60.04, 60.06, 60.144), "60.04 s|60.06 s|+0.02 s|+0.10 s");
    period_s = 0.01;
    EXPECT_EQ(shown(60.0449, 60.0551, 60.0), "60.045 s|60.055 s|+0.010 s|\u22120.045 s");
    const auto path = [](double a_m, double b_m) {
        ObjectMetrics a = settled(40.0, 60.0), b = a;
        a.pathLength_m = a_m;
        b.pathLength_m = b_m;
        const auto metrics =
            compareMetrics({comparedRun("A", {{"circle", a}}), comparedRun("B", {{"circle", b}})}, 0,
                           TemperatureUnit::Celsius);
        const ComparedMetric metric = row(metrics, "Path length", "circle");
        return plain(metric.cells[0].text + u'|' + metric.cells[1].text + u'|' + metric.cells[1].difference);
    };
    EXPECT_EQ(path(9.7154, 9.7157), "9715.4 mm|9715.7 mm|+0.3 mm");
}

// Catches values and differences without their uncertainty, one that is added up straight, and more digits
// than it allows.
TEST(MetricComparison, TellsTheUncertaintyOfValuesAndDifferences) {
    ObjectMetrics a = settled(40.031, 62.0), b = settled(40.312, 60.0);
    a.readingUncertainty_K = a.steadyUncertainty_K = 0.15;
    b.readingUncertainty_K = 0.2;
    a.settlingUncertainty_s = 0.3;
    a.riseUncertainty_s = 1.2;
    b.riseUncertainty_s = 0.5;
    a.overshoot_K = 0.5;
    const std::vector<ComparedRun> runs{comparedRun("A", {{"circle", a}}), comparedRun("B", {{"circle", b}})};
    const auto metrics = compareMetrics(runs, 0, TemperatureUnit::Celsius);
    const auto cell = [&metrics](const char* name, std::size_t k) {
        return row(metrics, name, "circle").cells[k];
    };
    EXPECT_EQ(plain(cell("Final", 0).text), "40.03 °C ± 0.15 K");
    EXPECT_EQ(plain(cell("Final", 1).text), "40.31 °C ± 0.20 K");
    EXPECT_EQ(plain(cell("Final", 1).difference), "+0.28 K ± 0.25 K");
    EXPECT_EQ(plain(cell("Settling time", 0).text), "62.0 s ± 0.30 s");
    EXPECT_EQ(plain(cell("Settling time", 1).difference), "\u22122.0 s") << "that of one run is not known";
    EXPECT_EQ(plain(cell("Rise time", 0).text), "30.0 s ± 1.2 s");
    EXPECT_EQ(plain(cell("Rise time", 1).difference), "0.0 s ± 1.3 s");
    EXPECT_EQ(plain(cell("Overshoot", 0).text), "0.50 K ± 0.15 K (3.3 %)");
    EXPECT_EQ(plain(cell("Overshoot", 1).text), "none");
    EXPECT_EQ(plain(cell("Steady-state error", 0).text), "+0.02 K ± 0.15 K");
    EXPECT_EQ(plain(cell("Target", 0).text), "40.0 °C");
    const std::string csv = comparisonCsv(runs, 0, metrics);
    EXPECT_NE(csv.find("\nfinal standard uncertainty (K),circle,0.15,0.2,0.25\n"), std::string::npos) << csv;
    EXPECT_NE(csv.find("\nsettling time standard uncertainty (s),circle,0.3,,\n"), std::string::npos) << csv;
    EXPECT_EQ(csv.find("target standard uncertainty"), std::string::npos);
    a.settlingUncertainty_s = std::numeric_limits<double>::infinity();
    b.settlingUncertainty_s = 0.4;
    const auto unsure = compareMetrics({comparedRun("A", {{"circle", a}}), comparedRun("B", {{"circle", b}})},
                                       0, TemperatureUnit::Celsius);
    EXPECT_EQ(plain(row(unsure, "Settling time", "circle").cells[0].text), "62.0 s, not sure");
    EXPECT_EQ(plain(row(unsure, "Settling time", "circle").cells[1].difference), "\u22122.0 s, not sure");
    a.readingUncertainty_K = 2.3;
    EXPECT_EQ(plain(compareMetrics({comparedRun("A", {{"circle", a}})}, 0, TemperatureUnit::Celsius)
                        .at(2)
                        .cells[0]
                        .text),
              "40.0 °C ± 2.3 K");
}

// Catches "s.d. 0.00", and tenths of a millimetre of a path of metres.
TEST(MetricComparison, ShowsTheDigitsThatMeanSomething) {
    const auto shown = [](double deviation_K, double path_m) {
        ObjectMetrics object = settled(40.0, 62.0);
        object.steadyError_K = 0.0123;
        object.steadyDeviation_K = deviation_K;
        object.pathLength_m = path_m;
        const auto metrics =
            compareMetrics({comparedRun("A", {{"circle", object}})}, 0, TemperatureUnit::Celsius);
        return plain(row(metrics, "Steady-state error", "circle").cells[0].text) + ", " +
               plain(row(metrics, "Path length", "circle").cells[0].text);
    };
    EXPECT_EQ(shown(0.054, 0.1056), "+0.01 K (s.d. 0.05), 105.6 mm");
    EXPECT_EQ(shown(0.004, 9.7156), "+0.012 K (s.d. 0.004), 9716 mm");
    EXPECT_EQ(shown(0.0, 0.0), "+0.01 K (s.d. < 0.01), 0.0 mm") << "it rounds to nought, and is known";
    EXPECT_EQ(shown(2e-4, 0.0), "+0.012 K (s.d. < 0.001), 0.0 mm");
}

// Catches digits of a time that sampling does not tell, of a reading that its sensor does not, and a
// difference in a file that is not that of the numbers beside it.
TEST(MetricComparison, NoDigitsWithoutAMeaning) {
    std::vector<ComparedRun> runs{comparedRun("A", {{"circle", settled(40.03, 77.7266755)}}),
                                  comparedRun("B", {{"circle", settled(40.20400007, 85.00000042)}})};
    runs[0].metrics->objects[0].steadyDeviation_K = 8.396541621e-05;
    for (ComparedRun& run : runs) {
        run.metrics->resolution_K = 0.1;
        run.metrics->atVelocityLimit_s = 446.7266755;
    }
    const auto metrics = compareMetrics(runs, 0, TemperatureUnit::Celsius);
    EXPECT_EQ(plain(row(metrics, "Settling time", "circle").cells[0].text), "77.7 s");
    EXPECT_EQ(plain(row(metrics, "Final", "circle").cells[0].text), "40.0 °C") << "of steps of 0.1 K";
    EXPECT_TRUE(plain(row(metrics, "Time at a velocity limit", "").cells[0].text).starts_with("446.7 s"));
    const QStringList lines = QString::fromStdString(comparisonCsv(runs, 0, metrics)).split('\n');
    for (const char* line :
         {"settling time (s),circle,77.7,85,7.3", "final (degC),circle,40.03,40.204,0.174",
          "steady-state error s.d. (K),circle,8.4e-05,,", "time at a velocity limit (s),,446.7,446.7,0"})
        EXPECT_TRUE(lines.contains(line)) << line << '\n' << lines.join('\n').toStdString();
}

// Catches a file for other programs in the notation of the window's language.
TEST(MetricComparison, TheFileHasThePointInEveryLanguage) {
    const auto csv = [] {
        const auto runs = twoRuns();
        return comparisonCsv(runs, 0, compareMetrics(runs, 0, TemperatureUnit::Celsius));
    };
    const std::string point = csv();
    Language language;
    language.set(QStringLiteral("fr"));
    EXPECT_EQ(csv(), point);
}

struct ComparisonViewTest : testing::Test {
    ComparisonView view;
    QTableWidget* table = view.findChild<QTableWidget*>("comparisonTable");
    QComboBox* references = view.findChild<QComboBox*>("comparisonReference");
    QPushButton* save = view.findChild<QPushButton*>("comparisonExport");
    QLabel* note = view.findChild<QLabel*>("comparisonNote");

    ComparisonViewTest() {
        view.resize(760, 300);
        view.show();
        QApplication::processEvents();
    }
    QStringList header() const {
        QStringList names;
        for (int k = 0; k < table->columnCount(); ++k)
            names << table->horizontalHeaderItem(k)->text();
        return names;
    }
};

// Catches a reference that cannot be chosen, or that changes when the runs are told anew.
TEST_F(ComparisonViewTest, TheReferenceIsChosen) {
    view.setRuns(twoRuns());
    EXPECT_FALSE(table->accessibleName().isEmpty());
    EXPECT_EQ(header(), (QStringList{"A run", "B run", "B \u2212 A"}));
    EXPECT_EQ(table->verticalHeaderItem(0)->text(), "Target \u00b7 circle");
    references->setCurrentIndex(1);
    emit references->activated(1);
    EXPECT_EQ(header(), (QStringList{"A run", "A \u2212 B", "B run"}));
    EXPECT_EQ(plain(table->item(12, 1)->text()), "+4.0 s") << "settling of the circle";
    view.setRuns(twoRuns());
    EXPECT_EQ(references->currentText(), "B run");
    auto others = twoRuns();
    others[1].path = "/runs/C.bask";
    view.setRuns(others);
    EXPECT_EQ(references->currentText(), "A run") << "the chosen one is gone";
    view.setRuns({});
    EXPECT_EQ(table->rowCount(), 0);
}

// Catches a table that cannot be copied, or an export of what is not known yet.
TEST_F(ComparisonViewTest, IsCopiedAndExported) {
    auto runs = twoRuns();
    view.setRuns(runs);
    QTest::keyClick(table, Qt::Key_C, Qt::ControlModifier);
    const QStringList copied = QApplication::clipboard()->text().split('\n');
    ASSERT_EQ(copied.size(), 8 * 4 + 5 + 1);
    EXPECT_EQ(copied[0].toStdString(), "Metric\tObject\tA run\tB run\tB \u2212 A");
    EXPECT_EQ(plain(copied[9]), "Final\tcircle\t40.00 °C\t40.30 °C\t+0.30 K");
    QApplication::clipboard()->clear();
    const QSignalSpy told(&view, &ComparisonView::copied);
    QTest::mouseClick(view.findChild<QPushButton*>("comparisonCopy"), Qt::LeftButton);
    EXPECT_EQ(QApplication::clipboard()->text(), copied.join('\n'));
    ASSERT_EQ(told.count(), 1) << "a person sees nothing else of it";
    EXPECT_TRUE(told[0][0].toString().contains("37"));
    QSignalSpy wanted(&view, &ComparisonView::exportRequested);
    QTest::mouseClick(save, Qt::LeftButton);
    ASSERT_EQ(wanted.count(), 1);
    EXPECT_TRUE(wanted[0][0].toString().startsWith("metric,object,A run,"));

    runs[1].metrics.reset();
    view.setRuns(runs);
    EXPECT_FALSE(save->isEnabled());
    EXPECT_TRUE(note->isVisible());
    EXPECT_TRUE(note->text().contains("B run"));
    runs[1].isFailed = true;
    view.setRuns(runs);
    EXPECT_TRUE(save->isEnabled()) << "it will not be known";
    EXPECT_TRUE(note->text().startsWith("No metrics"));
    view.setRuns(twoRuns());
    EXPECT_FALSE(note->isVisible());
}

// Catches a table that keeps the window waiting.
TEST_F(ComparisonViewTest, SixRunsOfEightObjectsAreShownAtOnce) {
    std::vector<ComparedRun> runs;
    const char* names[] = {"one", "two", "three", "four", "five", "six", "seven", "eight"};
    for (int k = 0; k < 6; ++k) {
        std::vector<std::pair<const char*, ObjectMetrics>> objects;
        for (const char* name : names)
            objects.emplace_back(name, settled(40.0 + 0.1 * k, 60.0 + k));
        runs.push_back(comparedRun(QString(QChar(u'A' + k)), objects));
    }
    QElapsedTimer timer;
    timer.start();
    for (int k = 0; k < 6; ++k) // once for each run whose metrics come
        view.setRuns(runs);
    QApplication::processEvents();
    RecordProperty("ms_each", std::to_string(static_cast<double>(timer.elapsed()) / 6.0));
    EXPECT_LT(timer.elapsed(), 6'000);
    EXPECT_EQ(table->rowCount(), 8 * 8 + 5);
    EXPECT_EQ(table->columnCount(), 11);
    EXPECT_EQ(plain(table->item(24, 10)->text()), "+5.0 s") << "settling of the first object in F";
    EXPECT_TRUE(view.grab().save("comparison.png"));
}

} // namespace bask
