#include "engine/experiment/experiment_file.h"
#include "widgets/targets/targets_page.h"

#include "engine/base/message_code.h"
#include "tests/support/longer_translator.h"
#include "widgets/common/quantity_spin_box.h"
#include "widgets/common/theme.h"
#include "widgets/common/verdict_words.h"
#include "widgets/targets/reach_bar.h"

#include <QApplication>
#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

constexpr double kRoom_K = 298.15;

/// Gray source of the example: 0.10 at most 0.93 in view, 88.2 degC.
TargetVerdict verdict(double target_degC, double neededF) {
    TargetVerdict v;
    v.target_K = kelvinFromCelsius(target_degC);
    v.lowest_K = kRoom_K;
    v.highest_K = kelvinFromCelsius(95.4);
    v.neededViewFactor = neededF;
    v.reachableMin_F = 0.004;
    v.reachableMin_K = kelvinFromCelsius(25.4);
    v.reachableMax_F = 0.93;
    v.reachableMax_K = kelvinFromCelsius(88.24);
    v.verdict = neededF > v.reachableMax_F   ? FeasibilityVerdict::TooHot
                : neededF < v.reachableMin_F ? FeasibilityVerdict::TooCold
                                             : FeasibilityVerdict::Reachable;
    return v;
}

/// Not feasible unless each is by itself; the nearest targets are 30, 31, 32 degC then.
JointVerdict joint(const std::vector<TargetVerdict>& each) {
    JointVerdict verdict;
    verdict.conditions1 = each;
    verdict.feasible = std::ranges::all_of(
        each, [](const TargetVerdict& v) { return v.verdict == FeasibilityVerdict::Reachable; });
    verdict.pose << 0.012, -0.034, 0.06, radFromDeg(10.0), 0.0, 0.0;
    verdict.margin.distance_m = 0.021;
    verdict.margin.limit = Limit::Clearance;
    for (std::size_t i = 0; i < each.size(); ++i) {
        verdict.residuals_K.push_back(verdict.feasible ? 0.0 : 1.5 - static_cast<double>(i));
        verdict.nearest_K.push_back(verdict.feasible ? each[i].target_K
                                                     : kelvinFromCelsius(30.0 + static_cast<double>(i)));
    }
    if (!verdict.feasible)
        verdict.reason = {MessageCode::TargetNeedsMore, {"bunny", "1.31", "0.93"}};
    return verdict;
}

Experiment experimentWith(const std::vector<double>& targets_degC) {
    static const Experiment shipped = readExperiment(BASK_EXAMPLES "/three-objects.json").value();
    Experiment experiment = shipped;
    experiment.robot.lower.head<3>() << -0.05, -0.05,
        0.02; // its surfaces are not looked at here, and come soon
    experiment.robot.upper.head<3>() << 0.05, 0.05, 0.1;
    experiment.start[kZ] = 0.08;
    for (std::size_t i = 0; i < 3; ++i)
        experiment.objects[i].target_K = kelvinFromCelsius(targets_degC[i]);
    return experiment;
}

struct TargetsPageTest : testing::Test {
    TargetsPage page;
    QSignalSpy edited{&page, &TargetsPage::targetsEdited};

    TargetsPageTest() {
        page.setExperiment(experimentWith({40.0, 120.0, 20.0}));
        page.setVerdict(joint({verdict(40.0, 0.16), verdict(120.0, 1.31), verdict(20.0, -0.05)}));
        page.resize(1150, 620);
        page.show();
        page.activateWindow();
        QApplication::processEvents();
    }
    template <class T> T* child(const QString& name) {
        auto* found = page.findChild<T*>(name);
        EXPECT_NE(found, nullptr) << name.toStdString();
        return found;
    }
    QString text(const QString& name) { return child<QLabel>(name)->text().replace(QChar(0x00a0), ' '); }
    void type(const QString& name, const QString& value) {
        auto* field = child<QuantitySpinBox>(name);
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, value);
        QTest::keyClick(field, Qt::Key_Return);
    }
    void moveTo(QWidget* widget, QPoint place, Qt::MouseButton held = Qt::LeftButton) {
        QMouseEvent move(QEvent::MouseMove, place, widget->mapToGlobal(place), Qt::NoButton, held, {});
        QApplication::sendEvent(widget, &move);
    }
    std::vector<double> lastTargets() { return edited.last()[0].value<std::vector<double>>(); }
};

// Catches a verdict in the wrong words or with the wrong figures.
TEST_F(TargetsPageTest, VerdictsInWords) {
    EXPECT_EQ(text("verdict0"), "Reachable alone");
    EXPECT_EQ(text("verdictDetail0"), "needs F = 0.16, up to 0.93 here");
    EXPECT_EQ(text("verdict1"), "Too hot");
    EXPECT_EQ(text("verdictDetail1").toStdString(), "needs F = 1.31, at most 0.93 here; at most 88.2 °C");
    EXPECT_EQ(text("verdict2"), "Too cold");
    EXPECT_EQ(text("verdictDetail2").toStdString(), "below the room's 25.0 °C");
    EXPECT_TRUE(text("jointVerdict").contains("bunny")) << text("jointVerdict").toStdString();
    EXPECT_TRUE(text("jointDetail").contains("hand \u22120.5 K")) << text("jointDetail").toStdString();
    EXPECT_TRUE(text("jointDetail").contains("bunny 31.0 °C"));
}

// Catches a name that is taken for mark-up.
TEST_F(TargetsPageTest, NamesAreShownAsTheyAre) {
    Experiment experiment = experimentWith({40.0, 120.0, 20.0});
    experiment.objects[1].name = "<i>b</i>";
    page.setExperiment(experiment);
    EXPECT_TRUE(text("jointDetail").contains("<i>b</i>"));
    int shown = 0;
    for (const auto* label : page.findChildren<QLabel*>())
        if (label->text().contains("<i>b</i>")) {
            ++shown;
            EXPECT_EQ(label->textFormat(), Qt::PlainText) << label->text().toStdString();
        }
    EXPECT_GE(shown, 2);
}

// Catches a target that is called good and that no run can be armed for.
TEST_F(TargetsPageTest, ATargetAboveItsWarningLimitIsTold) {
    Experiment experiment = experimentWith({40.0, 40.0, 40.0});
    experiment.objects[1].warning_K = kelvinFromCelsius(38.0);
    page.setExperiment(experiment);
    page.setVerdict(joint({verdict(40.0, 0.16), verdict(40.0, 0.16), verdict(40.0, 0.16)}));
    EXPECT_TRUE(text("jointVerdict").contains("above its warning limit"))
        << text("jointVerdict").toStdString();
    experiment.objects[1].warning_K = kelvinFromCelsius(41.0);
    page.setExperiment(experiment);
    EXPECT_EQ(text("jointVerdict"), "All targets can be held together.");
}

// Catches a joint verdict without its pose and margin, and a button that offers what is held already.
TEST_F(TargetsPageTest, HeldTogether) {
    page.setExperiment(experimentWith({40.0, 40.0, 40.0}));
    page.setVerdict(joint({verdict(40.0, 0.16), verdict(40.0, 0.16), verdict(40.0, 0.16)}));
    EXPECT_EQ(text("jointVerdict"), "All targets can be held together.");
    EXPECT_TRUE(text("jointDetail").contains("z +6.0 cm")) << text("jointDetail").toStdString();
    EXPECT_TRUE(text("jointDetail").contains("2.1 cm from the nearest limit: clearance"));
    EXPECT_TRUE(text("jointDetail").contains("No object shades another at this pose."));
    PoseMargin angle;
    angle.distance_m = 0.05;
    angle.coordinate = kThetaX;
    EXPECT_EQ(marginText(angle), QStringLiteral("28.6\u00b0")); // half a radian
    EXPECT_FALSE(child<QPushButton>("useNearest")->isVisible());
}

// Catches a predicted time of another verdict, and one that is asked for though nothing can be held.
TEST_F(TargetsPageTest, TheTimeIsPredictedForWhatCanBeHeld) {
    QSignalSpy wanted{&page, &TargetsPage::predictionWanted};
    page.setVerdict(joint({verdict(40.0, 0.16), verdict(120.0, 1.31), verdict(20.0, -0.05)}));
    EXPECT_EQ(wanted.count(), 0);
    const auto feasible = joint({verdict(40.0, 0.16), verdict(40.0, 0.16), verdict(40.0, 0.16)});
    page.setExperiment(experimentWith({40.0, 40.0, 40.0}));
    page.setVerdict(feasible);
    EXPECT_EQ(wanted.count(), 1);
    EXPECT_TRUE(text("jointDetail").contains("Predicting"));
    page.setPrediction(77.0);
    EXPECT_TRUE(text("jointDetail").contains("has settled after 1:17")) << text("jointDetail").toStdString();
    page.setPrediction(std::nullopt);
    EXPECT_TRUE(text("jointDetail").contains("does not settle within"));
    page.dropPrediction(); // another controller
    EXPECT_TRUE(text("jointDetail").contains("Predicting"));
    EXPECT_EQ(wanted.count(), 2);
    page.setVerdict(feasible);
    EXPECT_TRUE(text("jointDetail").contains("Predicting"));
    EXPECT_EQ(wanted.count(), 3);
    page.hide();
    page.setVerdict(feasible);
    EXPECT_EQ(wanted.count(), 3);
    page.show();
    EXPECT_EQ(wanted.count(), 4);
}

// Catches a mark that cannot be dragged, a drag that edits the experiment at each step or not at its end, and
// a bar that a click beside the mark changes.
TEST_F(TargetsPageTest, ATargetIsDraggedInItsBar) {
    QSignalSpy tried{&page, &TargetsPage::targetsTried};
    auto* bar = child<ReachBar>("reach0");
    // The axis: 25.0 to 95.4 degC with 12 % to each side, between 26 px of margin.
    const double low = 25.0 - 0.12 * 70.4, width = 1.24 * 70.4;
    const auto at = [&](double t_degC) {
        return QPoint(static_cast<int>(std::lround(26.0 + (t_degC - low) / width * (bar->width() - 52.0))),
                      bar->height() / 2);
    };
    QTest::mousePress(bar, Qt::LeftButton, {}, at(60.0));
    moveTo(bar, at(70.0));
    QTest::mouseRelease(bar, Qt::LeftButton, {}, at(70.0));
    EXPECT_EQ(tried.count() + edited.count(), 0);
    QTest::mousePress(bar, Qt::LeftButton, {}, at(40.0));
    moveTo(bar, at(50.0));
    moveTo(bar, at(60.0));
    EXPECT_EQ(tried.count(), 2);
    EXPECT_EQ(edited.count(), 0);
    QTest::mouseRelease(bar, Qt::LeftButton, {}, at(60.0));
    ASSERT_EQ(edited.count(), 1);
    EXPECT_NEAR(lastTargets()[0], kelvinFromCelsius(60.0), 0.51);
    EXPECT_NEAR(std::remainder(celsiusFromKelvin(lastTargets()[0]), 0.5), 0.0, 1e-9);
    EXPECT_NEAR(lastTargets()[1], kelvinFromCelsius(120.0), 1e-9);
    type("target0", "60.3");
    tried.clear();
    QTest::mousePress(bar, Qt::LeftButton, {}, at(60.3));
    moveTo(bar, at(60.3) + QPoint(1, 1)); // a hand that trembles
    QTest::mouseRelease(bar, Qt::LeftButton, {}, at(60.3));
    EXPECT_EQ(tried.count(), 0);
    EXPECT_EQ(edited.count(), 2) << "by typing";
    page.setEditable(false);
    QTest::mousePress(bar, Qt::LeftButton, {}, at(60.3));
    moveTo(bar, at(50.0));
    QTest::mouseRelease(bar, Qt::LeftButton, {}, at(50.0));
    EXPECT_EQ(edited.count(), 2);
}

// Catches a drag that goes on, or is taken over, after the page was left, the targets were locked or the
// button was let go elsewhere; and one whose end nobody hears of.
TEST_F(TargetsPageTest, ADragThatIsBrokenOffIsDropped) {
    QSignalSpy tried{&page, &TargetsPage::targetsTried};
    QSignalSpy dropped{&page, &TargetsPage::triesDropped};
    auto* bar = child<ReachBar>("reach0");
    const QPoint mark(26 + (bar->width() - 52) * 235 / 873, bar->height() / 2); // of 40 degC
    const auto drag = [&] {
        page.setExperiment(experimentWith({40.0, 120.0, 20.0}));
        QTest::mousePress(bar, Qt::LeftButton, {}, mark);
        moveTo(bar, mark + QPoint(60, 0));
    };
    drag();
    page.hide();
    EXPECT_EQ(dropped.count(), 1);
    page.show();
    drag();
    page.setEditable(false);
    EXPECT_EQ(dropped.count(), 2);
    page.setEditable(true);
    drag();
    moveTo(bar, mark + QPoint(90, 0), Qt::NoButton);
    EXPECT_EQ(dropped.count(), 3);
    EXPECT_EQ(tried.count(), 3);
    moveTo(bar, mark + QPoint(120, 0));
    QTest::mouseRelease(bar, Qt::LeftButton, {}, mark + QPoint(120, 0));
    page.hide();
    EXPECT_EQ(tried.count(), 3);
    EXPECT_EQ(dropped.count(), 3);
    EXPECT_EQ(edited.count(), 0);
}

// Catches a verdict that waits for Enter, and a field that is rewritten under the hand.
TEST_F(TargetsPageTest, TypedTargetsAreTried) {
    QSignalSpy tried{&page, &TargetsPage::targetsTried};
    auto* field = child<QuantitySpinBox>("target0");
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, "55");
    ASSERT_EQ(tried.count(), 2);
    EXPECT_NEAR(tried.last()[0].value<std::vector<double>>()[0], kelvinFromCelsius(55.0), 1e-9);
    EXPECT_TRUE(field->text().startsWith("55") && !field->text().startsWith("55.")) << "not rewritten";
    EXPECT_EQ(edited.count(), 0);
    QTest::keyClick(field, Qt::Key_Escape);
    EXPECT_NEAR(tried.last()[0].value<std::vector<double>>()[0], kelvinFromCelsius(40.0), 1e-9);
    QTest::keyClicks(field, "55");
    QTest::keyClick(field, Qt::Key_Return);
    ASSERT_EQ(edited.count(), 1);
    EXPECT_NEAR(lastTargets()[0], kelvinFromCelsius(55.0), 1e-9);
}

// Catches a verdict on all targets below their list, where four times "Reachable alone" is all that is seen.
TEST_F(TargetsPageTest, TheVerdictIsSeenWithoutScrolling) {
    Experiment four = experimentWith({40.0, 40.0, 40.0});
    four.objects.push_back(four.objects[0]);
    four.objects.back().name = "horse";
    page.setExperiment(four);
    JointVerdict apart = joint(std::vector(4, verdict(40.0, 0.16)));
    apart.feasible = false;
    apart.reason = {MessageCode::TargetsNotTogether, {"circle", "1.1"}};
    page.setVerdict(apart);
    const auto* sentence = child<QLabel>("jointVerdict");
    ASSERT_TRUE(sentence->text().startsWith("Cannot be held: ")) << sentence->text().toStdString();
    auto* area = page.findChild<QScrollArea*>("targetRows");
    ASSERT_NE(area, nullptr);
    for (const QSize size : {QSize(1150, 480), QSize(700, 620)}) { // beside the views and above them
        page.resize(size);
        for (int i = 0; i < 6; ++i) // nested layouts settle one after the other
            QApplication::processEvents();
        const auto top = [&](const QWidget* part) { return part->mapTo(&page, QPoint(0, 0)).y(); };
        for (const int place : {area->verticalScrollBar()->maximum(), 0}) {
            area->verticalScrollBar()->setValue(place);
            for (const QWidget* part :
                 std::initializer_list<const QWidget*>{sentence, child<QPushButton>("useNearest")})
                EXPECT_EQ(part->visibleRegion(), QRegion(part->rect())) << size.width() << ' ' << place;
        }
        EXPECT_GT(area->verticalScrollBar()->maximum(), 0) << "or nothing is tried here";
        EXPECT_LT(top(sentence), top(child<QuantitySpinBox>("target0")));
    }
}

// Catches rows that move under the hand while their verdict is sought, or with the verdict.
TEST_F(TargetsPageTest, RowsStayWhereTheyAreWithEachVerdict) {
    const auto rowTop = [this] {
        for (int i = 0; i < 6; ++i)
            QApplication::processEvents();
        return child<QuantitySpinBox>("target0")->mapTo(&page, QPoint(0, 0)).y();
    };
    const int before = rowTop();
    page.setStale(true);
    EXPECT_EQ(rowTop(), before);
    page.setExperiment(experimentWith({40.0, 40.0, 40.0}));
    page.setVerdict(joint({verdict(40.0, 0.16), verdict(40.0, 0.16), verdict(40.0, 0.16)}));
    ASSERT_EQ(text("jointVerdict"), "All targets can be held together.");
    EXPECT_EQ(rowTop(), before);
}

// Catches nearest targets offered that break what is to be kept.
TEST_F(TargetsPageTest, KeptTargetsThatCannotBeHeldAreNotOverridden) {
    JointVerdict bad = joint({verdict(40.0, 0.16), verdict(120.0, 1.31), verdict(20.0, -0.05)});
    bad.fixedKept = false;
    page.setVerdict(bad);
    EXPECT_FALSE(child<QPushButton>("useNearest")->isEnabled());
}

// Catches nearest targets that are rounded, or sent one by one.
TEST_F(TargetsPageTest, TheNearestFeasibleTargetsAreTakenTogether) {
    QTest::mouseClick(child<QPushButton>("useNearest"), Qt::LeftButton);
    ASSERT_EQ(edited.count(), 1);
    EXPECT_EQ(lastTargets(),
              joint({verdict(40.0, 0.16), verdict(120.0, 1.31), verdict(20.0, -0.05)}).nearest_K);
}

// Catches a table that is wider than its column, so that boxes and buttons are cut off, in whatever state.
TEST_F(TargetsPageTest, NothingIsCutOff) {
    const auto* area = page.findChild<QScrollArea*>("targetRows");
    ASSERT_NE(area, nullptr);
    page.resize(1020, 620);
    for (const bool apart : {false, true}) {
        JointVerdict shown =
            joint({verdict(40.0, 0.16), verdict(40.0, 0.16), verdict(apart ? 40.0 : 120.0, 1.31)});
        page.setExperiment(experimentWith({40.0, 40.0, apart ? 40.0 : 120.0}));
        shown.feasible = false;
        page.setVerdict(shown);
        QApplication::processEvents();
        EXPECT_LE(area->widget()->minimumSizeHint().width(), area->viewport()->width());
    }
}

// Catches a target to be kept that is not told to who seeks, or a verdict that stays although the question
// changed.
TEST_F(TargetsPageTest, KeptTargetsAreAskedFor) {
    QSignalSpy keptChanged{&page, &TargetsPage::keptChanged};
    child<QCheckBox>("keep2")->click();
    ASSERT_EQ(keptChanged.count(), 1);
    EXPECT_EQ(page.kept(), (std::vector<bool>{false, false, true}));
    EXPECT_TRUE(text("jointVerdict").startsWith("Checking"));
    page.clearKept(); // of another experiment
    EXPECT_EQ(page.kept(), std::vector<bool>(3));
    ASSERT_EQ(keptChanged.count(), 2);
    EXPECT_EQ(keptChanged.last()[0].value<std::vector<bool>>(), std::vector<bool>(3));
}

// Catches boxes of other objects that go on being obeyed.
TEST_F(TargetsPageTest, OtherObjectsAreNotKept) {
    QSignalSpy keptChanged{&page, &TargetsPage::keptChanged};
    child<QCheckBox>("keep2")->click();
    Experiment two = experimentWith({40.0, 40.0, 40.0});
    two.objects.pop_back();
    page.setExperiment(two);
    ASSERT_EQ(keptChanged.count(), 2);
    EXPECT_EQ(keptChanged.last()[0].value<std::vector<bool>>(), (std::vector<bool>{false, false}));
}

// Catches a target inside the source's range but outside the workspace's called reachable, and figures that
// look equal.
TEST_F(TargetsPageTest, OutsideTheWorkspaceIsNotReachable) {
    TargetVerdict v = verdict(89.0, 0.932);
    v.verdict = FeasibilityVerdict::Reachable;
    EXPECT_EQ(verdictHere(v), FeasibilityVerdict::TooHot);
    EXPECT_TRUE(verdictDetail(v, kRoom_K, TemperatureUnit::Celsius)
                    .startsWith("needs F = 0.932, at most 0.930 here"));
    TargetVerdict cold = verdict(25.2, 0.002);
    EXPECT_EQ(verdictHere(cold), FeasibilityVerdict::TooCold);
    EXPECT_TRUE(verdictDetail(cold, kRoom_K, TemperatureUnit::Celsius).contains("at least 25.4"));
}

// Catches targets that are sent in display units, or only the changed one.
TEST_F(TargetsPageTest, TypingATargetSendsAllInKelvinAndMakesItsRowStale) {
    type("target0", "55");
    ASSERT_EQ(edited.count(), 1);
    ASSERT_EQ(lastTargets().size(), 3u);
    EXPECT_DOUBLE_EQ(lastTargets()[0], 328.15);
    EXPECT_DOUBLE_EQ(lastTargets()[1], 393.15);
    EXPECT_EQ(page.targets_K(), lastTargets());
    EXPECT_TRUE(text("verdict0").startsWith("Checking")) << "the verdict was for another target";
    EXPECT_EQ(text("verdict1"), "Too hot");
    page.setVerdict(joint({verdict(55.0, 0.33), verdict(120.0, 1.31), verdict(20.0, -0.05)}));
    EXPECT_EQ(text("verdict0"), "Reachable alone");
}

// Catches a bound that is rounded out of reach.
TEST_F(TargetsPageTest, NearestReachableIsInsideTheRange) {
    EXPECT_FALSE(child<QPushButton>("nearest0")->isEnabled());
    QTest::mouseClick(child<QPushButton>("nearest1"), Qt::LeftButton);
    EXPECT_NEAR(lastTargets()[1], kelvinFromCelsius(88.2), 1e-9);
    QTest::mouseClick(child<QPushButton>("nearest2"), Qt::LeftButton);
    EXPECT_NEAR(lastTargets()[2], kelvinFromCelsius(25.4), 1e-9);
    for (const auto unit : {TemperatureUnit::Celsius, TemperatureUnit::Kelvin, TemperatureUnit::Fahrenheit}) {
        const TargetVerdict hot = verdict(120.0, 1.31);
        EXPECT_LE(nearestReachable_K(hot, unit), hot.reachableMax_K);
        EXPECT_GT(nearestReachable_K(hot, unit), hot.reachableMax_K - 0.11);
        const TargetVerdict cold = verdict(20.0, -0.05);
        EXPECT_GE(nearestReachable_K(cold, unit), cold.reachableMin_K - 1e-9);
    }
}

// Catches old verdicts shown as if they were new.
TEST_F(TargetsPageTest, StaleUntilNewVerdictsCome) {
    page.setStale(true);
    for (const char* name : {"verdict0", "verdict1", "verdict2"})
        EXPECT_TRUE(text(name).startsWith("Checking"));
    EXPECT_EQ(text("verdictDetail1"), "");
    EXPECT_FALSE(child<QPushButton>("nearest1")->isEnabled());
    EXPECT_TRUE(text("jointVerdict").startsWith("Checking"));
}

// Catches values that change with the unit, or verdicts left in the old one.
TEST_F(TargetsPageTest, UnitSwitch) {
    page.setTemperatureUnit(TemperatureUnit::Fahrenheit);
    EXPECT_NEAR(child<QuantitySpinBox>("target0")->value(), 104.0, 0.05);
    EXPECT_TRUE(text("verdictDetail1").contains(QString::fromUtf8("190.8 °F")));
    EXPECT_EQ(edited.count(), 0);
    type("target0", "140");
    EXPECT_NEAR(lastTargets()[0], 333.15, 1e-9);
}

// Catches fields that can be edited when the engine would refuse, and rows that do not follow the experiment.
TEST_F(TargetsPageTest, EditabilityAndRows) {
    page.setEditable(false, "The rig is in a fault.");
    EXPECT_FALSE(child<QuantitySpinBox>("target0")->isEnabled());
    EXPECT_FALSE(child<QPushButton>("nearest1")->isEnabled());
    EXPECT_EQ(text("targetsNote"), "The rig is in a fault.");
    Experiment none = experimentWith({40.0, 40.0, 40.0});
    none.objects.clear();
    page.setExperiment(none);
    EXPECT_EQ(page.findChild<QuantitySpinBox*>("target0"), nullptr);
    EXPECT_TRUE(text("jointVerdict").contains("no object"));
}

// Catches text that stays in the old language or has no room in a longer one.
TEST_F(TargetsPageTest, LanguageChangeWithLongerText) {
    LongerTranslator longer;
    qApp->installTranslator(&longer);
    for (int i = 0; i < 6; ++i) // nested layouts settle one after the other
        QApplication::processEvents();
    page.grab().save("targets_longer.png");
    for (QLabel* label : page.findChildren<QLabel*>()) {
        const bool isName = label->text() == "circle" || label->text() == "bunny" || label->text() == "hand";
        const bool isValue = label->objectName().startsWith("heldWord");
        if (!label->isVisible() || label->text().isEmpty() || isName || isValue)
            continue;
        EXPECT_TRUE(label->text().contains('[')) << label->text().toStdString();
        if (label->wordWrap()) {
            EXPECT_GE(label->height(), label->heightForWidth(label->width())) << label->text().toStdString();
        }
    }
    EXPECT_TRUE(child<QPushButton>("nearest1")->text().startsWith('['));
    qApp->removeTranslator(&longer);
}

// Keeps a picture of the page in both themes; catches text cut off by its row.
TEST_F(TargetsPageTest, PictureInBothThemes) {
    for (const bool dark : {false, true}) {
        applyTheme(*qApp, dark ? Theme::Dark : Theme::Light);
        QApplication::processEvents();
        const QImage picture = page.grab().toImage();
        EXPECT_TRUE(picture.save(dark ? "targets_dark.png" : "targets_light.png"));
        EXPECT_EQ(picture.pixelColor(2, 2).lightness() < 128, dark);
    }
    applyTheme(*qApp, Theme::Light);
    for (const char* name :
         {"verdictDetail0", "verdictDetail1", "verdictDetail2", "jointVerdict", "infeasibleNote"}) {
        auto* label = child<QLabel>(name);
        EXPECT_GE(label->height(), label->heightForWidth(label->width())) << name;
    }
    EXPECT_LE(page.minimumSizeHint().width(), 1100);
}

// Catches: a shade that counts in the verdict and is not told with it, or told of the verdict before.
TEST_F(TargetsPageTest, WhoShadesWhomIsToldWithTheVerdict) {
    const MountingRemark shade{{MessageCode::ShadeAtPose, {"bunny", "12", "hand"}}, {2, 1}};
    const JointVerdict held = joint({verdict(40.0, 0.16), verdict(120.0, 0.31), verdict(20.0, 0.15)});
    page.setVerdict(held, {shade});
    auto* detail = child<QLabel>("jointDetail");
    EXPECT_TRUE(detail->text().endsWith(
        QString::fromUtf8("\n\u2022 bunny takes 12 % of the light of hand at this pose")))
        << detail->text().toStdString();
    page.setVerdict(held);
    EXPECT_FALSE(detail->text().contains("of the light of"));
}

} // namespace
} // namespace bask
