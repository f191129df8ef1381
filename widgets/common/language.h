#pragma once
// The window's language, which can change at run time: every widget is told by QEvent::LanguageChange.

#include <QLocale>
#include <QString>
#include <QStringList>
#include <QTranslator>

namespace bask {

/// Installs the translators of one language, and makes its notation of numbers that of QLocale() and of the
/// fields: French has a decimal comma, the others a point, and none groups digits. Files never go by it.
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
    void setNotation();
    void chooseFonts();

    QString m_code;
    QTranslator m_bask;
    QTranslator m_qt;
};

} // namespace bask
