// Surfaces as .vtp, read back as ParaView does.

#include "engine/base/message_code.h"
#include "engine/base/version.h"
#include "engine/exchange/field_file.h"

#include "tests/engine/exchange/read_image.h"

#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <filesystem>
#include <fstream>

#include <unistd.h>

namespace bask {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;
using Numbers = std::vector<double>;
using test::numbersIn;
using test::samplesIn;
using test::wordsIn;

Field field() {
    Field made;
    made.axes = {{kX, -0.2, 0.01, 41}, {kY, -0.2, 0.01, 41}, {kZ, 0.01, 0.01, 30}};
    made.fixed << 9.0, 9.0, 9.0, 0.1, 0.2, 1.0 / 3.0;
    made.tolerance = 1e-6;
    return made;
}

/// Two made-up surfaces: a triangle, and two that share an edge.
SurfaceSet twoSurfaces() {
    SurfaceSet set;
    set.title = "two sheets";
    set.steadyTemperatures_K = {313.15, 323.15};
    Isosurface one;
    one.value = 1.0 / 3.0;
    one.points = {{0.1, 0.0, 1.0 / 7.0}, {0.2, 0.0, 0.1}, {0.1, 0.1, 0.1}};
    one.normals = {{0, 0, 1}, {0, 1, 0}, {0.6, 0.8, 0}};
    one.triangles = {{0, 1, 2}};
    Isosurface two;
    two.value = 0.65;
    two.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    two.normals.assign(4, Eigen::Vector3d::UnitZ());
    two.triangles = {{0, 1, 2}, {0, 2, 3}};
    set.surfaces = {one, two};
    return set;
}

class SurfaceFile : public testing::Test {
protected:
    SurfaceFile() : m_folder(fs::temp_directory_path() / ("bask-surface-" + std::to_string(::getpid()))) {
        fs::create_directory(m_folder);
    }
    ~SurfaceFile() override { fs::remove_all(m_folder); }

    std::string path(const char* name = "surface.vtp") const { return (m_folder / name).string(); }
    std::size_t filesThere() const {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(m_folder), {}));
    }
    vtkSmartPointer<vtkPolyData> writtenAndRead(const SurfaceSet& set) {
        const auto written = writeSurfaces(field(), set, path());
        EXPECT_TRUE(written) << (written ? "" : describe(written.error()));
        EXPECT_EQ(filesThere(), 1u) << "a temporary is left";
        vtkNew<vtkXMLPolyDataReader> reader;
        EXPECT_TRUE(reader->CanReadFile(path().c_str()));
        reader->SetFileName(path().c_str());
        reader->Update();
        return reader->GetOutput();
    }

private:
    fs::path m_folder;
};

// Catches: points cut to single precision, triangles of the second surface that use the first one's points,
// values or temperatures at the wrong surface.
TEST_F(SurfaceFile, holdsEverySurface) {
    const auto data = writtenAndRead(twoSurfaces());
    ASSERT_EQ(data->GetNumberOfPoints(), 7);
    EXPECT_EQ(data->GetPoint(0)[2], 1.0 / 7.0);
    EXPECT_EQ(data->GetPoint(5)[1], 1.0);
    ASSERT_EQ(data->GetNumberOfPolys(), 3);
    const vtkIdType* corners = nullptr;
    vtkIdType count = 0;
    data->GetCellPoints(2, count, corners);
    EXPECT_EQ(std::vector<vtkIdType>(corners, corners + count), (std::vector<vtkIdType>{3, 5, 6}));
    EXPECT_EQ(samplesIn(data, "view_factor"), (Numbers{1 / 3.0, 1 / 3.0, 1 / 3.0, 0.65, 0.65, 0.65, 0.65}));
    EXPECT_EQ(samplesIn(data, "steady_temperature_K"),
              (Numbers{313.15, 313.15, 313.15, 323.15, 323.15, 323.15, 323.15}));
    ASSERT_TRUE(data->GetPointData()->GetNormals());
    EXPECT_EQ(data->GetPointData()->GetNormals()->GetComponent(2, 1), 0.8);
    EXPECT_STREQ(data->GetPointData()->GetScalars()->GetName(), "view_factor");
}

// Catches: a file that does not say what it shows, in which coordinates and with which held.
TEST_F(SurfaceFile, explainsItself) {
    const auto data = writtenAndRead(twoSurfaces());
    EXPECT_EQ(wordsIn(data, "title"), Words{"two sheets"});
    EXPECT_EQ(wordsIn(data, "made_by"), Words{"Bask " BASK_VERSION});
    EXPECT_EQ(wordsIn(data, "axis_names"), (Words{"x", "y", "z"}));
    EXPECT_EQ(wordsIn(data, "axis_units"), (Words{"m", "m", "m"}));
    EXPECT_EQ(numbersIn(data, "axis_count"), (Numbers{41, 41, 30}));
    EXPECT_EQ(wordsIn(data, "held_names"), (Words{"theta_x", "theta_y", "theta_z"}));
    EXPECT_EQ(numbersIn(data, "held_values"), (Numbers{0.1, 0.2, 1.0 / 3.0}));
    EXPECT_EQ(numbersIn(data, "values"), (Numbers{1.0 / 3.0, 0.65}));
    EXPECT_EQ(numbersIn(data, "tolerance"), Numbers{1e-6});
}

// Catches: a crash on surfaces without triangles or without temperatures.
TEST_F(SurfaceFile, emptySurfacesAreEmpty) {
    const auto data = writtenAndRead({{Isosurface{0.9, {}, {}, {}}}, {}, "nothing"});
    EXPECT_EQ(data->GetNumberOfPolys(), 0);
    EXPECT_EQ(data->GetPointData()->GetArray("steady_temperature_K"), nullptr);
    EXPECT_EQ(numbersIn(data, "values"), Numbers{0.9});
}

// Catches: a user's file, or a field of Bask's, lost to surfaces; an unwritable place that is a success.
TEST_F(SurfaceFile, replacesNothingButSurfaces) {
    ASSERT_TRUE(writeSurfaces(field(), twoSurfaces(), path()));
    ASSERT_TRUE(writeSurfaces(field(), twoSurfaces(), path())) << "its own are replaced";
    for (const char* mine :
         {"mine", "<VTKFile type=\"ImageData\" Name=\"made_by\"", "<VTKFile type=\"PolyData\""}) {
        std::ofstream(path("mine.vtp")) << mine;
        const auto written = writeSurfaces(field(), twoSurfaces(), path("mine.vtp"));
        ASSERT_FALSE(written);
        EXPECT_EQ(written.error().code(), MessageCode::OutputForeign);
        EXPECT_EQ(fs::file_size(path("mine.vtp")), std::string(mine).size());
    }
    const auto nowhere = writeSurfaces(field(), twoSurfaces(), path("no/such.vtp"));
    ASSERT_FALSE(nowhere);
    EXPECT_EQ(nowhere.error().code(), MessageCode::FileUnwritable);
}

} // namespace
} // namespace bask
