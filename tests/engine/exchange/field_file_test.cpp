#include "engine/base/message_code.h"
#include "engine/base/version.h"
#include "engine/exchange/field_file.h"

#include "tests/engine/exchange/read_image.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include <unistd.h>

namespace bask {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;
using Numbers = std::vector<double>;
using test::numbersIn;
using test::samplesIn;
using test::wordsIn;

const std::vector<FieldAxis> kAxes{
    {kThetaX, -1.5707963267948966, 0.034906585039886591, 4}, {kZ, 0.01, 0.1 / 3.0, 3}, {kY, -0.2, 0.05, 2}};

/// A made-up field with numbers that take all digits.
Field fieldOn(std::vector<FieldAxis> axes, bool withGradient = false) {
    Field field;
    field.axes = std::move(axes);
    field.fixed << 0.1, 0.2, 0.3, 0.4, 0.5, 1.0 / 3.0;
    field.quantity = "view_factor";
    field.tolerance = 1e-9;
    std::size_t count = 1;
    for (const FieldAxis& axis : field.axes)
        count *= static_cast<std::size_t>(axis.count);
    for (std::size_t i = 0; i < count; ++i)
        field.values.push_back(std::sin(static_cast<double>(i)));
    for (std::size_t i = 0; withGradient && i < 6 * count; ++i)
        field.gradient.push_back(std::cos(static_cast<double>(i)));
    return field;
}

class FieldFile : public testing::Test {
protected:
    FieldFile() : m_folder(fs::temp_directory_path() / ("bask-field-" + std::to_string(::getpid()))) {
        fs::create_directory(m_folder);
    }
    ~FieldFile() override { fs::remove_all(m_folder); }

    std::string path(const char* name = "field.vti") const { return (m_folder / name).string(); }
    std::size_t filesThere() const {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(m_folder), {}));
    }
    vtkSmartPointer<vtkImageData> writtenAndRead(const Field& field) {
        const auto written = writeField(field, path(), "a disk over a disk");
        EXPECT_TRUE(written) << (written ? "" : describe(written.error()));
        EXPECT_EQ(filesThere(), 1u) << "a temporary is left";
        return test::readImage(path());
    }

private:
    fs::path m_folder;
};

// Catches: axes in the wrong order, digits lost, an undefined sample that becomes a number.
TEST_F(FieldFile, threeAxesAreTheImage) {
    Field field = fieldOn(kAxes, true);
    field.values[5] = std::numeric_limits<double>::quiet_NaN();
    field.undefinedSamples = 1;
    const auto image = writtenAndRead(field);
    for (int a = 0; a < 3; ++a) {
        EXPECT_EQ(image->GetDimensions()[a], kAxes[static_cast<std::size_t>(a)].count);
        EXPECT_EQ(image->GetOrigin()[a], kAxes[static_cast<std::size_t>(a)].first);
        EXPECT_EQ(image->GetSpacing()[a], kAxes[static_cast<std::size_t>(a)].step);
    }
    EXPECT_STREQ(image->GetPointData()->GetScalars()->GetName(), "view_factor");
    Numbers values = samplesIn(image, "view_factor");
    EXPECT_TRUE(std::isnan(values[5]));
    values[5] = field.values[5] = 0.0;
    EXPECT_EQ(values, field.values);
    EXPECT_EQ(samplesIn(image, "view_factor_gradient"), field.gradient);
    EXPECT_STREQ(image->GetPointData()->GetArray("view_factor_gradient")->GetComponentName(4), "by theta_y");
    // (1, 2, 1): theta_x first
    EXPECT_EQ(image->GetScalarComponentAsDouble(1, 2, 1, 0), std::sin(1.0 + 4.0 * (2.0 + 3.0 * 1.0)));
}

// Catches: a file that does not say what was sampled where.
TEST_F(FieldFile, explainsItself) {
    const auto image = writtenAndRead(fieldOn(kAxes));
    EXPECT_EQ(wordsIn(image, "title"), Words{"a disk over a disk"});
    EXPECT_EQ(wordsIn(image, "made_by"), Words{"Bask " BASK_VERSION});
    EXPECT_EQ(wordsIn(image, "axis_names"), (Words{"theta_x", "z", "y"}));
    EXPECT_EQ(wordsIn(image, "axis_units"), (Words{"rad", "m", "m"}));
    EXPECT_EQ(numbersIn(image, "axis_first"), (Numbers{-1.5707963267948966, 0.01, -0.2}));
    EXPECT_EQ(numbersIn(image, "axis_step"), (Numbers{0.034906585039886591, 0.1 / 3.0, 0.05}));
    EXPECT_EQ(numbersIn(image, "axis_count"), (Numbers{4, 3, 2}));
    EXPECT_EQ(wordsIn(image, "held_names"), (Words{"x", "theta_y", "theta_z"}));
    EXPECT_EQ(wordsIn(image, "held_units"), (Words{"m", "rad", "rad"}));
    EXPECT_EQ(numbersIn(image, "held_values"), (Numbers{0.1, 0.5, 1.0 / 3.0}));
    EXPECT_EQ(numbersIn(image, "tolerance"), Numbers{1e-9});
    EXPECT_EQ(numbersIn(image, "undefined_samples"), Numbers{0});
}

// Catches: grids of one and two axes, and axes of one value, that VTK does not take.
TEST_F(FieldFile, fewerAxesAndSingleValuesWork) {
    const auto line = writtenAndRead(fieldOn({kAxes[1]}));
    EXPECT_EQ(line->GetNumberOfPoints(), 3);
    EXPECT_EQ(line->GetDimensions()[1], 1);
    EXPECT_EQ(samplesIn(line, "view_factor"), fieldOn({kAxes[1]}).values);
    const auto sheet = writtenAndRead(fieldOn({kAxes[1], kAxes[0]}));
    EXPECT_EQ(sheet->GetDimensions()[1], 4);
    EXPECT_EQ(sheet->GetSpacing()[1], kAxes[0].step);
    const auto point = writtenAndRead(fieldOn({{kX, 0.1, 1.0, 1}}));
    EXPECT_EQ(point->GetNumberOfPoints(), 1);
    EXPECT_EQ(point->GetOrigin()[0], 0.1);
}

// Catches: steps of the fourth axis mixed up, or an image in the wrong place.
TEST_F(FieldFile, aFourthAxisIsOneArrayAStep) {
    std::vector<FieldAxis> axes = kAxes;
    axes.push_back({kThetaZ, -0.3, 0.1, 4}); // the last one is 5.6e-17
    const Field field = fieldOn(axes, true);
    const auto image = writtenAndRead(field);
    EXPECT_EQ(image->GetOrigin()[0], axes[0].first);
    EXPECT_EQ(image->GetSpacing()[0], axes[0].step);
    EXPECT_EQ(image->GetPointData()->GetNumberOfArrays(), 8);
    EXPECT_STREQ(image->GetPointData()->GetScalars()->GetName(), "view_factor at theta_z=-0.3 rad");
    EXPECT_EQ(samplesIn(image, "view_factor at theta_z=-0.2 rad"),
              Numbers(field.values.begin() + 24, field.values.begin() + 48));
    EXPECT_EQ(samplesIn(image, "view_factor_gradient at theta_z=0 rad"),
              Numbers(field.gradient.begin() + 6 * 72, field.gradient.end()));
    EXPECT_EQ(wordsIn(image, "axis_names").back(), "theta_z");
    EXPECT_EQ(wordsIn(image, "held_names"), (Words{"x", "theta_y"}));

    axes[3] = {kThetaZ, 0.0, 1e-3, kMaxFourthAxisSamples + 1};
    const auto refused = checkFieldFile(path("other.vti"), axes);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code(), MessageCode::FieldTooLarge);
    EXPECT_NE(refused.error().where.find("theta_z"), std::string::npos);
}

TEST_F(FieldFile, namesCarryTheUnit) {
    Field field = fieldOn(kAxes);
    field.quantity = "steady_temperature";
    field.unit = "K";
    EXPECT_EQ(samplesIn(writtenAndRead(field), "steady_temperature_K"), field.values);
}

// Catches: a user's file lost to a field; a field of Bask's own or an empty file in the way of the next.
TEST_F(FieldFile, replacesNothingButFields) {
    const Field field = fieldOn(kAxes);
    std::ofstream(path()).close();
    ASSERT_TRUE(writeField(field, path(), "over an empty file"));
    ASSERT_TRUE(writeField(field, path(), "over a field"));
    EXPECT_EQ(wordsIn(test::readImage(path()), "title"), Words{"over a field"});
    for (const char* mine : {"mine", "<VTKFile type=\"ImageData\" version=\"1.0\">", "made_by"}) {
        std::ofstream(path("mine.vti")) << mine;
        EXPECT_FALSE(checkFieldFile(path("mine.vti"), field.axes));
        const auto written = writeField(field, path("mine.vti"), "");
        ASSERT_FALSE(written);
        EXPECT_EQ(written.error().code(), MessageCode::OutputForeign);
        EXPECT_EQ(fs::file_size(path("mine.vti")), std::string(mine).size());
    }
    EXPECT_EQ(filesThere(), 2u);
}

// Catches: a link replaced by a file.
TEST_F(FieldFile, writesWhereALinkLeads) {
    ASSERT_TRUE(writeField(fieldOn(kAxes), path(), "first"));
    fs::create_symlink("field.vti", path("link.vti"));
    ASSERT_TRUE(writeField(fieldOn(kAxes), path("link.vti"), "second"));
    EXPECT_TRUE(fs::is_symlink(path("link.vti")));
    EXPECT_EQ(wordsIn(test::readImage(path()), "title"), Words{"second"});
}

// Catches: an unwritable place that is a success, or VTK's own words on standard error.
TEST_F(FieldFile, anUnwritablePlaceIsAnError) {
    testing::internal::CaptureStderr();
    const auto written = writeField(fieldOn(kAxes), path("no/such/folder.vti"), "");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().code(), MessageCode::FileUnwritable);
    fs::create_directory(path("folder.vti"));
    EXPECT_FALSE(writeField(fieldOn(kAxes), path("folder.vti"), ""));
    EXPECT_EQ(filesThere(), 1u);
}

} // namespace
} // namespace bask
