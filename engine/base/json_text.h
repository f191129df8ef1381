#pragma once
// A JSON text as a whole: checked before it is parsed, then read.

#include "engine/base/result.h"

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <optional>
#include <string>

namespace bask {

/// The first failure; everything after it is skipped.
using Failure = std::optional<Error>;

/// Puts the place before that which the error names already.
Error located(Error error, const std::string& place);

/// Empty if the result is a success.
inline Failure failureOf(const Result<void>& result) {
    return result ? Failure() : result.error();
}

/// Calls read(json, failure) with the parsed text; `place` names the text in errors. Errors: FileEmpty;
/// syntax, numbers out of range, repeated keys, nesting deeper than 32; what `read` leaves in its failure or
/// throws as nlohmann::json::exception.
Failure readJsonTree(const std::string& text, const std::string& place,
                     const std::function<void(const nlohmann::json&, Failure&)>& read);

/// Same, where read(json, failure, out) fills in what the text holds.
template <class T, class Read>
Result<T> readJsonText(const std::string& text, const std::string& place, Read read) {
    T out;
    const Failure failed =
        readJsonTree(text, place, [&](const nlohmann::json& j, Failure& failure) { read(j, failure, out); });
    return failed ? Result<T>(*failed) : Result<T>(std::move(out));
}

} // namespace bask
