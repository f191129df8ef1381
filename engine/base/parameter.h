#pragma once
// A table of parameters states what there is to know of a struct's values once: the name in files, the unit,
// what is valid, in which direction a change allows more, and the words. Files, checks, forms, questions,
// reports and exports walk it.

#include "engine/base/unit.h"

#include <optional>
#include <span>
#include <string>
#include <variant>

namespace bask {

/// In which direction a change of a limit allows a rig more than before, so that a person is asked first.
enum class Loosens {
    Never, ///< it is no limit
    Up,
    UpOrZero, ///< zero: no limit at all
    Down,
    InCode ///< it depends on other values; see limits_widened.cpp
};

/// From min to max in the unit of files; NaN is never valid.
struct ValidRange {
    double min = 0.0;
    double max = 0.0;
    bool excludesMin = false;
};

/// All of a parameter but where its value is.
struct ParameterFacts {
    const char* name; ///< in files, without the unit: "held_limit"
    Unit unit;
    ValidRange range;
    Loosens loosens = Loosens::Never;
    const char* label = "";  ///< English, context "Parameter"
    const char* help = "";   ///< a sentence, likewise; empty: the label says it
    int decimals = 2;        ///< on a screen
    bool isRequired = false; ///< in a file
    const char* symbol = ""; ///< in formulas, UTF-8
};

/// "held_limit_s", as people write it in a file.
std::string keyOf(const ParameterFacts& facts);
/// The value as people write it in a file, from SI.
double written(const ParameterFacts& facts, double si);
/// And back.
double fromWritten(const ParameterFacts& facts, double value);

template <class Spec> struct Parameter : ParameterFacts {
    std::variant<double Spec::*, int Spec::*, std::optional<double> Spec::*> member;

    bool isWhole() const { return std::holds_alternative<int Spec::*>(member); }
    bool isOptional() const { return std::holds_alternative<std::optional<double> Spec::*>(member); }
    /// In SI; empty: an optional one that is not set.
    std::optional<double> get(const Spec& spec) const {
        return std::visit([&](auto m) -> std::optional<double> { return spec.*m; }, member);
    }
    /// An optional one can be made empty.
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

/// Sets the parameter with these facts; no effect if it is not in the table.
template <class Spec>
void setParameter(ParameterTable<Spec> table, const ParameterFacts* facts, Spec& spec,
                  std::optional<double> si) {
    for (const Parameter<Spec>& parameter : table)
        if (&parameter == facts)
            parameter.set(spec, si);
}

} // namespace bask
