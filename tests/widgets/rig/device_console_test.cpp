// The device console as a person uses it: rows, filters, pause, copy, and sending by hand.

#include "widgets/rig/device_console.h"

#include "engine/base/clock.h"
#include "engine/drivers/traffic_log.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableView>
#include <QTest>

#include <gtest/gtest.h>

namespace bask {
namespace {

struct DeviceConsoleTest : testing::Test {
    std::shared_ptr<TrafficLog> log = std::make_shared<TrafficLog>();
    DeviceConsole console;
    std::vector<SendByHand> sent;
    SteadyClock clock;

    DeviceConsoleTest() {
        QObject::connect(&console, &DeviceConsole::sendWanted, &console,
                         [this](const SendByHand& send) { sent.push_back(send); });
        add(TrafficKind::Opened, "/dev/robot", "");
        add(TrafficKind::Sent, "/dev/robot", "?");
        add(TrafficKind::Received, "/dev/robot", "<Idle|MPos:0,0,0>\r\n");
        add(TrafficKind::Opened, "/dev/module", "");
        add(TrafficKind::Sent, "/dev/module", std::string("\x11\x04\x00\x01", 4));
        console.show();
        apply();
    }
    void add(TrafficKind kind, const char* link, const std::string& bytes) {
        log->add(kind, link, bytes, clock.now_s());
    }
    void apply(bool maySend = true) {
        Snapshot snapshot;
        snapshot.traffic = log;
        console.apply(snapshot, maySend);
    }
    template <class T> T* child(const char* name) { return console.findChild<T*>(QLatin1String(name)); }
    const QAbstractItemModel& rows() { return *child<QTableView>("consoleTable")->model(); }
    QString bytes(int row) { return rows().index(row, 3).data().toString(); }
    void click(const char* name) { QTest::mouseClick(child<QPushButton>(name), Qt::LeftButton); }
};

} // namespace

TEST_F(DeviceConsoleTest, RowsAreShownAndFiltered) {
    ASSERT_EQ(rows().rowCount(), 5);
    EXPECT_EQ(bytes(2), "<Idle|MPos:0,0,0>\\r\\n");
    EXPECT_EQ(bytes(4), "11 04 00 01");
    child<QComboBox>("consoleLink")->setCurrentIndex(2);
    EXPECT_EQ(rows().rowCount(), 2);
    child<QComboBox>("consoleLink")->setCurrentIndex(0);
    child<QComboBox>("consoleDirection")->setCurrentIndex(2);
    ASSERT_EQ(rows().rowCount(), 1);
    EXPECT_EQ(rows().index(0, 1).data(), "/dev/robot");
    child<QComboBox>("consoleDirection")->setCurrentIndex(0);
    child<QLineEdit>("consoleText")->setText("mpos");
    EXPECT_TRUE(QTest::qWaitFor([&] { return rows().rowCount() == 1; }));
    child<QLineEdit>("consoleText")->setText("04 00");
    EXPECT_TRUE(QTest::qWaitFor([&] { return rows().rowCount() == 1 && bytes(0) == "11 04 00 01"; }));
}

// Catches rows that are lost by a pause, and a pause that stops nothing.
TEST_F(DeviceConsoleTest, APauseLosesNothing) {
    click("consolePause");
    add(TrafficKind::Sent, "/dev/robot", "$H\n");
    apply();
    EXPECT_EQ(rows().rowCount(), 5);
    click("consolePause");
    ASSERT_EQ(rows().rowCount(), 6);
    EXPECT_EQ(bytes(5), "$H\\n");
}

// Catches a copy that is cut like its row on the screen.
TEST_F(DeviceConsoleTest, WhatIsShownIsCopiedWhole) {
    add(TrafficKind::Received, "/dev/robot", std::string(1000, 'x'));
    apply();
    EXPECT_LT(bytes(5).size(), 500);
    click("consoleCopy");
    const QString text = QApplication::clipboard()->text();
    EXPECT_EQ(text.count(u'\n'), 6);
    EXPECT_TRUE(text.contains(QString(1000, u'x')));
    child<QTableView>("consoleTable")->selectRow(1);
    click("consoleCopy");
    EXPECT_TRUE(QApplication::clipboard()->text().endsWith("\t/dev/robot\tsent\t?\n"));
}

// Catches bytes that are not those that were typed, and sending where nothing may be sent.
TEST_F(DeviceConsoleTest, ATextIsSentAsTyped) {
    auto* text = child<QLineEdit>("sendText");
    auto* end = child<QComboBox>("sendEnd");
    text->setText("$$");
    EXPECT_FALSE(child<QPushButton>("sendByHand")->isEnabled()) << "to which device?";
    auto* link = child<QComboBox>("sendLink");
    link->setCurrentIndex(link->findText("/dev/robot"));
    apply();
    click("sendByHand");
    ASSERT_EQ(sent.size(), 1U);
    EXPECT_EQ(sent[0].link, "/dev/robot");
    EXPECT_EQ(sent[0].bytes, "$$\n");
    end->setCurrentIndex(4);
    EXPECT_FALSE(child<QPushButton>("sendByHand")->isEnabled()) << "$$ is not hexadecimal";
    text->setText("11 04 00 0A");
    QTest::keyClick(text, Qt::Key_Return);
    ASSERT_EQ(sent.size(), 2U);
    EXPECT_EQ(sent[1].bytes, std::string("\x11\x04\x00\x0a", 4));
    apply(false);
    EXPECT_FALSE(child<QPushButton>("sendByHand")->isEnabled());
    EXPECT_TRUE(child<QLabel>("sendNote")->text().contains("armed or on"));
    apply();
    text->setText(QString(300, u'0'));
    EXPECT_TRUE(child<QPushButton>("sendByHand")->isEnabled()) << "150 bytes";
    text->setText(QString(600, u'0'));
    EXPECT_FALSE(child<QPushButton>("sendByHand")->isEnabled()) << "too many";
    QTest::keyClick(text, Qt::Key_Return);
    EXPECT_EQ(sent.size(), 2U);
    text->setText("00");
    add(TrafficKind::Closed, "/dev/robot", "");
    apply();
    EXPECT_EQ(link->currentText(), "/dev/robot") << "another device is not chosen instead";
    EXPECT_FALSE(child<QPushButton>("sendByHand")->isEnabled());
    add(TrafficKind::Opened, "/dev/robot", "");
    apply();
    EXPECT_TRUE(child<QPushButton>("sendByHand")->isEnabled());
}

} // namespace bask
