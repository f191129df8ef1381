// The form of one object: what it tells besides the fields, which objects_page_test types into.

#include "engine/base/units.h"
#include "widgets/objects/object_properties.h"

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

} // namespace bask
