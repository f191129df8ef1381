#include "app/drawing/field_blocks.h"

#include "app/commands/progress.h"
#include "engine/base/message_code.h"
#include "engine/base/parallel.h"
#include "engine/exchange/field_file.h"
#include "engine/exchange/field_store.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstring>
#include <filesystem>
#include <memory>
#include <mutex>

namespace bask {
namespace {

constexpr const char* kImage = ".vti";
constexpr const char* kStore = ".h5";
constexpr std::size_t kImageAxes = 4;

std::size_t blocksOf(std::size_t samples) {
    return (samples + kFieldBlock - 1) / kFieldBlock;
}

/// A block's samples and what is to be told of them.
struct Block {
    std::size_t begin = 0;
    FieldFigures figures;
    std::vector<double> values, gradient;
};

Block sampled(const FieldSampler& sampler, std::size_t index, bool withGradient) {
    Block block;
    block.begin = index * kFieldBlock;
    const std::size_t end = std::min(block.begin + kFieldBlock, sampler.samples());
    block.values.resize(end - block.begin);
    block.gradient.resize(withGradient ? 6 * block.values.size() : 0);
    block.figures.tally =
        sampler.sample(block.begin, end, block.values.data(), withGradient ? block.gradient.data() : nullptr);
    for (const double value : block.values) { // comparisons with NaN are false
        block.figures.min = value < block.figures.min ? value : block.figures.min;
        block.figures.max = value > block.figures.max ? value : block.figures.max;
    }
    return block;
}

/// What is in front of a block's numbers in a record.
struct BlockHead {
    std::uint64_t undefined = 0, unreached = 0;
    double largestError = 0.0, min = 0.0, max = 0.0;
};

std::string bytesOf(const Block& block) {
    const FieldFigures& f = block.figures;
    const BlockHead head{f.tally.undefined, f.tally.unreached, f.tally.largestError, f.min, f.max};
    const std::size_t values = block.values.size() * sizeof(double),
                      gradient = block.gradient.size() * sizeof(double);
    std::string bytes(sizeof head + values + gradient, '\0');
    std::memcpy(bytes.data(), &head, sizeof head);
    std::memcpy(bytes.data() + sizeof head, block.values.data(), values);
    if (gradient > 0)
        std::memcpy(bytes.data() + sizeof head + values, block.gradient.data(), gradient);
    return bytes;
}

std::optional<Block> blockOf(const std::string& bytes, std::size_t index, std::size_t samples,
                             bool withGradient) {
    Block block;
    block.begin = index * kFieldBlock;
    const std::size_t count = std::min(kFieldBlock, samples - block.begin);
    const std::size_t values = count * sizeof(double), gradient = withGradient ? 6 * values : 0;
    BlockHead head;
    if (bytes.size() != sizeof head + values + gradient)
        return std::nullopt;
    std::memcpy(&head, bytes.data(), sizeof head);
    block.figures = {{head.undefined, head.unreached, head.largestError}, head.min, head.max};
    block.values.resize(count);
    std::memcpy(block.values.data(), bytes.data() + sizeof head, values);
    block.gradient.resize(withGradient ? 6 * count : 0);
    if (withGradient)
        std::memcpy(block.gradient.data(), bytes.data() + sizeof head + values, gradient);
    return block;
}

/// Where blocks go. Thread-safe.
class FieldSink {
public:
    virtual ~FieldSink() = default;
    virtual Result<void> take(const Block& block) = 0;
    virtual Result<void> finish(const FieldTally& tally) = 0;
};

class NoSink : public FieldSink {
public:
    Result<void> take(const Block&) override { return {}; }
    Result<void> finish(const FieldTally&) override { return {}; }
};

/// In memory until the end: VTK's images are written at once.
class ImageSink : public FieldSink {
public:
    ImageSink(const Field& header, const FieldFile& file) : m_field(header), m_file(file) {
        m_field.values.resize(sampleCount(header.axes));
        m_field.gradient.resize(file.withGradient ? 6 * m_field.values.size() : 0);
    }
    Result<void> take(const Block& block) override {
        std::ranges::copy(block.values, m_field.values.begin() + static_cast<std::ptrdiff_t>(block.begin));
        std::ranges::copy(block.gradient,
                          m_field.gradient.begin() + static_cast<std::ptrdiff_t>(6 * block.begin));
        return {};
    }
    Result<void> finish(const FieldTally& tally) override {
        m_field.undefinedSamples = tally.undefined;
        m_field.unreachedSamples = tally.unreached;
        m_field.largestErrorEstimate = tally.largestError;
        return writeField(m_field, m_file.path, m_file.title);
    }

private:
    Field m_field;
    FieldFile m_file;
};

class StoreSink : public FieldSink {
public:
    explicit StoreSink(std::unique_ptr<FieldStore> store) : m_store(std::move(store)) {}
    Result<void> take(const Block& block) override {
        return m_store->write(block.begin, block.values, block.gradient);
    }
    Result<void> finish(const FieldTally& tally) override { return m_store->finish(tally); }

private:
    std::unique_ptr<FieldStore> m_store;
};

Result<std::unique_ptr<FieldSink>> sinkOf(const FieldFile& file, const Field& header) {
    if (file.path.empty())
        return std::unique_ptr<FieldSink>(std::make_unique<NoSink>());
    if (auto place = checkFieldOutput(file.path, header.axes, file.withGradient); !place)
        return place.error();
    if (std::filesystem::path(file.path).extension() == kImage)
        return std::unique_ptr<FieldSink>(std::make_unique<ImageSink>(header, file));
    auto store = FieldStore::create(file.path, header, file.withGradient, file.title);
    if (!store)
        return store.error();
    return std::unique_ptr<FieldSink>(std::make_unique<StoreSink>(std::move(*store)));
}

nlohmann::json jsonOf(const Field& header) {
    nlohmann::json axes = nlohmann::json::array();
    for (const FieldAxis& axis : header.axes)
        axes.push_back({{"coordinate", kCoordinateNames[axis.coordinate]},
                        {"first", axis.first},
                        {"step", axis.step},
                        {"count", axis.count}});
    return {{"axes", axes},
            {"fixed", std::vector<double>(header.fixed.begin(), header.fixed.end())},
            {"quantity", header.quantity},
            {"unit", header.unit},
            {"tolerance", header.tolerance},
            {"rough_shade", header.isShadeRough}};
}

/// Throws as the library does.
Field headerOf(const nlohmann::json& json) {
    Field header;
    for (const nlohmann::json& each : json.at("axes")) {
        const auto name = std::ranges::find(kCoordinateNames, each.at("coordinate").get<std::string>());
        header.axes.push_back({static_cast<Coordinate>(name - kCoordinateNames.begin()), each.at("first"),
                               each.at("step"), each.at("count")});
        if (name == kCoordinateNames.end() || header.axes.back().count < 1)
            throw std::invalid_argument("no axis");
    }
    const auto fixed = json.at("fixed").get<std::array<double, 6>>();
    std::ranges::copy(fixed, header.fixed.begin());
    header.quantity = json.at("quantity");
    header.unit = json.at("unit");
    header.tolerance = json.at("tolerance");
    header.isShadeRough = json.at("rough_shade");
    return header;
}

} // namespace

void FieldFigures::add(const FieldFigures& more) {
    tally.add(more.tally);
    min = std::min(min, more.min);
    max = std::max(max, more.max);
}

Result<void> checkFieldOutput(const std::string& path, const std::vector<FieldAxis>& axes,
                              bool withGradient) {
    const std::string extension = std::filesystem::path(path).extension();
    if (extension == kStore)
        return checkFieldStore(path);
    if (extension != kImage)
        return Error(MessageCode::ValueUnknown, "-o " + path, {extension, ".vti, .h5"});
    if (axes.size() > kImageAxes)
        return Error(MessageCode::ValueOutOfRange, "-o " + path,
                     {std::to_string(axes.size()), "1", "4", "axes of a .vti (an .h5 has up to six)"});
    double numbers = withGradient ? 7.0 : 1.0;
    for (const FieldAxis& axis : axes)
        numbers *= axis.count;
    if (numbers > kMaxFieldNumbers)
        return Error(MessageCode::FieldTooLarge, "-o " + path + " (an .h5 holds more)",
                     {formatNumber(numbers, 12), formatNumber(kMaxFieldNumbers, 12)});
    return checkFieldFile(path, axes);
}

Result<FieldFigures> sampleInto(const FieldFile& file, const FieldSampler& sampler, int threads) {
    const auto sink = sinkOf(file, sampler.header());
    if (!sink)
        return sink.error();
    FieldFigures figures;
    std::mutex mutex;
    std::optional<Error> failed;
    std::atomic<bool> isOver = false;
    const std::size_t blocks = blocksOf(sampler.samples());
    Progress progress(static_cast<double>(blocks));
    runInParallel(
        static_cast<int>(blocks), threads,
        [&](int index) {
            if (isOver)
                return;
            const Block block = sampled(sampler, static_cast<std::size_t>(index), file.withGradient);
            const auto taken = (*sink)->take(block);
            const std::lock_guard lock(mutex);
            figures.add(block.figures);
            if (!taken)
                failed = taken.error();
            isOver = failed.has_value();
        },
        [&](int done) { progress.tell(done); });
    if (failed)
        return *failed;
    if (const auto finished = (*sink)->finish(figures.tally); !finished)
        return finished.error();
    return figures;
}

std::string fieldAsked(const FieldFile& file, const Field& header, const std::string& besides) {
    nlohmann::json work = nlohmann::json::parse(besides);
    work["field"] = jsonOf(header);
    work["title"] = file.title;
    work["gradient"] = file.withGradient;
    return work.dump();
}

DividedWork fieldWork(const FieldSampler& sampler, bool withGradient, std::string asked) {
    return {std::move(asked), static_cast<std::int64_t>(blocksOf(sampler.samples())), "blocks",
            [&sampler, withGradient](std::int64_t index) {
                return Result<std::string>(
                    bytesOf(sampled(sampler, static_cast<std::size_t>(index), withGradient)));
            }};
}

Result<MergedField> mergeFieldInto(const MergedParts& parts, const nlohmann::json& work,
                                   const std::string& path) {
    const Error foreign(MessageCode::NotAPart, "the parts");
    MergedField merged;
    FieldFile file{path, {}, false};
    try {
        merged.header = headerOf(work.at("field"));
        file.title = work.at("title");
        file.withGradient = work.at("gradient");
    } catch (const std::exception&) {
        return foreign;
    }
    const std::size_t samples = sampleCount(merged.header.axes);
    if (static_cast<std::int64_t>(blocksOf(samples)) != parts.cases())
        return foreign;
    const auto sink = sinkOf(file, merged.header);
    if (!sink)
        return sink.error();
    Progress progress(static_cast<double>(parts.cases()));
    for (std::int64_t index = 0; index < parts.cases(); ++index) {
        const auto bytes = parts.record(index);
        if (!bytes)
            return bytes.error();
        const auto block = blockOf(*bytes, static_cast<std::size_t>(index), samples, file.withGradient);
        if (!block)
            return foreign;
        if (const auto taken = (*sink)->take(*block); !taken)
            return taken.error();
        merged.figures.add(block->figures);
        progress.tell(static_cast<double>(index + 1));
    }
    if (const auto finished = (*sink)->finish(merged.figures.tally); !finished)
        return finished.error();
    return merged;
}

} // namespace bask
