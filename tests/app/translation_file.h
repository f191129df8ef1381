#pragma once
// A .ts file as the tests read it.

#include <QFile>
#include <QList>
#include <QString>
#include <QXmlStreamReader>

namespace bask::test {

struct TranslationEntry {
    QString context, source, translation;
    bool finished = true;
};

inline QList<TranslationEntry> readTranslations(const QString& path) {
    QFile file(path);
    QList<TranslationEntry> entries;
    if (!file.open(QIODevice::ReadOnly))
        return entries;
    QXmlStreamReader xml(&file);
    QString context;
    TranslationEntry entry;
    while (!xml.atEnd()) {
        if (xml.readNext() == QXmlStreamReader::StartElement) {
            if (xml.name() == QLatin1String("name")) {
                context = xml.readElementText();
            } else if (xml.name() == QLatin1String("source")) {
                entry = {context, xml.readElementText(), {}, true};
            } else if (xml.name() == QLatin1String("translation")) {
                entry.finished = !xml.attributes().hasAttribute(QLatin1String("type"));
                entry.translation = xml.readElementText(QXmlStreamReader::IncludeChildElements).trimmed();
            }
        } else if (xml.isEndElement() && xml.name() == QLatin1String("message")) {
            entries << entry;
        }
    }
    return entries;
}

} // namespace bask::test
