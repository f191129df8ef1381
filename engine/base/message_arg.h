#pragma once
// What a sentence speaks of: text, a temperature, an object's temperature, a word of the engine's own,
// another sentence. An argument keeps its value until it is shown, in the reader's language and unit.

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace bask {

struct Message;

/// What an argument is, as the table of messages declares it. An argument that is text, since it was read
/// from a file or its maker has no value, is read as this when it is shown.
enum class ArgKind : unsigned char {
    Text,            ///< as it is: a number, a name, words of a device or a library
    Temperature,     ///< in files in degC, "94.8"; shown with its unit
    BareTemperature, ///< the same, shown without its unit: the first of "88 to 95 °C"
    Difference,      ///< of temperatures; in files in K, "12.4"; shown with its unit
    Temperatures,    ///< of objects: "left 60 °C, right 55.5 °C"
    Differences,     ///< of objects: "left +2.1 K, right ? K"
    Figure,          ///< a number in the unit that the FigureUnit names
    FigureUnit,      ///< the last argument: "mm", "°C"; temperatures in degC are shown in the reader's unit
    About,           ///< the name of another message, whose arguments follow
    Sentence,        ///< another message, or several; in files their English words
    Verb,            ///< what a person asks for, see words.h
    State,           ///< of the run, or why it has none
    Fault,           ///< a simulated fault, by its name in files
    Device,          ///< a device by its role
    Damage,          ///< of a session file
    Label            ///< of a parameter (context "Parameter"), or a value in words
};

/// A temperature or a difference of one object, in K; NaN where it is not known.
struct ObjectKelvin {
    std::string object;
    double value_K = 0.0;
};

class MessageArg {
public:
    MessageArg(std::string text) : m_text(std::move(text)) {}
    MessageArg(const char* text) : m_text(text) {}
    MessageArg(Message sentence);
    /// Several sentences, shown with semicolons between them.
    MessageArg(std::vector<Message> sentences);

    static MessageArg temperature(double t_K, std::string text_degC) {
        return {ArgKind::Temperature, std::move(text_degC), t_K};
    }
    static MessageArg difference(double d_K, std::string text_K) {
        return {ArgKind::Difference, std::move(text_K), d_K};
    }
    static MessageArg temperatures(std::vector<ObjectKelvin> objects);
    static MessageArg differences(std::vector<ObjectKelvin> objects);

    /// As files keep it, in English.
    const std::string& text() const { return m_text; }
    /// What it is: its own kind, else `declared`.
    ArgKind kind(ArgKind declared) const { return m_kind == ArgKind::Text ? declared : m_kind; }

    /// The value of a Temperature or a Difference, from its text if need be; empty: no number.
    std::optional<double> kelvin(ArgKind declared) const;
    /// Those of Temperatures or Differences; empty: the text is none such.
    std::vector<ObjectKelvin> objects(ArgKind declared) const;
    /// Empty where there are only words.
    const std::vector<Message>& sentences() const;

    /// Alike in a file.
    friend bool operator==(const MessageArg& a, const MessageArg& b) { return a.m_text == b.m_text; }

private:
    using Objects = std::shared_ptr<const std::vector<ObjectKelvin>>;
    using Sentences = std::shared_ptr<const std::vector<Message>>;
    using Value = std::variant<std::monostate, double, Objects, Sentences>;
    MessageArg(ArgKind kind, std::string text, Value value)
        : m_text(std::move(text)), m_kind(kind), m_value(std::move(value)) {}

    std::string m_text;
    ArgKind m_kind = ArgKind::Text;
    Value m_value;
};

/// Number in a sentence: %.*g with `digits` significant digits.
std::string formatNumber(double value, int digits = 4);
/// A temperature in a sentence; in English in degC with so many significant digits.
MessageArg temperatureArg(double t_K, int digits = 4);
/// The same, to a tenth or a hundredth of a degree; "?" where it is not finite.
MessageArg roundedTemperatureArg(double t_K, int decimals = 1);
/// A difference of temperatures, or a rate of which "/s" is in the sentence.
MessageArg differenceArg(double d_K, int digits = 4);

} // namespace bask
