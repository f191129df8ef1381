#include "engine/shape/svg_path_data.h"

namespace bask::svg {
namespace {

class PathData {
public:
    explicit PathData(QStringView text) : m_text(text) {}

    std::optional<qsizetype> damage() {
        skipBlanks();
        bool isFirst = true;
        while (m_at < m_text.size()) {
            const char16_t command = m_text[m_at].toLower().unicode();
            const int count = numbersOf(command);
            if (count < 0 || (isFirst && command != u'm'))
                return m_at;
            isFirst = false;
            ++m_at;
            skipBlanks();
            if (count == 0)
                continue;
            do {
                for (int k = 0; k < count; ++k) {
                    const bool isFlag = command == u'a' && (k == 3 || k == 4);
                    if (!(isFlag ? takeFlag() : takeNumber()))
                        return m_at;
                    skipSeparator();
                }
            } while (isNumberNext());
        }
        return std::nullopt;
    }

private:
    /// A repetition of a command; -1: there is no such command.
    static int numbersOf(char16_t command) {
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
    char16_t next(qsizetype after = 0) const {
        return m_at + after < m_text.size() ? m_text[m_at + after].unicode() : u'\0';
    }
    static bool isDigit(char16_t c) { return c >= u'0' && c <= u'9'; }
    void skipBlanks() {
        while (next() == u' ' || next() == u'\t' || next() == u'\n' || next() == u'\r' || next() == u'\f')
            ++m_at;
    }
    void skipSeparator() {
        skipBlanks();
        if (next() == u',') {
            ++m_at;
            skipBlanks();
        }
    }
    bool isNumberNext() const {
        return isDigit(next()) || next() == u'+' || next() == u'-' || next() == u'.';
    }
    int takeDigits() {
        int count = 0;
        for (; isDigit(next()); ++m_at)
            ++count;
        return count;
    }
    bool takeFlag() {
        if (next() != u'0' && next() != u'1')
            return false;
        ++m_at;
        return true;
    }
    bool takeNumber() {
        const qsizetype begun = m_at;
        if (next() == u'+' || next() == u'-')
            ++m_at;
        int digits = takeDigits();
        if (next() == u'.') {
            ++m_at;
            digits += takeDigits();
        }
        if (digits == 0) {
            m_at = begun;
            return false;
        }
        const qsizetype sign = next(1) == u'+' || next(1) == u'-' ? 1 : 0;
        if ((next() == u'e' || next() == u'E') && isDigit(next(1 + sign))) {
            m_at += 1 + sign;
            takeDigits();
        }
        return true;
    }

    QStringView m_text;
    qsizetype m_at = 0;
};

} // namespace

std::optional<qsizetype> damageOf(QStringView data) {
    return PathData(data).damage();
}

} // namespace bask::svg
