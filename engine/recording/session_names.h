#pragma once
// What there is in a session by name: its tables and views, and the facts in meta.

#include <string>
#include <vector>

namespace bask {

struct NamesInSession {
    std::vector<std::string> always;
    std::vector<std::string> sometimes; ///< by the rig, or by what people say

    bool has(const std::string& name) const;
};
NamesInSession namesOfTables(); ///< and of views; without the chain and the seal
NamesInSession namesOfFacts();  ///< keys of meta; a recording without an end lacks the last two of `always`
/// Whether it is the name of a table, not of a view.
bool isTableName(const std::string& name);

/// Whether this statement is of a Bask that chains its recordings.
bool isOfChainingBask(const std::string& schemaSql);

/// Returns "a, b or c".
std::string eitherOf(const std::vector<std::string>& names);

} // namespace bask
