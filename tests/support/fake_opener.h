#pragma once
// An xdg-open of a test's own, which tells what it was asked to open.

#include <QByteArray>
#include <QFile>
#include <QString>
#include <QTemporaryDir>
#include <QUrl>

namespace bask::test {

/// The first one that is found while this lives.
class FakeOpener {
public:
    /// `then`: what it does after it was asked, in the language of `shell`.
    explicit FakeOpener(const QByteArray& then = {}, const QByteArray& shell = "/bin/sh") {
        QFile script(m_folder.filePath(QStringLiteral("xdg-open")));
        const QByteArray asked = m_folder.filePath(QStringLiteral("asked")).toUtf8();
        if (script.open(QIODevice::WriteOnly))
            script.write("#!" + shell + "\nprintf %s \"$1\" > '" + asked + ".part' && mv '" + asked +
                         ".part' '" + asked + "'\n" + then + '\n');
        script.close();
        script.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
        qputenv("PATH", m_folder.path().toUtf8() + ':' + m_path);
    }
    ~FakeOpener() { qputenv("PATH", m_path); }
    FakeOpener(const FakeOpener&) = delete;
    FakeOpener& operator=(const FakeOpener&) = delete;

    QString pathOf(const QString& name) const { return m_folder.filePath(name); }
    /// Empty until it was asked.
    QUrl asked() const {
        QFile file(m_folder.filePath(QStringLiteral("asked")));
        return file.open(QIODevice::ReadOnly) ? QUrl::fromEncoded(file.readAll(), QUrl::StrictMode) : QUrl();
    }

private:
    QTemporaryDir m_folder;
    QByteArray m_path = qgetenv("PATH");
};

} // namespace bask::test
