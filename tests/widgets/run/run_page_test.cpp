#include "engine/base/message_code.h"
#include "widgets/run/run_page.h"

#include "tests/support/thread_time.h"
#include "tests/support/wait_for.h"
#include "widgets/common/theme.h"
#include "widgets/plots/trace_plot.h"
#include "widgets/run/controller_panel.h"
#include "widgets/scene/scene_view.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QOpenGLWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTest>
#include <QToolButton>
#include <QTranslator>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <random>

using namespace bask;

namespace {

Experiment threeObjects() {
    Experiment experiment;
    experiment.title = "three objects";
    const char* names[] = {"circle", "bunny", "hand"};
    const double radii_m[] = {0.015, 0.03, 0.027};
    const double x_m[] = {0.0, -0.0435, 0.0435}, y_m[] = {0.05, -0.025, -0.025};
    for (int i = 0; i < 3; ++i) {
        ObjectSpec object;
        object.name = names[i];
        object.shape = Disk{radii_m[i]};
        object.mounting << x_m[i], y_m[i], 0, 0, 0, 0;
        experiment.objects.push_back(object);
    }
    return experiment;
}

/// A run like the level servo's: warming at the bound, a short overshoot, then quiet inside the band.
std::vector<TraceSample> likeARun(int seconds) {
    std::mt19937 random(7);
    std::normal_distribution<double> noise(0.0, 0.02);
    std::vector<TraceSample> out;
    const double heating_s[] = {72.0, 24.0, 36.0}, strength[] = {0.107, 0.39, 0.234};
    for (int k = 1; k <= seconds; ++k) {
        TraceSample sample;
        sample.time_s = k;
        const double near_s = 80.0;
        const double approach = std::exp(-k / 18.0);
        sample.coordinates << 0.03 * (1 - approach) * std::cos(k / 40.0),
            0.02 * (1 - approach) * std::sin(k / 30.0), 0.05 + 0.1 * approach, 0.2 * (1 - approach), 0, 0;
        sample.twist << 0.004 * approach, 0.002, -0.0194 * approach, 0.08 * std::exp(-k / 40.0), 0, 0;
        sample.source_K = 473.15;
        for (int i = 0; i < 3; ++i) {
            ObjectSample object;
            object.target_K = 313.15;
            const double rise = 1.0 - std::exp(-k / (heating_s[i] / 3.2));
            const double bump = 0.9 * std::exp(-std::pow((k - heating_s[i] * 1.15) / 14.0, 2));
            object.true_K = 298.15 + 15.0 * rise + bump;
            object.measured_K = std::round((object.true_K + noise(random)) * 10.0) / 10.0;
            object.estimated_K = object.true_K;
            object.rate_K_s =
                15.0 / (heating_s[i] / 3.2) * std::exp(-k / (heating_s[i] / 3.2)) + 0.2 * noise(random);
            object.viewFactor = 0.42 + 0.35 * approach - 0.05 * i + 0.01 * std::sin(k / 9.0);
            object.lambda1 = strength[i] * (1.0 + 1.5 * std::exp(-k / 15.0));
            object.valid = !(i == 2 && k > near_s && k < near_s + 8);
            sample.objects.push_back(object);
        }
        out.push_back(sample);
    }
    return out;
}

Snapshot snapshotOf(const std::vector<TraceSample>& samples) {
    Snapshot snapshot;
    snapshot.state = RunState::Running;
    snapshot.runId = 1;
    snapshot.newSamples = samples;
    snapshot.latest = samples.back();
    snapshot.runTime_s = samples.back().time_s;
    snapshot.targets_K = {313.15, 313.15, 313.15};
    return snapshot;
}

struct Shown {
    RunPage page;
    Shown() {
        page.setExperiment(threeObjects());
        page.resize(1180, 640);
        page.show();
        page.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&page));
        EXPECT_TRUE(QTest::qWaitForWindowActive(&page)) << "keys go to the active window only";
    }
    template <class Widget> Widget* child(const char* name) {
        return page.findChild<Widget*>(QLatin1String(name));
    }
    QString tileText(int tile, const char* name) {
        return page.findChild<QWidget*>(QStringLiteral("objectTile.%1").arg(tile))
            ->findChild<QLabel*>(QLatin1String(name))
            ->text();
    }
};

/// Every text 40 % longer: what French does to a layout.
class LongTexts : public QTranslator {
public:
    bool isEmpty() const override { return false; }
    QString translate(const char*, const char* source, const char*, int) const override {
        const QString text = QString::fromUtf8(source);
        return text + QString(std::max<qsizetype>(1, text.size() * 2 / 5), QLatin1Char('x'));
    }
};

} // namespace

// Catches numbers, traces and tiles that do not tell the same as the snapshot.
TEST(RunPage, ShowsWhatTheSnapshotSays) {
    Shown shown;
    const auto samples = likeARun(60);
    shown.page.apply(snapshotOf(samples));
    EXPECT_EQ(shown.tileText(1, "tileName"), QStringLiteral("bunny"));
    EXPECT_TRUE(shown.tileText(1, "tileTarget").startsWith(QStringLiteral("40.0")));
    for (const char* name :
         {"plot.measured_K", "plot.error_K", "plot.view_factor", "plot.rate_K_s", "plot.lambda1_K_s"})
        EXPECT_EQ(shown.child<TracePlot>(name)->seriesPoints(2).size(), 60) << name;

    shown.page.setTemperatureUnit(TemperatureUnit::Fahrenheit);
    EXPECT_TRUE(shown.tileText(1, "tileTarget").startsWith(QStringLiteral("104.0")));
    EXPECT_EQ(shown.child<TracePlot>("plot.measured_K")->valueAxisLabel(),
              QStringLiteral("Temperature (°F)"));
}

// Catches: a frozen sensor whose tile and whose alarm tell two times.
TEST(RunPage, AFrozenSensorsTileTellsTheTimeOfItsAlarm) {
    Shown shown;
    Snapshot snapshot = snapshotOf(likeARun(5));
    snapshot.sensors.assign(3, SensorTrust::Stale);
    snapshot.readingAges_s.assign(3, 0.2);
    for (const ObjectSample& object : snapshot.latest.objects)
        snapshot.toldReadings_K.push_back(object.measured_K);
    snapshot.alarms.resize(2);
    snapshot.alarms[0].message = {MessageCode::SafetySensorFrozen, {"bunny", "39"}};
    snapshot.alarms[1].message = {MessageCode::SafetySensorQuiet, {"hand", "61"}};
    shown.page.apply(snapshot);
    EXPECT_EQ(shown.tileText(1, "tileAge"), QStringLiteral("same for 39 s"));
    EXPECT_EQ(shown.tileText(2, "tileAge"), QStringLiteral("same for 61 s"));
    EXPECT_EQ(shown.tileText(0, "tileAge"), QStringLiteral("0 s old")) << "another one's alarm";
}

// Catches a limit that is active and not told, told in the wrong word, or told when the run is over.
TEST(RunPage, SaysWhichLimitsHoldTheRobotBack) {
    RunPage page;
    page.setExperiment(threeObjects());
    auto* said = page.findChild<QLabel*>(QStringLiteral("activeLimits"));
    ASSERT_NE(said, nullptr);
    Snapshot snapshot = snapshotOf(likeARun(5));
    snapshot.state = RunState::Running;
    snapshot.place = PlaceState::Sure;
    page.apply(snapshot);
    EXPECT_EQ(said->text(), QStringLiteral("No limit holds the robot back."));
    snapshot.latest.limits.add(Limit::Speed);
    snapshot.latest.limits.add(Limit::Workspace, kThetaX);
    page.apply(snapshot);
    EXPECT_EQ(said->text(), QStringLiteral("Held back by: speed, workspace \u03b8x"));
    snapshot.latest.limits = {};
    snapshot.latest.limits.addUnnamed();
    page.apply(snapshot);
    EXPECT_EQ(said->text(), QStringLiteral("A limit holds the robot back."));
    snapshot.state = RunState::Stopped;
    page.apply(snapshot);
    EXPECT_TRUE(said->text().isEmpty());
}

// Catches: a shade that only a lower view factor tells, one that is told where there is none, and one of a
// place that is not known.
TEST(RunPage, SaysHowMuchTheObjectsShadeEachOther) {
    RunPage page;
    page.setExperiment(threeObjects());
    const auto* said = page.findChild<QLabel*>(QStringLiteral("shade"));
    ASSERT_NE(said, nullptr);
    Snapshot snapshot = snapshotOf(likeARun(5));
    snapshot.place = PlaceState::Sure;
    for (ObjectSample& object : snapshot.latest.objects) {
        object.viewFactor = 0.22;
        object.unshadedViewFactor = 0.2205;
    }
    snapshot.latest.objects[0].unshadedViewFactor = std::numeric_limits<double>::quiet_NaN();
    page.apply(snapshot);
    EXPECT_EQ(said->text(), QString()) << "less than half a percent";
    snapshot.latest.objects[1].unshadedViewFactor = 0.25;
    snapshot.latest.objects[2].unshadedViewFactor = 0.23;
    page.apply(snapshot);
    EXPECT_EQ(said->text(), QStringLiteral("Shaded: bunny 12 %"));
    EXPECT_TRUE(said->toolTip().contains(QStringLiteral("hand 4 %"))) << said->toolTip().toStdString();
    snapshot.place = PlaceState::Unknown;
    page.apply(snapshot);
    EXPECT_EQ(said->text(), QString());
}

// Catches: a plot of shade that no object can have, one that is missing where one object stands in the light
// of another, and one of another scale than its axis says.
TEST(RunPage, PlotsTheShadeWhereThereCanBeSome) {
    RunPage page;
    Experiment experiment = threeObjects();
    page.setExperiment(experiment);
    auto* tabs = page.findChild<QTabWidget*>(QStringLiteral("plotTabs"));
    auto* plot = page.findChild<TracePlot*>(QStringLiteral("plot.shade"));
    ASSERT_NE(plot, nullptr);
    const int tab = tabs->indexOf(plot->parentWidget());
    ASSERT_GE(tab, 0);
    EXPECT_EQ(tabs->tabText(tab), QStringLiteral("Shade"));
    EXPECT_FALSE(tabs->isTabVisible(tab)) << "they lie in one plane";
    experiment.objects[1].mounting.head<3>() << 0.0, 0.05, -0.02; // in the light of the first
    page.setExperiment(experiment);
    EXPECT_TRUE(tabs->isTabVisible(tab));
    std::vector<TraceSample> samples = likeARun(20);
    for (TraceSample& sample : samples)
        for (ObjectSample& object : sample.objects)
            object.unshadedViewFactor = object.viewFactor;
    for (std::size_t k = 10; k < samples.size(); ++k)
        samples[k].objects[0].viewFactor *= 0.75;
    page.apply(snapshotOf(samples));
    plot->redraw();
    EXPECT_EQ(plot->valueAxisLabel(), QStringLiteral("Shade (%)"));
    EXPECT_NEAR(plot->seriesPoints(0).front().y(), 0.0, 1e-9);
    EXPECT_NEAR(plot->seriesPoints(0).back().y(), 25.0, 1e-9);
    EXPECT_NEAR(plot->seriesPoints(1).back().y(), 0.0, 1e-9);
    page.setExperiment(threeObjects());
    EXPECT_FALSE(tabs->isTabVisible(tab));
}

// Catches two runs drawn into each other.
TEST(RunPage, ANewRunBeginsANewTrace) {
    Shown shown;
    Snapshot first = snapshotOf(likeARun(60));
    first.newNotes = {{30.0, "lamp moved"}};
    shown.page.apply(first);
    auto* plot = shown.child<TracePlot>("plot.measured_K");
    EXPECT_EQ(plot->markerTexts(), QStringList{QStringLiteral("lamp moved")});
    Snapshot second = snapshotOf(likeARun(5));
    second.runId = 2;
    shown.page.apply(second);
    EXPECT_EQ(plot->seriesPoints(0).size(), 5);
    EXPECT_TRUE(plot->markerTexts().isEmpty());
}

// Catches plots of one page that show different stretches of time.
TEST(RunPage, PlotsMoveTogetherAndJumpBackToLive) {
    Shown shown;
    shown.page.apply(snapshotOf(likeARun(200)));
    auto* temperature = shown.child<TracePlot>("plot.measured_K");
    auto* error = shown.child<TracePlot>("plot.error_K");
    auto* follow = shown.child<QCheckBox>("followLive");
    auto* jump = shown.child<QPushButton>("jumpToLive");
    EXPECT_TRUE(follow->isChecked());
    EXPECT_FALSE(jump->isVisible());

    temperature->setFocus();
    QTest::keyClick(temperature, Qt::Key_Left);
    EXPECT_FALSE(follow->isChecked());
    EXPECT_FALSE(error->followsLive());
    EXPECT_DOUBLE_EQ(error->visibleTo_s(), temperature->visibleTo_s());
    ASSERT_TRUE(jump->isVisible());
    EXPECT_TRUE(jump->text().contains(QStringLiteral("0:30"))) << jump->text().toStdString();

    QTest::mouseClick(jump, Qt::LeftButton);
    EXPECT_TRUE(follow->isChecked());
    EXPECT_TRUE(error->followsLive());
    EXPECT_DOUBLE_EQ(temperature->visibleTo_s(), 200.0);
    EXPECT_FALSE(jump->isVisible());
}

// Catches a prediction without its lines, without a way to hide it, or one that stays with other objects.
TEST(RunPage, ThePredictedRunIsShownAndHidden) {
    Shown shown;
    auto* plot = shown.child<TracePlot>("plot.measured_K");
    auto* error = shown.child<TracePlot>("plot.error_K");
    auto* shows = shown.child<QCheckBox>("showPrediction");
    ASSERT_NE(shows, nullptr);
    EXPECT_TRUE(shows->isVisible()) << "what comes and goes moves the others";
    PredictedRun run;
    for (const TraceSample& sample : likeARun(150)) {
        run.samples.push_back({sample.time_s, sample.coordinates, {}});
        for (const ObjectSample& object : sample.objects)
            run.samples.back().temperatures_K.push_back(object.true_K);
    }
    run.settling_s = 90.0;
    shown.page.setPrediction(run);
    EXPECT_TRUE(shows->isChecked());
    for (int i = 0; i < 3; ++i)
        EXPECT_EQ(plot->predictedPoints(i).size(), 150) << i;
    EXPECT_DOUBLE_EQ(plot->visibleTo_s(), error->visibleTo_s());
    plot->redraw();
    error->redraw();
    shown.page.grab().save(QStringLiteral("run_page_predicted.png"));
    shown.page.apply(snapshotOf(likeARun(30)));
    EXPECT_EQ(plot->predictedPoints(2).size(), 150) << "it stays behind the run";
    plot->redraw();
    error->redraw();
    shown.page.grab().save(QStringLiteral("run_page_predicted_run.png"));
    QTest::mouseClick(shows, Qt::LeftButton, Qt::NoModifier, {8, shows->height() / 2});
    EXPECT_TRUE(plot->predictedPoints(0).isEmpty());
    EXPECT_DOUBLE_EQ(plot->visibleTo_s(), error->visibleTo_s());
    QTest::mouseClick(shows, Qt::LeftButton, Qt::NoModifier, {8, shows->height() / 2});
    EXPECT_EQ(plot->predictedPoints(0).size(), 150);
    shows->setFocus();
    shown.page.setExperiment(threeObjects());
    EXPECT_TRUE(plot->predictedPoints(0).isEmpty());
    EXPECT_TRUE(shows->isVisible());
    EXPECT_EQ(shown.page.focusWidget(), shows) << "the keys are somebody else's";
}

// Catches a source that looks cold and off although nobody is told of it any more.
TEST(RunPage, ASilentEngineLeavesNoColdSource) {
    Shown shown;
    auto* scene = shown.child<SceneView>("runScene");
    if (!scene->hasPicture())
        GTEST_SKIP() << "no OpenGL here";
    Snapshot snapshot = snapshotOf(likeARun(5));
    snapshot.source_K = threeObjects().environment_K;
    snapshot.heat = HeatState::Off;
    shown.page.apply(snapshot);
    const auto violet = [scene] {
        const QImage image = scene->grab().toImage();
        int count = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                count += image.pixelColor(x, y) == unknownColor(isDark(scene)) ? 1 : 0;
        return count;
    };
    const int before = violet();
    shown.page.setAnswering(false);
    EXPECT_TRUE(test::waitFor([&] { return violet() > before + 10; }));
    shown.page.apply(snapshot);
    EXPECT_TRUE(test::waitFor([&] { return violet() <= before; }));
}

TEST(RunPage, KeyNThenTextThenEnterAddsANote) {
    Shown shown;
    shown.page.setFocus();
    QSignalSpy notes(&shown.page, &RunPage::noteAdded);
    QTest::keyClick(&shown.page, Qt::Key_N);
    auto* edit = shown.child<QLineEdit>("noteEdit");
    ASSERT_TRUE(edit->hasFocus());
    QTest::keyClick(edit, Qt::Key_Return);
    EXPECT_EQ(notes.count(), 0) << "nothing to note";
    QTest::keyClicks(edit, QStringLiteral("no draught now"));
    QTest::keyClick(edit, Qt::Key_Return);
    ASSERT_EQ(notes.count(), 1);
    EXPECT_EQ(notes.first().first().toString(), QStringLiteral("no draught now"));
    EXPECT_TRUE(edit->text().isEmpty());
    EXPECT_FALSE(edit->hasFocus());
}

TEST(RunPage, SimulationSpeedOnTheSimulatedRigOnly) {
    Shown shown;
    QSignalSpy speeds(&shown.page, &RunPage::simulationSpeedChosen);
    auto* speed = shown.child<QComboBox>("simulationSpeed");
    Snapshot snapshot = snapshotOf(likeARun(5));
    snapshot.simulationSpeed = 5.0;
    shown.page.apply(snapshot);
    EXPECT_EQ(speed->currentText(), QStringLiteral("5\u00d7"));
    speed->setFocus();
    QTest::keyClick(speed, Qt::Key_End);
    ASSERT_EQ(speeds.count(), 1);
    EXPECT_DOUBLE_EQ(speeds.first().first().toDouble(), 20.0);
    snapshot.simulated = false;
    shown.page.apply(snapshot);
    EXPECT_FALSE(speed->isVisible());
}

// Catches work in apply() that makes the window stutter.
TEST(RunPage, ApplyTakesAFewMilliseconds) {
    Shown shown;
    const auto samples = likeARun(2000);
    shown.page.apply(snapshotOf({samples.begin(), samples.begin() + 1500}));
    const double before_s = test::threadTime_s();
    constexpr int kCount = 400;
    for (int i = 0; i < kCount; ++i)
        shown.page.apply(snapshotOf({samples[static_cast<std::size_t>(1500 + i)]}));
    const double apply_ms = 1e3 * (test::threadTime_s() - before_s) / kCount;
    std::printf("apply: %.2f ms\n", apply_ms);
    EXPECT_LT(apply_ms, 10.0);
}

// Catches texts cut off in a language that is 40 % longer than English, at the smallest useful window.
TEST(RunPage, NothingIsClippedInALongLanguage) {
    LongTexts translator;
    {
        Shown shown;
        shown.page.apply(snapshotOf(likeARun(200)));
        QApplication::installTranslator(&translator);
        QCoreApplication::processEvents();
        EXPECT_TRUE(shown.child<QTabWidget>("plotTabs")->tabText(0).endsWith(QLatin1Char('x')));
        EXPECT_TRUE(shown.child<QLabel>("tileState")->text().endsWith(QLatin1Char('x')));
        EXPECT_TRUE(shown.child<TracePlot>("plot.error_K")->valueAxisLabel().contains(QStringLiteral(")x")));
        shown.page.resize(1100, 560);
        QCoreApplication::processEvents();
        for (const QLabel* label : shown.page.findChildren<QLabel*>()) {
            if (!label->isVisible() || label->text().isEmpty() ||
                label->sizePolicy().horizontalPolicy() == QSizePolicy::Ignored)
                continue;
            EXPECT_GE(label->width(), label->sizeHint().width()) << label->text().toStdString();
        }
        for (const QAbstractButton* button : shown.page.findChildren<QAbstractButton*>()) {
            if (button->isVisible() && !button->text().isEmpty()) {
                EXPECT_GE(button->width(), button->sizeHint().width()) << button->text().toStdString();
            }
        }
        EXPECT_LE(shown.page.minimumSizeHint().width(), 1100);
        for (auto* plot : shown.page.findChildren<TracePlot*>())
            plot->redraw();
        shown.page.grab().save(QStringLiteral("run_page_long.png"));
    }
    QApplication::removeTranslator(&translator);
}

// Catches controls that a screen reader or a test cannot name.
TEST(RunPage, EveryControlHasAName) {
    Shown shown;
    for (const QWidget* widget : shown.page.findChildren<QWidget*>()) {
        const bool inner = widget->inherits("QComboBoxListView"); // Qt's own list inside of a combo box
        if (inner || !(widget->focusPolicy() & Qt::TabFocus) ||
            widget->objectName().startsWith(QStringLiteral("qt_")))
            continue;
        const auto* button = qobject_cast<const QAbstractButton*>(widget);
        EXPECT_TRUE(!widget->accessibleName().isEmpty() || (button != nullptr && !button->text().isEmpty()))
            << widget->objectName().toStdString() << " " << widget->metaObject()->className();
    }
}

// Catches a source that stands still on this page while it is moved, and one that only a run's samples move.
TEST(RunPage, TheSourceIsDrawnWhereTheEngineHasIt) {
    Shown shown;
    auto* picture = shown.page.findChild<QOpenGLWidget*>();
    if (picture == nullptr)
        GTEST_SKIP() << "no OpenGL here";
    const auto glow = [picture] { // mean place of its middle's colour
        const QImage image = picture->grabFramebuffer();
        QPointF sum;
        int count = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x) {
                const QColor c = image.pixelColor(x, y);
                if (std::abs(c.red() - 0xff) + std::abs(c.green() - 0xb4) + std::abs(c.blue() - 0x5c) < 40) {
                    sum += QPointF(x, y);
                    ++count;
                }
            }
        return sum / std::max(1, count);
    };
    auto samples = likeARun(60);
    shown.page.apply(snapshotOf(samples));
    const QPointF first = glow();
    for (TraceSample& sample : samples)
        sample.source << 0.1, -0.03, 0.02, 0.2, 0.0, 0.0;
    Snapshot moved = snapshotOf(samples);
    moved.newSamples.clear(); // not in a run
    shown.page.apply(moved);
    EXPECT_TRUE(QTest::qWaitFor([&] { return glow().x() > first.x() + 30.0; })) << "the view may draw later";
    EXPECT_TRUE(shown.page.grab().save(QStringLiteral("run_page_moved_source.png")));
}

// Pictures of the page with a made-up run, in both themes, kept beside the test.
TEST(RunPage, Pictures) {
    for (const bool dark : {false, true}) {
        applyTheme(*qApp, dark ? Theme::Dark : Theme::Light);
        Shown shown;
        const auto samples = likeARun(140);
        for (const TraceSample& sample : samples) {
            Snapshot snapshot = snapshotOf({sample});
            snapshot.state = RunState::Running;
            snapshot.latest.limits.add(Limit::Speed);
            snapshot.latest.limits.add(Limit::Clearance);
            snapshot.controller.kind = dark ? ControllerKind::ModelBased : ControllerKind::Adaptive;
            if (sample.time_s == 52.0)
                snapshot.newNotes = {{52.0, "lamp cover opened"}};
            if (sample.time_s == 96.0)
                snapshot.newEvents = {{96.0, {MessageCode::EventGainsChanged, {}}}};
            if (sample.time_s == 121.0)
                snapshot.newEvents = {{121.0, {MessageCode::EventSettled, {}}}};
            shown.page.apply(snapshot);
        }
        auto* tabs = shown.child<QTabWidget>("plotTabs");
        for (int tab = tabs->count() - 1; tab >= 0; --tab) {
            tabs->setCurrentIndex(tab);
            for (int i = 0; i < 5; ++i) {
                QCoreApplication::processEvents(QEventLoop::AllEvents, 50);
                for (auto* plot : shown.page.findChildren<TracePlot*>())
                    plot->redraw();
            }
            const QString name = QStringLiteral("run_page_%1_%2.png").arg(dark ? "dark" : "light").arg(tab);
            EXPECT_TRUE(shown.page.grab().save(name));
        }
    }
    applyTheme(*qApp, Theme::Light);
}
