#include "widgets/common/evenness_words.h"

#include "engine/model/uneven_source.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>

namespace bask {
namespace {

struct EvennessText {
    Q_DECLARE_TR_FUNCTIONS(bask::EvennessText)
};

} // namespace

QString evennessText(const Experiment& experiment) {
    const SourceSpec& source = experiment.source;
    if (source.uneven.isEven())
        return EvennessText::tr("even");
    const std::vector<double> weights = emissionWithoutRings(experiment).weights(source.temperature_K);
    const auto [min, max] = std::ranges::minmax(weights);
    const auto percent = [](double weight) { return QLocale().toString(100.0 * weight, 'f', 0); };
    const QString words =
        source.uneven.profile.empty()
            ? EvennessText::tr("Parts: %1, which radiate %2 to %3 % of what an even one does")
            : EvennessText::tr("Radial profile of %1 points, radiating %2 to %3 % of what an even one does");
    return words.arg(weights.size()).arg(percent(min), percent(max));
}

} // namespace bask
