#pragma once
// The window's language, changed at run time: every widget hears of it through QEvent::LanguageChange.

#include <QLocale>
#include <QString>
#include <QStringList>
#include <QTranslator>

namespace bask {

/// Installs the translators of one language. Numbers keep the decimal point in every language, as in Bask's
/// files and in the engine's sentences.
class Language {
public:
    Language() = default;
    ~Language();
    Language(const Language&) = delete;
    Language& operator=(const Language&) = delete;

    static QStringList codes();                  ///< "en", "fr", "zh_CN", "zh_TW"
    static QString ownName(const QString& code); ///< "English", "Français"
    /// The code for a locale, "en" where Bask does not speak its language. Chinese goes by the script: zh_HK
    /// and zh_MO get zh_TW, zh_SG gets zh_CN.
    static QString nearest(const QLocale& locale);
    static QString ofDesktop();

    void set(const QString& code);
    QString current() const { return m_code; }

private:
    void remove();
    void chooseFonts();

    QString m_code;
    QTranslator m_bask;
    QTranslator m_qt;
};

} // namespace bask
