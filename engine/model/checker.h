#pragma once
// Finds the first invalid value of an experiment.

#include "engine/base/message_code.h"
#include "engine/base/parameter.h"
#include "engine/base/result.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bask {

/// Stores the first error; later checks are skipped.
class Checker {
public:
    static constexpr std::size_t kMaxNameLength = 64;

    bool failed() const { return m_error.has_value(); }
    const std::optional<Error>& error() const { return m_error; }
    Result<void> result() const { return m_error ? Result<void>(*m_error) : Result<void>(); }

    void fail(MessageCode code, const std::string& where, std::vector<MessageArg> args = {});
    void take(const Result<void>& result);

    /// Refuses a value outside [min, max], and NaN.
    void range(const std::string& where, double value, double min, double max, std::string_view unit = {});
    /// Refuses a value outside (0, max].
    void positive(const std::string& where, double value, double max, std::string_view unit = {});
    /// Checks a quantity given in SI and reports it in the units of the file.
    void quantity(const std::string& path, std::string_view name, EdgeUnit unit, double si, double min,
                  double max);
    /// Refuses a name that is not plain (NameNotPlain), or has more than `max` characters. An empty one is
    /// for the caller.
    void name(const std::string& where, const std::string& name, std::size_t max = kMaxNameLength);
    /// The same for words of one line or the name of a person, of at most `max` characters: what chooses a
    /// variant of the character before it is allowed.
    void line(const std::string& where, const std::string& text, std::size_t max);
    /// Checks a parameter; `path` ends with a dot.
    void parameter(const std::string& path, const ParameterFacts& facts, double si);
    /// Checks all parameters of a table; optional ones that are not set are valid.
    template <class Spec>
    void parameters(const std::string& path, ParameterTable<Spec> table, const Spec& spec) {
        for (const Parameter<Spec>& each : table)
            if (const auto si = each.get(spec))
                parameter(path, each, *si);
    }

private:
    std::optional<Error> m_error;
};

} // namespace bask
