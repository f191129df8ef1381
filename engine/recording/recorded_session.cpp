#include "engine/recording/recorded_session.h"

#include "engine/base/message_code.h"
#include "engine/recording/session_facts.h"

#include <QAbstractEventDispatcher>
#include <QTimer>

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

constexpr std::size_t kNoLimit = static_cast<std::size_t>(std::numeric_limits<std::int64_t>::max());
constexpr int kLetGo_ms = 1000;
constexpr double kMaxReadWhole = 20'000; // samples: half an hour; they take a quarter of a second
// Of a longer run, looked at in as many places, from its first sample to its last.
constexpr std::int64_t kLooks = 32, kLook = 512;
constexpr double kMaxLooked = 1e12;

/// Returns what no run records in a row of selectSteps(), in words; empty if there is nothing.
std::string impossibleIn(const SessionTables& tables, SessionStore::Row row, SampleTimes& times) {
    std::string words = tables.impossibleIn(row);
    if (words.empty() && !times.isPossible(tables.sampleOf(row).time_s))
        words = "a time that is none";
    return words.empty() ? words
                         : "sample " + std::to_string(SessionTables::numberOfStep(row)) + " has " + words;
}

/// Refuses a long run that holds in some places what no run records: what was done to a whole column is found
/// here, what was done to a sample where it is read.
Result<void> lookAtPlaces(const SessionStore& store, const SessionTables& tables, const std::string& path) {
    const double rows = roughRows(store, "step");
    if (rows <= kMaxReadWhole) // all were looked at
        return {};
    const auto last = static_cast<std::int64_t>(std::min(rows, kMaxLooked));
    SampleTimes times;
    std::string impossible;
    Result<void> done;
    for (std::int64_t k = 0; k < kLooks && done && impossible.empty(); ++k) {
        const std::int64_t first = 1 + k * (last - kLook) / (kLooks - 1);
        done = store.select(tables.selectSteps() + " WHERE number BETWEEN " + std::to_string(first) +
                                " AND " + std::to_string(first + kLook - 1) + " ORDER BY number",
                            [&](SessionStore::Row row) {
                                if (impossible.empty())
                                    impossible = impossibleIn(tables, row, times);
                            });
    }
    if (done && !impossible.empty())
        return Error(MessageCode::SessionDamaged, path, {impossible});
    return done;
}

} // namespace

/// The file while it is being read. An open one could not be closed by its recorder or by closeInterrupted().
struct RecordedSession::Reader {
    Reader() {
        timer.setSingleShot(true);
        timer.setInterval(kLetGo_ms);
        QObject::connect(&timer, &QTimer::timeout, [this] { store.reset(); });
    }
    Result<SessionStore*> open(const std::string& path) {
        if (!store) {
            auto opened = SessionStore::open(path);
            if (!opened)
                return opened.error();
            store = std::move(*opened);
        }
        if (QAbstractEventDispatcher::instance() != nullptr)
            timer.start();
        return store.get();
    }

    std::unique_ptr<SessionStore> store;
    QTimer timer;
};

RecordedSession::~RecordedSession() = default;

Result<std::shared_ptr<RecordedSession>> RecordedSession::open(const std::string& path) {
    const auto store = SessionStore::open(path);
    if (!store)
        return store.error();
    const std::shared_ptr<RecordedSession> session(new RecordedSession);
    if ((*store)->version() < 2) {
        auto record = readSession(path);
        if (!record)
            return record.error();
        session->m_facts = std::move(*record);
        session->adopt(std::exchange(session->m_facts.samples, {}));
        return session;
    }
    // One moment of a run that is still being recorded.
    if (auto begun = (*store)->execute("BEGIN"); !begun)
        return begun.error();
    auto facts = readFacts(**store, path);
    if (!facts)
        return facts.error();
    session->m_facts = std::move(*facts);
    auto tables = SessionTables::of(**store, session->m_facts);
    if (!tables)
        return tables.error();
    session->m_tables = std::make_unique<SessionTables>(std::move(*tables));
    auto done = session->readOverview(**store);
    if (done)
        done = session->readTargets(**store);
    if (done)
        done = session->countFrames(**store);
    if (!done)
        return done.error();
    return session;
}

/// What the recorder has summed up, and the samples that came after.
Result<void> RecordedSession::readOverview(const SessionStore& store) {
    const auto isRead = readWhole(store);
    if (!isRead || *isRead)
        return isRead ? Result<void>() : Result<void>(isRead.error());
    if (auto possible = lookAtPlaces(store, *m_tables, m_facts.path); !possible)
        return possible;
    m_overview = TraceOverview(m_facts.experiment.objects.size());
    bool isSound = true;
    SampleTimes times;
    const auto done = store.select(
        "SELECT last_step, extremes FROM overview ORDER BY last_step", [&](SessionStore::Row row) {
            const auto* last = std::get_if<std::int64_t>(&row[0]);
            const auto* extremes = std::get_if<SqlBlob>(&row[1]);
            const std::size_t before = m_overview.samples();
            isSound = isSound && last != nullptr && extremes != nullptr &&
                      std::cmp_equal(*last, before + kSamplesPerOverviewRow) &&
                      m_overview.addBytes(extremes->bytes, m_tables->quantities()) &&
                      std::cmp_equal(*last, m_overview.samples()) &&
                      times.isPossible(m_overview.lastTime_s());
        });
    if (!done)
        return done;
    if (!isSound)
        m_overview = TraceOverview(m_facts.experiment.objects.size());
    return readSteps(store, *m_tables, m_facts.path, m_overview.samples() + 1, kNoLimit,
                     [this](const TraceSample& sample) { m_overview.add(sample); });
}

/// Sums up all samples of a short run, and refuses what no run records. False: it is longer, or has a gap,
/// which is told where it is read.
Result<bool> RecordedSession::readWhole(const SessionStore& store) {
    if (roughRows(store, "step") > kMaxReadWhole)
        return false;
    m_overview = TraceOverview(m_facts.experiment.objects.size());
    std::int64_t due = 1;
    bool isWhole = true;
    SampleTimes times;
    std::string impossible;
    const auto done = store.select(m_tables->selectSteps() + " ORDER BY number", [&](SessionStore::Row row) {
        if (!impossible.empty())
            return;
        isWhole = isWhole && SessionTables::numberOfStep(row) == due++;
        impossible = impossibleIn(*m_tables, row, times);
        if (impossible.empty() && isWhole)
            m_overview.add(m_tables->sampleOf(row));
    });
    if (done && !impossible.empty())
        return Error(MessageCode::SessionDamaged, m_facts.path, {impossible});
    return done ? Result<bool>(isWhole) : done.error();
}

Result<void> RecordedSession::readTargets(const SessionStore& store) {
    m_targets.resize(m_facts.experiment.objects.size());
    bool isPossible = true;
    auto done = store.select(
        "SELECT time_s, object, target_K FROM target_step ORDER BY rowid", [&](SessionStore::Row row) {
            const double time_s = numberOf(row[0]), object = numberOf(row[1]), target_K = numberOf(row[2]);
            const bool isKnown = !std::holds_alternative<std::monostate>(row[2]);
            isPossible = isPossible && std::isfinite(time_s) && object >= 1.0 &&
                         object <= static_cast<double>(m_targets.size()) &&
                         (!isKnown || (std::isfinite(target_K) && target_K >= 0.0));
            if (isPossible)
                m_targets[static_cast<std::size_t>(object) - 1].emplace_back(time_s, target_K);
        });
    if (done && !isPossible)
        done = Error(MessageCode::SessionDamaged, m_facts.path, {"a target that is none"});
    return done;
}

Result<void> RecordedSession::countFrames(const SessionStore& store) {
    const auto columns = store.columns("thermal_frame");
    if (!columns || columns->empty())
        return columns ? Result<void>() : Result<void>(columns.error());
    return store.select("SELECT max(rowid) FROM thermal_frame", [this](SessionStore::Row row) {
        if (const auto* last = std::get_if<std::int64_t>(&row[0]))
            m_lastFrame = *last;
    });
}

/// All samples of a file of version 1.
void RecordedSession::adopt(std::vector<TraceSample> samples) {
    const std::size_t objects = m_facts.experiment.objects.size();
    m_isWhole = true;
    m_overview = TraceOverview(objects);
    m_targets.resize(objects);
    for (TraceSample& sample : samples) {
        m_overview.add(sample);
        for (std::size_t i = 0; i < objects; ++i) {
            const double target_K = sample.objects[i].target_K;
            if (std::isfinite(target_K) && (m_targets[i].empty() || m_targets[i].back().second != target_K))
                m_targets[i].emplace_back(sample.time_s, target_K);
        }
        if (m_blocks.empty() || m_blocks.back().samples.size() == kBlock)
            m_blocks.push_back({m_blocks.size(), 0, {}});
        m_blocks.back().samples.push_back(std::move(sample));
    }
}

bool RecordedSession::holds(std::size_t k) const {
    return m_isWhole || m_failed.contains(k) ||
           std::ranges::find(m_blocks, k, &Block::index) != m_blocks.end();
}

const std::vector<TraceSample>* RecordedSession::block(std::size_t k) {
    if (k * kBlock >= size() || m_failed.contains(k))
        return nullptr;
    if (m_isWhole)
        return &m_blocks[k].samples;
    auto found = std::ranges::find(m_blocks, k, &Block::index);
    if (found == m_blocks.end()) {
        auto read = readBlock(k);
        if (!read) {
            m_failed.emplace(k, read.error());
            return nullptr;
        }
        if (m_blocks.size() < kMaxBlocks)
            found = m_blocks.insert(m_blocks.end(), Block());
        else
            found = std::ranges::min_element(m_blocks, {}, &Block::used);
        found->index = k;
        found->samples = std::move(*read);
    }
    found->used = ++m_uses;
    return &found->samples;
}

Result<SessionStore*> RecordedSession::store() {
    if (!m_reader)
        m_reader = std::make_unique<Reader>();
    return m_reader->open(m_facts.path);
}

Result<std::vector<TraceSample>> RecordedSession::readBlock(std::size_t k) {
    const auto opened = store();
    if (!opened)
        return opened.error();
    const std::size_t first = k * kBlock, last = std::min(first + kBlock, size());
    std::vector<TraceSample> samples;
    samples.reserve(last - first);
    const auto done = readSteps(**opened, *m_tables, m_facts.path, first + 1, last,
                                [&](const TraceSample& sample) { samples.push_back(sample); });
    if (!done)
        return done.error();
    if (samples.size() != last - first)
        return Error(MessageCode::SessionDamaged, m_facts.path, {"a sample is missing"});
    return samples;
}

Result<std::size_t> RecordedSession::lowerIndex(double time_s) {
    if (size() == 0 || !(time_s > m_overview.from_s(0)))
        return std::size_t{0};
    if (time_s > lastTime_s())
        return size();
    // The first that is not before it lies in the stretch that begins before it, or begins the next one.
    std::size_t stretch = m_overview.stretchAt(time_s);
    while (stretch > 0 && m_overview.from_s(stretch) >= time_s)
        --stretch;
    const std::size_t first = stretch * m_overview.samplesPerStretch();
    const std::size_t end = std::min(first + m_overview.samplesPerStretch(), size());
    const std::vector<TraceSample>* const samples = block(first / kBlock);
    if (samples == nullptr)
        return m_failed.at(first / kBlock);
    const auto from = samples->begin() + static_cast<std::ptrdiff_t>(first % kBlock);
    const auto at = std::lower_bound(from, from + static_cast<std::ptrdiff_t>(end - first), time_s,
                                     [](const TraceSample& sample, double t) { return sample.time_s < t; });
    return first + static_cast<std::size_t>(at - from);
}

Result<TraceSample> RecordedSession::sample(std::size_t index) {
    const std::vector<TraceSample>* const samples = block(index / kBlock);
    if (samples == nullptr)
        return m_failed.at(index / kBlock);
    return (*samples)[index % kBlock];
}

Result<std::size_t> RecordedSession::indexFrom(double time_s) {
    if (size() == 0)
        return Error(MessageCode::SessionDamaged, m_facts.path, {"a sample is missing"});
    const auto index = lowerIndex(time_s);
    return index ? Result<std::size_t>(std::min(*index, size() - 1)) : index;
}

Result<TraceSample> RecordedSession::sampleFrom(double time_s) {
    const auto index = indexFrom(time_s);
    return index ? sample(*index) : index.error();
}

Result<TraceSample> RecordedSession::sampleAt(double time_s) {
    const auto index = indexFrom(time_s);
    if (!index)
        return index.error();
    auto found = sample(*index);
    return found && *index > 0 && found->time_s > time_s ? sample(*index - 1) : found;
}

Result<std::vector<TraceSample>> RecordedSession::samples(double from_s, double to_s) {
    const auto first = lowerIndex(from_s);
    if (!first)
        return first.error();
    std::vector<TraceSample> out;
    for (std::size_t i = *first; i < size(); ++i) {
        const std::vector<TraceSample>* const samples = block(i / kBlock);
        if (samples == nullptr)
            return m_failed.at(i / kBlock);
        if ((*samples)[i % kBlock].time_s > to_s)
            break;
        out.push_back((*samples)[i % kBlock]);
    }
    return out;
}

// By halving: a table of a day has too many pictures to be looked through, and no index of times.
Result<RecordedFrame> RecordedSession::thermalFrameAt(double time_s) {
    const Error missing(MessageCode::SessionDamaged, m_facts.path, {"a picture is missing"});
    const auto opened = store();
    if (!opened)
        return opened.error();
    RecordedFrame frame;
    const auto read = [&](std::int64_t number, const char* what,
                          const std::function<void(SessionStore::Row)>& take) {
        return (*opened)->select("SELECT rowid, time_s, " + std::string(what) +
                                     " FROM thermal_frame WHERE rowid >= " + std::to_string(number) +
                                     " ORDER BY rowid LIMIT 1",
                                 take);
    };
    std::int64_t low = 1, high = m_lastFrame; // the wanted one is among these
    while (low < high) {
        const std::int64_t middle = low + (high - low + 1) / 2;
        bool isLater = true;
        const auto done =
            read(middle, "0", [&](SessionStore::Row row) { isLater = numberOf(row[1]) > time_s; });
        if (!done)
            return done.error();
        if (isLater)
            high = middle - 1;
        else
            low = middle;
    }
    const auto done = read(low, "png", [&](SessionStore::Row row) {
        const auto* number = std::get_if<std::int64_t>(&row[0]);
        const auto* png = std::get_if<SqlBlob>(&row[2]);
        if (number != nullptr && png != nullptr)
            frame = {*number, numberOf(row[1]), png->bytes};
    });
    if (!done)
        return done.error();
    return frame.number > 0 ? Result<RecordedFrame>(std::move(frame)) : Result<RecordedFrame>(missing);
}

} // namespace bask
