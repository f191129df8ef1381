#include "widgets/common/desktop_opener.h"

#include <QDesktopServices>
#include <QProcess>
#include <QStandardPaths>
#include <QString>
#include <QStringList>
#include <QUrl>

namespace bask {

bool openOnDesktop(const QUrl& address) {
    // QDesktopServices may ask services of the desktop itself and wait: the window would hang with its STOP.
    const QString opener = QStandardPaths::findExecutable(QStringLiteral("xdg-open"));
    if (opener.isEmpty())
        return QDesktopServices::openUrl(address);
    return QProcess::startDetached(opener, {address.toString(QUrl::FullyEncoded)});
}

} // namespace bask
