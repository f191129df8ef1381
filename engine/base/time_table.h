#pragma once
// A value given at several times: linear between them, constant before the first and after the last.

#include <algorithm>
#include <iterator>
#include <vector>

namespace bask {

/// T: a number or a vector of numbers.
template <class T> struct TimePoint {
    double time_s = 0.0;
    T value{};
    bool operator==(const TimePoint&) const = default;
};

/// Points in ascending order of time.
template <class T> using TimeTable = std::vector<TimePoint<T>>;

/// Returns the value at a time, or `otherwise` if the table is empty.
template <class T> T valueAt(const TimeTable<T>& table, double time_s, const T& otherwise) {
    if (table.empty())
        return otherwise;
    const auto next = std::ranges::upper_bound(table, time_s, {}, &TimePoint<T>::time_s);
    if (next == table.begin())
        return next->value;
    const auto before = std::prev(next);
    if (next == table.end())
        return before->value;
    const double part = (time_s - before->time_s) / (next->time_s - before->time_s);
    return before->value + part * (next->value - before->value);
}

} // namespace bask
