#include "engine/recording/hdf5_file.h"

#include "engine/base/message_code.h"

#include <hdf5.h>

#include <algorithm>
#include <array>
#include <mutex>

namespace bask {
namespace {

constexpr std::size_t kGrowth = 16 << 20;   // bytes that the image in memory grows by
constexpr std::size_t kWorthPacking = 4096; // numbers; less is not compressed
constexpr hsize_t kChunk = 1 << 16;         // numbers
constexpr unsigned kPacking = 4;            // of 9

std::mutex& library() {
    static std::mutex mutex;
    return mutex;
}

/// A handle and how it is closed.
class Handle {
public:
    Handle(hid_t id, herr_t (*close)(hid_t)) : m_id(id), m_close(close) {}
    ~Handle() {
        if (m_id >= 0)
            m_close(m_id);
    }
    operator hid_t() const { return m_id; }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;

private:
    hid_t m_id;
    herr_t (*m_close)(hid_t);
};

/// UTF-8; a size of 0: each as long as it is.
hid_t textType(std::size_t size) {
    const hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, size == 0 ? H5T_VARIABLE : size);
    H5Tset_cset(type, H5T_CSET_UTF8);
    H5Tset_strpad(type, H5T_STR_NULLPAD);
    return type;
}

std::vector<const char*> pointers(const std::vector<std::string>& texts) {
    std::vector<const char*> out;
    for (const std::string& text : texts)
        out.push_back(text.c_str());
    return out;
}

} // namespace

struct Hdf5File::Impl {
    std::unique_lock<std::mutex> lock{library()};
    hid_t file = -1;
    std::string refused; ///< what failed first

    void check(bool done, const std::string& what) {
        if (!done && refused.empty())
            refused = what;
    }

    void dataSet(const std::string& path, hid_t type, hsize_t count, bool isScalar, const void* values) {
        const Handle space(isScalar ? H5Screate(H5S_SCALAR) : H5Screate_simple(1, &count, nullptr), H5Sclose);
        const Handle how(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
        H5Pset_obj_track_times(how, false); // the same session, the same bytes
        if (count >= kWorthPacking && H5Zfilter_avail(H5Z_FILTER_DEFLATE) > 0) {
            const hsize_t chunk = std::min(count, kChunk);
            H5Pset_chunk(how, 1, &chunk);
            H5Pset_shuffle(how);
            H5Pset_deflate(how, kPacking);
        }
        const Handle set(H5Dcreate2(file, path.c_str(), type, space, H5P_DEFAULT, how, H5P_DEFAULT),
                         H5Dclose);
        check(set >= 0 && (count == 0 || H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0),
              path);
    }

    void attribute(const std::string& path, const std::string& name, hid_t type, hid_t space,
                   const void* values) {
        const Handle made(H5Acreate_by_name(file, path.c_str(), name.c_str(), type, space, H5P_DEFAULT,
                                            H5P_DEFAULT, H5P_DEFAULT),
                          H5Aclose);
        check(made >= 0 && H5Awrite(made, type, values) >= 0, path + "@" + name);
    }
};

Hdf5File::Hdf5File() : m_impl(std::make_unique<Impl>()) {
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); // it would print
    const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    H5Pset_fapl_core(access, kGrowth, false);
    m_impl->file = H5Fcreate("bask-export-in-memory", H5F_ACC_TRUNC, H5P_DEFAULT, access);
    m_impl->check(m_impl->file >= 0, "/");
}

Hdf5File::~Hdf5File() {
    if (m_impl->file >= 0)
        H5Fclose(m_impl->file);
}

void Hdf5File::group(const std::string& path, const std::string& nxClass) {
    const Handle made(H5Gcreate2(m_impl->file, path.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                      H5Gclose);
    m_impl->check(made >= 0, path);
    attribute(path, "NX_class", nxClass);
}

void Hdf5File::attribute(const std::string& path, const std::string& name, const std::string& text) {
    const Handle type(textType(text.size() + 1), H5Tclose), space(H5Screate(H5S_SCALAR), H5Sclose);
    m_impl->attribute(path, name, type, space, text.c_str());
}

void Hdf5File::attribute(const std::string& path, const std::string& name,
                         const std::vector<std::string>& texts) {
    const hsize_t count = texts.size();
    const Handle type(textType(0), H5Tclose), space(H5Screate_simple(1, &count, nullptr), H5Sclose);
    m_impl->attribute(path, name, type, space, pointers(texts).data());
}

void Hdf5File::text(const std::string& path, const std::string& text) {
    const Handle type(textType(text.size() + 1), H5Tclose);
    m_impl->dataSet(path, type, 1, true, text.c_str());
}

void Hdf5File::texts(const std::string& path, const std::vector<std::string>& texts) {
    const Handle type(textType(0), H5Tclose);
    m_impl->dataSet(path, type, texts.size(), false, pointers(texts).data());
}

void Hdf5File::number(const std::string& path, double value, const std::string& units) {
    m_impl->dataSet(path, H5T_NATIVE_DOUBLE, 1, true, &value);
    attribute(path, "units", units);
}

void Hdf5File::numbers(const std::string& path, std::span<const double> values, const std::string& units) {
    m_impl->dataSet(path, H5T_NATIVE_DOUBLE, values.size(), false, values.data());
    attribute(path, "units", units);
}

void Hdf5File::wholeNumbers(const std::string& path, std::span<const int> values, const std::string& units) {
    m_impl->dataSet(path, H5T_NATIVE_INT, values.size(), false, values.data());
    attribute(path, "units", units);
}

void Hdf5File::link(const std::string& there, const std::string& path) {
    m_impl->check(H5Lcreate_hard(m_impl->file, there.c_str(), H5L_SAME_LOC, path.c_str(), H5P_DEFAULT,
                                 H5P_DEFAULT) >= 0,
                  path);
}

Result<std::string> Hdf5File::image(const std::string& where) {
    m_impl->check(H5Fflush(m_impl->file, H5F_SCOPE_LOCAL) >= 0, "/");
    std::string bytes;
    if (m_impl->refused.empty()) {
        const ssize_t size = H5Fget_file_image(m_impl->file, nullptr, 0);
        bytes.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
        m_impl->check(size > 0 && H5Fget_file_image(m_impl->file, bytes.data(), bytes.size()) == size, "/");
    }
    if (!m_impl->refused.empty())
        return Error(MessageCode::FileUnwritable, where, {"HDF5 refuses " + m_impl->refused});
    return bytes;
}

} // namespace bask
