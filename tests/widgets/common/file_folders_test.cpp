#include "widgets/common/file_folders.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QLineEdit>
#include <QTemporaryDir>
#include <QTimer>

#include <functional>
#include <map>

namespace bask {
namespace {

class Kept : public FileFolders {
public:
    QString lastFolder(FileFolder kind) const override { return folders.at(kind); }
    void setLastFolder(FileFolder kind, const QString& folder) override { folders[kind] = folder; }
    std::map<FileFolder, QString> folders;
};

/// Answers the next dialog.
void answer(const std::function<void(QFileDialog&)>& by) {
    auto* look = new QTimer;
    look->setInterval(10);
    QObject::connect(look, &QTimer::timeout, [look, by] {
        if (auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget())) {
            look->deleteLater();
            by(*dialog);
        }
    });
    look->start();
}

/// As a person does: selectFile() does not while the field has the keyboard.
void type(QFileDialog& dialog, const QString& text) {
    dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->setText(text);
}

// Catches a dialog that begins elsewhere, forgets where it was answered, or takes another kind's folder.
TEST(FileFolders, DialogsBeginWhereTheirKindWasLast) {
    const QTemporaryDir first, second;
    QFile file(QDir(second.path()).filePath("outline.csv"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.close();
    Kept kept;
    kept.folders = {{FileFolder::Imports, first.path()}, {FileFolder::Exports, first.path()}};
    setFileFolders(&kept);
    QString begun;
    answer([&](QFileDialog& dialog) {
        begun = dialog.directory().path();
        dialog.setDirectory(second.path());
        type(dialog, file.fileName());
        dialog.QDialog::accept();
    });
    EXPECT_EQ(askFileToOpen(nullptr, "Open", "*.csv", FileFolder::Imports), file.fileName());
    EXPECT_EQ(begun, first.path());
    EXPECT_EQ(kept.folders.at(FileFolder::Imports), second.path());
    EXPECT_EQ(kept.folders.at(FileFolder::Exports), first.path());

    answer([&](QFileDialog& dialog) {
        begun = dialog.directory().path();
        dialog.reject();
    });
    EXPECT_EQ(askFileToSave(nullptr, "Save", "markers.pdf", "*.pdf", FileFolder::Imports), QString());
    EXPECT_EQ(begun, second.path());
    EXPECT_EQ(kept.folders.at(FileFolder::Imports), second.path()) << "nothing was chosen";

    answer([&](QFileDialog& dialog) {
        begun = dialog.directory().path();
        dialog.reject();
    });
    EXPECT_EQ(askFileToOpen(nullptr, "Open", "*.csv", FileFolder::Imports, first.path()), QString());
    EXPECT_EQ(begun, first.path()) << "where it was told to";

    answer([&](QFileDialog& dialog) {
        begun = dialog.directory().path();
        dialog.setDirectory(second.path());
        type(dialog, {});
        dialog.QDialog::accept();
    });
    EXPECT_EQ(askFolder(nullptr, "Folder", FileFolder::Exports), second.path());
    EXPECT_EQ(begun, first.path());
    EXPECT_EQ(kept.folders.at(FileFolder::Exports), second.path()) << "the folder itself";

    answer([&](QFileDialog& dialog) {
        begun = dialog.directory().path();
        dialog.reject();
    });
    EXPECT_EQ(askFolder(nullptr, "Folder", FileFolder::Exports, first.path()), QString());
    EXPECT_EQ(begun, first.path());
    setFileFolders(nullptr);
}

// Catches recordings that are looked for among the experiments.
TEST(FileFolders, ASessionIsKeptWithTheRecordings) {
    const QTemporaryDir folder;
    Kept kept;
    setFileFolders(&kept);
    for (const char* name : {"run.bask", "RUN.BASK"})
        EXPECT_EQ(remembered(folder.filePath(name), FileFolder::Experiments), folder.filePath(name));
    EXPECT_EQ(kept.folders.at(FileFolder::Recordings), folder.path());
    EXPECT_FALSE(kept.folders.contains(FileFolder::Experiments));
    remembered({}, FileFolder::Experiments);
    EXPECT_FALSE(kept.folders.contains(FileFolder::Experiments)) << "cancelled";
    setFileFolders(nullptr);
}

} // namespace
} // namespace bask
