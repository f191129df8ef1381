#include "engine/base/message_code.h"
#include "engine/base/version.h"
#include "engine/experiment/experiment_file.h"
#include "widgets/review/review_page.h"

#include "engine/recording/session_header.h"
#include "engine/recording/session_store.h"
#include "tests/support/first_version.h"
#include "tests/support/longer_translator.h"
#include "tests/support/wait_for.h"
#include "widgets/common/display.h"
#include "widgets/common/event_list.h"
#include "widgets/common/message_bar.h"
#include "widgets/common/metric_words.h"
#include "widgets/common/theme.h"
#include "widgets/plots/plot_place.h"
#include "widgets/plots/trace_plot.h"
#include "widgets/review/comparison_view.h"
#include "widgets/review/final_values.h"
#include "widgets/review/identified_table.h"
#include "widgets/review/outcome_words.h"
#include "widgets/review/replay_view.h"
#include "widgets/review/session_list.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDir>
#include <QElapsedTimer>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalSpy>
#include <QSlider>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

namespace bask {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Three objects that approach 40 degC, the third one too slowly to settle within the 200 s.
SessionRecord record() {
    SessionRecord session;
    session.path = "2026-03-14 morning.bask";
    session.experiment = readExperiment(BASK_EXAMPLES "/three-objects.json").value();
    session.simulated = true;
    session.outcome = "not-settled";
    for (int k = 0; k <= 200; ++k) {
        TraceSample sample;
        sample.time_s = k;
        for (const double tau_s : {18.0, 24.0, 110.0}) {
            ObjectSample object;
            object.target_K = 313.15;
            object.true_K = 313.15 - 15.0 * std::exp(-k / tau_s);
            object.measured_K = std::round(object.true_K * 10.0) / 10.0;
            object.estimated_K = object.true_K + 0.05;
            object.valid = true;
            sample.objects.push_back(object);
        }
        session.samples.push_back(sample);
    }
    const auto event = [&](double time_s, MessageCode code) {
        session.events.push_back({time_s, {code, {}}});
    };
    event(0.0, MessageCode::EventZeroed);
    event(0.0, MessageCode::EventStarted);
    event(90.0, MessageCode::EventGainsChanged);
    event(200.0, MessageCode::EventNotSettled);
    session.notes.push_back({45.0, "door opened"});
    return session;
}

QStringList sentences() {
    return {"Sensors zeroed at ambient", "Started", "Controller or gains changed", "Not settled: hand"};
}

/// A run of so many samples at 10 Hz.
SessionRecord longRecord(int samples) {
    SessionRecord session = record();
    const TraceSample last = session.samples.back();
    session.samples.assign(static_cast<std::size_t>(samples), last);
    for (int k = 0; k < samples; ++k)
        session.samples[static_cast<std::size_t>(k)].time_s = 0.1 * k;
    return session;
}

void alter(const RecordedSession& session, const std::string& sql) {
    const auto store = SessionStore::create(session.facts().path);
    ASSERT_TRUE((*store)->execute(sql)) << sql;
}

/// Blocks of its samples that are in memory.
std::size_t blocksHeld(const RecordedSession& session) {
    std::size_t count = 0;
    for (std::size_t k = 0; k * RecordedSession::kBlock < session.size(); ++k)
        count += session.holds(k) ? 1 : 0;
    return count;
}

/// The record as a file of the folder.
std::string written(const QTemporaryDir& folder, const SessionRecord& session) {
    std::string path = folder.filePath(QString::fromStdString(session.path)).toStdString();
    auto writer = SessionWriter::create(path, session.experiment, session.simulated, 1e6,
                                        SessionWriter::Earlier::Replaced);
    EXPECT_TRUE(writer);
    for (const TraceSample& sample : session.samples)
        EXPECT_TRUE((*writer)->add(sample));
    for (const TraceEvent& event : session.events)
        EXPECT_TRUE((*writer)->add(event));
    for (const TraceNote& note : session.notes)
        EXPECT_TRUE((*writer)->add(note));
    if (!session.prediction.samples.empty()) {
        EXPECT_TRUE((*writer)->add(session.prediction));
    }
    if (!session.interrupted()) {
        EXPECT_TRUE((*writer)->finish(session.outcome));
    }
    return path;
}

struct ReviewPageTest : testing::Test {
    QTemporaryDir folder;
    ReviewPage page;

    ReviewPageTest() {
        page.resize(1150, 620);
        page.show();
        QApplication::processEvents();
    }
    std::shared_ptr<RecordedSession> opened(const SessionRecord& session) {
        return RecordedSession::open(written(folder, session)).value();
    }
    /// With its metrics.
    std::shared_ptr<RecordedSession> show(const SessionRecord& session) {
        auto run = opened(session);
        page.setSession(run, sentences());
        page.setMetrics(runMetrics(session));
        return run;
    }
    template <class T> T* child(const char* name) {
        auto* found = page.findChild<T*>(name);
        EXPECT_NE(found, nullptr) << name;
        return found;
    }
    QString text(const char* name) { return child<QLabel>(name)->text(); }
    QString cell(int row, int column) {
        return child<FinalValuesTable>("finalValues")->item(row, column)->text().replace(QChar(0x00a0), ' ');
    }
};

/// With a run that can be laid over the open one: it takes twice as long.
struct ReviewOverlayTest : ReviewPageTest {
    SessionRecord evening = record();
    std::shared_ptr<RecordedSession> other;
    TracePlot* plot = child<TracePlot>("review.measured_K");
    QTabWidget* tabs = child<QTabWidget>("reviewTabs");
    QTableWidget* comparison = child<QTableWidget>("comparisonTable");
    const QStringList eveningAlone{"circle B", "bunny B", "hand B"};

    ReviewOverlayTest() {
        evening.path = "evening.bask";
        for (TraceSample& sample : evening.samples)
            sample.time_s *= 2.0;
        show(record());
        other = opened(evening);
    }
    /// The same run by another name.
    std::shared_ptr<RecordedSession> renamed(const char* path) {
        evening.path = path;
        return opened(evening);
    }
    void takeAway(const char* button) {
        QTest::mouseClick(child<QPushButton>(button), Qt::LeftButton);
        QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    bool isCompared() { return tabs->indexOf(page.replay()->comparison()) >= 0; }
    QString heading(int column) { return comparison->horizontalHeaderItem(column)->text(); }
};

/// Two runs of 118 blocks, one over the other, with one hot sample in fifty minutes; recorded once.
struct ReviewLongRunTest : ReviewPageTest {
    static constexpr int kHot = 20'000; ///< at 2000 s
    static constexpr double kHot_K = 350.0;
    inline static std::unique_ptr<QTemporaryDir> recordings;
    inline static std::string runPath, otherPath;
    inline static RunMetrics metrics;
    std::shared_ptr<RecordedSession> run = RecordedSession::open(runPath).value(),
                                     other = RecordedSession::open(otherPath).value();
    TracePlot* plot = child<TracePlot>("review.measured_K");

    static void SetUpTestSuite() {
        recordings = std::make_unique<QTemporaryDir>();
        SessionRecord session = longRecord(30'000);
        session.samples[kHot].objects[1].measured_K = kHot_K;
        metrics = runMetrics(session);
        runPath = written(*recordings, session);
        session.path = "other.bask";
        otherPath = written(*recordings, session);
    }
    static void TearDownTestSuite() { recordings.reset(); }

    ReviewLongRunTest() {
        page.setSession(run, sentences());
        page.setMetrics(metrics);
        EXPECT_TRUE(page.replay()->addOverlay(other));
        plot->redraw();
    }
    QString tile(const char* object, const char* label) {
        return child<QWidget>(object)->findChild<QLabel*>(label)->text();
    }
};

// Catches a button of the open run that nobody hears.
TEST_F(ReviewPageTest, TheExperimentOfTheRunIsAskedFor) {
    show(record());
    QSignalSpy asked(&page, &ReviewPage::experimentRequested);
    child<QComboBox>("reviewDetails")->setCurrentIndex(4);
    QApplication::processEvents();
    auto* button = child<QPushButton>("useExperiment");
    ASSERT_TRUE(button->isVisible());
    QTest::mouseClick(button, Qt::LeftButton);
    EXPECT_EQ(asked.count(), 1);
}

// Catches an empty page without a way on.
TEST_F(ReviewPageTest, EmptyPageOffersToOpen) {
    QSignalSpy open(&page, &ReviewPage::openRequested);
    ASSERT_TRUE(child<QPushButton>("openSessionEmpty")->isVisible());
    EXPECT_FALSE(child<QPushButton>("exportSession")->isVisible());
    QTest::mouseClick(child<QPushButton>("openSessionEmpty"), Qt::LeftButton);
    EXPECT_EQ(open.count(), 1);
}

// Catches facts of the run that are left out or wrong.
TEST_F(ReviewPageTest, HeaderTellsTheFacts) {
    show(record());
    EXPECT_EQ(text("sessionFile"), "2026-03-14 morning.bask");
    EXPECT_EQ(text("sessionTag"), "SIMULATED");
    EXPECT_EQ(text("factDuration"), "3:20");
    EXPECT_EQ(text("factController"), "Level servo");
    EXPECT_EQ(
        text("factBelief"),
        QString("The controller begins with heat rates wrong by up to \u00d74, as the experiment asks."));
    EXPECT_EQ(text("factOutcome"), "Not all objects settled");
    EXPECT_EQ(text("factSoftware"), "Bask " BASK_VERSION);
    EXPECT_TRUE(text("factCreated").contains(':'));
    EXPECT_TRUE(text("factPace").startsWith("Faster than real time: 3:20 (min:s)"));
    SessionRecord stopped = record();
    stopped.events.push_back({20.0, {MessageCode::EventEmergencyStop, {}}});
    show(stopped);
    EXPECT_EQ(text("factDuration"), "0:20, recorded until 3:20") << "it cooled until then";
    stopped.samples.resize(20);
    show(stopped);
    EXPECT_EQ(text("factDuration"), "0:20") << "as in the metrics, also where nothing was recorded after it";

    SessionRecord broken = record();
    broken.outcome.clear();
    broken.simulated = false;
    broken.experiment.controller.estimatedRateErrorFactor = 1.0;
    show(broken);
    EXPECT_EQ(text("factBelief"), "");
    EXPECT_EQ(text("factPace"), "");
    EXPECT_TRUE(text("factOutcome").startsWith("Interrupted"));
    EXPECT_EQ(text("sessionTag"), "LIVE");

    broken.outcome = "stopped"; // by the operator, or at the end of a recipe's step
    show(broken);
    EXPECT_EQ(text("factOutcome"), "Stopped");
    broken.outcome = "emergency-stop";
    show(broken);
    EXPECT_EQ(text("factOutcome"), "Ended by STOP");
    EXPECT_EQ(text("outcomeWord"), "STOP");
    const auto shape = [](Outcome outcome) { return outcomePixmap(outcome, false, 16, 1.0).toImage(); };
    for (const Outcome other : {Outcome::Stopped, Outcome::Fault, Outcome::Unreadable, Outcome::Other})
        EXPECT_NE(shape(Outcome::EmergencyStop), shape(other));
}

// Catches final errors judged on the wrong temperature, with the wrong sign, or settling times that are made
// up.
TEST_F(ReviewPageTest, FinalValuesPerObject) {
    const SessionRecord session = record();
    show(session);
    ASSERT_EQ(child<FinalValuesTable>("finalValues")->rowCount(), 3);
    EXPECT_EQ(cell(0, 0), "circle");
    EXPECT_EQ(cell(0, 1).toStdString(), "40.0 °C") << "as the others, or the error is not their difference";
    EXPECT_EQ(cell(0, 2).toStdString(), "40.0 °C") << "39.95 of a sensor with steps of 0.1 K";
    EXPECT_EQ(cell(0, 4), "0.0 K");
    EXPECT_EQ(cell(0, 5), QString("%1 s").arg(std::ceil(18.0 * std::log(30.0))));
    EXPECT_EQ(cell(0, 3).toStdString(), "40.00 °C");
    EXPECT_EQ(cell(2, 5), "not settled");
    EXPECT_EQ(cell(2, 4), QString(QChar(0x2212)) + "2.4 K") << "310.7 K was read, 310.716 K was true";
    auto* table = child<FinalValuesTable>("finalValues");
    EXPECT_EQ(table->horizontalHeaderItem(2)->text(), "Final");
    EXPECT_EQ(table->horizontalHeaderItem(3)->text(), "True");
    EXPECT_FALSE(table->isColumnHidden(3));
}

// Catches rates without their error, an object's failure without its reason, and a button that has nothing to
// give.
TEST_F(ReviewPageTest, ShowsTheIdentifiedRatesBesideTheControllers) {
    show(record());
    auto* use = child<QPushButton>("useIdentified");
    EXPECT_FALSE(use->isEnabled());
    EXPECT_TRUE(text("identifiedNote").startsWith("Fitting"));
    IdentifiedRow good;
    good.name = "circle";
    good.lambda1 = {0.21537, 0.0042};
    good.lambda2 = {2.1e-11, 3e-13};
    good.controller = 0.2301;
    good.material = 0.2203;
    good.begun = 0.1021;
    IdentifiedRow bad;
    bad.name = "hand";
    bad.unusable = "The source was never in view.";
    page.setIdentified({good, bad});
    auto* table = child<IdentifiedTable>("identifiedRates");
    ASSERT_EQ(table->rowCount(), 2);
    EXPECT_EQ(table->item(0, 1)->text(), QString("0.2154 \u00b1 0.0042"));
    EXPECT_EQ(table->item(0, 2)->text(), "0.2301");
    EXPECT_EQ(table->item(0, 3)->text(), "0.2203");
    EXPECT_EQ(table->item(0, 4)->text(), "0.1021");
    EXPECT_EQ(table->item(1, 1)->text(), "not usable");
    EXPECT_EQ(text("identifiedNote"), "hand: The source was never in view.");
    QSignalSpy wanted(&page, &ReviewPage::useIdentifiedRequested);
    ASSERT_TRUE(use->isEnabled());
    QTest::mouseClick(use, Qt::LeftButton);
    EXPECT_EQ(wanted.count(), 1);
    page.setIdentified({bad});
    EXPECT_FALSE(use->isEnabled());
    page.setIdentificationFailed("It went wrong.");
    EXPECT_EQ(text("identifiedNote"), "It went wrong.");
    EXPECT_EQ(table->rowCount(), 0);
    show(record()); // another one: what was said of the last is gone
    EXPECT_TRUE(text("identifiedNote").startsWith("Fitting"));
}

// Catches: a loss or an h without unit or error, an h that the record does not tell, and a radiation that is
// the air's in part and of which that is not said.
TEST_F(ReviewPageTest, TellsWhatTheRecordSaysOfTheAir) {
    show(record());
    IdentifiedRow apart;
    apart.name = "circle";
    apart.lambda1 = {0.21537, 0.0042};
    apart.working_K = 313.04;
    apart.loss = {0.085438, 0.00056};
    apart.lossSlope = {0.0059489, 0.00032};
    apart.convection = {8.13, 0.42};
    IdentifiedRow together = apart;
    together.name = "hand";
    together.hUntold = "The record tells lambda2 within 330 % only.";
    together.isAirApart = false;
    page.setIdentified({apart, together});
    const auto* table = child<IdentifiedLosses>("identifiedLosses");
    ASSERT_EQ(table->rowCount(), 2);
    const QStringList told{"circle", "39.9\u00a0\u00b0C", "0.08544 \u00b1 0.00056", "8.13 \u00b1 0.42"};
    for (int column = 0; column < told.size(); ++column)
        EXPECT_EQ(table->item(0, column)->text().toStdString(), told[column].toStdString());
    page.setTemperatureUnit(TemperatureUnit::Kelvin);
    EXPECT_EQ(table->item(0, 1)->text(), QString("313.0\u00a0K"));
    EXPECT_TRUE(table->item(0, 2)->toolTip().contains("0.00595 \u00b1 0.00032 1/s"));
    EXPECT_EQ(table->horizontalHeaderItem(3)->text(), QString("h, W/(m\u00b2 K)"));
    EXPECT_EQ(table->item(1, 3)->text(), "not told");
    EXPECT_EQ(table->item(1, 3)->toolTip(), together.hUntold);
    EXPECT_TRUE(text("identifiedNote").startsWith("The record tells the losses of hand, but not"));
    EXPECT_TRUE(child<QPushButton>("useIdentified")->isEnabled());
    page.setIdentified({apart});
    EXPECT_EQ(text("identifiedNote"), "");
}

// Catches a final value with other digits than among the metrics of the same page.
TEST_F(ReviewPageTest, AFinalValueHasTheDigitsOfItsUncertainty) {
    const SessionRecord session = record();
    RunMetrics metrics = runMetrics(session);
    metrics.objects[0].readingUncertainty_K = 0.02;
    metrics.objects[1].readingUncertainty_K = 40.0;
    page.setSession(opened(session), sentences());
    page.setMetrics(metrics);
    for (const TemperatureUnit unit : {TemperatureUnit::Celsius, TemperatureUnit::Fahrenheit}) {
        page.setTemperatureUnit(unit);
        for (int i = 0; i < 3; ++i) {
            QString told = metricText({ObjectMetric::Final}, metrics, static_cast<std::size_t>(i), unit);
            told.replace(QChar(0x00a0), ' ');
            EXPECT_EQ(cell(i, 2).toStdString(), told.section(" \u00b1", 0, 0).toStdString()) << i;
        }
        EXPECT_NE(cell(0, 2).section('.', 1).size(), cell(1, 2).section('.', 1).size());
    }
}

// Catches the cool-down after Stop taken for the run's end.
TEST_F(ReviewPageTest, FinalValuesAreThoseAtStop) {
    SessionRecord session = record();
    TraceSample retreated = session.samples.back();
    retreated.time_s += 20.0;
    for (ObjectSample& object : retreated.objects) {
        object.measured_K -= 8.0;
        object.true_K -= 8.0;
    }
    session.events.push_back({session.samples.back().time_s, {MessageCode::EventStopped, {}}});
    session.samples.push_back(retreated);
    show(session);
    EXPECT_EQ(cell(0, 4), "0.0 K");
    EXPECT_EQ(cell(0, 3).toStdString(), "40.00 °C");
    EXPECT_EQ(cell(0, 5), QString("%1 s").arg(std::ceil(18.0 * std::log(30.0))));
}

// Catches a real rig's reading shown as the truth.
TEST_F(ReviewPageTest, WithoutATruthTheReadingsStandAlone) {
    SessionRecord session = record();
    for (TraceSample& sample : session.samples)
        for (ObjectSample& object : sample.objects)
            object.true_K = kNan;
    show(session);
    EXPECT_EQ(cell(0, 2).toStdString(), "40.0 °C");
    EXPECT_TRUE(child<FinalValuesTable>("finalValues")->isColumnHidden(3));
    EXPECT_EQ(child<QTableWidget>("metricsTable")->rowCount(), 13);
    QTest::keyClick(child<FinalValuesTable>("finalValues"), Qt::Key_C, Qt::ControlModifier);
    EXPECT_EQ(QApplication::clipboard()->text().split('\n').first(),
              "Object\tTarget\tFinal\tError\tSettled at");
}

// Catches traces that are not those of the record.
TEST_F(ReviewPageTest, TracesAreThoseOfTheRun) {
    show(record());
    auto* plot = child<TracePlot>("review.measured_K");
    ASSERT_GE(plot->seriesCount(), 3);
    EXPECT_EQ(plot->seriesName(0), "circle");
    EXPECT_EQ(plot->seriesPoints(0).size(), 201);
    EXPECT_EQ(plot->seriesPoints(0).last().x(), 200.0);
    EXPECT_TRUE(plot->markerTexts().contains("door opened"));
    EXPECT_TRUE(plot->markerTexts().contains("New gains")) << "as on the Run page";
    EXPECT_GE(child<TracePlot>("review.error_K")->seriesCount(), 3);
}

// Catches events and notes out of order or missing.
TEST_F(ReviewPageTest, ThePredictionIsBehindTheTracesOfItsRun) {
    SessionRecord session = record();
    for (int k = 0; k <= 30; ++k) {
        PredictedSample sample;
        sample.time_s = 10.0 * k;
        sample.temperatures_K = sample.lowest_K = sample.highest_K = {310.0, 311.0, 312.0};
        session.prediction.samples.push_back(std::move(sample));
    }
    const auto* plot = child<TracePlot>("review.measured_K");
    show(session);
    EXPECT_EQ(plot->predictedPoints(2).size(), 31);
    EXPECT_TRUE(plot->predictionLabel().contains("other sensor noise only"));
    EXPECT_LT(plot->visibleTo_s(), 230.0) << "the run's own time";
    SessionRecord other = record();
    other.path = "without.bask";
    show(other);
    EXPECT_TRUE(plot->predictedPoints(2).isEmpty()) << "that of another run";
}

TEST_F(ReviewPageTest, EventsAndNotesInOrderOfTime) {
    show(record());
    auto* events = child<EventList>("reviewEvents");
    ASSERT_EQ(events->count(), 5);
    EXPECT_EQ(events->textAt(0), "Sensors zeroed at ambient");
    EXPECT_EQ(events->textAt(2), "door opened");
    EXPECT_EQ(events->textAt(4), "Not settled: hand");
}

// Catches a unit switch that leaves a part in the old unit.
TEST_F(ReviewPageTest, UnitSwitch) {
    show(record());
    page.setTemperatureUnit(TemperatureUnit::Kelvin);
    EXPECT_EQ(cell(0, 1).toStdString(), "313.15 K");
    EXPECT_NEAR(child<TracePlot>("review.measured_K")->seriesPoints(0).last().y(), 313.15, 0.2);
}

// Catches a run of an empty file, and buttons that ask for the wrong thing.
TEST_F(ReviewPageTest, EmptyRunAndButtons) {
    SessionRecord session = record();
    session.samples.clear();
    show(session);
    EXPECT_EQ(text("factDuration"), QString(QChar(0x2014)));
    EXPECT_EQ(cell(0, 5), "not settled");
    QSignalSpy open(&page, &ReviewPage::openRequested);
    QSignalSpy save(&page, &ReviewPage::exportRequested);
    QTest::mouseClick(child<QPushButton>("openSession"), Qt::LeftButton);
    const QList<QAction*> forms = child<QPushButton>("exportSession")->menu()->actions();
    ASSERT_EQ(forms.size(), 7);
    for (QAction* form : forms)
        form->trigger();
    EXPECT_EQ(open.count(), 1);
    QList<SessionForm> asked;
    for (const QList<QVariant>& call : save)
        asked << call.first().value<SessionForm>();
    EXPECT_EQ(asked, (QList<SessionForm>{SessionForm::ReportPdf, SessionForm::ReportHtml,
                                         SessionForm::Figures, SessionForm::Csv, SessionForm::CsvAllDigits,
                                         SessionForm::Nexus, SessionForm::Vtk}));
    page.clear();
    EXPECT_TRUE(child<QPushButton>("openSessionEmpty")->isVisible());
}

// Catches text that stays in the old language or has no room in a longer one.
TEST_F(ReviewPageTest, LanguageChangeWithLongerText) {
    show(record());
    LongerTranslator longer;
    qApp->installTranslator(&longer);
    for (int i = 0; i < 6; ++i) // nested layouts settle one after the other
        QApplication::processEvents();
    page.grab().save("review_longer.png");
    EXPECT_TRUE(text("factOutcome").startsWith('['));
    EXPECT_TRUE(text("sessionTag").startsWith('['));
    EXPECT_TRUE(text("outcomeWord").startsWith('['));
    EXPECT_TRUE(child<QPushButton>("exportSession")->text().startsWith('['));
    EXPECT_TRUE(child<FinalValuesTable>("finalValues")->horizontalHeaderItem(3)->text().startsWith('['));
    EXPECT_TRUE(cell(2, 5).startsWith('['));
    qApp->removeTranslator(&longer);
    QApplication::processEvents();
    EXPECT_EQ(text("sessionTag"), "SIMULATED");
}

// Catches a replay whose tiles, lines and slider do not tell the same moment, and a seek that takes long.
TEST_F(ReviewPageTest, ASeekMovesAllToThatMoment) {
    show(record());
    EXPECT_EQ(child<QLabel>("replayTime")->text(), "0:00 / 3:20");
    QElapsedTimer timer;
    timer.start();
    for (const int moment_s : {20, 199, 3, 120, 55, 90, 10, 199, 1, 40}) {
        page.replay()->seek(moment_s);
        QApplication::processEvents();
    }
    RecordProperty("ms_each", std::to_string(static_cast<double>(timer.elapsed()) / 10.0));
    EXPECT_LT(timer.elapsed(), 10'000) << "ten seeks with what they draw";
    EXPECT_EQ(child<QLabel>("replayTime")->text(), "0:40 / 3:20");
    EXPECT_EQ(child<QSlider>("replaySlider")->value(), 40'000);
    EXPECT_EQ(child<TracePlot>("review.measured_K")->position_s(), 40.0);
    const double then_K = std::round((313.15 - 15.0 * std::exp(-40 / 18.0)) * 10.0) / 10.0;
    auto* tile = child<QWidget>("reviewTile.0");
    EXPECT_EQ(tile->findChild<QLabel*>("tileTemperature")->text(),
              formatTemperature(then_K, TemperatureUnit::Celsius));
    child<QSlider>("replaySlider")->setValue(60'000);
    EXPECT_EQ(child<TracePlot>("review.error_K")->position_s(), 60.0);
    emit child<TracePlot>("review.measured_K")->momentClicked(75.0);
    EXPECT_EQ(page.replay()->position_s(), 75.0);
}

// Catches a tile and a cursor that tell different temperatures of one moment between two samples.
TEST_F(ReviewPageTest, TileAndCursorReadTheSameSample) {
    show(record());
    for (const double moment_s : {10.0, 10.2, 10.8}) {
        page.replay()->seek(moment_s);
        const QString tile = child<QWidget>("reviewTile.0")->findChild<QLabel*>("tileTemperature")->text();
        const QString read = child<TracePlot>("review.measured_K")->readout(moment_s);
        EXPECT_TRUE(read.startsWith("0:10")) << read.toStdString();
        EXPECT_TRUE(read.contains(tile)) << read.toStdString() << ", tile " << tile.toStdString();
    }
}

// Catches a zoomed plot that is turned over to the time after the last sample.
TEST_F(ReviewPageTest, TheEndStaysAtTheRightEdge) {
    show(record());
    auto* plot = child<TracePlot>("review.measured_K");
    emit plot->timeRangeChosen(100.0, 120.0);
    page.replay()->seek(199.0);
    EXPECT_NEAR(plot->visibleFrom_s(), 180.0, 1e-9);
    EXPECT_NEAR(plot->visibleTo_s(), 200.0, 1e-9);
    page.replay()->seek(50.0);
    EXPECT_NEAR(plot->visibleFrom_s(), 48.0, 1e-9) << "a page of which the moment is at the begin";
}

// Catches events and notes that cannot be gone to, and a zoomed plot that stays behind.
TEST_F(ReviewPageTest, AClickInTheListGoesToThatMoment) {
    show(record());
    auto* plot = child<TracePlot>("review.measured_K");
    emit plot->timeRangeChosen(100.0, 120.0);
    auto* tree = child<QTreeWidget>("eventListTree");
    emit tree->itemClicked(tree->topLevelItem(2), 2);
    EXPECT_EQ(page.replay()->position_s(), 45.0);
    EXPECT_LE(plot->visibleFrom_s(), 45.0);
    EXPECT_GE(plot->visibleTo_s(), 45.0);
    EXPECT_NEAR(plot->visibleTo_s() - plot->visibleFrom_s(), 20.0, 1e-6) << "as far zoomed in as before";
    EXPECT_EQ(child<TracePlot>("review.error_K")->visibleFrom_s(), plot->visibleFrom_s());
}

// Catches a run with shade that is reviewed without it, and one without that has an empty plot of it.
TEST_F(ReviewPageTest, ShowsTheShadeOfARunThatCanHaveSome) {
    SessionRecord session = record();
    auto* plot = child<TracePlot>("review.shade");
    auto* tabs = child<QTabWidget>("reviewTabs");
    const int tab = tabs->indexOf(plot->parentWidget());
    ASSERT_GE(tab, 0);
    for (ObjectSpec& object : session.experiment.objects)
        object.mounting.tail<4>().setZero(); // in one plane
    show(session);
    EXPECT_FALSE(tabs->isTabVisible(tab));
    session.path = "stacked.bask";
    session.experiment.objects[1].mounting = session.experiment.objects[0].mounting;
    session.experiment.objects[1].mounting[2] -= 0.02;
    for (TraceSample& sample : session.samples)
        for (ObjectSample& object : sample.objects) {
            object.viewFactor = 0.15;
            object.unshadedViewFactor = 0.2;
        }
    show(session);
    ASSERT_TRUE(tabs->isTabVisible(tab));
    tabs->setCurrentIndex(tab);
    plot->redraw();
    ASSERT_FALSE(plot->seriesPoints(0).isEmpty());
    EXPECT_NEAR(plot->seriesPoints(0).back().y(), 25.0, 1e-6);
}

// Catches a zoomed plot that moves when a tab is looked at, or that goes on behind the end of the run.
TEST_F(ReviewPageTest, AZoomedPlotMovesWithTheReplayOnly) {
    show(record());
    auto* plot = child<TracePlot>("review.measured_K");
    plot->setTimeRange(100.0, 120.0);
    emit plot->timeRangeChosen(100.0, 120.0);
    auto* tabs = child<QTabWidget>("reviewTabs");
    for (int tab = 0; tab < tabs->count(); ++tab)
        if (tabs->widget(tab)->findChild<TracePlot*>() != nullptr) { // the scene wants OpenGL
            tabs->setCurrentIndex(tab);
            EXPECT_EQ(plot->visibleFrom_s(), 100.0) << tab;
        }
    EXPECT_EQ(child<TracePlot>("review.view_factor")->visibleFrom_s(), 100.0);
    page.replay()->seek(200.0);
    EXPECT_NEAR(plot->visibleTo_s(), 200.0, 1e-6) << "not a stretch that is nearly empty";
    EXPECT_NEAR(plot->visibleFrom_s(), 180.0, 1e-6);
}

// Catches Space that does nothing, a replay that goes on unseen, and one that does not advance.
TEST_F(ReviewPageTest, SpacePlaysAndPauses) {
    show(record());
    page.activateWindow();
    auto* speed = child<QComboBox>("replaySpeed");
    ASSERT_EQ(speed->count(), 10);
    speed->setCurrentIndex(speed->findData(100.0));
    auto* play = child<QPushButton>("replayPlay");
    EXPECT_EQ(play->text(), "Play");
    QTest::keyClick(&page, Qt::Key_Space);
    EXPECT_EQ(play->text(), "Pause");
    ASSERT_TRUE(test::waitFor([this] { return page.replay()->position_s() > 20.0; }));
    EXPECT_GT(child<TracePlot>("review.measured_K")->position_s().value_or(0.0), 0.0);
    QTest::keyClick(&page, Qt::Key_Space);
    const double there_s = page.replay()->position_s();
    QTest::qWait(60);
    EXPECT_EQ(page.replay()->position_s(), there_s);
    QTest::keyClick(&page, Qt::Key_Space);
    page.hide();
    EXPECT_EQ(play->text(), "Play") << "hidden, it pauses";
    page.show();
    page.replay()->seek(199.0);
    QTest::mouseClick(play, Qt::LeftButton);
    EXPECT_TRUE(test::waitFor([&] { return play->text() == "Play"; })) << "at the end it stops";
    EXPECT_EQ(page.replay()->position_s(), 200.0);
}

// Catches Space that does nothing and says nothing where no run is open.
TEST_F(ReviewPageTest, SpaceWithoutARunSaysWhy) {
    QSignalSpy told(&page, &ReviewPage::told);
    QTest::keyClick(&page, Qt::Key_Space);
    ASSERT_EQ(told.count(), 1);
    EXPECT_TRUE(told[0][0].toString().contains("no run is open"));
    show(record());
    QTest::keyClick(&page, Qt::Key_Space);
    EXPECT_EQ(told.count(), 1);
}

// Catches metrics without definitions, in the wrong unit, or of another run.
TEST_F(ReviewPageTest, MetricsHaveTheirDefinitions) {
    show(record());
    auto* table = child<QTableWidget>("metricsTable");
    ASSERT_EQ(table->columnCount(), 3);
    ASSERT_EQ(table->rowCount(), 18);
    EXPECT_EQ(table->horizontalHeaderItem(0)->text(), "circle");
    EXPECT_EQ(table->verticalHeaderItem(0)->text(), "Target");
    EXPECT_EQ(table->verticalHeaderItem(1)->text(), "Step");
    EXPECT_EQ(table->verticalHeaderItem(2)->text(), "Final");
    EXPECT_EQ(table->verticalHeaderItem(3)->text(), "Final, true");
    EXPECT_EQ(table->item(2, 0)->text().replace(QChar(0x00a0), ' ').toStdString(), "40.0 °C");
    EXPECT_EQ(table->item(3, 0)->text().replace(QChar(0x00a0), ' ').toStdString(), "40.00 °C");
    EXPECT_EQ(table->item(4, 0)->text(), QString("%1.0 s").arg(std::ceil(18.0 * std::log(30.0))));
    EXPECT_EQ(table->item(4, 2)->text(), "not settled");
    for (int row = 0; row < table->rowCount(); ++row)
        EXPECT_GT(table->verticalHeaderItem(row)->toolTip().size(), 20) << row;
    page.setTemperatureUnit(TemperatureUnit::Kelvin);
    EXPECT_EQ(table->item(0, 0)->text().replace(QChar(0x00a0), ' ').toStdString(), "313.2 K");
    QTest::keyClick(table, Qt::Key_C, Qt::ControlModifier);
    const QStringList copied = QApplication::clipboard()->text().split('\n');
    ASSERT_EQ(copied.size(), 19);
    EXPECT_EQ(copied[0], "\tcircle\tbunny\thand");
    EXPECT_TRUE(copied[1].startsWith("Target\t313.2"));
    QSignalSpy wanted(&page, &ReviewPage::definitionsRequested);
    emit child<QLabel>("metricsDetails")->linkActivated("#");
    EXPECT_EQ(wanted.count(), 1);
}

// Catches numbers of an object that are out of sight until a splitter is dragged, or cut in their cell.
TEST_F(ReviewPageTest, MetricsOfThreeObjectsAreSeenAtOnce) {
    page.resize(1180, 640); // in a window of 1280 x 800
    show(record());
    QApplication::processEvents();
    const auto* table = child<QTableWidget>("metricsTable");
    ASSERT_TRUE(table->isVisible()) << "without choosing it";
    EXPECT_EQ(table->horizontalScrollBar()->maximum(), 0);
    const int margin = 2 * (page.style()->pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, table) + 1);
    for (int row = 0; row < table->rowCount(); ++row)
        for (int column = 0; column < table->columnCount(); ++column) {
            const QTableWidgetItem* item = table->item(row, column);
            if (item == nullptr || table->columnSpan(row, column) > 1)
                continue;
            const QRect needed = table->fontMetrics().boundingRect(0, 0, table->columnWidth(column) - margin,
                                                                   1000, Qt::TextWordWrap, item->text());
            EXPECT_LE(needed.width(), table->columnWidth(column) - margin) << item->text().toStdString();
            EXPECT_LE(needed.height(), table->rowHeight(row)) << item->text().toStdString();
        }
    EXPECT_TRUE(page.grab().save("review_metrics.png"));
}

// Catches a run that is laid over itself, or twice.
TEST_F(ReviewOverlayTest, ARunIsLaidOverOnce) {
    ASSERT_TRUE(page.replay()->addOverlay(other));
    EXPECT_FALSE(page.replay()->addOverlay(other)) << "it is there";
    EXPECT_FALSE(page.replay()->addOverlay(opened(record()))) << "it is the open one";
    EXPECT_EQ(plot->overlayLabels(), eveningAlone);
}

// Catches an overlay without its mark, out of view, or in the old unit.
TEST_F(ReviewOverlayTest, EveryPlotHasIt) {
    ASSERT_TRUE(page.replay()->addOverlay(other));
    EXPECT_EQ(plot->overlayLabels(), eveningAlone);
    EXPECT_EQ(plot->visibleTo_s(), 400.0) << "the longer run is in view";
    EXPECT_EQ(plot->seriesPoints(0).last().x(), 200.0);
    tabs->setCurrentIndex(3);
    EXPECT_EQ(child<TracePlot>("review.speed")->overlayLabels().size(), 2);
    page.setTemperatureUnit(TemperatureUnit::Kelvin);
    EXPECT_EQ(plot->overlayLabels().size(), 3);
}

// Catches a figure whose key calls the runs by their files where their controllers tell them apart.
TEST_F(ReviewOverlayTest, RunsAreCalledByWhatTellsThemApart) {
    SessionRecord first = record(), second = record();
    first.path = "20260314T092653Z.bask";
    second.path = "20260314T102653Z.bask";
    first.experiment.controller.kind = ControllerKind::LevelServo;
    second.experiment.controller.kind = ControllerKind::Adaptive;
    show(first);
    ASSERT_TRUE(page.replay()->addOverlay(opened(second)));
    EXPECT_TRUE(child<QPushButton>("overlay.B")->text().startsWith("B  Adaptive"));
    const QString svg = QString::fromUtf8(plot->figure({}, FigureFormat::Svg, {}));
    const qsizetype own = svg.indexOf(QString::fromUtf8(">A Level servo · circle<"));
    EXPECT_GE(own, 0);
    EXPECT_GT(svg.indexOf(QString::fromUtf8(">B Adaptive · circle<")), own);
}

// Catches a button beside the overlaid runs that nobody hears.
TEST_F(ReviewOverlayTest, TheFigureIsExportedInEveryForm) {
    ASSERT_TRUE(page.replay()->addOverlay(other));
    int asked = 0;
    QObject::connect(qobject_cast<PlotPlace*>(plot->parentWidget()), &PlotPlace::exportRequested,
                     [&] { ++asked; });
    for (QAction* form : child<QPushButton>("overlayExport")->menu()->actions())
        form->trigger();
    EXPECT_EQ(asked, 4);
}

// Catches an overlay that cannot be taken away.
TEST_F(ReviewOverlayTest, OneIsTakenAwayAndTheLettersMoveUp) {
    ASSERT_TRUE(page.replay()->addOverlay(other));
    ASSERT_TRUE(page.replay()->addOverlay(renamed("night.bask")));
    QTest::qWait(100);
    EXPECT_TRUE(page.grab().save("review_overlay.png"));
    takeAway("overlay.B");
    EXPECT_EQ(plot->overlayLabels(), eveningAlone);
}

// Catches an overlay that stays when another run is opened.
TEST_F(ReviewOverlayTest, AnotherRunHasNone) {
    ASSERT_TRUE(page.replay()->addOverlay(other));
    SessionRecord next = record();
    next.path = "next.bask";
    show(next);
    EXPECT_TRUE(plot->overlayLabels().isEmpty());
}

// Catches a comparison that is there without overlays, and rows of runs that were taken away.
TEST_F(ReviewOverlayTest, RunsAreComparedWhileSomeAreOverlaid) {
    EXPECT_FALSE(isCompared());
    const QSignalSpy changed(page.replay(), &ReplayView::overlaysChanged);
    ASSERT_TRUE(page.replay()->addOverlay(other));
    EXPECT_TRUE(isCompared());
    EXPECT_EQ(changed.count(), 1);
    takeAway("overlay.B");
    EXPECT_FALSE(isCompared());
    EXPECT_EQ(comparison->rowCount(), 0);
}

// Catches a comparison that lacks a run or its metrics, or has the old unit.
TEST_F(ReviewOverlayTest, TheComparisonHasTheMetricsOfEachRun) {
    constexpr int kSettling = 12; ///< the row, of the circle
    ASSERT_TRUE(page.replay()->addOverlay(other));
    const QString path = QString::fromStdString(other->facts().path);
    EXPECT_EQ(page.replay()->uncounted(), other);
    EXPECT_EQ(page.replay()->uncounted(path), nullptr);
    ASSERT_EQ(comparison->columnCount(), 3);
    EXPECT_EQ(heading(0), "A 2026-03-14 morning");
    EXPECT_EQ(heading(1), "B evening");
    EXPECT_EQ(comparison->item(kSettling, 0)->text(), child<QTableWidget>("metricsTable")->item(4, 0)->text())
        << "counted already";
    EXPECT_EQ(comparison->item(kSettling, 1)->text(), QString(QChar(0x2014)));
    const RunMetrics metrics = runMetrics(evening);
    page.replay()->setMetrics(path, &metrics);
    EXPECT_EQ(page.replay()->uncounted(), nullptr);
    const double settling_s = std::ceil(18.0 * std::log(30.0));
    EXPECT_EQ(comparison->item(kSettling, 1)->text(), QString("%1.0 s").arg(2.0 * settling_s));
    EXPECT_EQ(comparison->item(kSettling, 2)->text(), QString("+%1.0 s").arg(settling_s));
    page.setTemperatureUnit(TemperatureUnit::Kelvin);
    EXPECT_TRUE(comparison->item(0, 1)->text().startsWith("313.2"));
}

// Catches a comparison that cannot tell two files of one name apart.
TEST_F(ReviewOverlayTest, FilesOfOneNameAreComparedByTheirFolders) {
    ASSERT_TRUE(page.replay()->addOverlay(other));
    ASSERT_TRUE(QDir(folder.path()).mkdir("monday"));
    ASSERT_TRUE(page.replay()->addOverlay(renamed("monday/evening.bask")));
    ASSERT_EQ(comparison->columnCount(), 5);
    EXPECT_EQ(heading(3), "C evening (monday)");
    EXPECT_NE(heading(1), "B evening");
    tabs->setCurrentWidget(page.replay()->comparison());
    QTest::qWait(100);
    EXPECT_TRUE(page.grab().save("review_comparison.png"));
}

// Catches a page that reads all of a long run, or of one laid over it, to show some of it.
TEST_F(ReviewLongRunTest, IsShownByItsOverview) {
    EXPECT_EQ(text("factDuration"), "49:59");
    EXPECT_GT(plot->visibleHighest(), kHot_K - 273.15) << "the spike is in the picture";
    EXPECT_LE(blocksHeld(*run), 8U) << "of 118";
    EXPECT_LE(blocksHeld(*other), 8U);
}

// Catches a moment that is not read, or is taken from the overview.
TEST_F(ReviewLongRunTest, ASeekReadsThatMoment) {
    page.replay()->seek(0.1 * kHot);
    EXPECT_EQ(tile("reviewTile.1", "tileTemperature"), formatTemperature(kHot_K, TemperatureUnit::Celsius));
    EXPECT_EQ(tile("reviewTile.0", "tileState"), "Settled");
    EXPECT_LE(blocksHeld(*run), 16U);
}

// Catches a short stretch that is drawn by the overview, or for which all of a run is read.
TEST_F(ReviewLongRunTest, AShortStretchIsReadOfEachRun) {
    page.replay()->seek(0.1 * kHot);
    plot->setTimeRange(0.1 * kHot - 10.0, 0.1 * kHot + 10.0);
    plot->redraw();
    EXPECT_GT(plot->visibleHighest(), kHot_K - 273.15);
    EXPECT_TRUE(other->holds(kHot / RecordedSession::kBlock));
    EXPECT_LE(blocksHeld(*run), 16U);
    EXPECT_LE(blocksHeld(*other), 8U);
}

// Catches a damaged stretch that freezes or ends the replay, shows numbers of another moment, or is told of
// again and again.
TEST_F(ReviewPageTest, ADamagedStretchIsToldOnceAndTheRestShown) {
    auto run = opened(longRecord(3000));
    alter(*run, "DELETE FROM step WHERE number = 1500");
    page.setSession(run, sentences());
    QSignalSpy failed(page.replay(), &ReplayView::readFailed);
    auto* temperature = child<QWidget>("reviewTile.0")->findChild<QLabel*>("tileTemperature");
    const QString known = temperature->text();
    EXPECT_NE(known, QString(QChar(0x2014)));
    for (const double moment_s : {149.0, 150.0, 151.0})
        page.replay()->seek(moment_s);
    EXPECT_EQ(temperature->text(), QString(QChar(0x2014)));
    ASSERT_EQ(failed.count(), 1);
    EXPECT_EQ(failed.first().first().value<Error>().code(), MessageCode::SessionDamaged);
    auto* plot = child<TracePlot>("review.measured_K");
    plot->setTimeRange(140.0, 160.0);
    plot->redraw();
    EXPECT_GT(plot->visibleHighest(), 39.0) << "by the overview";
    EXPECT_TRUE(plot->readout(150.0).isEmpty());
    page.replay()->seek(290.0);
    EXPECT_EQ(temperature->text(), known);
    EXPECT_EQ(failed.count(), 1);
    page.setCountFailed();
    EXPECT_TRUE(text("reviewCounting").contains("cannot be read"));
    EXPECT_TRUE(child<QLabel>("reviewCounting")->isVisible());
    show(record());
    EXPECT_FALSE(child<QLabel>("reviewCounting")->isVisible()) << "of the other run";
}

// Catches: a damaged run that is "Settled" above its replay, and damage of one that is told of the next.
TEST_F(ReviewPageTest, TheHeaderOfADamagedRunSaysSo) {
    show(record());
    const QString recorded = text("outcomeWord");
    ASSERT_NE(recorded, "Damaged");
    page.setDamaged();
    EXPECT_EQ(text("outcomeWord"), "Damaged");
    show(record());
    EXPECT_EQ(text("outcomeWord"), recorded);
    const std::string path = child<QLabel>("sessionFile")->toolTip().toStdString();
    SessionHeader listed = readSessionHeader(path);
    listed.damage = Error(MessageCode::SessionDamaged, path, {"its database is not whole"});
    page.sessions()->setSessions({listed});
    EXPECT_EQ(text("outcomeWord"), "Damaged") << "it was found when the run was selected";
}

// Catches: an altered run without a word about it, one whose verdict is told of the next, and a page that
// does not say that a run is intact.
TEST_F(ReviewPageTest, TellsWhetherTheRunIsAsItWasRecorded) {
    show(record());
    const QString recorded = text("outcomeWord");
    EXPECT_EQ(text("factVerification"), QStringLiteral("Being verified\u2026"));
    SessionVerdict verdict;
    verdict.hasChain = true;
    verdict.seal = Seal::Holds;
    verdict.rows = 700;
    verdict.head = "3f2a91c0" + std::string(56, '0');
    page.setVerdict(verdict);
    EXPECT_EQ(text("factVerification"), QStringLiteral("Intact: 700 rows, sealed, head 3f2a91c0\u2026"));
    EXPECT_TRUE(child<QLabel>("factVerification")->toolTip().contains(QString::fromStdString(verdict.head)));
    EXPECT_EQ(text("outcomeWord"), recorded);
    EXPECT_TRUE(child<MessageBar>("sessionAltered")->isHidden());

    verdict.seal = Seal::Broken;
    verdict.findings = {{SessionFinding::Kind::Changed, "step", 123, 187.2}};
    verdict.allFindings = 3;
    page.setVerdict(verdict);
    const QString told = QStringLiteral("Altered: table step, row 123, at 3:07, and 2 more; see bask verify");
    EXPECT_EQ(text("outcomeWord"), "Altered");
    EXPECT_EQ(text("factVerification"), told);
    EXPECT_EQ(child<MessageBar>("sessionAltered")->sentence(), told);
    EXPECT_TRUE(child<QLabel>("factVerification")->toolTip().isEmpty()) << "a head that proves nothing";

    show(record());
    EXPECT_EQ(text("outcomeWord"), recorded);
    EXPECT_TRUE(child<MessageBar>("sessionAltered")->isHidden());
    page.setVerificationFailed("gone");
    EXPECT_EQ(text("factVerification"), "Not verified: gone");
}

// Catches: shade that nobody is told of, "nobody" where it is not known, and that of the run before.
TEST_F(ReviewPageTest, TellsWhetherAnObjectShadesAnother) {
    show(record());
    EXPECT_EQ(text("factShade"), kNoValue);
    page.setShade(0.0);
    EXPECT_EQ(text("factShade"), "No object shades another");
    page.setShade(0.123);
    EXPECT_EQ(text("factShade"), "At most 12.3 % of an object's view factor is taken by the others");
    show(record());
    EXPECT_EQ(text("factShade"), kNoValue);
}

// Catches files that the page could show before and cannot now.
TEST_F(ReviewPageTest, ShowsAnInterruptedRunAndOneOfTheFirstVersion) {
    SessionRecord session = record();
    session.outcome.clear();
    show(session);
    EXPECT_TRUE(text("factOutcome").startsWith("Interrupted"));
    EXPECT_EQ(child<TracePlot>("review.measured_K")->seriesPoints(0).size(), 201);
    session = record();
    session.path = "first.bask";
    const std::string path = written(folder, session);
    ASSERT_TRUE(test::makeFirstVersion(path));
    page.setSession(RecordedSession::open(path).value(), sentences());
    EXPECT_EQ(text("sessionFile"), "first.bask");
    EXPECT_EQ(child<TracePlot>("review.measured_K")->seriesPoints(0).size(), 201);
    page.replay()->seek(199.0);
    EXPECT_EQ(child<QWidget>("reviewTile.0")->findChild<QLabel*>("tileTemperature")->text(),
              formatTemperature(session.samples[199].objects[0].measured_K, TemperatureUnit::Celsius));
}

// Catches a run that was stopped and is said to have no Stop, since the power failed in its retreat or while
// it cooled; and one that is said to have ended, though its retreat is not known.
TEST_F(ReviewPageTest, ARunThatWasCutOffAfterItsStopHadBeenStopped) {
    SessionRecord session = record();
    session.events.push_back({200.0, {MessageCode::EventStopped, {}}});
    for (const char* outcome : {"", kOutcomeInterrupted}) {
        session.outcome = outcome;
        show(session);
        EXPECT_EQ(text("factOutcome"), "The run had been stopped; what followed is not recorded to its end.");
    }
    session.events.back().message = {MessageCode::EventEmergencyStop, {}};
    session.outcome = "emergency-stop";
    show(session);
    EXPECT_EQ(text("factOutcome"), "Ended by STOP");
}

// Catches a run that is on and is called interrupted.
TEST_F(ReviewPageTest, ARunThatIsBeingRecordedIsNotInterrupted) {
    SessionRecord session = record();
    session.outcome.clear();
    const std::string path = written(folder, session);
    page.sessions()->setRecording(QString::fromStdString(path));
    page.setSession(RecordedSession::open(path).value(), sentences());
    EXPECT_TRUE(text("factOutcome").startsWith("Opened while")) << text("factOutcome").toStdString();
}

// Catches a long count that nobody is told of, and one that is said to go on when it is over.
TEST_F(ReviewPageTest, SaysHowFarItHasCounted) {
    const SessionRecord session = record();
    page.setSession(opened(session), sentences());
    auto* counting = child<QLabel>("reviewCounting");
    EXPECT_FALSE(counting->isVisible()) << "not of a short run";
    page.setCounting(43);
    EXPECT_TRUE(counting->isVisible());
    EXPECT_TRUE(counting->text().contains("43 %"));
    page.setMetrics(runMetrics(session));
    EXPECT_FALSE(counting->isVisible());
    EXPECT_EQ(child<QTableWidget>("finalValues")->rowCount(), 3);
}

// Keeps a picture of the page in both themes.
TEST_F(ReviewPageTest, PictureInBothThemes) {
    EXPECT_TRUE(page.grab().save("review_empty.png"));
    show(record());
    for (const bool dark : {false, true}) {
        applyTheme(*qApp, dark ? Theme::Dark : Theme::Light);
        QTest::qWait(150); // plots redraw at most 20 times a second
        const QImage picture = page.grab().toImage();
        EXPECT_TRUE(picture.save(dark ? "review_dark.png" : "review_light.png"));
        EXPECT_EQ(picture.pixelColor(2, 2).lightness() < 128, dark);
    }
    applyTheme(*qApp, Theme::Light);
    EXPECT_LE(page.minimumSizeHint().width(), 1100);
    EXPECT_LE(page.minimumSizeHint().height(), 700); // the window scrolls it
}

} // namespace
} // namespace bask
