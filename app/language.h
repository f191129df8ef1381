#pragma once
// The window's language, changed at run time: every widget hears of it through QEvent::LanguageChange.

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

    static QStringList codes();                  ///< "en", "fr"
    static QString ownName(const QString& code); ///< "English", "Français"
    static QString ofDesktop();                  ///< the desktop's, if Bask speaks it, else "en"

    void set(const QString& code);
    QString current() const { return m_code; }

private:
    void remove();

    QString m_code;
    QTranslator m_bask;
    QTranslator m_qt;
};

} // namespace bask
