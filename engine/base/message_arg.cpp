#include "engine/base/message_arg.h"

#include "engine/base/message.h"
#include "engine/base/units.h"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

namespace bask {
namespace {

/// Of the whole text, without regard to the computer's language.
std::optional<double> numberOf(std::string_view text) {
    if (text.starts_with('+'))
        text.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool isWhole = error == std::errc() && end == text.data() + text.size();
    return isWhole ? std::optional(value) : std::nullopt;
}

constexpr std::string_view kCelsius = " \u00b0C", kKelvin = " K", kUnknown = "?";

std::string_view unitOf(ArgKind kind) {
    return kind == ArgKind::Temperatures ? kCelsius : kKelvin;
}

std::string figureOf(double value_K, ArgKind kind) {
    if (!std::isfinite(value_K))
        return std::string(kUnknown);
    if (kind == ArgKind::Temperatures)
        return roundedTemperatureArg(value_K, 2).text();
    return (value_K > 0.0 ? "+" : "") + formatNumber(value_K, 2);
}

std::string joined(const std::vector<ObjectKelvin>& objects, ArgKind kind) {
    std::string out;
    for (const ObjectKelvin& each : objects) {
        out += (out.empty() ? "" : ", ") + each.object + ' ' + figureOf(each.value_K, kind);
        out += unitOf(kind);
    }
    return out;
}

/// "left 60 °C": a name may have spaces and commas, so it is read from its end.
std::optional<ObjectFigure> objectOf(std::string_view text, ArgKind kind) {
    const std::string_view unit = unitOf(kind);
    if (!text.ends_with(unit))
        return std::nullopt;
    text.remove_suffix(unit.size());
    const std::size_t space = text.rfind(' ');
    if (space == std::string_view::npos)
        return std::nullopt;
    const std::string_view figure = text.substr(space + 1);
    if (figure != kUnknown && !numberOf(figure))
        return std::nullopt;
    return ObjectFigure{std::string(text.substr(0, space)), std::string(figure)};
}

double kelvinOf(const ObjectFigure& object, ArgKind kind) {
    const double value = numberOf(object.figure).value_or(std::numeric_limits<double>::quiet_NaN());
    return kind == ArgKind::Temperatures ? kelvinFromCelsius(value) : value;
}

std::vector<ObjectFigure> objectsOf(std::string_view text, ArgKind kind) {
    constexpr std::string_view kBetween = ", ";
    std::vector<ObjectFigure> out;
    for (std::size_t from = 0, to = 0; to != std::string_view::npos;) {
        to = text.find(kBetween, to);
        if (const auto object = objectOf(text.substr(from, to - from), kind)) {
            out.push_back(*object);
            from = to + kBetween.size();
        } else if (to == std::string_view::npos) {
            return {};
        }
        to += to == std::string_view::npos ? 0 : kBetween.size();
    }
    return out;
}

std::string joined(const std::vector<Message>& sentences) {
    std::string out;
    for (const Message& each : sentences)
        out += (out.empty() ? "" : "; ") + describe(each);
    return out;
}

} // namespace

MessageArg::MessageArg(std::vector<Message> sentences)
    : m_text(joined(sentences)), m_kind(ArgKind::Sentence),
      m_value(std::make_shared<const std::vector<Message>>(std::move(sentences))) {}

MessageArg::MessageArg(Message sentence) : MessageArg(std::vector<Message>{std::move(sentence)}) {}

MessageArg MessageArg::temperatures(std::vector<ObjectKelvin> objects) {
    std::string text = joined(objects, ArgKind::Temperatures);
    return {ArgKind::Temperatures, std::move(text),
            std::make_shared<const std::vector<ObjectKelvin>>(std::move(objects))};
}

MessageArg MessageArg::differences(std::vector<ObjectKelvin> objects) {
    std::string text = joined(objects, ArgKind::Differences);
    return {ArgKind::Differences, std::move(text),
            std::make_shared<const std::vector<ObjectKelvin>>(std::move(objects))};
}

std::optional<double> MessageArg::kelvin(ArgKind declared) const {
    if (const double* value = std::get_if<double>(&m_value))
        return *value;
    const auto value = numberOf(m_text);
    const bool isDifference = kind(declared) == ArgKind::Difference;
    return value && !isDifference ? std::optional(kelvinFromCelsius(*value)) : value;
}

std::vector<ObjectKelvin> MessageArg::objects(ArgKind declared) const {
    if (const Objects* value = std::get_if<Objects>(&m_value))
        return **value;
    std::vector<ObjectKelvin> out;
    for (ObjectFigure& each : objectsOf(m_text, kind(declared))) {
        const double value_K = kelvinOf(each, kind(declared));
        out.push_back({std::move(each.object), value_K});
    }
    return out;
}

std::vector<ObjectFigure> MessageArg::figures(ArgKind declared) const {
    const Objects* value = std::get_if<Objects>(&m_value);
    if (value == nullptr)
        return objectsOf(m_text, kind(declared));
    std::vector<ObjectFigure> out;
    for (const ObjectKelvin& each : **value)
        out.push_back({each.object, figureOf(each.value_K, kind(declared))});
    return out;
}

std::optional<double> MessageArg::number() const {
    const double* value = std::get_if<double>(&m_value);
    return value != nullptr ? std::optional(*value) : numberOf(m_text);
}

const std::vector<Message>& MessageArg::sentences() const {
    static const std::vector<Message> kNone;
    const Sentences* value = std::get_if<Sentences>(&m_value);
    return value != nullptr ? **value : kNone;
}

std::string formatNumber(double value, int digits) {
    std::array<char, 40> buffer{};        // not printf: its decimal point is that of the computer's language
    constexpr double kLargestWhole = 1e5; // "113", never "1.1e+02"
    const bool isWhole = std::abs(value) < kLargestWhole && std::abs(value) >= std::pow(10.0, digits) - 0.5;
    const auto [end, failed] =
        isWhole ? std::to_chars(buffer.begin(), buffer.end(), value, std::chars_format::fixed, 0)
                : std::to_chars(buffer.begin(), buffer.end(), value, std::chars_format::general, digits);
    return {buffer.begin(), end};
}

MessageArg numberArg(double value, const std::string& unit, int digits) {
    return MessageArg::number(value, formatNumber(value, digits) + (unit.empty() ? unit : ' ' + unit));
}

MessageArg temperatureArg(double t_K, int digits) {
    return MessageArg::temperature(t_K, formatNumber(celsiusFromKelvin(t_K), digits));
}

MessageArg roundedTemperatureArg(double t_K, int decimals) {
    if (!std::isfinite(t_K))
        return MessageArg::temperature(t_K, std::string(kUnknown));
    const double scale = std::pow(10.0, decimals);
    return MessageArg::temperature(t_K, formatNumber(std::round(celsiusFromKelvin(t_K) * scale) / scale, 6));
}

MessageArg differenceArg(double d_K, int digits) {
    return MessageArg::difference(d_K, formatNumber(d_K, digits));
}

} // namespace bask
