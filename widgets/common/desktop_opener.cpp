#include "widgets/common/desktop_opener.h"

#include <QProcess>
#include <QStandardPaths>
#include <QString>
#include <QStringList>
#include <QUrl>

namespace bask {

bool openOnDesktop(const QUrl& address) {
    // QDesktopServices belongs to the GUI thread, and may ask services of the desktop itself and wait.
    return openBy(QStringLiteral("xdg-open"), address);
}

bool openBy(const QString& program, const QUrl& address) {
    const QString file = QStandardPaths::findExecutable(program);
    return !file.isEmpty() && QProcess::startDetached(file, {address.toString(QUrl::FullyEncoded)});
}

} // namespace bask
