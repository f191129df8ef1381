#pragma once
// Arguments of a sentence: text, a temperature, an object's temperature, a word of the engine, another
// sentence. An argument keeps its value until it is shown, in the reader's language and unit.

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace bask {

struct Message;

/// The kind of an argument, as the message table declares it. An argument that is only text (read from a
/// file, or made without a value) is interpreted as this kind when it is shown.
enum class ArgKind : unsigned char {
    Text,            ///< shown as it is, number or not: a name, words of a device or a library
    Number,          ///< of the engine, perhaps with a unit: "12.5", "2 mm"; shown in the reader's notation
    Temperature,     ///< in degC in files, "94.8"; shown with its unit
    BareTemperature, ///< a temperature shown without its unit: the first of "88 to 95 °C"
    Difference,      ///< of temperatures; in K in files, "12.4"; shown with its unit
    Temperatures,    ///< of objects: "left 60 °C, right 55.5 °C"
    Differences,     ///< of objects: "left +2.1 K, right ? K"
    Figure,          ///< a number in the unit given by the FigureUnit
    FigureUnit,      ///< the last argument: "mm", "°C"; temperatures in degC are shown in the reader's unit
    About,           ///< the name of another message, whose arguments follow
    Sentence,        ///< another message, or several; in files their English words
    Verb,            ///< a command of a person, see words.h
    State,           ///< a state of the run, or the reason why there is no run
    Fault,           ///< a simulated fault, by its name in files
    Device,          ///< a device, named by its role
    Damage,          ///< of a session file
    Label            ///< of a parameter (context "Parameter"), or a value in words
};

/// A temperature or a temperature difference of one object, in K; NaN if it is unknown.
struct ObjectKelvin {
    std::string object;
    double value_K = 0.0;
};

/// Such a value as files store it: "60", "+2.1" or "?", without its unit.
struct ObjectFigure {
    std::string object;
    std::string figure;
};

class MessageArg {
public:
    MessageArg(std::string text) : m_text(std::move(text)) {}
    MessageArg(const char* text) : m_text(text) {}
    MessageArg(Message sentence);
    /// Several sentences, shown with semicolons between them.
    MessageArg(std::vector<Message> sentences);

    /// A number of the engine whose text may end in a unit: "2 mm".
    static MessageArg number(double value, std::string text) {
        return {ArgKind::Number, std::move(text), value};
    }
    static MessageArg temperature(double t_K, std::string text_degC) {
        return {ArgKind::Temperature, std::move(text_degC), t_K};
    }
    static MessageArg difference(double d_K, std::string text_K) {
        return {ArgKind::Difference, std::move(text_K), d_K};
    }
    static MessageArg temperatures(std::vector<ObjectKelvin> objects);
    static MessageArg differences(std::vector<ObjectKelvin> objects);

    /// Returns the English text, as files store it.
    const std::string& text() const { return m_text; }
    /// Returns the argument's own kind, or `declared` if it has none.
    ArgKind kind(ArgKind declared) const { return m_kind == ArgKind::Text ? declared : m_kind; }

    /// Returns the value of a Temperature or a Difference, parsed from its text if necessary; empty if it is
    /// not a number.
    std::optional<double> kelvin(ArgKind declared) const;
    /// Returns the value of a Number, parsed from its text if necessary; empty if the text is not a number
    /// alone.
    std::optional<double> number() const;
    /// Returns the values of Temperatures or Differences; empty if the text does not contain any.
    std::vector<ObjectKelvin> objects(ArgKind declared) const;
    /// Returns the same with the digits that files store.
    std::vector<ObjectFigure> figures(ArgKind declared) const;
    /// Returns the sentences of a Sentence; empty if the argument is only text.
    const std::vector<Message>& sentences() const;

    /// Compares the texts, as files store them.
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

/// Returns a number for a sentence: %.*g with `digits` significant digits; below 100,000 without an exponent.
std::string formatNumber(double value, int digits = 4);
/// Makes a number argument with `digits` significant digits, followed by the unit if there is one.
MessageArg numberArg(double value, const std::string& unit = {}, int digits = 4);
/// Makes a temperature argument; the English text is in degC with `digits` significant digits.
MessageArg temperatureArg(double t_K, int digits = 4);
/// Makes a temperature argument rounded to `decimals` decimals; "?" if it is not finite.
MessageArg roundedTemperatureArg(double t_K, int decimals = 1);
/// Makes an argument of a temperature difference, or of a rate if the sentence adds "/s".
MessageArg differenceArg(double d_K, int digits = 4);

} // namespace bask
