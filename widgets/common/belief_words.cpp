#include "widgets/common/belief_words.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>

namespace bask {
namespace {

struct BeliefText {
    Q_DECLARE_TR_FUNCTIONS(bask::BeliefText)
};

} // namespace

QString wrongRatesText(const Experiment& experiment) {
    const double factor = experiment.controller.estimatedRateErrorFactor;
    const auto isGiven = [](const ObjectSpec& object) { return object.estimatedRates.has_value(); };
    if (factor == 1.0 || std::ranges::all_of(experiment.objects, isGiven)) // given ones are not made wrong
        return {};
    return BeliefText::tr(
               "The controller began with heat rates wrong by up to \u00d7%1, as the experiment asks.")
        .arg(QLocale().toString(factor, 'g', 3));
}

} // namespace bask
