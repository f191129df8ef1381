#pragma once
// An xdg-open of a test's own, which tells what it was asked to open.

#include "widgets/common/desktop_opener.h"

#include <QByteArray>
#include <QFile>
#include <QString>
#include <QTemporaryDir>
#include <QUrl>

#include <functional>

namespace bask::test {

/// Given to what opens: no variable of the environment, which other threads may read.
class FakeOpener {
public:
    /// `then`: what it does after it was asked, in the language of `shell`.
    explicit FakeOpener(const QByteArray& then = {}, const QByteArray& shell = "/bin/sh") {
        QFile script(program());
        const QByteArray asked = m_folder.filePath(QStringLiteral("asked")).toUtf8();
        if (script.open(QIODevice::WriteOnly))
            script.write("#!" + shell + "\nprintf %s \"$1\" > '" + asked + ".part' && mv '" + asked +
                         ".part' '" + asked + "'\n" + then + '\n');
        script.close();
        script.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    }

    QString program() const { return pathOf(QStringLiteral("xdg-open")); }
    /// As openOnDesktop.
    std::function<bool(const QUrl&)> opener() const {
        return [program = program()](const QUrl& address) { return openBy(program, address); };
    }
    QString pathOf(const QString& name) const { return m_folder.filePath(name); }
    /// Empty until it was asked.
    QUrl asked() const {
        QFile file(m_folder.filePath(QStringLiteral("asked")));
        return file.open(QIODevice::ReadOnly) ? QUrl::fromEncoded(file.readAll(), QUrl::StrictMode) : QUrl();
    }

private:
    QTemporaryDir m_folder;
};

} // namespace bask::test
