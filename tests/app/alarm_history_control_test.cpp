// The alarms of the listed runs with the files behind them.

#include "app/alarm_history_control.h"
#include "app/examples.h"
#include "app/resources.h"
#include "engine/base/message_code.h"
#include "engine/experiment/unrecorded_alarms.h"
#include "engine/recording/session_file.h"
#include "tests/support/wait_for.h"
#include "widgets/review/session_list.h"

#include <QDialog>
#include <QFile>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>

#include <gtest/gtest.h>

namespace bask::test {
namespace {

class AlarmHistoryControlTest : public testing::Test {
protected:
    void SetUp() override {
        initResources();
        list.show();
        QObject::connect(&control, &AlarmHistoryControl::runChosen,
                         [this](const QString& path, double time_s) {
                             chosen << path;
                             chosen_s = time_s;
                         });
    }

    /// A short run with an alarm.
    QString record(const QString& name) {
        QString path = folder.filePath(name);
        auto writer = SessionWriter::create(path.toStdString(), readExample("three-objects").value(), true,
                                            0.5, SessionWriter::Earlier::Replaced);
        EXPECT_TRUE(writer);
        const TraceEvent hot{1.0, {MessageCode::SafetyObjectHot, {"hand", "91", "90"}}};
        EXPECT_TRUE((*writer)->add(hot));
        EXPECT_TRUE((*writer)->finish("fault"));
        return path;
    }
    void listAll() {
        const std::vector<std::string> paths = sessionFiles(folder.path().toStdString());
        std::vector<SessionHeader> headers;
        headers.reserve(paths.size());
        for (const std::string& path : paths)
            headers.push_back(readSessionHeader(path));
        list.setSessions(headers);
    }
    QDialog* openDialog() {
        QTest::mouseClick(list.findChild<QPushButton*>("sessionAlarms"), Qt::LeftButton);
        return dialog();
    }
    void close() {
        QTest::mouseClick(dialog()->findChild<QPushButton*>("alarmHistoryClose"), Qt::LeftButton);
    }
    QDialog* dialog() { return list.findChild<QDialog*>("alarmHistoryDialog"); }
    QTreeWidget* tree(const char* name) { return dialog()->findChild<QTreeWidget*>(QLatin1String(name)); }
    bool waitForAlarms(const QString& runs) {
        return waitFor([&] {
            const QTreeWidget* alarms = tree("alarmHistoryAlarms");
            return alarms->topLevelItemCount() == 1 && alarms->topLevelItem(0)->text(2) == runs;
        });
    }

    QTemporaryDir folder;
    SessionList list;
    const std::string unrecorded = folder.filePath("alarms-without-run.jsonl").toStdString();
    AlarmHistoryControl control{list, unrecorded};
    QStringList chosen;
    double chosen_s = 0.0;
};

// Catches: runs that the list does not show, one that is not opened, a second dialog, numbers that stay when
// another search is on.
TEST_F(AlarmHistoryControlTest, TheListedRunsAreRead) {
    record("morning.bask");
    const QString evening = record("evening.bask");
    listAll();
    ASSERT_NE(openDialog(), nullptr);
    ASSERT_TRUE(waitForAlarms("2"));
    list.findChild<QLineEdit*>("sessionSearch")->setText("evening");
    openDialog();
    ASSERT_TRUE(waitForAlarms("1"));
    EXPECT_EQ(list.findChildren<QDialog*>("alarmHistoryDialog").size(), 1);
    QTest::mouseClick(dialog()->findChild<QPushButton*>("alarmHistoryOpen"), Qt::LeftButton);
    EXPECT_EQ(chosen, QStringList{evening});
    EXPECT_EQ(chosen_s, 1.0) << "the moment of the alarm";
}

// Catches: a dialog that is opened again while the one before is on its way out.
TEST_F(AlarmHistoryControlTest, ItIsOpenedAgainAfterItWasClosed) {
    record("a.bask");
    listAll();
    QPointer<QDialog> first = openDialog();
    ASSERT_NE(first, nullptr);
    close();
    openDialog();
    ASSERT_TRUE(waitFor([&] { return first.isNull(); }));
    ASSERT_NE(dialog(), nullptr);
    EXPECT_TRUE(dialog()->isVisible());
    EXPECT_TRUE(waitForAlarms("1"));
}

// Catches: a dialog, or a window, that is closed while runs are read and is used by what was read.
TEST_F(AlarmHistoryControlTest, ItIsClosedWhileRunsAreRead) {
    const QString first = record("run0.bask");
    std::vector<SessionHeader> headers(20, readSessionHeader(first.toStdString()));
    for (std::size_t k = 1; k < headers.size(); ++k) {
        const QString copy = folder.filePath(QStringLiteral("run%1.bask").arg(k));
        ASSERT_TRUE(QFile::copy(first, copy));
        headers[k].path = copy.toStdString();
    }
    list.setSessions(headers);
    {
        AlarmHistoryControl brief(list);
        brief.open();
    }
    QCoreApplication::processEvents();
    openDialog();
    close();
    EXPECT_TRUE(waitFor([&] { return dialog() == nullptr; }));
    openDialog();
    EXPECT_TRUE(waitForAlarms("20"));
}

// Catches: a run that cannot be read, which only the dialog tells of.
TEST_F(AlarmHistoryControlTest, ARunThatCannotBeReadIsToldToTheList) {
    const QString a = record("a.bask"), b = record("b.bask");
    listAll();
    ASSERT_TRUE(QFile::resize(b, QFile(b).size() / 2));
    std::vector<Error> errors;
    QObject::connect(&control, &AlarmHistoryControl::readFailed,
                     [&](const Error& error) { errors.push_back(error); });
    openDialog();
    ASSERT_TRUE(waitForAlarms("1"));
    ASSERT_EQ(errors.size(), 1U);
    EXPECT_EQ(errors.front().code(), MessageCode::SessionDamaged);
    EXPECT_EQ(errors.front().where, b.toStdString());
}

// Catches: runs in another order than their dates are shown in: time zones.
TEST_F(AlarmHistoryControlTest, TheNewestRunIsTheOneWithTheLastDate) {
    std::vector<SessionHeader> headers(2, readSessionHeader(record("early.bask").toStdString()));
    headers[0].created = "2026-03-14T10:00:00+05:00";
    headers[1] = readSessionHeader(record("late.bask").toStdString());
    headers[1].created = "2026-03-14T09:00:00Z";
    list.setSessions(headers);
    openDialog();
    ASSERT_TRUE(waitForAlarms("2"));
    EXPECT_TRUE(tree("alarmHistoryAlarms")->topLevelItem(0)->text(6).startsWith("late, "));
}

// Catches: alarms that came while nothing was recorded which the dialog does not read, or reads once alone.
TEST_F(AlarmHistoryControlTest, AlarmsWithoutARunAreRead) {
    record("a.bask");
    listAll();
    const Message unasked{MessageCode::SafetySourceHeatsUnasked, {"11", "20", "10"}};
    const auto raise = [&](double utc_s) {
        return appendUnrecordedAlarms(
            {{AlarmChange::Raised, utc_s, utc_s, "SafetySourceHeatsUnasked", unasked, 1, false, {}}},
            unrecorded);
    };
    const auto waitForTimes = [&](const QString& times) {
        return waitFor([&] {
            const QTreeWidget* alarms = tree("alarmHistoryAlarms");
            return alarms->topLevelItemCount() == 2 && alarms->topLevelItem(0)->text(2) == "0" &&
                   alarms->topLevelItem(0)->text(3) == times;
        });
    };
    ASSERT_TRUE(raise(4e9));
    openDialog();
    EXPECT_TRUE(waitForTimes("1"));
    ASSERT_TRUE(raise(4.1e9));
    openDialog();
    EXPECT_TRUE(waitForTimes("2"));
}

} // namespace
} // namespace bask::test
