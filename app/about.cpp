#include "app/about.h"

#include <QCoreApplication>
#include <QMessageBox>
#include <QSysInfo>

namespace bask {

QString exactVersion() {
    const QString revision = QStringLiteral(BASK_REVISION);
    return revision.isEmpty() ? QStringLiteral(BASK_VERSION)
                              : QStringLiteral("%1 (%2)").arg(QStringLiteral(BASK_VERSION), revision);
}

void showAbout(QWidget* parent) {
    const auto tr = [](const char* text) { return QCoreApplication::translate("About", text); };
    auto* box = new QMessageBox(parent);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setObjectName(QStringLiteral("aboutBox"));
    box->setWindowTitle(tr(QT_TRANSLATE_NOOP("About", "About Bask")));
    box->setIconPixmap(QIcon(QStringLiteral(":/icons/bask.svg")).pixmap(64, 64));
    box->setTextInteractionFlags(Qt::TextBrowserInteraction);
    box->setText(
        QStringLiteral("<h3>Bask %1</h3>").arg(exactVersion()) +
        tr(QT_TRANSLATE_NOOP("About", "Radiation-based thermal servoing: a robot brings objects to their "
                                      "temperatures by holding them in front of a heat source.")));
    box->setInformativeText(tr(QT_TRANSLATE_NOOP("About", "Qt %1 on %2. Licence: GPL-3.0-or-later."))
                                .arg(QString::fromLatin1(qVersion()), QSysInfo::prettyProductName()));
    box->addButton(tr(QT_TRANSLATE_NOOP("About", "Close")), QMessageBox::RejectRole);
    box->open();
}

} // namespace bask
