#include "app/resources.h"
#include "tests/app/translation_file.h"

#include <QFile>
#include <QRegularExpression>
#include <QSet>

#include <gtest/gtest.h>

namespace bask::test {
namespace {

QSet<QString> placeholders(const QString& text) {
    static const QRegularExpression kPlaceholder(QStringLiteral("%(?:L?[1-9]|n)"));
    QSet<QString> found;
    for (auto match = kPlaceholder.globalMatch(text); match.hasNext();)
        found << match.next().captured();
    return found;
}

// Catches: a string added without its French.
TEST(Translations, FrenchIsComplete) {
    const auto entries = readTranslations(QStringLiteral(BASK_TRANSLATIONS "/bask_fr.ts"));
    ASSERT_GT(entries.size(), 200);
    for (const auto& entry : entries)
        EXPECT_TRUE(entry.finished && (entry.source.isEmpty() || !entry.translation.isEmpty()))
            << entry.context.toStdString() << ": " << entry.source.toStdString();
}

// Catches: a number or name that a translation drops or invents.
TEST(Translations, PlaceholdersAgree) {
    for (const auto& entry : readTranslations(QStringLiteral(BASK_TRANSLATIONS "/bask_fr.ts")))
        EXPECT_EQ(placeholders(entry.source), placeholders(entry.translation))
            << entry.context.toStdString() << ": " << entry.source.toStdString();
}

// Catches: a shortcut letter lost in a menu, or an ellipsis that promises a dialog in one language only.
TEST(Translations, MenusKeepTheirMnemonics) {
    for (const auto& entry : readTranslations(QStringLiteral(BASK_TRANSLATIONS "/bask_fr.ts"))) {
        EXPECT_EQ(entry.source.contains(u'&'), entry.translation.contains(u'&'))
            << entry.source.toStdString();
        EXPECT_EQ(entry.source.endsWith(u'…'), entry.translation.endsWith(u'…'))
            << entry.source.toStdString();
    }
}

// Catches: a translation that is not in the binary.
TEST(Translations, AreInTheBinary) {
    initResources();
    EXPECT_TRUE(QFile::exists(QStringLiteral(":/i18n/bask_fr.qm")));
    EXPECT_TRUE(QFile::exists(QStringLiteral(":/i18n/bask_en.qm")));
}

} // namespace
} // namespace bask::test
