// What the Objects page says of the air, and how it is edited.

#include "engine/experiment/experiment_file.h"
#include "engine/model/experiment_rig.h"
#include "widgets/objects/air_form.h"
#include "widgets/objects/objects_page.h"

#include "tests/widgets/objects/page_history.h"

#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLocale>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

namespace bask {
namespace {

struct AirFormTest : testing::Test {
    ObjectsPage page;
    QSignalSpy edited{&page, &ObjectsPage::experimentEdited};
    test::PageHistory history{page};
    Experiment experiment = readExperiment(BASK_EXAMPLES "/three-objects.json").value();

    AirFormTest() {
        QLocale::setDefault(QLocale::c());
        page.setExperiment(experiment);
        history.begin();
        page.resize(1150, 900);
        page.show();
        page.activateWindow();
        QApplication::processEvents();
    }
    ~AirFormTest() override { QLocale::setDefault(QLocale()); }
    template <class T> T* child(const char* name) {
        auto* found = page.findChild<T*>(QString::fromLatin1(name));
        EXPECT_NE(found, nullptr) << name;
        return found;
    }
    void choose(int row) { // as a person does
        auto* kind = child<QComboBox>("airKind");
        kind->setFocus();
        while (kind->currentIndex() != row)
            QTest::keyClick(kind, kind->currentIndex() < row ? Qt::Key_Down : Qt::Key_Up);
    }
    void type(const QString& text) {
        auto* field = child<QDoubleSpinBox>("air.convection");
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
    }
    double share() { // in percent, as told
        static const QRegularExpression kShare("(\\d+) %");
        return kShare.match(child<QLabel>("airTakes")->text()).captured(1).toDouble();
    }
};

} // namespace

// Catches: air that is shown otherwise than it is stated, an edit of it that is none, or that an undo does
// not take back.
TEST_F(AirFormTest, IsStatedInOneOfThreeWays) {
    EXPECT_EQ(child<QComboBox>("airKind")->currentText(), "not known, not counted");
    EXPECT_FALSE(child<QDoubleSpinBox>("air.convection")->isVisible());
    choose(1);
    ASSERT_TRUE(page.experiment().air.convection_W_m2K.has_value());
    EXPECT_GT(*page.experiment().air.convection_W_m2K, 1.0) << "begins at what the correlation says";
    EXPECT_LT(*page.experiment().air.convection_W_m2K, 20.0);
    EXPECT_TRUE(child<QDoubleSpinBox>("air.convection")->isVisible());
    EXPECT_EQ(child<QDoubleSpinBox>("air.convection")->suffix(), QString::fromUtf8("\u00a0W/(m² K)"));
    type("8.5");
    EXPECT_EQ(page.experiment().air, (Air{8.5, false}));
    choose(2);
    EXPECT_EQ(page.experiment().air, (Air{std::nullopt, true}));
    EXPECT_FALSE(child<QDoubleSpinBox>("air.convection")->isVisible());
    history.undo.trigger();
    EXPECT_EQ(page.experiment().air, (Air{8.5, false}));
    EXPECT_EQ(child<QDoubleSpinBox>("air.convection")->value(), 8.5);
    history.undo.trigger();
    history.undo.trigger();
    EXPECT_EQ(page.experiment(), experiment);
    EXPECT_EQ(child<QComboBox>("airKind")->currentText(), "not known, not counted");
}

// Catches: an h beyond the range of the file's format.
TEST_F(AirFormTest, KeepsTheRangeOfTheFormat) {
    choose(1);
    EXPECT_EQ(child<QDoubleSpinBox>("air.convection")->minimum(), 0.0);
    EXPECT_EQ(child<QDoubleSpinBox>("air.convection")->maximum(), 1000.0);
    type("0");
    EXPECT_EQ(page.experiment().air, (Air{0.0, false}));
    EXPECT_TRUE(validate(page.experiment()).ok());
}

// Catches: a share of another temperature, object or law than the sentence says.
TEST_F(AirFormTest, TellsWhatTheAirTakesFromTheSelectedObject) {
    experiment.air.convection_W_m2K = 10.0;
    experiment.objects[0].material.emittance = 0.9;
    experiment.objects[0].target_K = 330.0;
    experiment.environment_K = 300.0;
    page.setExperiment(experiment);
    const double air_W_m2 = 10.0 * 30.0;
    const double radiated_W_m2 = 0.9 * 5.670374419e-8 * (std::pow(330.0, 4) - std::pow(300.0, 4));
    EXPECT_NEAR(share(), 100.0 * air_W_m2 / (air_W_m2 + radiated_W_m2), 0.5);
    EXPECT_TRUE(child<QLabel>("airTakes")->text().contains("h = 10.0 W/(m")) << share();
    experiment.objects[0].target_K = 299.0;
    page.setExperiment(experiment);
    EXPECT_FALSE(child<QLabel>("airTakes")->isVisible()) << "a target below the room has no loss";
}

// Catches: unknown air of which nobody is told how much it is, and time constants without the air.
TEST_F(AirFormTest, UnknownAirIsWeighedByNaturalConvection) {
    const double unknown = share();
    EXPECT_TRUE(child<QLabel>("airTakes")->text().startsWith("Natural convection would take"));
    const QString timeConstant = child<QLabel>("timeConstant")->text();
    choose(2);
    EXPECT_GT(unknown, 10.0);
    EXPECT_EQ(share(), unknown);
    EXPECT_TRUE(child<QLabel>("airTakes")->text().startsWith("Takes"));
    EXPECT_NE(child<QLabel>("timeConstant")->text(), timeConstant);
}

// Catches: a person who states an air that the simulated rig does not have, and is not told.
TEST_F(AirFormTest, TheSimulatedAirIsTold) {
    EXPECT_EQ(child<QLabel>("airSimulated")->text(),
              QString::fromUtf8("The simulated rig has h = 0 W/(m² K)."));
    experiment.simulation.convection_W_m2K = 6.5;
    page.setExperiment(experiment);
    EXPECT_TRUE(child<QLabel>("airSimulated")->text().contains("6.5"));
    experiment.rig.emplace();
    page.setExperiment(experiment);
    EXPECT_FALSE(child<QLabel>("airSimulated")->isVisible());
}

// Catches: air that can be edited during a run.
TEST_F(AirFormTest, IsLockedDuringARun) {
    experiment.air.convection_W_m2K = 10.0;
    page.setExperiment(experiment);
    page.setEditable(false, "A run is on.");
    EXPECT_FALSE(child<QComboBox>("airKind")->isEnabled());
    EXPECT_FALSE(child<QDoubleSpinBox>("air.convection")->isEnabled());
}

} // namespace bask
