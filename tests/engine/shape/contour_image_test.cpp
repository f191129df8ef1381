// Outlines from pictures: true size to a fraction of a pixel, and refusals of what is no silhouette.

#include "engine/base/message_code.h"
#include "engine/media/media.h"
#include "engine/shape/contour_import.h"
#include "engine/shape/fourier_contour.h"
#include "tests/engine/shape/shape_samples.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <filesystem>
#include <iterator>
#include <random>

namespace bask {
namespace {

std::string fileBytes(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::string encoded(const cv::Mat& image, const char* ending = ".png") {
    std::vector<unsigned char> bytes;
    cv::imencode(ending, image, bytes);
    return {bytes.begin(), bytes.end()};
}

Result<Contour> readContourImage(const std::string& path, double scale_px_per_mm) {
    auto file = readImageOutlines(path, {.scale_px_per_mm = scale_px_per_mm});
    if (!file)
        return file.error();
    file->arrange();
    auto picked = pickOutline(*file, std::nullopt, path);
    if (!picked)
        return picked.error();
    return picked->contour;
}

Result<Contour> readPicture(const cv::Mat& image, double scale = 1.0, const char* ending = ".png") {
    return readContourImage(test::writeFile(ending, encoded(image, ending)), scale);
}

MessageCode pictureCode(const Result<Contour>& result) {
    if (result)
        return MessageCode::None;
    EXPECT_FALSE(describe(result.error()).empty());
    return result.error().code();
}

// Share of every pixel that an ellipse covers, by 16 x 16 samples; centre and half axes in px, y down.
cv::Mat1f coverage(cv::Size size, double cx, double cy, double a, double b) {
    cv::Mat1f share(size, 0.0F);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            for (int k = 0; k < 256; ++k) {
                const double u = (x + (k % 16 + 0.5) / 16 - cx) / a, v = (y + (k / 16 + 0.5) / 16.0 - cy) / b;
                share(y, x) += u * u + v * v < 1.0 ? 1.0F / 256 : 0.0F;
            }
    return share;
}

cv::Mat grey(const cv::Mat1f& share, double ground, double object, int type = CV_8U) {
    cv::Mat out;
    cv::Mat1f(share * (object - ground) + ground).convertTo(out, type);
    return out;
}

void expectShape(const std::string& path, double area_mm2, double perimeter_mm, const std::string& truth) {
    const auto traced = readContourImage(path, 15.0);
    ASSERT_TRUE(traced) << describe(traced.error());
    EXPECT_NEAR(contourArea(*traced) * 1e6, area_mm2, 1e-3 * area_mm2);
    EXPECT_NEAR(contourPerimeter(*traced) * 1e3, perimeter_mm, 2e-3 * perimeter_mm);
    EXPECT_LT(traced->points_m.size(), 800U) << "thinned";
    const Contour exact = readContourCsv(truth, std::nullopt).value();
    // The moments fix size and form: the same series but for the phase of its start.
    const auto a = fitFourier(*traced, 5), b = fitFourier(exact, 5);
    for (int j = -5; j <= 5; ++j)
        EXPECT_NEAR(std::abs(a->contour.coefficient(j)), std::abs(b->contour.coefficient(j)), 3e-5) << j;
}

TEST(ContourImage, BunnyAndHandHaveTheirTrueSize) {
    expectShape(test::examplePath("bunny_1200.png"), 2894.2338, 284.3103, test::examplePath("bunny_mm.csv"));
    expectShape(test::examplePath("hand_1200.png"), 2326.7417, 379.9561, test::examplePath("hand_mm.csv"));
}

TEST(ContourImage, AlphaAndInvertedPicturesGiveTheSame) {
    expectShape(test::dataPath("bunny_alpha.png"), 2894.2338, 284.3103, test::examplePath("bunny_mm.csv"));
    expectShape(test::dataPath("hand_white_on_black.png"), 2326.7417, 379.9561,
                test::examplePath("hand_mm.csv"));
}

TEST(ContourImage, YPointsUpAndPixelsHaveTheirPlace) {
    const auto bunny = readContourImage(test::examplePath("bunny_1200.png"), 15.0);
    ASSERT_TRUE(bunny);
    // The drawing's own centroid (31.9246, 27.3994) mm from a corner that lies at (75.0, 88.217) px.
    const Eigen::Vector2d centroid_mm = contourCentroid(*bunny) * 1e3;
    EXPECT_NEAR(centroid_mm.x(), 31.9246 + 75.0 / 15, 0.01);
    EXPECT_NEAR(centroid_mm.y(), 27.3994 + 88.217 / 15, 0.01);
}

TEST(ContourImage, OtherPeoplesSilhouettes) {
    const auto horse = readContourImage(test::dataPath("horse.png"), 1.0);
    ASSERT_TRUE(horse) << "its alpha is for rounded corners only: " << describe(horse.error());
    EXPECT_NEAR(contourArea(*horse) * 1e6, 43412, 100);
    const auto head = readContourImage(test::dataPath("templ.png"), 1.0);
    ASSERT_TRUE(head) << describe(head.error());
    EXPECT_NEAR(contourArea(*head) * 1e6, 8614, 30);
}

TEST(ContourImage, SubPixelWhateverTheLevelsAndDepth) {
    const cv::Mat1f share = coverage({160, 120}, 71.3, 58.6, 50.2, 33.7);
    const double area = std::numbers::pi * 50.2 * 33.7, perimeter = 266.186;
    cv::Mat colour, dim16 = grey(share, 900, 3000, CV_16U);
    cv::cvtColor(grey(share, 240, 60), colour, cv::COLOR_GRAY2BGR);
    colour.forEach<cv::Vec3b>([](cv::Vec3b& p, const int*) { p[2] = static_cast<uchar>(p[2] / 2); });
    const cv::Mat pictures[] = {grey(share, 255, 0),           grey(share, 0, 255),
                                grey(share, 200, 90),          colour,
                                grey(share, 65535, 0, CV_16U), dim16};
    for (const cv::Mat& picture : pictures)
        for (const char* ending : {".png", ".tiff"}) {
            const auto contour = readPicture(picture, 2.0, ending);
            ASSERT_TRUE(contour) << describe(contour.error());
            EXPECT_NEAR(contourArea(*contour) * 4e6, area, 2e-3 * area) << ending;
            EXPECT_NEAR(contourPerimeter(*contour) * 2e3, perimeter, 5e-3 * perimeter) << ending;
            EXPECT_NEAR(contourCentroid(*contour).x() * 2e3, 71.3, 0.03);
            EXPECT_NEAR(contourCentroid(*contour).y() * 2e3, 120 - 58.6, 0.03);
        }
    const auto jpeg = readPicture(pictures[0], 2.0, ".jpg");
    ASSERT_TRUE(jpeg) << describe(jpeg.error());
    EXPECT_NEAR(contourArea(*jpeg) * 4e6, area, 5e-3 * area);
}

TEST(ContourImage, BlackAndWhiteStairsAreStraightened) {
    cv::Mat picture = grey(coverage({300, 260}, 148.7, 131.2, 120.0, 97.0), 255, 0);
    cv::threshold(picture, picture, 127, 255, cv::THRESH_BINARY);
    const auto contour = readPicture(picture);
    ASSERT_TRUE(contour) << describe(contour.error());
    const double area = std::numbers::pi * 120 * 97;
    EXPECT_NEAR(contourArea(*contour) * 1e6, area, 3e-3 * area);
    EXPECT_NEAR(contourPerimeter(*contour) * 1e3, 683.687,
                0.01 * 683.687); // the stair would be 27 % too long
}

TEST(ContourImage, DustAndHolesDoNotMatter) {
    cv::Mat picture = grey(coverage({160, 120}, 71.3, 58.6, 50.2, 33.7), 255, 0);
    const auto clean = readPicture(picture);
    cv::rectangle(picture, {60, 50, 9, 9}, cv::Scalar(255), cv::FILLED);
    for (const cv::Point p : {cv::Point(3, 3), cv::Point(150, 20), cv::Point(0, 60)})
        picture.at<uchar>(p) = 0;
    const auto dusty = readPicture(picture);
    ASSERT_TRUE(clean);
    ASSERT_TRUE(dusty) << describe(dusty.error());
    EXPECT_NEAR(contourArea(*dusty), contourArea(*clean), 1e-3 * contourArea(*clean));
}

TEST(ContourImage, RaggedSilhouettesNeverGiveACrossingOutline) {
    cv::RNG random(23);
    int read = 0;
    for (int trial = 0; trial < 60; ++trial) {
        cv::Mat picture(60, 60, CV_8U), mask(60, 60, CV_8U, cv::Scalar(0));
        random.fill(picture, cv::RNG::UNIFORM, 0, 256); // pixels that touch by corners, holes, hairs
        if (trial % 3 == 1)
            cv::GaussianBlur(picture, picture, cv::Size(), 1.0);
        if (trial % 3 != 0)
            cv::threshold(picture, picture, 120, 255,
                          trial % 3 == 1 ? cv::THRESH_TOZERO : cv::THRESH_BINARY_INV);
        else
            cv::threshold(picture, picture, 90, 255, cv::THRESH_BINARY);
        cv::circle(mask, {30, 30}, 26, cv::Scalar(255), cv::FILLED);
        picture.setTo(0, ~mask);
        const auto contour = readPicture(picture);
        read += contour.ok();
        EXPECT_NE(pictureCode(contour), MessageCode::ContourCrossing) << trial;
    }
    EXPECT_GT(read, 20);
}

TEST(ContourImage, RefusesPicturesWithoutASilhouette) {
    const auto code = [](const char* name) {
        return pictureCode(readContourImage(test::dataPath(name), 10.0));
    };
    EXPECT_EQ(code("coins.png"), MessageCode::SilhouetteAtBorder) << "its ground grows dark towards one side";
    EXPECT_EQ(code("tiny_indexed_3x5.png"), MessageCode::NoSilhouette);
    EXPECT_EQ(code("hand_photo_border.jpg"), MessageCode::SilhouetteAtBorder);
    EXPECT_NE(code("fruits.jpg"), MessageCode::None);
    EXPECT_NE(code("detect_blob.png"), MessageCode::None);
    EXPECT_EQ(pictureCode(readPicture(cv::Mat(80, 90, CV_8U, cv::Scalar(77)))), MessageCode::NoSilhouette);
    EXPECT_EQ(pictureCode(readPicture(cv::Mat(80, 90, CV_8UC4, cv::Scalar(9, 9, 9, 0)))),
              MessageCode::NoSilhouette);
    EXPECT_EQ(pictureCode(readPicture(cv::Mat(1, 1, CV_8U, cv::Scalar(0)))), MessageCode::NoSilhouette);
    cv::Mat noise(200, 200, CV_8U), speckle;
    cv::RNG random(5);
    random.fill(noise, cv::RNG::NORMAL, 128, 40);
    EXPECT_EQ(pictureCode(readPicture(noise)), MessageCode::NoSilhouette);
    cv::threshold(noise, speckle, 200, 255, cv::THRESH_BINARY);
    EXPECT_EQ(pictureCode(readPicture(speckle)), MessageCode::NoSilhouette);
    cv::Mat cut(100, 100, CV_8U, cv::Scalar(255));
    cv::circle(cut, {50, 85}, 20, cv::Scalar(0), cv::FILLED);
    EXPECT_EQ(pictureCode(readPicture(cut)), MessageCode::SilhouetteAtBorder);
}

TEST(ContourImage, RefusesWhatIsNoPicture) {
    const auto code = [](const std::string& path) { return pictureCode(readContourImage(path, 10.0)); };
    EXPECT_EQ(code(test::dataPath("empty.png")), MessageCode::FileEmpty);
    EXPECT_EQ(code(test::dataPath("truncated.jpg")), MessageCode::ImageUnreadable);
    EXPECT_EQ(code(test::dataPath("earcut_dude.csv")), MessageCode::ImageUnreadable);
    EXPECT_EQ(code("/no/such/picture.png"), MessageCode::FileNotFound);
    EXPECT_EQ(code(testing::TempDir()), MessageCode::FileUnreadable);
    const std::string photo = fileBytes(test::dataPath("hand_photo_border.jpg"));
    EXPECT_EQ(code(test::writeFile(".jpg", photo.substr(0, photo.size() / 2))), MessageCode::ImageUnreadable)
        << "a decoder fills the lost half with grey";
    for (const double scale : {0.0, -3.0, std::nan(""), HUGE_VAL})
        EXPECT_EQ(pictureCode(readContourImage(test::examplePath("bunny_1200.png"), scale)),
                  MessageCode::ScaleNotPositive);
}

// Catches: channels in another order, a picture that OpenCV's decoder gives otherwise, damage that is not
// noticed.
TEST(ContourImage, APlainPngIsWhatOpenCvMakesOfIt) {
    const auto plain = [](const std::string& bytes) {
        return decodePlainPng(
            cv::Mat(1, static_cast<int>(bytes.size()), CV_8U, const_cast<char*>(bytes.data())));
    };
    const auto isSame = [](const cv::Mat& a, const cv::Mat& b) {
        return a.size() == b.size() && a.type() == b.type() && cv::norm(a, b, cv::NORM_INF) == 0.0;
    };
    std::mt19937 random(3);
    for (const int type : {CV_8UC1, CV_8UC3, CV_8UC4}) {
        cv::Mat noise(37, 53, type);
        cv::randu(noise, 0, 256);
        EXPECT_TRUE(isSame(plain(encoded(noise)), noise)) << type;
    }
    EXPECT_TRUE(plain(encoded(cv::Mat(9, 9, CV_16U, cv::Scalar(7)))).empty());
    EXPECT_TRUE(plain(encoded(cv::Mat(9, 9, CV_8U, cv::Scalar(7)), ".bmp")).empty());
    EXPECT_TRUE(plain("").empty());
    int read = 0;
    for (const auto& entry : std::filesystem::directory_iterator(test::dataPath(""))) {
        if (entry.path().extension() != ".png")
            continue;
        const std::string bytes = fileBytes(entry.path());
        const cv::Mat image = plain(bytes);
        read += image.empty() ? 0 : 1;
        EXPECT_TRUE(image.empty() || isSame(image, cv::imread(entry.path(), cv::IMREAD_UNCHANGED)))
            << entry.path();
    }
    EXPECT_GT(read, 2);
    const std::string whole = fileBytes(test::examplePath("hand_1200.png"));
    for (int i = 0; i < 60; ++i) {
        EXPECT_TRUE(plain(whole.substr(0, random() % (whole.size() - 12))).empty());
        std::string changed = whole;
        changed[random() % changed.size()] ^= static_cast<char>(1U << random() % 8);
        plain(changed); // ends, whatever it gives
    }
}

TEST(ContourImage, RefusesAnAbsurdSizeBeforeItIsUnpacked) {
    std::string png = fileBytes(test::dataPath("horse.png"));
    png[16] = png[20] = 0;
    png[17] = png[21] = 1; // more than 65536 x 65536
    EXPECT_EQ(pictureCode(readContourImage(test::writeFile(".png", png), 1.0)), MessageCode::FileTooLarge);
    std::string bmp = encoded(cv::Mat(8, 8, CV_8U, cv::Scalar(0)), ".bmp");
    bmp[20] = bmp[24] = 1;
    EXPECT_EQ(pictureCode(readContourImage(test::writeFile(".bmp", bmp), 1.0)), MessageCode::FileTooLarge);
    std::string jpeg = encoded(cv::Mat(8, 8, CV_8U, cv::Scalar(0)), ".jpg");
    const std::size_t frame = jpeg.find("\xFF\xC0");
    ASSERT_NE(frame, std::string::npos);
    for (const std::size_t k : {5U, 6U, 7U, 8U})
        jpeg[frame + k] = '\x7F';
    EXPECT_EQ(pictureCode(readContourImage(test::writeFile(".jpg", jpeg), 1.0)), MessageCode::FileTooLarge);
    // Another format under a known ending would be unpacked by its own words.
    EXPECT_EQ(pictureCode(readContourImage(test::writeFile(".png", "P6\n30000 30000\n255\nabc"), 1.0)),
              MessageCode::ImageUnreadable);
}

TEST(ContourImage, DamagedFilesNeverCrashAndAlwaysAnswer) {
    std::mt19937 random(17);
    const cv::Mat picture = grey(coverage({60, 50}, 29.3, 25.6, 20.2, 13.7), 255, 0);
    for (const char* ending : {".png", ".jpg", ".bmp", ".tiff"}) {
        const std::string whole = encoded(picture, ending);
        for (int trial = 0; trial < 60; ++trial) {
            std::string bytes = whole;
            for (int k = 0; k <= trial % 4; ++k)
                bytes[random() % (trial % 2 ? bytes.size() : std::min<std::size_t>(bytes.size(), 64))] =
                    static_cast<char>(random());
            if (trial % 5 == 0)
                bytes.resize(random() % bytes.size() + 1);
            const auto contour = readContourImage(test::writeFile(ending, bytes), 1.0);
            if (contour)
                EXPECT_GT(contourArea(*contour), 0.0);
            else
                EXPECT_FALSE(describe(contour.error()).empty());
        }
    }
}

} // namespace
} // namespace bask
