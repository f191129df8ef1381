// A device set up as a person would: driver, port, its settings, a test read.

#include "widgets/rig/device_dialog.h"

#include "engine/base/message_code.h"
#include "tests/widgets/rig/rig_bench.h"
#include "widgets/common/message_bar.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>

#include <gtest/gtest.h>

#include <memory>

namespace bask {
namespace {

struct DeviceDialogTest : testing::Test {
    std::unique_ptr<DeviceDialog> dialog;
    std::vector<RigSpec> tried, used;
    std::vector<ModbusSearchSpec> searches;
    int searchesEnded = 0;

    void open(DeviceRole role, const RigSpec& rig = {}) {
        dialog = std::make_unique<DeviceDialog>(role, rig, std::vector<std::string>{"left", "right"});
        QObject::connect(dialog.get(), &DeviceDialog::tryWanted, dialog.get(),
                         [this](const RigSpec& device) { tried.push_back(device); });
        QObject::connect(dialog.get(), &DeviceDialog::useWanted, dialog.get(),
                         [this](const RigSpec& device) { used.push_back(device); });
        QObject::connect(dialog.get(), &DeviceDialog::searchWanted, dialog.get(),
                         [this](const ModbusSearchSpec& spec) { searches.push_back(spec); });
        QObject::connect(dialog.get(), &DeviceDialog::searchEnded, dialog.get(), [this] { ++searchesEnded; });
        dialog->show();
    }
    template <class T> T* child(const char* name) {
        T* found = dialog->findChild<T*>(QLatin1String(name));
        EXPECT_NE(found, nullptr) << name;
        return found;
    }
    void click(const char* name) { QTest::mouseClick(child<QAbstractButton>(name), Qt::LeftButton); }
    void choose(const char* name, int index) {
        auto* box = child<QComboBox>(name);
        box->setFocus();
        QTest::keyClick(box, Qt::Key_Home);
        for (int i = 0; i < index; ++i)
            QTest::keyClick(box, Qt::Key_Down);
        ASSERT_EQ(box->currentIndex(), index);
        emit box->activated(index);
    }
    void typePort(const QString& path) { child<QComboBox>("port")->setEditText(path); }
};

} // namespace

// Catches a device that changes by being looked at: every field must come back as it went in.
TEST_F(DeviceDialogTest, WhatIsSetUpComesBackUnchanged) {
    RigSpec rig = test::realRig();
    rig.robot->mustHome = true;
    rig.robot->serial = {250000, 8, 'O', 2};
    rig.robot->axes = {{'X', kY, true, 0.123456789}, {'Y', kX, false, -0.05}, {'A', kThetaZ, true, 0.3}};
    rig.thermometer->driver = "modbus";
    rig.thermometer->unit = 17;
    rig.thermometer->profile = shippedProfiles().front();
    rig.thermometer->channels = {1, 0};
    rig.source->isProbeUsed = true;
    rig.source->watchdog_s = 45.0;
    rig.camera = "/dev/video3";
    ThermalCameraSpec& camera = rig.thermalCamera.emplace();
    camera.device = "/dev/video2";
    camera.profile = findThermalProfile("tc001").value();
    camera.profile.name = "ours";
    camera.calibration.lens.emplace().fx = 211.123456;
    camera.calibration.pose = Vector6d{{0.123456789, -0.05, 1.1, 3.0, 0.1, -0.2}};
    camera.calibration.poseUncertainty_m = 0.0007;
    for (const DeviceRole role : kDeviceRoles) {
        open(role, rig);
        EXPECT_EQ(dialog->device(), withDevice({}, role, rig)) << roleName(role);
    }
}

// Catches a camera of another kind with the old one's lens, and a pose that is taken though it is not known.
TEST_F(DeviceDialogTest, AThermalCameraIsItsKindItsDeviceAndItsPose) {
    RigSpec rig;
    ThermalCameraSpec& camera = rig.thermalCamera.emplace();
    camera.device = "0";
    camera.profile = findThermalProfile("lepton-3.5").value();
    camera.calibration.lens.emplace().fx = 150.0;
    camera.calibration.pose = Vector6d{{0.0, 0.0, 1.1, 3.0, 0.0, 0.0}};
    camera.calibration.poseUncertainty_m = 0.0007;
    open(DeviceRole::ThermalCamera, rig);
    child<QDoubleSpinBox>("thermalPose.z")->setValue(1000.0);
    EXPECT_FALSE(dialog->device().thermalCamera->calibration.poseUncertainty_m) << "it is typed now";
    camera.calibration.pose.reset();
    camera.calibration.poseUncertainty_m.reset();
    open(DeviceRole::ThermalCamera, rig);
    EXPECT_FALSE(dialog->device().thermalCamera->calibration.pose);
    EXPECT_FALSE(child<QDoubleSpinBox>("thermalPose.z")->isEnabled());
    child<QCheckBox>("poseKnown")->click();
    child<QDoubleSpinBox>("thermalPose.z")->setValue(900.0);
    EXPECT_NEAR((*dialog->device().thermalCamera->calibration.pose)[kZ], 0.9, 1e-9);
    EXPECT_TRUE(dialog->device().thermalCamera->calibration.lens);
    auto* kinds = child<QComboBox>("thermalProfile");
    EXPECT_EQ(kinds->count(), static_cast<int>(shippedThermalProfiles().size()));
    kinds->setCurrentIndex(kinds->currentIndex() == 0 ? 1 : 0);
    EXPECT_NE(dialog->device().thermalCamera->profile.name, "lepton-3.5");
    EXPECT_FALSE(dialog->device().thermalCamera->calibration.lens);
    click("tryDevice");
    ASSERT_EQ(tried.size(), 1U);
    EXPECT_TRUE(tried[0].thermalCamera);
    EXPECT_FALSE(tried[0].robot);
    TriedDevice answer;
    answer.state.role = DeviceRole::ThermalCamera;
    answer.state.status.link = LinkState::Live;
    answer.temperatures_K = {295.15, 353.15};
    dialog->setTried(answer);
    EXPECT_TRUE(child<QLabel>("tryResult")->text().contains("22.0"));
    EXPECT_TRUE(child<QLabel>("tryResult")->text().contains("80.0"));
}

// Catches line settings that are not what a driver's devices leave the factory with.
TEST_F(DeviceDialogTest, ADriverBringsItsUsualLine) {
    open(DeviceRole::HeatSource);
    EXPECT_FALSE(child<QComboBox>("port")->isVisible()); // by hand
    choose("driver", 1);
    EXPECT_EQ(dialog->device().source->driver, "namur");
    EXPECT_EQ(dialog->device().source->serial, (SerialSettings{9600, 7, 'E', 1}));
    EXPECT_TRUE(child<QCheckBox>("probe")->isVisible());
    EXPECT_FALSE(child<QDoubleSpinBox>("unit")->isVisible());
    choose("driver", 2);
    EXPECT_EQ(dialog->device().source->serial, (SerialSettings{19200, 8, 'E', 1}));
    EXPECT_TRUE(child<QDoubleSpinBox>("unit")->isVisible());
    open(DeviceRole::Robot);
    EXPECT_EQ(dialog->device().robot->serial, (SerialSettings{115200, 8, 'N', 1}));
    choose("driver", 1); // a Dobot has R for A, and no line
    EXPECT_EQ(dialog->device().robot->axes.back().letter, 'R');
    EXPECT_EQ(dialog->device().robot->axes.back().coordinate, kThetaZ);
    EXPECT_FALSE(child<QComboBox>("baud")->isVisible());
}

// Catches profiles of thermometers offered as controllers, and a controller that cannot be set up at all.
TEST_F(DeviceDialogTest, ProfilesAreThoseOfTheRole) {
    open(DeviceRole::Thermometer);
    const int thermometers = child<QComboBox>("profile")->count();
    for (int i = 0; i < thermometers; ++i) {
        child<QComboBox>("profile")->setCurrentIndex(i);
        EXPECT_TRUE(dialog->device().thermometer->profile.channel) << i;
    }
    open(DeviceRole::HeatSource);
    choose("driver", 2);
    const int controllers = child<QComboBox>("profile")->count();
    for (int i = 0; i < controllers; ++i) {
        child<QComboBox>("profile")->setCurrentIndex(i);
        EXPECT_TRUE(dialog->device().source->profile.setPoint) << i;
        const bool isWatched = dialog->device().source->profile.watchdog.has_value();
        EXPECT_EQ(child<QDoubleSpinBox>("watchdog")->isVisible(), isWatched);
        EXPECT_NE(child<QCheckBox>("unattended")->isVisible(), isWatched);
        child<QCheckBox>("unattended")->setChecked(true);
        EXPECT_NE(dialog->device().source->mayHeatUnattended, isWatched);
    }
    EXPECT_GT(thermometers, 0);
    EXPECT_GT(controllers, 0);
}

// Catches a profile file that is taken though it is damaged, or refused without a word.
TEST_F(DeviceDialogTest, AProfileComesFromAFile) {
    QTemporaryDir folder;
    const QString good = folder.filePath("good.json"), bad = folder.filePath("bad.json");
    ModbusProfile profile;
    for (const ModbusProfile& shipped : shippedProfiles())
        if (shipped.channel)
            profile = shipped;
    profile.name = "of-our-lab";
    profile.title = "Of our lab";
    QFile file(good);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(QByteArray::fromStdString(modbusProfileToJson(profile)));
    file.close();
    QFile(good).copy(bad);
    QFile broken(bad);
    ASSERT_TRUE(broken.resize(broken.size() / 2));

    open(DeviceRole::Thermometer);
    dialog->useProfileFile(bad);
    EXPECT_TRUE(child<MessageBar>("deviceMessage")->sentence().contains("bad.json"));
    EXPECT_NE(dialog->device().thermometer->profile, profile);
    dialog->useProfileFile(folder.filePath("none.json"));
    EXPECT_TRUE(child<MessageBar>("deviceMessage")->sentence().contains("none.json"));
    dialog->useProfileFile(good);
    EXPECT_EQ(child<MessageBar>("deviceMessage")->sentence(), "");
    EXPECT_EQ(dialog->device().thermometer->profile, profile);
    EXPECT_EQ(child<QComboBox>("profile")->currentText(), "Of our lab");
}

// Catches a list of ports that overwrites a path that was typed, or that cannot be typed into.
TEST_F(DeviceDialogTest, PortsAreListedAndTyped) {
    open(DeviceRole::Robot);
    dialog->setPorts({{"/dev/serial/by-id/usb-one", "FTDI (ttyUSB0)"}, {"/dev/ttyS0", "8250"}});
    EXPECT_EQ(dialog->device().robot->port, "/dev/serial/by-id/usb-one");
    EXPECT_EQ(child<QLabel>("portDescription")->text(), "FTDI (ttyUSB0)");
    typePort(" /tmp/pty-robot ");
    EXPECT_EQ(dialog->device().robot->port, "/tmp/pty-robot");
    EXPECT_FALSE(child<QLabel>("portDescription")->isVisible());
    dialog->setPorts({{"/dev/ttyS0", "8250"}});
    EXPECT_EQ(dialog->device().robot->port, "/tmp/pty-robot");
}

// Catches a test read that asks another device than the one set up, or does not show what came.
TEST_F(DeviceDialogTest, ATestReadShowsWhatTheDeviceSays) {
    open(DeviceRole::Thermometer);
    choose("driver", 1);
    typePort("/dev/ttyTEMP");
    click("tryDevice");
    ASSERT_EQ(tried.size(), 1U);
    EXPECT_EQ(tried.back(), dialog->device());
    EXPECT_FALSE(tried.back().robot || tried.back().source);

    TriedDevice answer;
    answer.state.status.link = LinkState::Live;
    answer.state.status.identity = "MAX31865";
    answer.temperatures_K = {296.55, std::numeric_limits<double>::quiet_NaN()};
    dialog->setTried(answer);
    const auto text = [this] { return child<QLabel>("tryResult")->text(); };
    EXPECT_TRUE(text().contains("Live: MAX31865")) << text().toStdString();
    EXPECT_TRUE(text().contains(QStringLiteral("0: 23.4\u00a0\u00b0C, 1: \u2014"))) << text().toStdString();

    answer.state.status = {};
    answer.state.status.link = LinkState::Lost;
    answer.state.status.problem = {MessageCode::DeviceSilent, {"/dev/ttyTEMP", "2"}};
    dialog->setTried(answer);
    EXPECT_TRUE(text().contains("has not answered for 2 s")) << text().toStdString();

    open(DeviceRole::Robot);
    click("tryDevice");
    answer = {};
    answer.coordinates = Vector6d::Zero();
    (*answer.coordinates)[kZ] = 0.1234;
    dialog->setTried(answer);
    EXPECT_TRUE(text().contains(QStringLiteral("z 123.40\u00a0mm"))) << text().toStdString();
}

// Catches an object that has no channel to choose, and channels beyond the module's last.
TEST_F(DeviceDialogTest, EachObjectHasItsChannel) {
    open(DeviceRole::Thermometer);
    choose("driver", 1);
    child<QDoubleSpinBox>("channel.0")->setValue(5);
    child<QDoubleSpinBox>("channel.1")->setValue(2);
    typePort("/dev/ttyTEMP");
    click("useDevice");
    ASSERT_EQ(used.size(), 1U);
    EXPECT_EQ(used.back().thermometer->channels, (std::vector{5, 2}));
    choose("driver", 0);
    const int last = dialog->device().thermometer->profile.channels - 1;
    EXPECT_EQ(child<QDoubleSpinBox>("channel.0")->maximum(), last);
}

// Catches channel 15 for "1.5", and a device that is taken with another channel than was typed.
TEST_F(DeviceDialogTest, IsNotTakenWhenANumberIsRefused) {
    open(DeviceRole::Thermometer);
    typePort("/dev/ttyTEMP");
    dialog->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(dialog.get()));
    auto* channel = child<QDoubleSpinBox>("channel.0");
    channel->setFocus();
    channel->selectAll();
    QTest::keyClicks(channel, QStringLiteral("1.5"));
    click("useDevice");
    EXPECT_TRUE(used.empty());
    click("useDevice");
    ASSERT_EQ(used.size(), 1U) << "the number is what is shown now";
    EXPECT_EQ(used.back().thermometer->channels.front(), 0);
}

// Catches a choice that sets another unit, profile or line than were found, and a search that keeps the port.
TEST_F(DeviceDialogTest, AUnitThatWasFoundIsChosen) {
    open(DeviceRole::Thermometer);
    typePort("/dev/ttyUSB7");
    click("findUnits");
    ASSERT_EQ(searches.size(), 1U);
    EXPECT_EQ(searches[0].port, "/dev/ttyUSB7");
    EXPECT_FALSE(searches[0].isNetwork);
    EXPECT_EQ(searches[0].lines.front(), dialog->device().thermometer->serial) << "as it is set first";
    EXPECT_EQ(searches[0].lines.size(), kCommonModbusLines.size()) << "each once";
    ModbusSearchState state;
    state.unit = 5;
    state.found = {{3, {{"pixsys-drr245", {300.0}, ""}}}, {5, {}}};
    dialog->setSearch(state);
    auto* list = child<QListWidget>("foundUnits");
    EXPECT_EQ(list->count(), 1) << "unit 5 is not complete yet";
    EXPECT_FALSE(list->item(0)->flags() & Qt::ItemIsEnabled) << "a controller is no thermometer";
    EXPECT_TRUE(child<QLabel>("findProgress")->text().contains("unit 5"));
    state.found[1].fits = {{"waveshare-8ch-4-20ma", {295.0, 296.0}, ""}};
    state.line = {9600, 8, 'N', 1};
    state.isOver = true;
    dialog->setSearch(state);
    ASSERT_EQ(list->count(), 2);
    list->setCurrentRow(1);
    EXPECT_EQ(dialog->device().thermometer->unit, 1) << "only looked at";
    emit list->itemClicked(list->item(1));
    const ThermometerDeviceSpec chosen = *dialog->device().thermometer;
    EXPECT_EQ(chosen.unit, 5);
    EXPECT_EQ(chosen.profile.name, "waveshare-8ch-4-20ma");
    EXPECT_EQ(chosen.serial, state.line);
    click("findUnits");
    click("findUnits"); // stop
    EXPECT_EQ(searchesEnded, 1);
    EXPECT_EQ(list->count(), 0);
    click("findUnits");
    dialog->setSearch(state);
    EXPECT_EQ(list->count(), 2);
    typePort("/dev/ttyUSB8");
    EXPECT_EQ(list->count(), 0) << "they are at another port";
    EXPECT_EQ(searchesEnded, 2);
}

} // namespace bask
