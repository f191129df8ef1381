// What a camera can be made from, and the words about what it cannot.

#include "engine/base/message_code.h"
#include "engine/devices/frame_source.h"
#include "tests/engine/devices/video_samples.h"

#include <gtest/gtest.h>

namespace bask {
namespace {

using test::even;
using test::ScratchFolder;

Result<std::unique_ptr<FrameSource>> opened(const std::string& name) {
    return openFrameSource(name, [] { return false; });
}

/// Mean grey of the next picture, -1 when there is none.
int greyOf(FrameSource& source) {
    const auto caught = source.next();
    if (!caught)
        return -1;
    double sum = 0.0;
    for (const std::uint8_t value : caught->picture.values)
        sum += value;
    return static_cast<int>(sum / static_cast<double>(caught->picture.values.size()) + 0.5);
}

} // namespace

// Catches: pictures out of order or lost, colour for brightness, a video that ends where a camera would go
// on, and one played at another rate than its own.
TEST(FrameSource, PlaysAVideoRoundAndRound) {
    const ScratchFolder folder;
    test::writeVideo(folder / "five.avi", 5, 25.0);
    const auto source = opened(folder / "five.avi");
    ASSERT_TRUE(source) << describe(source.error());
    EXPECT_NEAR((*source)->period_s(), 0.04, 1e-9);
    for (int k = 0; k < 12; ++k)
        EXPECT_NEAR(greyOf(**source), 40 + 10 * (k % 5), 2) << k;
}

// Catches: the order of the directory instead of the names', other files taken for pictures, an end.
TEST(FrameSource, PlaysAFolderInOrderOfNames) {
    const ScratchFolder folder;
    for (const int k : {3, 1, 2})
        cv::imwrite(folder / ("view_" + std::to_string(k) + ".png"), even(50 * k));
    test::writeText(folder / "notes.txt", "not a picture");
    std::filesystem::create_directory(folder / "more.png");
    const auto source = opened(folder.path());
    ASSERT_TRUE(source) << describe(source.error());
    EXPECT_NEAR((*source)->period_s(), 0.1, 1e-9);
    for (const int grey : {50, 100, 150, 50, 100})
        EXPECT_EQ(greyOf(**source), grey);
}

TEST(FrameSource, OnePictureIsAFolderOfOne) {
    const ScratchFolder folder;
    cv::imwrite(folder / "one.PNG", even(77));
    const auto source = opened(folder / "one.PNG");
    ASSERT_TRUE(source) << describe(source.error());
    EXPECT_EQ(greyOf(**source), 77);
    EXPECT_EQ(greyOf(**source), 77);
}

// Catches: a crash, gigabytes of memory or a silent skip by a bad source; words that do not say what is wrong
// with which file; what the libraries write to stderr besides.
TEST(FrameSource, BadSourcesAreRefusedInWords) {
    const ScratchFolder folder;
    const auto in = [&](const std::string& name) {
        std::filesystem::create_directory(folder / name);
        return folder / name + "/";
    };
    test::writeText(folder / "text.mp4", "This is no video.\n");
    test::writeText(folder / "empty.avi", "");
    test::writeText(folder / "text.png", "This is no picture.\n");
    test::writeVideo(folder / "tiny.avi", 3, 25.0, {16, 16});
    test::writeVideo(folder / "none.avi", 0);
    test::writeText(in("bare") + "notes.txt", "no pictures");
    cv::imwrite(in("dot") + "a.png", even(1, {1, 1}));
    cv::imwrite(in("sizes") + "a.png", even(1));
    cv::imwrite(in("sizes") + "b.png", even(1, {240, 320}));
    cv::imwrite(in("huge") + "a.png", even(1));
    std::string huge{"\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\x4e\x20\0\0\x4e\x20\x8\0\0\0\0", 29};
    test::writeText(folder / "huge/b.png", huge + std::string(100, '\0'));
    const struct {
        std::string name, words;
    } cases[] = {
        {"", "no camera is named"},
        {"97", "no camera answers there"},
        {"/dev/null", "no camera answers there"},
        {folder / "gone.mp4", "there is no such file or device"},
        {folder / "text.mp4", "not a video that can be read"},
        {folder / "empty.avi", "the file is empty"},
        {folder / "text.png", "not a picture that can be read"},
        {folder / "tiny.avi", "only 16 x 16 pixels"},
        {folder / "none.avi", ""},
        {folder / "bare", "there is no picture in this folder"},
        {folder / "dot", "only 1 x 1 pixels"},
        {folder / "sizes", "b.png has 240 x 320 pixels, those before 320 x 240 pixels"},
        {folder / "huge", "b.png: the file has 400 megapixels"},
        {"rtsp://127.0.0.1:1/none", "no video comes from there"},
    };
    testing::internal::CaptureStderr();
    for (const auto& [name, words] : cases) {
        auto source = opened(name);
        // A video without a picture is known by the first only.
        const bool isBad = !source || !(*source)->next();
        EXPECT_TRUE(isBad) << name;
        if (source)
            continue;
        EXPECT_EQ(source.error().code(), MessageCode::CameraNotOpened) << name;
        EXPECT_EQ(source.error().message.args.at(0), name);
        EXPECT_NE(source.error().message.args.at(1).text().find(words), std::string::npos)
            << name << ": " << describe(source.error());
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

} // namespace bask
