// Fields as HDF5 files, read back with the library alone.

#include "engine/exchange/field_store.h"

#include "engine/base/message_code.h"

#include <gtest/gtest.h>
#include <hdf5.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <numeric>

#include <sys/resource.h>
#include <unistd.h>

namespace bask {
namespace {

namespace fs = std::filesystem;

class FieldStoreFile : public testing::Test {
protected:
    FieldStoreFile() : m_folder(fs::temp_directory_path() / ("bask-store-" + std::to_string(::getpid()))) {
        fs::create_directory(m_folder);
    }
    ~FieldStoreFile() override { fs::remove_all(m_folder); }

    std::string path(const char* name = "field.h5") const { return (m_folder / name).string(); }
    std::size_t filesThere() const {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(m_folder), {}));
    }

    fs::path m_folder;
};

/// Six axes of 2, 3, 1, 2, 2 and 5 values.
Field header() {
    Field field;
    for (const auto& [coordinate, count] :
         {std::pair{kX, 2}, {kY, 3}, {kZ, 1}, {kThetaX, 2}, {kThetaY, 2}, {kThetaZ, 5}})
        field.axes.push_back({coordinate, 0.1 * static_cast<int>(coordinate), 0.01, count});
    field.quantity = "view_factor";
    field.tolerance = 1e-9;
    return field;
}

std::vector<double> numbersOf(const std::string& file, const char* name,
                              std::vector<hsize_t>* extent = nullptr) {
    const hid_t in = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    const hid_t set = H5Dopen2(in, name, H5P_DEFAULT);
    EXPECT_GE(set, 0) << name;
    const hid_t space = H5Dget_space(set);
    std::vector<double> numbers(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
    if (extent) {
        extent->resize(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
        H5Sget_simple_extent_dims(space, extent->data(), nullptr);
    }
    EXPECT_GE(H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()), 0);
    H5Sclose(space);
    H5Dclose(set);
    H5Fclose(in);
    return numbers;
}

// Catches: samples in another order, ranges in the wrong place, a layout that moves when the tally is known.
TEST_F(FieldStoreFile, hasEverySampleInItsPlace) {
    const Field field = header();
    std::vector<double> values(120), gradient(720);
    std::iota(values.begin(), values.end(), 0.5);
    std::iota(gradient.begin(), gradient.end(), 1000.25);
    {
        const auto store = FieldStore::create(path(), field, true, "a disk");
        ASSERT_TRUE(store) << describe(store.error());
        const std::span all(values);
        const std::span slopes(gradient);
        ASSERT_TRUE((*store)->write(70, all.subspan(70), slopes.subspan(420))); // in any order
        ASSERT_TRUE((*store)->write(0, all.first(70), slopes.first(420)));
        EXPECT_FALSE(fs::exists(path()));
        ASSERT_TRUE((*store)->finish({3, 2, 0.125}));
    }
    EXPECT_EQ(filesThere(), 1U);
    std::vector<hsize_t> extent;
    EXPECT_EQ(numbersOf(path(), "/entry/field/view_factor", &extent), values);
    EXPECT_EQ(extent, (std::vector<hsize_t>{5, 2, 2, 1, 3, 2})) << "the first axis runs fastest";
    EXPECT_EQ(numbersOf(path(), "/entry/field/view_factor_gradient", &extent), gradient);
    EXPECT_EQ(extent, (std::vector<hsize_t>{5, 2, 2, 1, 3, 2, 6}));
    EXPECT_EQ(numbersOf(path(), "/entry/field/theta_z").size(), 5U);
    EXPECT_EQ(numbersOf(path(), "/entry/field/x"),
              (std::vector<double>{field.axes[0].at(0), field.axes[0].at(1)}));
    EXPECT_EQ(numbersOf(path(), "/entry/sampling/undefined_samples"), std::vector{3.0});
    EXPECT_EQ(numbersOf(path(), "/entry/sampling/largest_error_estimate"), std::vector{0.125});
    EXPECT_TRUE(checkFieldStore(path())) << "may be replaced by the next";
}

std::vector<hsize_t> chunkOf(const std::string& file, const char* name) {
    const hid_t in = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    const hid_t set = H5Dopen2(in, name, H5P_DEFAULT);
    const hid_t how = H5Dget_create_plist(set);
    std::vector<hsize_t> chunk;
    if (H5Pget_layout(how) == H5D_CHUNKED) {
        chunk.resize(H5S_MAX_RANK);
        chunk.resize(static_cast<std::size_t>(H5Pget_chunk(how, H5S_MAX_RANK, chunk.data())));
    }
    H5Pclose(how);
    H5Dclose(set);
    H5Fclose(in);
    return chunk;
}

// Catches: samples in another order where there are many chunks, chunks so small that there are millions of
// them, sizes without divisors.
TEST_F(FieldStoreFile, liesInChunksThatAreRangesOfItsSamples) {
    struct Case {
        std::vector<int> counts; ///< the first axis runs fastest
        std::vector<hsize_t> chunk, gradientChunk;
    };
    const Case cases[] = {
        {{4, 3}, {3, 4}, {3, 4, 6}},                                         // small: one
        {{64, 64, 128}, {32, 64, 64}, {4, 64, 64, 6}},                       // of a megabyte, and not more
        {{521, 521}, {521, 521}, {521, 521, 6}},                             // without a divisor: larger
        {{50, 6, 7, 5, 41, 3}, {1, 1, 5, 7, 6, 50}, {1, 1, 5, 7, 6, 50, 6}}, // of three axes one each
    };
    for (const Case& one : cases) {
        Field field = header();
        field.axes.clear();
        std::size_t count = 1;
        for (std::size_t k = 0; k < one.counts.size(); ++k) {
            field.axes.push_back({static_cast<Coordinate>(k), 0.1, 0.01, one.counts[k]});
            count *= static_cast<std::size_t>(one.counts[k]);
        }
        std::vector<double> values(count), gradient(6 * count);
        std::iota(values.begin(), values.end(), 0.5);
        std::iota(gradient.begin(), gradient.end(), 1000.25);
        {
            const auto store = FieldStore::create(path(), field, true, "a disk");
            ASSERT_TRUE(store) << describe(store.error());
            ASSERT_TRUE((*store)->write(0, values, gradient));
            ASSERT_TRUE((*store)->finish({}));
        }
        EXPECT_EQ(chunkOf(path(), "/entry/field/view_factor"), one.chunk);
        EXPECT_EQ(chunkOf(path(), "/entry/field/view_factor_gradient"), one.gradientChunk);
        EXPECT_EQ(numbersOf(path(), "/entry/field/view_factor"), values);
        EXPECT_EQ(numbersOf(path(), "/entry/field/view_factor_gradient"), gradient);
        EXPECT_LT(fs::file_size(path()), 56 * count + 100'000) << "room for the index";
    }
}

TEST_F(FieldStoreFile, replacesNoForeignFile) {
    std::ofstream(path()) << "mine";
    const auto store = FieldStore::create(path(), header(), false, "");
    ASSERT_FALSE(store);
    EXPECT_EQ(store.error().code(), MessageCode::OutputForeign);
    std::ofstream(path("empty.h5")) << "";
    EXPECT_TRUE(FieldStore::create(path("empty.h5"), header(), false, ""));
    EXPECT_FALSE(FieldStore::create(path("no/folder.h5"), header(), false, ""));
    EXPECT_EQ(filesThere(), 2U);
}

// A limit on the size of files stands for a full disk: told before the sampling.
TEST_F(FieldStoreFile, takesItsRoomAtOnceOrNotAtAll) {
    Field field = header();
    field.axes[2].count = 1000;
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit old{}, tight{};
    getrlimit(RLIMIT_FSIZE, &old);
    tight = {100'000, old.rlim_max};
    setrlimit(RLIMIT_FSIZE, &tight);
    const auto store = FieldStore::create(path(), field, false, "");
    setrlimit(RLIMIT_FSIZE, &old);
    ASSERT_FALSE(store);
    EXPECT_EQ(store.error().code(), MessageCode::FileUnwritable);
    EXPECT_EQ(filesThere(), 0U);
}

// Catches: what is left of a field that was given up.
TEST_F(FieldStoreFile, leavesNothingHalf) {
    { ASSERT_TRUE(FieldStore::create(path(), header(), false, "")); }
    EXPECT_EQ(filesThere(), 0U);
}

} // namespace
} // namespace bask
