#pragma once
// A parameter table describes the values of a struct in one place: name in files, unit, valid range, which
// direction of change loosens a limit, and labels. Files, checks, forms, questions, reports and exports use
// it.

#include "engine/base/unit.h"

#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <variant>

namespace bask {

/// The direction in which a change loosens a limit. A person is asked before a limit is loosened.
enum class Loosens {
    Unstated, ///< treated as Never; a table whose values may be limits states it, and a test insists
    Never,    ///< the value is not a limit
    Up,
    UpOrZero, ///< a larger value loosens it, and zero means no limit
    Down,
    InCode ///< it depends on other values; see limits_widened.cpp
};

/// The valid range, from min to max in the unit of files; NaN is never valid.
struct ValidRange {
    double min = 0.0;
    double max = 0.0;
    bool excludesMin = false;
};

/// Everything about a parameter except the member that stores its value.
struct ParameterFacts {
    const char* name; ///< in files, without the unit: "held_limit"
    Unit unit;
    ValidRange range;
    Loosens loosens = Loosens::Unstated;
    const char* label = "";  ///< English label, translation context "Parameter"
    const char* help = "";   ///< an English sentence in the same context; empty if the label is enough
    int decimals = 2;        ///< number of decimals on a screen
    bool isRequired = false; ///< whether a file must contain it
    const char* symbol = ""; ///< in formulas, UTF-8
};

/// Returns whether a change in one direction loosens it by itself, without regard to other values.
inline bool loosensByItself(const ParameterFacts& facts) {
    return facts.loosens == Loosens::Up || facts.loosens == Loosens::UpOrZero ||
           facts.loosens == Loosens::Down;
}
/// Returns the key in files, with the unit: "held_limit_s".
std::string keyOf(const ParameterFacts& facts);
/// Converts a value from SI to the unit used in files.
double written(const ParameterFacts& facts, double si);
/// Converts a value from the unit used in files to SI.
double fromWritten(const ParameterFacts& facts, double value);

template <class Spec> struct Parameter : ParameterFacts {
    std::variant<double Spec::*, int Spec::*, std::optional<double> Spec::*> member;

    bool isWhole() const { return std::holds_alternative<int Spec::*>(member); }
    bool isOptional() const { return std::holds_alternative<std::optional<double> Spec::*>(member); }
    /// Returns the value in SI; empty for an optional value that is not set.
    std::optional<double> get(const Spec& spec) const {
        return std::visit([&](auto m) -> std::optional<double> { return spec.*m; }, member);
    }
    /// Sets the value in SI. Only an optional value may be set to empty.
    void set(Spec& spec, std::optional<double> si) const {
        if (const auto* optional = std::get_if<std::optional<double> Spec::*>(&member))
            spec.** optional = si;
        else if (const auto* whole = std::get_if<int Spec::*>(&member))
            spec.** whole = static_cast<int>(si.value());
        else
            spec.*std::get<double Spec::*>(member) = si.value();
    }
};

template <class Spec> using ParameterTable = std::span<const Parameter<Spec>>;

/// Returns the parameter that is stored in this member. Throws std::invalid_argument if the table has none.
template <class Spec, class Value>
const Parameter<Spec>& parameterOf(ParameterTable<Spec> table, Value Spec::*member) {
    for (const Parameter<Spec>& parameter : table)
        if (parameter.member == decltype(parameter.member)(member))
            return parameter;
    throw std::invalid_argument("a member without a parameter");
}

/// Sets the parameter with these facts; no effect if it is not in the table.
template <class Spec>
void setParameter(ParameterTable<Spec> table, const ParameterFacts* facts, Spec& spec,
                  std::optional<double> si) {
    for (const Parameter<Spec>& parameter : table)
        if (&parameter == facts)
            parameter.set(spec, si);
}

} // namespace bask
