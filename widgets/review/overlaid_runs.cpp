#include "widgets/review/overlaid_runs.h"

#include "widgets/review/run_differences.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>

namespace bask {

namespace {

/// What a list would read of it.
SessionHeader headerOf(const SessionRecord& facts) {
    SessionHeader header;
    header.path = facts.path;
    header.title = facts.experiment.title;
    for (const ObjectSpec& object : facts.experiment.objects)
        header.objects.push_back(
            {object.name, object.target_K, object.material.name, object.material.emittance});
    header.controller = facts.experiment.controller.kind.key();
    header.created = facts.created;
    header.simulated = facts.simulated;
    header.labels = facts.labels;
    return header;
}

} // namespace

QStringList objectNames(const RecordedSession& run) {
    QStringList names;
    for (const ObjectSpec& object : run.facts().experiment.objects)
        names << QString::fromStdString(object.name);
    return names;
}

void OverlaidRuns::setOpen(std::shared_ptr<RecordedSession> session) {
    m_over.clear();
    m_open = {std::move(session)};
}

bool OverlaidRuns::add(std::shared_ptr<RecordedSession> session, std::size_t most) {
    if (!m_open.session || m_over.size() >= most || find(QString::fromStdString(session->facts().path)))
        return false;
    m_over.push_back({std::move(session)});
    return true;
}

void OverlaidRuns::remove(const QString& path) {
    std::erase_if(m_over, [&](const Run& run) { return run.path() == path; });
}

OverlaidRuns::Run* OverlaidRuns::find(const QString& path) {
    if (m_open.session && m_open.path() == path)
        return &m_open;
    const auto found = std::ranges::find(m_over, path, &Run::path);
    return found == m_over.end() ? nullptr : &*found;
}

void OverlaidRuns::setMetrics(const QString& path, const RunMetrics* metrics) {
    Run* run = find(path);
    if (run == nullptr)
        return;
    run->metrics = metrics != nullptr ? std::optional(*metrics) : std::nullopt;
    run->isFailed = metrics == nullptr;
}

std::shared_ptr<RecordedSession> OverlaidRuns::uncounted(const QString& except) const {
    const auto found = std::ranges::find_if(
        m_over, [&](const Run& run) { return !run.metrics && !run.isFailed && run.path() != except; });
    return found == m_over.end() ? nullptr : found->session;
}

QStringList OverlaidRuns::keys(TemperatureUnit unit) const {
    if (!m_open.session)
        return {};
    std::vector<SessionHeader> headers{headerOf(m_open.session->facts())};
    headers.reserve(m_over.size() + 1);
    for (const Run& run : m_over)
        headers.push_back(headerOf(run.session->facts()));
    QStringList out;
    for (const QString& key : runKeys(headers, unit))
        out << key;
    return out;
}

/// By its file; two files of one name in two folders also by these.
std::vector<ComparedRun> OverlaidRuns::compared() const {
    std::vector<ComparedRun> out;
    if (!m_open.session)
        return out;
    std::vector<const Run*> runs{&m_open};
    for (const Run& run : m_over)
        runs.push_back(&run);
    QStringList files;
    for (const Run* run : runs)
        files << QFileInfo(run->path()).completeBaseName();
    for (std::size_t k = 0; k < runs.size(); ++k) {
        const QFileInfo file(runs[k]->path());
        QString name = mark(k) + u' ' + file.completeBaseName();
        if (files.count(file.completeBaseName()) > 1)
            name += QStringLiteral(" (%1)").arg(file.dir().dirName());
        out.push_back({mark(k), name, runs[k]->path(), objectNames(*runs[k]->session), runs[k]->metrics,
                       runs[k]->isFailed});
    }
    return out;
}

} // namespace bask
