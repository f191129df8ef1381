#include "app/settings_store.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <gtest/gtest.h>

namespace bask::test {
namespace {

/// A settings folder of its own, since QSettings remembers files by name.
class SettingsStoreTest : public testing::Test {
protected:
    void SetUp() override { qputenv("BASK_SETTINGS_DIR", m_folder.path().toLocal8Bit()); }
    void TearDown() override { qputenv("BASK_SETTINGS_DIR", m_before); }

private:
    QTemporaryDir m_folder;
    QByteArray m_before = qgetenv("BASK_SETTINGS_DIR");
};

// Catches: choices lost between starts.
TEST_F(SettingsStoreTest, ChoicesAreKept) {
    {
        SettingsStore store;
        store.setTemperatureUnit(TemperatureUnit::Fahrenheit);
        store.setTheme(Theme::Dark);
        store.setTextSize_percent(150);
        store.setLanguage(QStringLiteral("fr"));
        store.setSessionSorting(QStringLiteral("duration descending"));
    }
    SettingsStore store;
    EXPECT_EQ(store.temperatureUnit(), TemperatureUnit::Fahrenheit);
    EXPECT_EQ(store.theme(), Theme::Dark);
    EXPECT_EQ(store.textSize_percent(), 150);
    EXPECT_EQ(store.language(), QStringLiteral("fr"));
    EXPECT_EQ(store.sessionSorting(), QStringLiteral("duration descending"));
}

// Catches: one kind of files that moves the folder of another, and a dialog in a folder that is gone.
TEST_F(SettingsStoreTest, EachKindOfFilesHasAFolder) {
    const QTemporaryDir experiments, exports;
    SettingsStore().setLastFolder(FileFolder::Experiments, experiments.path());
    EXPECT_EQ(SettingsStore().lastFolder(FileFolder::Exports), experiments.path())
        << "before the first export";
    SettingsStore().setLastFolder(FileFolder::Exports, exports.path());
    {
        const QTemporaryDir gone;
        SettingsStore().setLastFolder(FileFolder::Recordings, gone.path());
        EXPECT_EQ(SettingsStore().lastFolder(FileFolder::Recordings), gone.path());
    }
    EXPECT_EQ(SettingsStore().lastFolder(FileFolder::Recordings), experiments.path());
    EXPECT_EQ(SettingsStore().lastFolder(FileFolder::Experiments), experiments.path());
    EXPECT_EQ(SettingsStore().lastFolder(FileFolder::Exports), exports.path());
}

// Catches: a damaged or old settings file that stops the program.
TEST_F(SettingsStoreTest, UnknownValuesReadAsDefaults) {
    {
        QFile file(qEnvironmentVariable("BASK_SETTINGS_DIR") + QStringLiteral("/bask.ini"));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly | QIODevice::Truncate));
        file.write("[General]\nunit=rankine\ntheme=7\ntextSize=100000\nfigureWidth_mm=2\nlanguage="
                   "klingon\nrecent=\x01\x02\n");
    }
    SettingsStore store;
    EXPECT_EQ(store.temperatureUnit(), TemperatureUnit::Celsius);
    EXPECT_EQ(store.theme(), Theme::System);
    EXPECT_EQ(store.textSize_percent(), 100);
    EXPECT_EQ(store.figureLayout(), FigureLayout());
    EXPECT_EQ(store.language(), QStringLiteral("en"));
}

TEST_F(SettingsStoreTest, RecentFilesAreNewestFirstOnceEachAndFew) {
    SettingsStore store;
    for (int i = 0; i < 12; ++i)
        store.addRecentFile(QStringLiteral("/tmp/%1.json").arg(i));
    store.addRecentFile(QStringLiteral("/tmp/7.json"));
    const QStringList files = store.recentFiles();
    EXPECT_EQ(files.size(), SettingsStore::kMaxRecent);
    EXPECT_EQ(files.first(), QStringLiteral("/tmp/7.json"));
    EXPECT_EQ(files.count(QStringLiteral("/tmp/7.json")), 1);
    EXPECT_EQ(files.value(1), QStringLiteral("/tmp/11.json"));
    store.removeRecentFile(QDir::current().relativeFilePath(QStringLiteral("/tmp/7.json")));
    EXPECT_EQ(store.recentFiles().first(), QStringLiteral("/tmp/11.json")) << "by another spelling";
    store.clearRecentFiles();
    EXPECT_TRUE(SettingsStore().recentFiles().isEmpty());
}

} // namespace
} // namespace bask::test
