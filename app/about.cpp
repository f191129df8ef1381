#include "app/about.h"

#include "app/exact_version.h"

#include <QCoreApplication>
#include <QMessageBox>
#include <QSysInfo>

namespace bask {

void showAbout(QWidget* parent) {
    // Not named tr: lupdate would take the calls for its own and find no string.
    const auto translated = [](const char* text) { return QCoreApplication::translate("About", text); };
    auto* box = new QMessageBox(parent);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setObjectName(QStringLiteral("aboutBox"));
    box->setWindowTitle(translated(QT_TRANSLATE_NOOP("About", "About Bask")));
    box->setIconPixmap(QIcon(QStringLiteral(":/icons/bask.svg")).pixmap(64, 64));
    box->setTextInteractionFlags(Qt::TextBrowserInteraction);
    box->setText(QStringLiteral("<h3>Bask %1</h3>").arg(exactVersion()) +
                 translated(QT_TRANSLATE_NOOP(
                     "About", "Radiation-based thermal servoing: a robot brings objects to their "
                              "temperatures by holding them in front of a heat source.")));
    box->setInformativeText(translated(QT_TRANSLATE_NOOP("About", "Qt %1 on %2. Licence: GPL-3.0-or-later."))
                                .arg(QString::fromLatin1(qVersion()), QSysInfo::prettyProductName()));
    box->addButton(translated(QT_TRANSLATE_NOOP("About", "Close")), QMessageBox::RejectRole);
    box->open();
}

} // namespace bask
