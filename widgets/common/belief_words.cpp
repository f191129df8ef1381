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

double wrongRatesFactor(const Experiment& experiment) {
    const auto isGiven = [](const ObjectSpec& object) { return object.estimatedRates.has_value(); };
    const bool areGiven = std::ranges::all_of(experiment.objects, isGiven); // these are not made wrong
    return areGiven ? 1.0 : experiment.controller.estimatedRateErrorFactor;
}

QString wrongRatesText(double factor) {
    if (factor == 1.0)
        return {};
    return BeliefText::tr(
               "The controller begins with heat rates wrong by up to \u00d7%1, as the experiment asks.")
        .arg(QLocale().toString(factor, 'g', 3));
}

QString wrongRatesText(const Experiment& experiment) {
    return wrongRatesText(wrongRatesFactor(experiment));
}

} // namespace bask
