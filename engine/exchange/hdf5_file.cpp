#include "engine/exchange/hdf5_file.h"

#include "engine/base/message_code.h"

#include <hdf5.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <utility>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

namespace bask {
namespace {

constexpr std::size_t kGrowth = 16 << 20;                           // bytes that the image in memory grows by
constexpr std::size_t kWorthPacking = 4096;                         // numbers; less is not compressed
constexpr hsize_t kChunk = 1 << 16;                                 // numbers
constexpr unsigned kPacking = 4;                                    // of 9
constexpr hsize_t kMinRoomChunk = 1 << 13, kMaxRoomChunk = 1 << 17; // numbers, where the sizes have divisors
constexpr hsize_t kMaxChunkBytes = 0xffffffff;                      // of the library's
constexpr hsize_t kFirstIndexBytes = 8192, kIndexBytes = 128;       // of a file and of each room; of a chunk

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

void beQuiet() {
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); // the library would print
}

void pack(hid_t how) {
    if (H5Zfilter_avail(H5Z_FILTER_DEFLATE) <= 0)
        return;
    H5Pset_shuffle(how);
    H5Pset_deflate(how, kPacking);
}

Error unwritable(const std::string& where, const std::string& refused) {
    return {MessageCode::FileUnwritable, where, {"HDF5 refuses " + refused}};
}

/// UTF-8; a size of 0: each as long as it is.
hid_t textType(std::size_t size) {
    const hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, size == 0 ? H5T_VARIABLE : size);
    H5Tset_cset(type, H5T_CSET_UTF8);
    H5Tset_strpad(type, H5T_STR_NULLPAD);
    return type;
}

hsize_t maxDivisor(hsize_t of, hsize_t limit) {
    hsize_t divisor = std::min(of, limit);
    while (of % divisor != 0)
        --divisor;
    return divisor;
}

hsize_t minDivisor(hsize_t of, hsize_t limit) {
    return of / maxDivisor(of, std::max<hsize_t>(1, of / limit));
}

/// The chunks of a room: whole in the last sizes, a divisor of the one before, 1 in all others, so that each
/// is a range of the numbers and none is cut. Nothing if that is more than the library has in a chunk.
std::vector<hsize_t> roomChunk(const std::vector<hsize_t>& sizes) {
    std::vector<hsize_t> chunk(sizes.size(), 1);
    hsize_t numbers = 1;
    std::size_t k = sizes.size();
    while (k > 0 && numbers * sizes[k - 1] <= kMaxRoomChunk) {
        --k;
        chunk[k] = sizes[k];
        numbers *= sizes[k];
    }
    if (k == 0)
        return chunk;
    const hsize_t limit = kMaxRoomChunk / numbers;
    chunk[k - 1] = maxDivisor(sizes[k - 1], limit);
    if (numbers * chunk[k - 1] < kMinRoomChunk)
        chunk[k - 1] = minDivisor(sizes[k - 1], limit + 1);
    return numbers * chunk[k - 1] * sizeof(double) <= kMaxChunkBytes ? chunk : std::vector<hsize_t>();
}

hsize_t roomChunks(const std::vector<hsize_t>& sizes) {
    const std::vector<hsize_t> chunk = roomChunk(sizes);
    hsize_t chunks = 1;
    for (std::size_t k = 0; k < chunk.size(); ++k)
        chunks *= sizes[k] / chunk[k];
    return chunks;
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
    int memory = -1;     ///< descriptor of what is behind Backing::Sparse
    std::string refused; ///< what failed first
    struct Room {
        std::string path;
        std::vector<hsize_t> sizes, chunk; ///< no chunk: in one piece
        std::uint64_t bytes;
    };
    std::vector<Room> rooms;

    void open(Backing backing, const std::vector<std::vector<std::size_t>>& roomSizes) {
        const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
        std::string name = "bask-export-in-memory";
        if (backing == Backing::Sparse) {
            // Of tmpfs: what is not written takes no memory. The library wants a name, so a memfd will not
            // do.
            name = (::access("/dev/shm", W_OK) == 0 ? "/dev/shm" : "/tmp") + std::string("/bask-XXXXXX");
            memory = ::mkostemp(name.data(), O_CLOEXEC);
            H5Pset_file_locking(access, false, true);
            hsize_t index = kFirstIndexBytes; // in one block, or it would lie between the chunks
            for (const auto& sizes : roomSizes)
                index += kFirstIndexBytes + kIndexBytes * roomChunks({sizes.begin(), sizes.end()});
            H5Pset_meta_block_size(access, index);
        } else {
            H5Pset_fapl_core(access, kGrowth, false);
        }
        file = H5Fcreate(name.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access);
        if (memory >= 0)
            ::unlink(name.c_str());
        check(file >= 0, "/");
    }

    /// Where a room begins, if its chunks lie one after another, else nowhere.
    static haddr_t place(hid_t set, const Room& room) {
        if (room.chunk.empty())
            return H5Dget_offset(set);
        std::vector<hsize_t> at(room.sizes.size(), 0);
        haddr_t first = HADDR_UNDEF, next = HADDR_UNDEF;
        for (;;) {
            haddr_t here = HADDR_UNDEF;
            hsize_t bytes = 0;
            if (H5Dget_chunk_info_by_coord(set, at.data(), nullptr, &here, &bytes) < 0 ||
                here == HADDR_UNDEF || (first != HADDR_UNDEF && here != next))
                return HADDR_UNDEF;
            if (first == HADDR_UNDEF)
                first = here;
            next = here + bytes;
            std::size_t k = at.size(); // on to the next one, the last sizes first
            while (k > 0 && (at[k - 1] += room.chunk[k - 1]) >= room.sizes[k - 1])
                at[--k] = 0;
            if (k == 0)
                return first;
        }
    }

    /// What is in the memory from one byte to another.
    std::string bytes(std::uint64_t from, std::uint64_t to) {
        std::string out(to - from, '\0');
        const ssize_t got = ::pread(memory, out.data(), out.size(), static_cast<off_t>(from));
        check(got == static_cast<ssize_t>(out.size()), "/");
        return out;
    }

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
            pack(how);
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

Hdf5File::Hdf5File(Backing backing, const std::vector<std::vector<std::size_t>>& roomSizes)
    : m_impl(std::make_unique<Impl>()) {
    beQuiet();
    m_impl->open(backing, roomSizes);
}

Hdf5File::~Hdf5File() {
    if (m_impl->file >= 0)
        H5Fclose(m_impl->file);
    if (m_impl->memory >= 0)
        ::close(m_impl->memory);
}

std::string Hdf5File::libraryVersion() {
    unsigned major = 0, minor = 0, release = 0;
    H5get_libversion(&major, &minor, &release);
    return std::to_string(major) + '.' + std::to_string(minor) + '.' + std::to_string(release);
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

void Hdf5File::wholeNumber(const std::string& path, int value, const std::string& units) {
    m_impl->dataSet(path, H5T_NATIVE_INT, 1, true, &value);
    attribute(path, "units", units);
}

void Hdf5File::wholeNumbers(const std::string& path, std::span<const int> values, const std::string& units) {
    m_impl->dataSet(path, H5T_NATIVE_INT, values.size(), false, values.data());
    attribute(path, "units", units);
}

void Hdf5File::pictures(const std::string& path, std::size_t count, int rows, int columns) {
    const std::array<hsize_t, 3> size{count, static_cast<hsize_t>(rows), static_cast<hsize_t>(columns)};
    const std::array<hsize_t, 3> chunk{1, size[1], size[2]};
    const Handle space(H5Screate_simple(3, size.data(), nullptr), H5Sclose);
    const Handle how(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    H5Pset_obj_track_times(how, false);
    H5Pset_chunk(how, 3, chunk.data());
    pack(how);
    const Handle set(
        H5Dcreate2(m_impl->file, path.c_str(), H5T_STD_U16LE, space, H5P_DEFAULT, how, H5P_DEFAULT),
        H5Dclose);
    m_impl->check(set >= 0, path);
    attribute(path, "units", "1");
}

void Hdf5File::room(const std::string& path, const std::vector<std::size_t>& sizes,
                    const std::string& units) {
    const std::vector<hsize_t> extent(sizes.begin(), sizes.end()), chunk = roomChunk(extent);
    std::uint64_t bytes = sizeof(double);
    for (const std::size_t size : sizes)
        bytes *= size;
    const Handle space(H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr), H5Sclose);
    const Handle how(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    H5Pset_obj_track_times(how, false);
    if (!chunk.empty())
        H5Pset_chunk(how, static_cast<int>(chunk.size()), chunk.data());
    H5Pset_alloc_time(how, H5D_ALLOC_TIME_EARLY);
    H5Pset_fill_time(how, H5D_FILL_TIME_NEVER);
    const Handle set(
        H5Dcreate2(m_impl->file, path.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT, how, H5P_DEFAULT),
        H5Dclose);
    m_impl->check(set >= 0, path);
    m_impl->rooms.push_back({path, extent, chunk, bytes});
    attribute(path, "units", units);
}

Result<Hdf5Sparse> Hdf5File::sparse(const std::string& where) {
    Hdf5Sparse all;
    for (const Impl::Room& room : m_impl->rooms) {
        const Handle set(H5Dopen2(m_impl->file, room.path.c_str(), H5P_DEFAULT), H5Dclose);
        const haddr_t offset = Impl::place(set, room);
        m_impl->check(offset != HADDR_UNDEF, room.path);
        all.rooms.push_back(offset);
    }
    m_impl->check(H5Fclose(std::exchange(m_impl->file, -1)) >= 0, "/");
    const off_t size = ::lseek(m_impl->memory, 0, SEEK_END);
    m_impl->check(size > 0, "/");
    for (std::uint64_t from = 0; m_impl->refused.empty();) {
        // The next room from here on, of which there are two at most.
        std::uint64_t to = static_cast<std::uint64_t>(size), after = to;
        for (std::size_t k = 0; k < all.rooms.size(); ++k)
            if (all.rooms[k] >= from && all.rooms[k] < to) {
                to = all.rooms[k];
                after = to + m_impl->rooms[k].bytes;
            }
        all.pieces.emplace_back(from, m_impl->bytes(from, to));
        if (to == static_cast<std::uint64_t>(size))
            break;
        from = after;
    }
    all.size = static_cast<std::uint64_t>(size);
    if (!m_impl->refused.empty())
        return unwritable(where, m_impl->refused);
    return all;
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
        return unwritable(where, m_impl->refused);
    return bytes;
}

struct Hdf5Pictures::Impl {
    std::unique_lock<std::mutex> lock{library()};
    hid_t file = -1, set = -1;
    std::string path;
    hsize_t next = 0;
    std::string refused; ///< what failed first

    void check(bool done) {
        if (done || !refused.empty())
            return;
        refused = path + (errno == 0 ? "" : std::string(": ") + std::strerror(errno));
        giveUp();
    }

    /// HDF5 cannot close a file that it cannot write, and crashes when the program ends. So the rest goes to
    /// memory that nobody sees, or nowhere where a limit on the size of files holds in memory too.
    void giveUp() const {
        void* descriptor = nullptr;
        if (file < 0 || H5Fget_vfd_handle(file, H5P_DEFAULT, &descriptor) < 0)
            return;
        const int sink = errno == EFBIG ? ::open("/dev/null", O_RDWR | O_CLOEXEC)
                                        : ::memfd_create("bask-export-given-up", MFD_CLOEXEC);
        if (sink < 0)
            return;
        ::dup2(sink, *static_cast<int*>(descriptor));
        ::close(sink);
    }

    void close() {
        if (set >= 0)
            H5Dclose(std::exchange(set, -1));
        if (file >= 0)
            check(H5Fclose(std::exchange(file, -1)) >= 0);
    }
};

Hdf5Pictures::Hdf5Pictures(const std::string& file, const std::string& path)
    : m_impl(std::make_unique<Impl>()) {
    beQuiet();
    m_impl->path = path;
    errno = 0;
    const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose),
        reading(H5Pcreate(H5P_DATASET_ACCESS), H5Pclose);
    H5Pset_file_locking(access, false, true); // not every file system has locks
    H5Pset_chunk_cache(reading, 0, 0, 1.0);   // each picture is written at once
    m_impl->file = H5Fopen(file.c_str(), H5F_ACC_RDWR, access);
    m_impl->set = H5Dopen2(m_impl->file, path.c_str(), reading);
    m_impl->check(m_impl->set >= 0);
}

Hdf5Pictures::~Hdf5Pictures() {
    if (m_impl->file >= 0)
        m_impl->giveUp();
    m_impl->close();
}

void Hdf5Pictures::add(std::span<const unsigned short> values) {
    if (!m_impl->refused.empty())
        return;
    const Handle there(H5Dget_space(m_impl->set), H5Sclose);
    std::array<hsize_t, 3> size{};
    H5Sget_simple_extent_dims(there, size.data(), nullptr);
    const std::array<hsize_t, 3> first{m_impl->next++, 0, 0}, one{1, size[1], size[2]};
    const Handle here(H5Screate_simple(3, one.data(), nullptr), H5Sclose);
    errno = 0;
    m_impl->check(values.size() == size[1] * size[2] &&
                  H5Sselect_hyperslab(there, H5S_SELECT_SET, first.data(), nullptr, one.data(), nullptr) >=
                      0 &&
                  H5Dwrite(m_impl->set, H5T_NATIVE_USHORT, here, there, H5P_DEFAULT, values.data()) >= 0);
}

Result<void> Hdf5Pictures::close(const std::string& where) {
    errno = 0;
    if (m_impl->refused.empty()) // before closing, which cannot fail well
        m_impl->check(H5Dflush(m_impl->set) >= 0 && H5Fflush(m_impl->file, H5F_SCOPE_LOCAL) >= 0);
    m_impl->close();
    return m_impl->refused.empty() ? Result<void>() : unwritable(where, m_impl->refused);
}

} // namespace bask
