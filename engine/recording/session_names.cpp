#include "engine/recording/session_names.h"

#include "engine/model/trace_sample.h"
#include "engine/recording/recorded_prediction.h"
#include "engine/recording/row_chain.h"
#include "engine/recording/session_seal.h"

#include <algorithm>
#include <iterator>

namespace bask {

bool NamesInSession::has(const std::string& name) const {
    return std::ranges::find(always, name) != always.end() ||
           std::ranges::find(sometimes, name) != sometimes.end();
}

NamesInSession namesOfTables() {
    NamesInSession names{{"pose", "source_pose"}, {"thermal_frame", "camera", "traffic", "prediction"}};
    for (const auto table : {ChainTable::Meta, ChainTable::Experiment, ChainTable::Object, ChainTable::Step,
                             ChainTable::TargetStep, ChainTable::Overview, ChainTable::Command,
                             ChainTable::Event, ChainTable::Note})
        names.always.emplace_back(tableName(table));
    for (const auto& views : {storedViews(kObjectColumns), storedViews(kRunColumns)})
        std::ranges::copy_if(views, std::back_inserter(names.always),
                             [&](const std::string& view) { return !names.has(view); });
    return names;
}

NamesInSession namesOfFacts() {
    return {{"software", "created", "simulated", "outcome", "finished"},
            {"operator", "sample", "batch", kPredictedEndKey}};
}

bool isTableName(const std::string& name) {
    return std::ranges::any_of(kChainedTables, [&](ChainTable table) { return name == tableName(table); });
}

/// Seal and chain came together, the column of the operator just after.
bool isOfChainingBask(const std::string& schemaSql) {
    return schemaSql == kCreateSeal || schemaSql.find("operator TEXT") != std::string::npos;
}

std::string eitherOf(const std::vector<std::string>& names) {
    std::string out;
    for (std::size_t k = 0; k < names.size(); ++k)
        out += (k == 0 ? "" : k + 1 == names.size() ? " or " : ", ") + names[k];
    return out;
}

} // namespace bask
