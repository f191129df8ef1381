// A rig alone in a file: it survives it, and damage is told where it is.

#include "engine/experiment/rig_file.h"

#include "engine/base/message_code.h"

#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <random>

namespace bask {
namespace {

RigSpec wholeRig() {
    RigSpec rig;
    rig.name = "b\u00e2nc 2 \"left\"";
    rig.robot.emplace().port = "/dev/serial/by-id/usb-robot";
    rig.robot->serial = {250000, 8, 'O', 2};
    rig.robot->axes = {{'X', 1, true, 0.123456789}, {'A', 3, false, -0.7}};
    rig.robot->mustHome = true;
    rig.thermometer.emplace().driver = "stream";
    rig.thermometer->port = "/dev/ttyTEMP";
    rig.thermometer->channels = {4, 0};
    rig.source.emplace().driver = "namur";
    rig.source->port = "/dev/ttyPLATE";
    rig.source->serial = {9600, 7, 'E', 1};
    rig.source->watchdog_s = 40.0;
    rig.source->isProbeUsed = true;
    rig.source->mayHeatUnattended = true;
    rig.camera = "/dev/video2";
    ThermalCameraSpec& camera = rig.thermalCamera.emplace();
    camera.device = "frames/of run 3";
    camera.profile = findThermalProfile("p2-pro").value();
    camera.profile.scale = 0.015625123; // one of nobody's
    CameraModel& lens = camera.calibration.lens.emplace();
    lens.width = 256;
    lens.height = 192;
    lens.fx = 211.5;
    lens.fy = 212.25;
    lens.cx = 127.5;
    lens.cy = 95.125;
    lens.distortion = {-0.2, 0.03, 0.001, 0.0};
    lens.rms_px = 0.123;
    camera.calibration.lensDate = "2026-11-20T10:00:00Z";
    camera.calibration.pose = Vector6d{{0.1, -0.2, 1.1, 3.0, 0.1, -0.2}};
    camera.calibration.poseDate = "2026-11-21T22:45:00Z";
    camera.calibration.poseUncertainty_m = 0.0005;
    return rig;
}

struct RigFile : testing::Test {
    QTemporaryDir folder;
    std::string path = folder.filePath("rig.json").toStdString();

    void write(const std::string& text) { std::ofstream(path, std::ios::binary) << text; }
    std::string text() {
        std::ifstream file(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    MessageCode refusal() {
        const auto read = readRigFile(path);
        return read ? MessageCode::None : read.error().code();
    }
};

} // namespace

// Catches a field that is written and not read, read and not written, or rounded.
TEST_F(RigFile, SurvivesItsFile) {
    for (const RigSpec& rig : {wholeRig(), RigSpec()}) {
        ASSERT_TRUE(writeRigFile(rig, path));
        EXPECT_TRUE(isRigFile(path));
        const auto read = readRigFile(path);
        ASSERT_TRUE(read) << describe(read.error());
        EXPECT_EQ(*read, rig);
    }
}

// Catches a hotplate that is asked at 115200 8N1 because its line is left out.
TEST_F(RigFile, AnAddressNeedsNoLine) {
    RigSpec rig;
    rig.thermometer.emplace().driver = "modbus_tcp";
    rig.thermometer->port = "[fe80::1]:1502";
    rig.thermometer->serial = {19200, 8, 'E', 1};
    rig.thermometer->unit = 247;
    rig.thermometer->profile =
        *std::ranges::find(shippedProfiles(), std::string("labjack-t7-thermocouples"), &ModbusProfile::name);
    rig.thermometer->channels = {13, 0};
    ModbusProfile own = rig.thermometer->profile;
    own.name = "ours";
    for (const ModbusProfile& profile : {rig.thermometer->profile, own}) { // by its name, and as a whole
        rig.thermometer->profile = profile;
        ASSERT_TRUE(writeRigFile(rig, path));
        const auto read = readRigFile(path);
        ASSERT_TRUE(read) << describe(read.error());
        EXPECT_EQ(read->thermometer->profile, profile);
        EXPECT_EQ(*read, rig);
        EXPECT_EQ(text().find("baud"), std::string::npos);
    }
}

TEST_F(RigFile, ALineThatIsLeftOutIsTheDriversUsual) {
    write(R"({"format": "bask-rig", "version": 1, "rig": {
        "robot": {"driver": "grbl", "port": "r"},
        "thermometer": {"driver": "modbus", "port": "t", "profile": "thermasgard-rtm1"},
        "source": {"driver": "namur", "port": "s", "serial": {"stop_bits": 2}}}})");
    const auto rig = readRigFile(path);
    ASSERT_TRUE(rig) << describe(rig.error());
    EXPECT_EQ(rig->robot->serial, (SerialSettings{115200, 8, 'N', 1}));
    EXPECT_EQ(rig->thermometer->serial, (SerialSettings{19200, 8, 'E', 1}));
    EXPECT_EQ(rig->source->serial, (SerialSettings{9600, 7, 'E', 2}));
}

// Catches a file of something else, of a newer Bask or with a misspelt key that is read as a rig.
TEST_F(RigFile, WhatIsNoRigIsRefusedInItsPlace) {
    EXPECT_FALSE(isRigFile(path));
    EXPECT_EQ(refusal(), MessageCode::FileNotFound);
    write(" \n");
    EXPECT_EQ(refusal(), MessageCode::FileEmpty);
    write("[]");
    EXPECT_EQ(refusal(), MessageCode::JsonWrongType);
    write(R"({"format": "bask-experiment", "version": 1, "rig": {}})");
    EXPECT_FALSE(isRigFile(path));
    EXPECT_EQ(refusal(), MessageCode::ValueUnknown);
    write(R"({"format": "bask-rig", "version": 2, "rig": {}, "more": 1})");
    EXPECT_EQ(refusal(), MessageCode::VersionTooNew);
    write(R"({"format": "bask-rig", "version": 0, "rig": {}})");
    EXPECT_EQ(refusal(), MessageCode::ValueOutOfRange);
    write(R"({"format": "bask-rig", "version": 1})");
    EXPECT_EQ(refusal(), MessageCode::JsonMissingKey);
    write(R"({"format": "bask-rig", "version": 1, "rig": {"robot": {"driver": "grbl", "prot": "x"}}})");
    const auto read = readRigFile(path);
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code(), MessageCode::JsonUnknownKey);
    EXPECT_EQ(read.error().where, path + ": rig.robot");
    EXPECT_EQ(read.error().message.args.front(), "prot");
    write(R"({"format": "bask-rig", "version": 1, "rig": {"name": "a", "name": "b"}})");
    EXPECT_EQ(refusal(), MessageCode::JsonDuplicateKey);
}

// Catches a watchdog's time that seems to say that there is one.
TEST_F(RigFile, AWatchdogThatIsNotThereHasNoTime) {
    const auto with = [](const std::string& keys) {
        return R"({"format": "bask-rig", "version": 1, "rig": {"source": {"driver": "modbus", "port": "x", )" +
               keys + "}}}";
    };
    write(with(R"("profile": "watlow-ez-zone", "unattended_heat": true)"));
    EXPECT_EQ(refusal(), MessageCode::None);
    EXPECT_TRUE(readRigFile(path)->source->mayHeatUnattended);
    ASSERT_TRUE(writeRigFile(*readRigFile(path), path));
    EXPECT_EQ(refusal(), MessageCode::None) << text();
    write(with(R"("profile": "watlow-ez-zone", "unattended_heat": true, "watchdog_s": 30)"));
    EXPECT_EQ(refusal(), MessageCode::JsonUnknownKey);
    write(with(R"("profile": "pixsys-drr245", "watchdog_s": 30)"));
    EXPECT_EQ(refusal(), MessageCode::None);
}

// Catches a damaged file that ends the program, or is taken though bytes are missing.
TEST_F(RigFile, DamagedFilesAreRefused) {
    ASSERT_TRUE(writeRigFile(wholeRig(), path));
    const std::string whole = text();
    for (std::size_t length = 0; length + 2 < whole.size(); length += 7) { // its last two are "}\n"
        write(whole.substr(0, length));
        EXPECT_NE(refusal(), MessageCode::None) << length;
    }
    std::mt19937 random(8);
    for (int i = 0; i < 300; ++i) {
        std::string damaged = whole;
        for (int k = 0; k < 4; ++k)
            damaged[random() % damaged.size()] = static_cast<char>(random());
        write(damaged);
        (void)refusal(); // answers, one way or the other
    }
}

// Catches a failed write that leaves half a file, or is told as a success.
TEST_F(RigFile, AFileThatCannotBeWrittenIsTold) {
    const std::string nowhere = folder.filePath("none/rig.json").toStdString();
    const auto written = writeRigFile(wholeRig(), nowhere);
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().code(), MessageCode::FileUnwritable);
}

// Catches a shipped camera written out in full, which would then never get a corrected profile.
TEST_F(RigFile, NamesAShippedThermalCamera) {
    for (const ThermalProfile& profile : shippedThermalProfiles()) {
        RigSpec rig;
        rig.thermalCamera = ThermalCameraSpec{"/dev/video2", profile, {}};
        ASSERT_TRUE(writeRigFile(rig, path));
        EXPECT_NE(text().find("\"profile\": \"" + profile.name + '"'), std::string::npos) << text();
        EXPECT_EQ(readRigFile(path).value(), rig);
        rig.thermalCamera->profile.name = "mine"; // written in full, and read back to the last digit
        ASSERT_TRUE(writeRigFile(rig, path));
        EXPECT_EQ(readRigFile(path).value(), rig);
    }
}

TEST_F(RigFile, RefusesAThermalCameraThatIsNone) {
    const auto refused = [&](const std::string& camera) {
        write(R"({"format": "bask-rig", "version": 1, "rig": {"thermal_camera": )" + camera + "}}");
        return refusal();
    };
    EXPECT_EQ(refused(R"({"device": "0"})"), MessageCode::JsonMissingKey);
    EXPECT_EQ(refused(R"({"profile": "p2-pro"})"), MessageCode::JsonMissingKey);
    EXPECT_EQ(refused(R"({"device": "0", "profile": "p3-pro"})"), MessageCode::ValueUnknown);
    EXPECT_EQ(refused(R"({"device": "0", "profile": {"name": "x"}})"), MessageCode::JsonMissingKey);
    EXPECT_EQ(refused(R"({"device": "0", "profile": "p2-pro", "rate": 1})"), MessageCode::JsonUnknownKey);
}

} // namespace bask
