#pragma once
// The window's language, which can change at run time: every widget is told by QEvent::LanguageChange.

#include <QLocale>
#include <QString>
#include <QStringList>
#include <QTranslator>

namespace bask {

/// Installs the translators of one language. Numbers have the decimal point in every language, as in Bask's
/// files and in the engine's sentences.
class Language {
public:
    Language() = default;
    ~Language();
    Language(const Language&) = delete;
    Language& operator=(const Language&) = delete;

    static QStringList codes();                  ///< "en", "fr", "zh_CN", "zh_TW"
    static QString ownName(const QString& code); ///< "English", "Français"
    /// Returns the code for a locale, "en" if there is no translation. Chinese is selected by script: zh_HK
    /// and zh_MO give zh_TW, zh_SG gives zh_CN.
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
