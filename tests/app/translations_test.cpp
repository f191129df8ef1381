#include "app/resources.h"
#include "tests/app/translation_file.h"
#include "widgets/common/language.h"

#include <QApplication>
#include <QFile>
#include <QFontDatabase>
#include <QGlyphRun>
#include <QRawFont>
#include <QRegularExpression>
#include <QSet>
#include <QTextLayout>

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

class Translations : public testing::TestWithParam<QString> {
protected:
    const QList<TranslationEntry> m_entries =
        readTranslations(QStringLiteral(BASK_TRANSLATIONS "/bask_%1.ts").arg(GetParam()));
};

// Catches: a string added without its translation.
TEST_P(Translations, AreComplete) {
    ASSERT_GT(m_entries.size(), 200);
    for (const auto& entry : m_entries)
        EXPECT_TRUE(entry.finished && (entry.source.isEmpty() || !entry.translation.isEmpty()))
            << entry.context.toStdString() << ": " << entry.source.toStdString();
}

// Catches: a number or name that a translation drops or invents.
TEST_P(Translations, PlaceholdersAgree) {
    for (const auto& entry : m_entries)
        EXPECT_EQ(placeholders(entry.source), placeholders(entry.translation))
            << entry.context.toStdString() << ": " << entry.source.toStdString();
}

// Catches: a shortcut letter lost in a menu, one that no key of a Chinese keyboard's types, or an ellipsis
// that promises a dialog in one language only.
TEST_P(Translations, MenusKeepTheirMnemonics) {
    static const QRegularExpression kMnemonic(QStringLiteral("&(.)"));
    for (const auto& entry : m_entries) {
        const QString letter = kMnemonic.match(entry.source).captured(1).toUpper();
        EXPECT_EQ(letter.isEmpty(), !entry.translation.contains(u'&')) << entry.source.toStdString();
        EXPECT_EQ(entry.source.endsWith(u'…'), entry.translation.endsWith(u'…'))
            << entry.source.toStdString();
        if (GetParam().startsWith(QLatin1String("zh")) && !letter.isEmpty()) {
            EXPECT_TRUE(entry.translation.contains(QStringLiteral("(&%1)").arg(letter)))
                << entry.translation.toStdString();
        }
    }
}

// Catches: a translation that is not in the binary.
TEST_P(Translations, AreInTheBinary) {
    initResources();
    EXPECT_TRUE(QFile::exists(QStringLiteral(":/i18n/bask_%1.qm").arg(GetParam())));
}

QStringList languages() {
    QStringList codes = Language::codes();
    codes.removeOne(QStringLiteral("en"));
    return codes;
}

INSTANTIATE_TEST_SUITE_P(Language, Translations, testing::ValuesIn(languages()),
                         [](const auto& language) { return language.param.toStdString(); });

// Catches: Simplified characters on a desktop of Hong Kong, or English on one of Singapore.
TEST(LanguageOfADesktop, IsTheNearest) {
    const std::pair<const char*, const char*> cases[] = {
        {"zh_CN", "zh_CN"}, {"zh_SG", "zh_CN"}, {"zh", "zh_CN"}, {"zh_TW", "zh_TW"}, {"zh_HK", "zh_TW"},
        {"zh_MO", "zh_TW"}, {"fr_CA", "fr"},    {"en_GB", "en"}, {"de_DE", "en"},    {"C", "en"}};
    for (const auto& [locale, code] : cases)
        EXPECT_EQ(Language::nearest(QLocale(QLatin1String(locale))), QLatin1String(code)) << locale;
}

// Catches: two languages of one name in the menu, or one that is named in another's words.
TEST(LanguageOfADesktop, HasANameOfItsOwn) {
    const QStringList codes = Language::codes();
    QSet<QString> names;
    for (const QString& code : codes)
        names << Language::ownName(code);
    EXPECT_EQ(names.size(), codes.size());
    EXPECT_EQ(Language::ownName(QStringLiteral("zh_CN")), QStringLiteral("简体中文"));
    EXPECT_EQ(Language::ownName(QStringLiteral("zh_TW")), QStringLiteral("繁體中文"));
}

// Catches: boxes in place of characters, and Han characters in Japanese or the other Chinese's forms.
TEST(Chinese, IsDrawnInItsOwnForms) {
    const std::pair<QString, QString> cases[] = {
        {QStringLiteral("zh_CN"), QStringLiteral("Noto Sans CJK SC")},
        {QStringLiteral("zh_TW"), QStringLiteral("Noto Sans CJK TC")}};
    initResources();
    Language language;
    for (const auto& [code, family] : cases) {
        if (!QFontDatabase::families().contains(family))
            GTEST_SKIP() << "fonts-noto-cjk is not installed";
        language.set(code);
        QSet<QChar> characters;
        for (const auto& entry : readTranslations(QStringLiteral(BASK_TRANSLATIONS "/bask_%1.ts").arg(code)))
            for (const QChar character : entry.translation)
                if (character.isPrint() && !character.isSpace())
                    characters << character;
        EXPECT_GT(characters.size(), 500);
        for (const QChar character : characters) {
            QTextLayout layout(character, QApplication::font());
            layout.beginLayout();
            layout.createLine();
            layout.endLayout();
            for (const QGlyphRun& run : layout.glyphRuns()) {
                EXPECT_FALSE(run.glyphIndexes().contains(0)) << QString(character).toStdString();
                if (character.script() == QChar::Script_Han) {
                    EXPECT_EQ(run.rawFont().familyName().toStdString(), family.toStdString())
                        << QString(character).toStdString();
                }
            }
        }
    }
    language.set(QStringLiteral("en"));
    EXPECT_FALSE(QApplication::font().families().contains(cases[1].second));
}

} // namespace
} // namespace bask::test
