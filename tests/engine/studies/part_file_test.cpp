// Parts of divided studies: killed at any byte, damaged at any byte, of other work, of two processes.

#include "engine/studies/part_file.h"

#include "engine/base/message_code.h"
#include "engine/studies/row_bytes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>

#include <csignal>
#include <sys/resource.h>

namespace bask::test {
namespace {

namespace fs = std::filesystem;

std::string bytesOfFile(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

void writeFile(const std::string& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
}

std::string recordOf(std::int64_t index) {
    return std::string(static_cast<std::size_t>(index % 5), static_cast<char>('a' + index)) + '\0' + "end";
}

class PartFile : public ::testing::Test {
protected:
    void SetUp() override {
        fs::remove_all(m_folder);
        fs::create_directories(m_folder);
    }
    void TearDown() override { fs::remove_all(m_folder); }

    std::string path(const std::string& name = "a.part") const { return (m_folder / name).string(); }
    static PartHeader header(Shard shard = {2, 3}, const char* work = R"({"seed":"1","software":"Bask"})") {
        return {work, 10, shard};
    }
    /// Computes what is missing; returns how many cases that were.
    static std::size_t complete(const std::string& file, const PartHeader& of) {
        auto part = PartWriter::open(file, of, true);
        if (!part) {
            ADD_FAILURE() << describe(part.error());
            return 0;
        }
        const auto missing = (*part)->missing();
        for (const std::int64_t index : missing)
            EXPECT_TRUE((*part)->add(index, recordOf(index), 0.5));
        EXPECT_TRUE((*part)->finish());
        return missing.size();
    }
    /// Parts of all shards; returns their paths.
    std::vector<std::string> allParts(int of, const char* work = R"({"seed":"1","software":"Bask"})") const {
        std::vector<std::string> paths;
        for (int number = 1; number <= of; ++number) {
            paths.push_back(path(std::to_string(number) + ".part"));
            complete(paths.back(), header({number, of}, work));
        }
        return paths;
    }

    fs::path m_folder = fs::temp_directory_path() / ("bask-parts-" + std::to_string(::getpid()));
};

// Catches: shards that leave a case out or share one.
TEST_F(PartFile, shardsShareAllCases) {
    for (const int of : {1, 3, 7, 64}) {
        std::map<std::int64_t, int> by;
        std::int64_t sum = 0;
        for (int number = 1; number <= of; ++number) {
            const Shard shard{number, of};
            std::int64_t has = 0;
            for (std::int64_t index = 0; index < 10; ++index)
                if (shard.has(index))
                    ++by[index], ++has;
            EXPECT_EQ(shard.share(10), has) << number << '/' << of;
            sum += has;
        }
        EXPECT_EQ(sum, 10);
        for (const auto& [index, count] : by)
            EXPECT_EQ(count, 1) << index;
    }
}

// Catches: a half-written record that is counted, or one that stops the next process, whatever byte the kill
// came at.
TEST_F(PartFile, goesOnAfterAKillAtAnyByte) {
    ASSERT_EQ(complete(path(), header()), 3U);
    const std::string whole = bytesOfFile(path());
    const std::size_t line = whole.find('\n') + 1;
    for (std::size_t size = 0; size < whole.size(); ++size) {
        SCOPED_TRACE(size);
        writeFile(path(), whole.substr(0, size));
        const auto merged = MergedParts::of({path()});
        EXPECT_FALSE(merged);
        const std::size_t lacking = complete(path(), header());
        EXPECT_GE(lacking, size < line ? 3U : 1U);
        if (size >= line) { // the header has the time in it
            EXPECT_EQ(bytesOfFile(path()).substr(line), whole.substr(line));
        }
        const auto part = readPart(path(), true);
        ASSERT_TRUE(part);
        EXPECT_EQ(part->records.size(), 3U);
        EXPECT_FALSE(part->isDamaged);
    }
}

// Catches: a byte that was changed and merged.
TEST_F(PartFile, refusesAByteThatWasChanged) {
    const auto paths = allParts(3);
    const std::string whole = bytesOfFile(paths[1]);
    for (std::size_t at = whole.find('\n') + 1; at < whole.size(); ++at) {
        std::string changed = whole;
        changed[at] = static_cast<char>(changed[at] ^ 0x10);
        writeFile(paths[1], changed);
        const auto merged = MergedParts::of(paths);
        ASSERT_FALSE(merged) << at;
        EXPECT_TRUE(merged.error().code() == MessageCode::PartDamaged ||
                    merged.error().code() == MessageCode::PartsMissing)
            << describe(merged.error());
        EXPECT_GE(complete(paths[1], header({2, 3})), 1U) << at;
        EXPECT_TRUE(MergedParts::of(paths)) << at;
    }
}

TEST_F(PartFile, mergesTheSameForEveryNumberOfShards) {
    for (const int of : {1, 3, 7, 64}) {
        const auto merged = MergedParts::of(allParts(of));
        ASSERT_TRUE(merged) << describe(merged.error());
        ASSERT_EQ(merged->cases(), 10);
        for (std::int64_t index = 0; index < 10; ++index)
            EXPECT_EQ(*merged->record(index), recordOf(index));
        SetUp();
    }
}

// Catches a case that two parts have with other bytes, of which the last one counts without a word.
TEST_F(PartFile, takesACaseFromTwoPartsOnlyWhereTheyAgree) {
    auto paths = allParts(3);
    paths.push_back(path("again.part"));
    complete(paths.back(), header({2, 3}));
    ASSERT_TRUE(MergedParts::of(paths));
    fs::remove(paths.back());
    {
        auto other = PartWriter::open(paths.back(), header({2, 3}), true);
        ASSERT_TRUE(other);
        ASSERT_TRUE((*other)->add(4, recordOf(4) + "!", 0.5));
        ASSERT_TRUE((*other)->finish());
    }
    const auto merged = MergedParts::of(paths);
    ASSERT_FALSE(merged);
    EXPECT_EQ(merged.error().code(), MessageCode::PartsDisagree);
    EXPECT_NE(describe(merged.error()).find("again.part: case 5 is also in " + paths[1]), std::string::npos)
        << describe(merged.error());
}

TEST_F(PartFile, saysWhichShardsLackCases) {
    auto paths = allParts(7);
    paths.erase(paths.begin() + 2);
    const auto merged = MergedParts::of(paths);
    ASSERT_FALSE(merged);
    EXPECT_EQ(merged.error().code(), MessageCode::PartsMissing);
    EXPECT_NE(describe(merged.error()).find("2 of 10 cases are not there yet (3/7)"), std::string::npos)
        << describe(merged.error());
}

TEST_F(PartFile, refusesWhatIsNotOfTheSameWork) {
    auto paths = allParts(2);
    const PartHeader other{R"({"seed":"2","software":"Bask"})", 10, {2, 2}};
    const auto resumed = PartWriter::open(paths[1], other, true);
    ASSERT_FALSE(resumed);
    EXPECT_NE(describe(resumed.error()).find("seed is 2 here and 1 there"), std::string::npos)
        << describe(resumed.error());
    EXPECT_FALSE(PartWriter::open(paths[1], header({1, 2}), true));
    EXPECT_FALSE(PartWriter::open(paths[1], header({2, 3}), true));
    PartHeader more = header({2, 2});
    more.cases = 11;
    EXPECT_FALSE(PartWriter::open(paths[1], more, true));
    fs::remove(paths[1]);
    complete(paths[1], other);
    const auto merged = MergedParts::of(paths);
    ASSERT_FALSE(merged);
    EXPECT_EQ(merged.error().code(), MessageCode::PartOfAnother);
    EXPECT_NE(describe(merged.error()).find("seed is 1 here and 2 there"), std::string::npos)
        << describe(merged.error());
}

TEST_F(PartFile, isOneProcessesOwnAndNotBegunTwice) {
    const auto first = PartWriter::open(path(), header(), false);
    ASSERT_TRUE(first);
    const auto beside = PartWriter::open(path(), header(), true);
    ASSERT_FALSE(beside);
    EXPECT_EQ(beside.error().code(), MessageCode::PartBusy);
    EXPECT_TRUE(readPart(path(), true)->isBeingWritten);
    writeFile(path("done.part"), bytesOfFile(path()));
    const auto again = PartWriter::open(path("done.part"), header(), false);
    ASSERT_FALSE(again);
    EXPECT_EQ(again.error().code(), MessageCode::PartThere);
}

TEST_F(PartFile, refusesForeignFiles) {
    for (const std::string& bytes :
         {std::string("x"), std::string("{}\n"), std::string(3 << 20, 'a'), std::string("\n\n\n"),
          std::string(R"({"bask_part":1,"shard":1,"of":1,"cases":99999999999999,"threads":1,"work":{}})"
                      "\n"),
          std::string(R"({"bask_part":1,"shard":0,"of":1,"cases":5,"threads":1,"work":{}})"
                      "\n"),
          std::string(R"({"bask_part":1,"shard":1,"of":1,"cases":5,"threads":1,"work":[]})"
                      "\n"),
          std::string(R"({"bask_part":"one","shard":1,"of":1,"cases":5,"threads":1,"work":{}})"
                      "\n"),
          std::string(R"({"bask_part":2,"shard":1,"of":1,"cases":5,"threads":1,"work":{}})"
                      "\n")}) {
        writeFile(path(), bytes);
        EXPECT_FALSE(readPart(path(), true)) << bytes.substr(0, 80);
        EXPECT_FALSE(PartWriter::open(path(), header(), true)) << bytes.substr(0, 80);
        EXPECT_EQ(bytesOfFile(path()), bytes) << "lost";
    }
    EXPECT_FALSE(readPart(path("nowhere.part"), true));
    EXPECT_FALSE(PartWriter::open(path("no/folder.part"), header(), true));
    EXPECT_FALSE(PartWriter::open(m_folder.string(), header(), true));
}

// A limit on the size of files stands for a full disk.
TEST_F(PartFile, tellsOfAFullDiskAndKeepsWhatIsWhole) {
    const auto part = PartWriter::open(path(), header(), false);
    ASSERT_TRUE(part);
    ASSERT_TRUE((*part)->add(1, std::string(100, 'a'), 0.0));
    const std::string before = bytesOfFile(path());
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit old{}, tight{};
    getrlimit(RLIMIT_FSIZE, &old);
    tight = {before.size() + 50, old.rlim_max};
    setrlimit(RLIMIT_FSIZE, &tight);
    const auto added = (*part)->add(4, std::string(100, 'b'), 0.0);
    setrlimit(RLIMIT_FSIZE, &old);
    ASSERT_FALSE(added);
    EXPECT_EQ(added.error().code(), MessageCode::FileUnwritable);
    EXPECT_EQ(bytesOfFile(path()), before);
}

// Catches: a row that comes back with a member left out or rounded.
TEST(RowBytes, giveTheRowBack) {
    ClosedLoopRow row;
    row.drawn.seed = 0xfedcba9876543210ULL;
    row.drawn.mountings = {Vector6d::Random()};
    row.drawn.start = Vector6d::Random();
    row.drawn.goal = Vector6d::Random();
    row.drawn.targets_K = {333.1};
    row.drawn.convection_W_m2K = 0.1;
    row.drawn.sensorLag_s = 0.2;
    row.drawn.robotLatency_s = 0.3;
    row.drawn.uneven = 0.4;
    row.drawn.radiation_s = 1.0 / 3.0;
    row.drawn.bound_s = 0.1 + 0.2;
    row.drawn.travel_s = 1e-300;
    row.settling_s = 12.3;
    row.overshoot_K = 0.7;
    row.way_m = 0.8;
    row.commandAcceleration_m_s2 = 0.9;
    row.final_K = {331.7};
    row.toldCompromise = true;
    row.failure = "not \"settled\"; \xc3\xa9";
    const auto back = closedLoopRowOf(bytesOf(row), 1);
    ASSERT_TRUE(back);
    EXPECT_EQ(bytesOf(*back), bytesOf(row));
    EXPECT_EQ(back->drawn.seed, row.drawn.seed);
    EXPECT_EQ(back->drawn.mountings, row.drawn.mountings);
    EXPECT_EQ(back->drawn.goal, row.drawn.goal);
    EXPECT_EQ(back->drawn.bound_s, 0.1 + 0.2);
    EXPECT_EQ(back->drawn.radiation_s, 1.0 / 3.0);
    EXPECT_EQ(back->settling_s, row.settling_s);
    EXPECT_EQ(back->restSpeed_m_s, std::nullopt);
    EXPECT_EQ(back->failure, row.failure);
    EXPECT_FALSE(closedLoopRowOf(bytesOf(row), 2));
    EXPECT_FALSE(closedLoopRowOf("nonsense", 1));

    AlarmStudyRow alarms;
    alarms.drawn = {"adaptive",   3,    573.15, SourceModel::Paper,           0.1,    0.2, 0.3,
                    ReadBy::Both, 0.05, 0.02,   SimulatedFault::SensorFrozen, "hand", 9.0};
    alarms.alarms = {{1.5, 2, "SafetyObjectHot", "hot", true, false}};
    alarms.acted_s = 3.5;
    alarms.unseen_K = 4.5;
    const auto same = alarmRowOf(bytesOf(alarms));
    ASSERT_TRUE(same);
    EXPECT_EQ(bytesOf(*same), bytesOf(alarms));
    EXPECT_EQ(same->drawn.fault, SimulatedFault::SensorFrozen);
    EXPECT_EQ(same->drawn.sourceModel, SourceModel::Paper);
    EXPECT_EQ(same->drawn.readBy, ReadBy::Both);
    EXPECT_EQ(same->alarms.at(0).sentence, "hot");
    EXPECT_EQ(same->acted_s, 3.5);
}

// Catches: a study that cannot be merged because one number of one run is not finite.
TEST(RowBytes, giveNumbersBackThatAreNotFinite) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    ClosedLoopRow row;
    row.drawn.mountings = {Vector6d::Zero()};
    row.drawn.targets_K = {333.1};
    row.drawn.bound_s = kInfinity;
    row.overshoot_K = -kInfinity;
    row.way_m = std::numeric_limits<double>::quiet_NaN();
    row.settling_s = kInfinity;
    row.final_K = {kInfinity};
    row.failure = "inf";
    const auto back = closedLoopRowOf(bytesOf(row), 1);
    ASSERT_TRUE(back);
    EXPECT_EQ(back->drawn.bound_s, kInfinity);
    EXPECT_EQ(back->overshoot_K, -kInfinity);
    EXPECT_TRUE(std::isnan(back->way_m));
    EXPECT_EQ(back->settling_s, kInfinity);
    EXPECT_EQ(back->restSpeed_m_s, std::nullopt);
    EXPECT_EQ(back->final_K, row.final_K);
    EXPECT_EQ(back->failure, "inf");
    EXPECT_EQ(back->drawn.targets_K, row.drawn.targets_K);
}

} // namespace
} // namespace bask::test
