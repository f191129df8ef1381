#include "engine/exchange/field_store.h"

#include "engine/base/hidden_folder.h"
#include "engine/base/message_code.h"
#include "engine/base/version.h"
#include "engine/exchange/hdf5_file.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

namespace bask {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMark = "Bask field"; ///< in the attribute creator, near the file's beginning
constexpr std::size_t kMarkWithin = 1 << 16;
constexpr double kSkeletonBytes = 64e6; ///< more than the axes and what explains them take

void addAxes(Hdf5File& file, const Field& header) {
    for (const FieldAxis& axis : header.axes) {
        std::vector<double> values;
        values.reserve(static_cast<std::size_t>(axis.count));
        for (int i = 0; i < axis.count; ++i)
            values.push_back(axis.at(i));
        file.numbers(std::string("/entry/field/") + kCoordinateNames[axis.coordinate], values,
                     coordinateUnit(axis.coordinate));
    }
    file.group("/entry/held", "NXcollection");
    for (int k = 0; k < 6; ++k)
        if (const auto coordinate = static_cast<Coordinate>(k);
            std::ranges::find(header.axes, coordinate, &FieldAxis::coordinate) == header.axes.end())
            file.number(std::string("/entry/held/") + kCoordinateNames[coordinate], header.fixed[k],
                        coordinateUnit(coordinate));
}

/// Everything but the samples: always of one layout, whatever the tally.
Result<Hdf5Sparse> skeleton(const std::string& where, const Field& header, bool withGradient,
                            const std::string& title, const FieldTally& tally) {
    std::vector<std::string> names;
    std::vector<std::vector<std::size_t>> rooms(withGradient ? 2 : 1);
    for (const FieldAxis& axis : header.axes) {
        names.emplace_back(kCoordinateNames[axis.coordinate]);
        rooms[0].push_back(static_cast<std::size_t>(axis.count));
    }
    std::ranges::reverse(names); // the first axis runs fastest
    std::ranges::reverse(rooms[0]);
    if (withGradient) {
        rooms[1] = rooms[0];
        rooms[1].push_back(kCoordinateNames.size());
    }
    Hdf5File file(Hdf5File::Backing::Sparse, rooms);
    file.attribute("/", "creator", kMark);
    file.attribute("/", "creator_version", BASK_VERSION);
    file.attribute("/", "NX_class", "NXroot");
    file.attribute("/", "default", "entry");
    file.group("/entry", "NXentry");
    file.attribute("/entry", "default", "field");
    file.text("/entry/title", title);
    file.group("/entry/field", "NXdata");
    file.attribute("/entry/field", "signal", header.quantity);
    file.attribute("/entry/field", "axes", names);
    addAxes(file, header);
    file.group("/entry/sampling", "NXcollection");
    file.number("/entry/sampling/tolerance", header.tolerance, "1");
    file.number("/entry/sampling/undefined_samples", static_cast<double>(tally.undefined), "1");
    file.number("/entry/sampling/samples_above_tolerance", static_cast<double>(tally.unreached), "1");
    file.number("/entry/sampling/largest_error_estimate", tally.largestError, "1");
    file.number("/entry/sampling/rough_shade", header.isShadeRough ? 1.0 : 0.0, "1");
    file.room("/entry/field/" + header.quantity, rooms[0], header.unit.empty() ? "1" : header.unit);
    if (withGradient)
        file.room("/entry/field/view_factor_gradient", rooms[1], "1/m, 1/rad");
    return file.sparse(where);
}

Result<void> writeAt(int file, const std::string& path, std::uint64_t offset, const char* bytes,
                     std::size_t size) {
    while (size > 0) {
        const ssize_t written = ::pwrite(file, bytes, size, static_cast<off_t>(offset));
        if (written < 0 && errno == EINTR)
            continue;
        if (written <= 0)
            return Error(MessageCode::FileUnwritable, path, {std::strerror(errno)});
        bytes += written;
        size -= static_cast<std::size_t>(written);
        offset += static_cast<std::uint64_t>(written);
    }
    return {};
}

Result<void> writeNumbers(int file, const std::string& path, std::uint64_t offset,
                          std::span<const double> numbers) {
    return writeAt(file, path, offset, reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes());
}

} // namespace

Result<void> checkFieldStore(const std::string& path) {
    std::ifstream old(path, std::ios::binary);
    std::string beginning(kMarkWithin, '\0');
    old.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
    beginning.resize(static_cast<std::size_t>(std::max<std::streamsize>(old.gcount(), 0)));
    if (!beginning.empty() && beginning.find(kMark) == std::string::npos)
        return Error(MessageCode::OutputForeign, path, {"a field written by Bask"});
    return {};
}

double fieldStoreBytes(const Field& header, bool withGradient) {
    return static_cast<double>(sampleCount(header.axes)) * sizeof(double) * (withGradient ? 7.0 : 1.0);
}

struct FieldStore::Impl {
    std::string path, title;
    Field header;
    bool withGradient = false;
    std::optional<HiddenFolder> hidden; ///< what has the file until it is whole
    std::string staged;                 ///< path in it
    int file = -1;
    std::vector<std::uint64_t> rooms;

    Result<void> refuse() const { return Error(MessageCode::FileUnwritable, path, {std::strerror(errno)}); }
    Result<void> writeSkeleton(const Hdf5Sparse& all) const {
        for (const auto& [offset, bytes] : all.pieces)
            if (auto written = writeAt(file, path, offset, bytes.data(), bytes.size()); !written)
                return written;
        return {};
    }
};

FieldStore::FieldStore(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}

FieldStore::~FieldStore() {
    if (m_impl->file >= 0)
        ::close(m_impl->file);
}

Result<std::unique_ptr<FieldStore>> FieldStore::create(const std::string& path, const Field& header,
                                                       bool withGradient, const std::string& title) {
    if (const auto place = checkFieldStore(path); !place)
        return place.error();
    // A limit on the size of files holds for the skeleton too, and the library does not survive it.
    if (rlimit limit{};
        ::getrlimit(RLIMIT_FSIZE, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY &&
        fieldStoreBytes(header, withGradient) + kSkeletonBytes > static_cast<double>(limit.rlim_cur))
        return Error(MessageCode::FileUnwritable, path, {std::strerror(EFBIG)});
    const auto all = skeleton(path, header, withGradient, title, {});
    if (!all)
        return all.error();
    std::unique_ptr<FieldStore> store(new FieldStore(std::make_unique<Impl>()));
    Impl& impl = *store->m_impl;
    impl.path = behindLinks(path);
    impl.title = title;
    impl.header = header;
    impl.withGradient = withGradient;
    impl.rooms = all->rooms;
    auto hidden = HiddenFolder::in(folderOfFile(impl.path));
    if (!hidden)
        return Error(MessageCode::FileUnwritable, path, hidden.error().message.args);
    impl.staged = hidden->place(fs::path(impl.path).filename().string());
    impl.hidden.emplace(std::move(*hidden));
    impl.file = ::open(impl.staged.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (impl.file < 0)
        return impl.refuse().error();
    const auto size = static_cast<off_t>(all->size);
    while (::fallocate(impl.file, 0, 0, size) != 0) {
        if (errno == EINTR)
            continue;
        if ((errno != EOPNOTSUPP && errno != ENOSYS) || ::ftruncate(impl.file, size) != 0)
            return impl.refuse().error();
        break; // a file system that cannot take room beforehand
    }
    return store;
}

Result<void> FieldStore::write(std::size_t begin, std::span<const double> values,
                               std::span<const double> gradient) {
    if (gradient.size() != (m_impl->withGradient ? 6 * values.size() : 0))
        throw std::invalid_argument("FieldStore: six numbers of gradient for each sample, or none");
    auto written =
        writeNumbers(m_impl->file, m_impl->path, m_impl->rooms[0] + begin * sizeof(double), values);
    if (written && m_impl->withGradient)
        written =
            writeNumbers(m_impl->file, m_impl->path, m_impl->rooms[1] + 6 * begin * sizeof(double), gradient);
    return written;
}

Result<void> FieldStore::finish(const FieldTally& tally) {
    Impl& impl = *m_impl;
    const auto all = skeleton(impl.path, impl.header, impl.withGradient, impl.title, tally);
    if (!all)
        return all.error();
    if (all->rooms != impl.rooms)
        throw std::logic_error("FieldStore: two layouts of one field");
    if (auto written = impl.writeSkeleton(*all); !written)
        return written;
    if (::fsync(impl.file) != 0 || ::rename(impl.staged.c_str(), impl.path.c_str()) != 0)
        return impl.refuse();
    impl.hidden.reset();
    return {};
}

} // namespace bask
