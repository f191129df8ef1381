#include "engine/shape/svg_grammar.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace bask::svg {
namespace {

/// A place in a text, and what is taken from there.
class Scanner {
public:
    explicit Scanner(QStringView text) : m_text(text) {}

    qsizetype at() const { return m_at; }
    bool isAtEnd() const { return m_at >= m_text.size(); }
    char16_t next(qsizetype after = 0) const {
        return m_at + after < m_text.size() ? m_text[m_at + after].unicode() : u'\0';
    }
    void skip(qsizetype count = 1) { m_at += count; }
    void skipBlanks() {
        while (next() == u' ' || next() == u'\t' || next() == u'\n' || next() == u'\r' || next() == u'\f')
            skip();
    }
    void skipSeparator() {
        skipBlanks();
        if (take(u','))
            skipBlanks();
    }
    bool take(char16_t c) {
        const bool isThere = next() == c;
        m_at += isThere;
        return isThere;
    }
    bool take(QStringView word) {
        const bool isThere = m_text.mid(m_at).startsWith(word);
        m_at += isThere ? word.size() : 0;
        return isThere;
    }
    bool isNumberNext() const {
        return isDigit(next()) || next() == u'+' || next() == u'-' || next() == u'.';
    }
    bool takeNumber() {
        const qsizetype begun = m_at;
        if (next() == u'+' || next() == u'-')
            skip();
        int digits = takeDigits();
        if (take(u'.'))
            digits += takeDigits();
        if (digits == 0) {
            m_at = begun;
            return false;
        }
        const qsizetype sign = next(1) == u'+' || next(1) == u'-' ? 1 : 0;
        if ((next() == u'e' || next() == u'E') && isDigit(next(1 + sign))) {
            skip(1 + sign);
            takeDigits();
        }
        // QtSvg draws a larger one at another place, or not at all.
        constexpr double kMax = 1e9;
        if (!(std::abs(m_text.mid(begun, m_at - begun).toDouble()) <= kMax)) {
            m_at = begun;
            return false;
        }
        return true;
    }

private:
    static bool isDigit(char16_t c) { return c >= u'0' && c <= u'9'; }
    int takeDigits() {
        int count = 0;
        for (; isDigit(next()); skip())
            ++count;
        return count;
    }

    QStringView m_text;
    qsizetype m_at = 0;
};

/// Of a repetition of a path's command; -1: there is no such command.
int numbersOf(char16_t command) {
    switch (command) {
    case u'z':
        return 0;
    case u'h':
    case u'v':
        return 1;
    case u'm':
    case u'l':
    case u't':
        return 2;
    case u's':
    case u'q':
        return 4;
    case u'c':
        return 6;
    case u'a':
        return 7;
    default:
        return -1;
    }
}

struct Transform {
    QStringView name;
    std::array<int, 2> counts; ///< of numbers, either of which it may have
};
constexpr std::array kTransforms{Transform{u"matrix", {6, 6}}, Transform{u"translate", {1, 2}},
                                 Transform{u"scale", {1, 2}},  Transform{u"rotate", {1, 3}},
                                 Transform{u"skewX", {1, 1}},  Transform{u"skewY", {1, 1}}};

/// "(10, 20)"; where not, the scanner stays where it cannot go on.
bool takeNumbers(Scanner& text, const Transform& transform) {
    text.skipBlanks();
    if (!text.take(u'('))
        return false;
    text.skipBlanks();
    int count = 0;
    for (; text.isNumberNext(); ++count) {
        if (!text.takeNumber())
            return false;
        text.skipSeparator();
    }
    return std::ranges::find(transform.counts, count) != transform.counts.end() && text.take(u')');
}

} // namespace

std::optional<qsizetype> pathDamage(QStringView data) {
    Scanner text(data);
    text.skipBlanks();
    for (bool isFirst = true; !text.isAtEnd(); isFirst = false) {
        const char16_t command = QChar(text.next()).toLower().unicode();
        const int count = numbersOf(command);
        if (count < 0 || (isFirst && command != u'm'))
            return text.at();
        text.skip();
        text.skipBlanks();
        if (count == 0)
            continue;
        do {
            for (int k = 0; k < count; ++k) {
                const bool isFlag = command == u'a' && (k == 3 || k == 4);
                if (!(isFlag ? text.take(u'0') || text.take(u'1') : text.takeNumber()))
                    return text.at();
                text.skipSeparator();
            }
        } while (text.isNumberNext());
    }
    return std::nullopt;
}

std::optional<qsizetype> pointsDamage(QStringView points) {
    Scanner text(points);
    text.skipBlanks();
    while (!text.isAtEnd()) {
        const qsizetype begun = text.at();
        if (!text.takeNumber())
            return text.at();
        text.skipSeparator();
        if (text.isAtEnd())
            return begun;
        if (!text.takeNumber())
            return text.at();
        text.skipSeparator();
    }
    return std::nullopt;
}

std::optional<qsizetype> transformDamage(QStringView transforms) {
    if (transforms.trimmed() == u"none")
        return std::nullopt;
    Scanner text(transforms);
    text.skipSeparator();
    while (!text.isAtEnd()) {
        const qsizetype begun = text.at();
        const auto transform =
            std::ranges::find_if(kTransforms, [&](const Transform& each) { return text.take(each.name); });
        if (transform == kTransforms.end() || !takeNumbers(text, *transform))
            return begun;
        text.skipSeparator();
    }
    return std::nullopt;
}

} // namespace bask::svg
