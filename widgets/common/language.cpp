#include "widgets/common/language.h"

#include <QApplication>
#include <QFont>
#include <QLibraryInfo>
#include <QLocale>
#include <QWidget>

namespace bask {
namespace {

/// Kept for good: another thread may be writing with the one before.
const QLocale& notationOf(const QString& code) {
    static const QLocale point = QLocale::c(), comma = [] {
        QLocale french(QLocale::French, QLocale::France);
        french.setNumberOptions(QLocale::OmitGroupSeparator);
        return french;
    }();
    return code == QLatin1String("fr") ? comma : point;
}

// Left to itself, fontconfig draws Han characters in the forms of the desktop's language, in Japanese ones if
// that is not Chinese.
const QStringList kHanFamilies = {QStringLiteral("Noto Sans CJK SC"), QStringLiteral("Noto Sans CJK TC")};

} // namespace

Language::~Language() {
    remove();
    QLocale::setDefault(notationOf({})); // the window's fields are being deleted
}

QStringList Language::codes() {
    return {QStringLiteral("en"), QStringLiteral("fr"), QStringLiteral("zh_CN"), QStringLiteral("zh_TW")};
}

QString Language::ownName(const QString& code) {
    return code == QLatin1String("fr")      ? QStringLiteral("Français")
           : code == QLatin1String("zh_CN") ? QStringLiteral("简体中文")
           : code == QLatin1String("zh_TW") ? QStringLiteral("繁體中文")
                                            : QStringLiteral("English");
}

QString Language::nearest(const QLocale& locale) {
    if (locale.language() == QLocale::Chinese)
        return locale.script() == QLocale::TraditionalHanScript ? QStringLiteral("zh_TW")
                                                                : QStringLiteral("zh_CN");
    const QString code = locale.name().left(2);
    return codes().contains(code) ? code : QStringLiteral("en");
}

QString Language::ofDesktop() {
    return nearest(QLocale::system());
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
    setNotation();
    // Qt's own words (file dialog, standard buttons), where the distribution has installed them.
    const QString qtName = QStringLiteral("qtbase_") + code;
    if (m_qt.load(qtName, QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        QCoreApplication::installTranslator(&m_qt);
    // English has a file of its own for plurals.
    if (m_bask.load(QStringLiteral(":/i18n/bask_%1.qm").arg(code)))
        QCoreApplication::installTranslator(&m_bask);
    chooseFonts();
}

void Language::setNotation() {
    QLocale::setDefault(notationOf(m_code));
    if (qobject_cast<QApplication*>(QCoreApplication::instance()) == nullptr) // there are no fields
        return;
    for (QWidget* widget : QApplication::allWidgets()) // plots have one of their own, others their window's
        if (widget->isWindow() || widget->testAttribute(Qt::WA_SetLocale))
            widget->unsetLocale();
}

void Language::chooseFonts() {
    if (qobject_cast<QApplication*>(QCoreApplication::instance()) == nullptr) // there is nothing to draw with
        return;
    QFont font = QApplication::font();
    QStringList families = font.families();
    families.removeIf([](const QString& family) { return kHanFamilies.contains(family); });
    // In front: Qt keeps what comes behind the first family from one language to the next.
    if (m_code.startsWith(QLatin1String("zh")))
        families.prepend(m_code == QLatin1String("zh_TW") ? kHanFamilies[1] : kHanFamilies[0]);
    if (families == font.families())
        return;
    font.setFamilies(families);
    QApplication::setFont(font);
}

} // namespace bask
