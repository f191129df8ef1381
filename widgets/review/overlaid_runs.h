#pragma once
// The open run and those that are laid over it, with their letters and metrics.

#include "engine/recording/recorded_session.h"
#include "widgets/review/metric_comparison.h"

#include <memory>
#include <optional>
#include <vector>

namespace bask {

QStringList objectNames(const RecordedSession& run);

class OverlaidRuns {
public:
    struct Run {
        std::shared_ptr<RecordedSession> session;
        std::optional<RunMetrics> metrics{};
        bool isFailed = false; ///< its samples cannot be read to their end

        QString path() const { return QString::fromStdString(session->facts().path); }
    };

    /// Replaces all; null for none.
    void setOpen(std::shared_ptr<RecordedSession> session);
    const std::vector<Run>& over() const { return m_over; }

    /// Returns false without an open run, if it is here already, or if there are `most` of them.
    bool add(std::shared_ptr<RecordedSession> session, std::size_t most);
    void remove(const QString& path);

    /// Sets the metrics of a run; null: they cannot be computed. Ignored if it is not here.
    void setMetrics(const QString& path, const RunMetrics* metrics);
    /// Returns the first one over the open run whose metrics are not known yet, other than that of a path.
    std::shared_ptr<RecordedSession> uncounted(const QString& except) const;

    /// Returns the letter of a run: the open one is the first.
    static QString mark(std::size_t place) { return QString(QChar(static_cast<char16_t>(u'A' + place))); }
    /// Returns what tells each from the others, the open one first; empty without an open run.
    QStringList keys(TemperatureUnit unit) const;
    /// Returns all of them, the open one first, with names that differ.
    std::vector<ComparedRun> compared() const;

private:
    Run* find(const QString& path);

    Run m_open;
    std::vector<Run> m_over;
};

} // namespace bask
