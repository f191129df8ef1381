#pragma once
// A translation of everything into something longer, for tests of language changes and of room for other
// languages.

#include <QString>
#include <QTranslator>

namespace bask {

/// Puts brackets round every sentence and makes it about 40 % longer, as French is.
class LongerTranslator : public QTranslator {
public:
    bool isEmpty() const override { return false; }
    QString translate(const char*, const char* source, const char*, int) const override {
        const QString text = QString::fromUtf8(source);
        QString more;
        while (more.size() < text.size() * 2 / 5)
            more +=
                more.size() % 8 == 0 ? QLatin1Char(' ') : QLatin1Char('o'); // breaks into lines as words do
        return QLatin1Char('[') + text + more + QLatin1Char(']');
    }
};

} // namespace bask
