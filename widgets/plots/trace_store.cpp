#include "widgets/plots/trace_store.h"

#include "engine/recording/recorded_session.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bask {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kNowhere = std::numeric_limits<std::size_t>::max();
constexpr double kSameMoment_s = 1e-6; ///< of two runs whose times were rounded in different ways

void add(TraceStore::Line& line, double time_s, double value) {
    line.times_s.push_back(time_s);
    line.values.push_back(value);
}

/// Least and greatest value of a stretch.
void addPair(TraceStore::Line& line, double from_s, double to_s, double min, double max) {
    // Goes on with the nearer one: a falling line falls.
    if (!line.values.empty() && std::abs(line.values.back() - max) < std::abs(line.values.back() - min))
        std::swap(min, max);
    add(line, from_s, min);
    add(line, to_s, max);
}

/// Puts samples into a line: all, or where there are more than two a pixel, least and greatest values of so
/// many at once. Which go together does not depend on where the line begins, so that it does not flicker when
/// moved.
class Samples {
public:
    Samples(TraceStore::Line& line, std::size_t count, std::size_t pixels)
        : m_line(line), m_group(count / 2 > pixels ? 1 + (count - 1) / pixels : 1) {}

    void add(std::size_t row, double time_s, double value) {
        if (m_group == 1)
            return bask::add(m_line, time_s, value);
        if (row % m_group == 0)
            end();
        if (m_count++ == 0)
            m_from_s = time_s;
        m_to_s = time_s;
        m_min = std::fmin(m_min, value); // the other one where one is NaN
        m_max = std::fmax(m_max, value);
    }
    void end() {
        if (m_count > 0)
            addPair(m_line, m_from_s, m_to_s, m_min, m_max);
        m_count = 0;
        m_min = m_max = kNaN;
    }

private:
    TraceStore::Line& m_line;
    std::size_t m_group, m_count = 0;
    double m_from_s = 0.0, m_to_s = 0.0, m_min = kNaN, m_max = kNaN;
};

} // namespace

void TraceStore::reset(std::size_t objects) {
    *this = TraceStore();
    m_objects = objects;
    m_lines.resize(lineCount(objects));
    m_targets.resize(objects);
    m_overview = TraceOverview(objects, kMaxStretches);
}

void TraceStore::show(std::shared_ptr<RecordedSession> run) {
    reset(run->overview().objects());
    m_run = std::move(run);
}

const TraceOverview& TraceStore::overview() const {
    return m_run ? m_run->overview() : m_overview;
}

void TraceStore::dropOldRows() {
    constexpr std::size_t kAtOnce = kMaxRows / 4;
    if (m_keepsAll || m_time_s.size() < kMaxRows + kAtOnce)
        return;
    const auto drop = [](std::vector<double>& values) {
        values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(kAtOnce));
    };
    drop(m_time_s);
    std::ranges::for_each(m_lines, drop);
}

std::size_t TraceStore::append(const std::vector<TraceSample>& samples) {
    dropOldRows();
    const std::size_t first = rows();
    for (const TraceSample& sample : samples) {
        if (!std::isfinite(sample.time_s) || (!m_time_s.empty() && sample.time_s <= m_time_s.back()))
            continue;
        m_overview.add(sample);
        m_time_s.push_back(sample.time_s);
        for (std::size_t q = 0, line = 0; q < quantityCount(); ++q)
            for (std::size_t i = 0; i < seriesCount(static_cast<Quantity>(q), m_objects); ++i)
                m_lines[line++].push_back(plottedValue(sample, static_cast<Quantity>(q), i));
        for (std::size_t i = 0; i < m_objects; ++i) {
            const double target_K = i < sample.objects.size() ? sample.objects[i].target_K : kNaN;
            auto& steps = m_targets[i];
            if (std::isfinite(target_K) && (steps.empty() || steps.back().second != target_K))
                steps.emplace_back(sample.time_s, target_K);
        }
    }
    return first;
}

std::size_t TraceStore::rows() const {
    return m_run ? m_run->size() : m_time_s.size();
}

double TraceStore::lastTime_s() const {
    return overview().lastTime_s();
}

double TraceStore::time_s(std::size_t row) const {
    if (!m_run)
        return m_time_s[row];
    const auto* block = m_run->block(row / RecordedSession::kBlock);
    return block == nullptr ? kNaN : (*block)[row % RecordedSession::kBlock].time_s;
}

bool TraceStore::keepsFrom(double from_s) const {
    return m_run || m_time_s.empty() || m_time_s.front() <= std::max(from_s, m_overview.from_s(0));
}

double TraceStore::value(Quantity quantity, std::size_t series, std::size_t row) const {
    if (!m_run)
        return values(quantity, series)[row];
    const auto* block = m_run->block(row / RecordedSession::kBlock);
    return block == nullptr ? kNaN : plottedValue((*block)[row % RecordedSession::kBlock], quantity, series);
}

const std::vector<std::pair<double, double>>& TraceStore::targetSteps(std::size_t object) const {
    return m_run ? m_run->targetSteps(object) : m_targets[object];
}

/// First row not before the time; kNowhere where the file cannot be read.
std::size_t TraceStore::lowerRow(double time_s) const {
    if (!m_run)
        return static_cast<std::size_t>(std::ranges::lower_bound(m_time_s, time_s) - m_time_s.begin());
    const auto found = m_run->lowerIndex(time_s);
    return found ? *found : kNowhere;
}

std::size_t TraceStore::rowAt(double at_s) const {
    const std::size_t after = lowerRow(at_s + kSameMoment_s);
    return rows() == 0 || after == kNowhere ? rows() : after - std::min<std::size_t>(after, 1);
}

std::size_t TraceStore::samplesBetween(double from_s, double to_s) const {
    const TraceOverview& all = overview();
    return (all.stretchAt(to_s) - std::min(all.stretchAt(from_s), all.stretchAt(to_s))) *
           all.samplesPerStretch();
}

TraceStore::Line TraceStore::line(Quantity quantity, std::size_t series, double from_s, double to_s,
                                  std::size_t pixels, int& reads) const {
    const TraceOverview& all = overview();
    Line line;
    if (all.stretches() == 0 || pixels == 0)
        return line;
    // One stretch more on either side, so that the line runs out of the picture.
    const std::size_t first = all.stretchAt(from_s) - std::min<std::size_t>(all.stretchAt(from_s), 1);
    const std::size_t last = std::min(all.stretchAt(to_s) + 2, all.stretches());
    const std::size_t group = 1 + (last - first - 1) / pixels; // at most a pixel wide
    if (group > 1) {
        addStretches(line, quantity, series, first - first % group, last, group);
    } else if (m_run) {
        const std::size_t each = all.samplesPerStretch();
        addBlocks(line, quantity, series, first * each, std::min(last * each, rows()), pixels, reads);
    } else {
        const std::size_t kept = all.stretchAt(m_time_s.front());
        addStretches(line, quantity, series, first, std::clamp(kept, first, last), 1);
        addRows(line, quantity, series, all.from_s(first), all.to_s(last - 1), pixels);
    }
    return line;
}

void TraceStore::addRows(Line& line, Quantity quantity, std::size_t series, double from_s, double to_s,
                         std::size_t pixels) const {
    const std::vector<double>& all = values(quantity, series);
    const std::size_t first = lowerRow(from_s);
    std::size_t last = first;
    while (last < m_time_s.size() && m_time_s[last] <= to_s)
        ++last;
    Samples samples(line, last - first, pixels);
    for (std::size_t row = first; row < last; ++row)
        samples.add(row, m_time_s[row], all[row]);
    samples.end();
}

/// Samples [first, last) of the recorded run.
void TraceStore::addBlocks(Line& line, Quantity quantity, std::size_t series, std::size_t first,
                           std::size_t last, std::size_t pixels, int& reads) const {
    constexpr std::size_t kBlock = RecordedSession::kBlock;
    const std::size_t each = overview().samplesPerStretch();
    Samples samples(line, last - first, pixels);
    while (first < last) {
        const std::size_t k = first / kBlock, end = std::min(last, (k + 1) * kBlock);
        const bool isHeld = m_run->holds(k);
        reads -= isHeld ? 0 : 1;
        const auto* block = isHeld || reads >= 0 ? m_run->block(k) : nullptr;
        if (block == nullptr) {
            samples.end();
            addStretches(line, quantity, series, first / each, (end + each - 1) / each, 1);
        } else {
            for (std::size_t i = first; i < end; ++i)
                samples.add(i, (*block)[i % kBlock].time_s,
                            plottedValue((*block)[i % kBlock], quantity, series));
        }
        first = end;
    }
    samples.end();
}

/// Stretches [first, last), so many at once.
void TraceStore::addStretches(Line& line, Quantity quantity, std::size_t series, std::size_t first,
                              std::size_t last, std::size_t group) const {
    const TraceOverview& all = overview();
    for (std::size_t k = first; k < last; k += group) {
        const std::size_t end = std::min(k + group, last);
        Extremes extremes;
        for (std::size_t j = k; j < end; ++j)
            extremes.include(all.extremes(quantity, series, j));
        addPair(line, all.from_s(k), all.to_s(end - 1), extremes.min, extremes.max);
    }
}

} // namespace bask
