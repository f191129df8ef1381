#include "app/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>

namespace bask {

Language::~Language() {
    remove();
}

QStringList Language::codes() {
    return {QStringLiteral("en"), QStringLiteral("fr")};
}

QString Language::ownName(const QString& code) {
    return code == QLatin1String("fr") ? QStringLiteral("Français") : QStringLiteral("English");
}

QString Language::ofDesktop() {
    const QString code = QLocale::system().name().left(2);
    return codes().contains(code) ? code : QStringLiteral("en");
}

void Language::remove() {
    QCoreApplication::removeTranslator(&m_bask);
    QCoreApplication::removeTranslator(&m_qt);
}

void Language::set(const QString& code) {
    if (code == m_code)
        return;
    remove();
    m_code = code;
    // Qt's own words (file dialog, standard buttons), where the distribution has installed them.
    const QString qtName = QStringLiteral("qtbase_") + code;
    if (m_qt.load(qtName, QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        QCoreApplication::installTranslator(&m_qt);
    // English has a file of its own for plurals.
    if (m_bask.load(QStringLiteral(":/i18n/bask_%1.qm").arg(code)))
        QCoreApplication::installTranslator(&m_bask);
}

} // namespace bask
