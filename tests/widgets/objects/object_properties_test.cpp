// The form of one object: what it tells besides the fields, which objects_page_test types into.

#include "engine/base/units.h"
#include "engine/model/coordinate_range.h"
#include "engine/model/experiment_parameters.h"
#include "widgets/common/parameter_form.h"
#include "widgets/common/quantity_spin_box.h"
#include "widgets/objects/object_properties.h"

#include <QDoubleSpinBox>
#include <QLabel>
#include <QLocale>

#include <gtest/gtest.h>

namespace bask {
namespace {

struct ObjectPropertiesTest : testing::Test {
    ObjectProperties form;
    ObjectSpec object;

    ObjectPropertiesTest() {
        QLocale::setDefault(QLocale::c());
        object.name = "plate";
        object.shape = Disk{0.015};
        object.material.emittance = object.material.absorptance = 0.9;
        object.material.specificHeat_J_kgK = 904.0;
        object.material.density_kg_m3 = 2700.0;
        object.material.thickness_m = 0.001;
        form.setSurroundings({SourceModel::Gray, 600.0, kelvinFromCelsius(25.0)});
    }
    ~ObjectPropertiesTest() override { QLocale::setDefault(QLocale()); }
    QString text(const char* name) {
        form.setObject(object);
        return form.findChild<QLabel*>(name)->text();
    }
};

} // namespace

// Catches a rate that is written as a computer does ("2.091e-11"), in another unit or with another value.
TEST_F(ObjectPropertiesTest, RatesAreWrittenAsPeopleDo) {
    // A sigma eps / (m c) = 0.9 * 5.670374419e-8 / (2700 * 0.001 * 904)
    EXPECT_EQ(text("lambda2"), QString::fromUtf8("2.091\u00a0×\u00a010⁻¹¹ K⁻³·s⁻¹"));
    EXPECT_EQ(text("lambda1"), "0.2212 K/s");
    EXPECT_EQ(text("lambda3"), "0.1652 K/s");
    object.material.thickness_m = 0.1;
    EXPECT_EQ(text("lambda2"), QString::fromUtf8("2.091\u00a0×\u00a010⁻¹³ K⁻³·s⁻¹"));
    EXPECT_EQ(text("heatCapacity"), QString::fromUtf8("244080 J/(m²·K)"));
}

// Catches a time constant without a unit, or in seconds where nobody counts in them.
TEST_F(ObjectPropertiesTest, TheTimeConstantHasAUnit) {
    object.target_K = kelvinFromCelsius(40.0);
    // 1 / (4 lambda2 T^3)
    EXPECT_EQ(text("timeConstant"), "6.5 min");
    object.material.thickness_m = 0.0001;
    EXPECT_EQ(text("timeConstant"), "39 s");
    object.material.thickness_m = 0.00001;
    EXPECT_EQ(text("timeConstant"), "3.9 s");
    object.material.thickness_m = 0.05;
    EXPECT_EQ(text("timeConstant"), "5.4 h");
}

// Catches a field that shows a value of a file as another: a form with a narrower range than files have.
TEST_F(ObjectPropertiesTest, ShowsWhatAFileMayHave) {
    const auto value = [&](const char* name) { return form.findChild<QDoubleSpinBox*>(name)->value(); };
    for (const double radius_m : {kMinShapeRadius_m, 1e-4, 0.1, kMaxObjectRadius_m}) {
        object.shape = Disk{radius_m};
        form.setObject(object);
        EXPECT_NEAR(value("radius"), 100.0 * radius_m, 1e-9);
    }
    EXPECT_TRUE(form.findChild<QDoubleSpinBox*>("radius")->text().startsWith("100.000"))
        << "the usual digits";
    for (const double sign : {-1.0, 1.0}) {
        object.target_K = kelvinFromCelsius(sign < 0.0 ? kMinTemperature_degC : kMaxTemperature_degC);
        for (int k = 0; k < 6; ++k)
            object.mounting[k] =
                toSi(sign * coordinateRange(k, kMaxMounting_cm, false).max, coordinateUnit(k));
        form.setObject(object);
        EXPECT_NEAR(form.findChild<QuantitySpinBox*>("target")->value_K(), object.target_K, 1e-9);
        for (const char* name : {"mountX", "mountY", "mountZ"})
            EXPECT_NEAR(value(name), sign * kMaxMounting_cm, 1e-9) << name;
        for (const char* name : {"mountRotation", "mountTiltX", "mountTiltY"})
            EXPECT_NEAR(std::abs(value(name)), 180.0, 1e-9) << name;
    }
    for (const Parameter<Material>& each : materialParameters()) {
        if (each.isOptional())
            continue;
        for (const double share : {0.5, 1.0}) {
            Material material = object.material;
            each.set(material, fromWritten(each, share * each.range.max));
            object.material = material;
            form.setObject(object);
            EXPECT_NEAR(value(parameterObjectName(each).toLatin1()),
                        each.unit.symbolPerSi * *each.get(material), 1e-9)
                << each.name;
        }
    }
}

} // namespace bask
