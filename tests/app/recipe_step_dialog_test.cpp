// The form of a recipe's step: what nobody touches stays as it is.

#include "widgets/recipe/recipe_step_dialog.h"

#include <QComboBox>
#include <QDoubleSpinBox>

#include <gtest/gtest.h>

namespace bask::test {
namespace {

using Until = RecipeStep::Until;

const QStringList kObjects{QStringLiteral("circle"), QStringLiteral("left")};

RecipeStep finelySet(Until until) {
    RecipeStep step;
    step.example = until == Until::Below ? "" : "two-circles";
    step.until = until;
    step.duration_s = 2.50049;
    step.object = until == Until::Above || until == Until::Below ? "left" : "";
    step.temperature_K = 314.8777;
    step.maxDuration_s = 1234.50049;
    return step;
}

} // namespace

// Catches: 2.5 s that become 3 s, 41.7277 degC that become 41.7 degC, by a look at them.
TEST(RecipeStepDialogTest, okWithoutAnEditChangesNothing) {
    for (const TemperatureUnit unit :
         {TemperatureUnit::Celsius, TemperatureUnit::Kelvin, TemperatureUnit::Fahrenheit})
        for (const Until until : {Until::Settled, Until::Time, Until::Above, Until::Below}) {
            const RecipeStep given = finelySet(until);
            RecipeStepDialog form(given, kObjects, unit);
            form.setAttribute(Qt::WA_DeleteOnClose, false);
            form.show();
            for (auto* field : form.findChildren<QDoubleSpinBox*>())
                field->interpretText(); // as when it is left
            form.accept();
            EXPECT_EQ(form.step(), given) << static_cast<int>(until);
        }
}

TEST(RecipeStepDialogTest, timesAreShownAsTheyAreAndTakenToTheMillisecond) {
    RecipeStep given = finelySet(Until::Settled);
    given.duration_s = 2.5;
    given.maxDuration_s = 1800.0;
    RecipeStepDialog form(given, kObjects, TemperatureUnit::Celsius);
    auto* duration = form.findChild<QDoubleSpinBox*>(QStringLiteral("duration"));
    auto* maxDuration = form.findChild<QDoubleSpinBox*>(QStringLiteral("atMost"));
    EXPECT_EQ(duration->text(), duration->locale().toString(2.5, 'f', 1) + QStringLiteral(" s"));
    EXPECT_EQ(maxDuration->text(), QStringLiteral("1800 s"));
    maxDuration->setValue(90.125);
    EXPECT_EQ(form.step().maxDuration_s, 90.125);
    EXPECT_EQ(form.step().duration_s, 2.5);

    given.duration_s = 0.9999; // shown as 1, which is a time that may be waited for
    RecipeStepDialog other(given, kObjects, TemperatureUnit::Celsius);
    EXPECT_EQ(other.step().duration_s, 0.9999);
    auto* until = other.findChild<QComboBox*>(QStringLiteral("until"));
    until->setCurrentIndex(until->findData(static_cast<int>(Until::Time)));
    EXPECT_EQ(other.step().duration_s, 1.0);
}

} // namespace bask::test
