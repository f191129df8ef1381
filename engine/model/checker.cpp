#include "engine/model/checker.h"

#include "engine/base/message.h"

namespace bask {

void Checker::fail(MessageCode code, const std::string& where, std::vector<MessageArg> args) {
    if (!m_error)
        m_error = Error(code, where, std::move(args));
}

void Checker::take(const Result<void>& result) {
    if (!result && !m_error)
        m_error = result.error();
}

void Checker::range(const std::string& where, double value, double min, double max, std::string_view unit) {
    if (!(value >= min && value <= max))
        fail(MessageCode::ValueOutOfRange, where,
             {formatNumber(value, 10), formatNumber(min), formatNumber(max), std::string(unit)});
}

void Checker::positive(const std::string& where, double value, double max, std::string_view unit) {
    if (value <= 0.0)
        fail(MessageCode::ValueNotPositive, where, {formatNumber(value, 10)});
    else
        range(where, value, 0.0, max, unit);
}

void Checker::quantity(const std::string& path, std::string_view name, EdgeUnit unit, double si, double min,
                       double max) {
    range(path + readableKey(name, unit), fromSi(si, unit).value, min, max, readableUnit(unit));
}

void Checker::parameter(const std::string& path, const ParameterFacts& facts, double si) {
    const std::string where = path + keyOf(facts);
    const double value = written(facts, si);
    if (facts.range.excludesMin)
        positive(where, value, facts.range.max, facts.unit.words);
    else
        range(where, value, facts.range.min, facts.range.max, facts.unit.words);
}

} // namespace bask
