#include "widgets/review/run_differences.h"

#include "engine/control/controller_catalogue.h"
#include "engine/recording/recording_name.h"
#include "widgets/common/device_words.h"
#include "widgets/common/display.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QLocale>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

namespace bask {
namespace {

struct DifferenceWords {
    Q_DECLARE_TR_FUNCTIONS(bask::RunDifferences)
};

const QString kBetween = QStringLiteral(" \u00b7 ");

bool isSame(double a, double b) {
    return a == b || (std::isnan(a) && std::isnan(b));
}

/// Of an object's name in all runs of a title.
struct ObjectFacts {
    const ListedObject* first = nullptr;
    std::size_t runs = 0;
    bool hasTargets = false, hasMaterials = false, hasEmittances = false; ///< several

    void add(const ListedObject& object) {
        ++runs;
        if (first == nullptr)
            first = &object;
        hasTargets = hasTargets || !isSame(object.target_K, first->target_K);
        hasMaterials = hasMaterials || object.material != first->material;
        hasEmittances = hasEmittances || !isSame(object.emittance, first->emittance);
    }
};

/// The runs of one title.
class Alike {
public:
    explicit Alike(std::vector<const SessionHeader*> runs) : m_runs(std::move(runs)) {
        for (const SessionHeader* run : m_runs) {
            m_hasControllers = m_hasControllers || run->controller != m_runs.front()->controller;
            for (const ListedObject& object : run->objects)
                m_objects[object.name].add(object);
        }
        m_haveSameObjects = std::ranges::all_of(
            m_objects, [this](const auto& object) { return object.second.runs == m_runs.size(); });
    }

    QString of(const SessionHeader& run, TemperatureUnit unit) const {
        QStringList parts;
        if (const QString targets = targetsOf(run, unit); !targets.isEmpty())
            parts << targets;
        if (m_hasControllers)
            parts << listedController(run);
        for (const ListedObject& object : run.objects)
            if (const QString material = materialOf(object); !material.isEmpty())
                parts << material;
        return parts.join(kBetween);
    }

private:
    /// Of all its objects where the runs do not have the same ones: what a run lacks would be read as what it
    /// has. One temperature where all have the same.
    QString targetsOf(const SessionHeader& run, TemperatureUnit unit) const {
        if (run.objects.empty())
            return {};
        const double first_K = run.objects.front().target_K;
        bool isOne = run.objects.size() > 1;
        QStringList names, targets;
        for (const ListedObject& object : run.objects) {
            isOne = isOne && isSame(object.target_K, first_K);
            if (m_haveSameObjects && !m_objects.at(object.name).hasTargets)
                continue;
            names << QString::fromStdString(object.name);
            targets << names.back() + u' ' + formatTemperature(object.target_K, unit);
        }
        if (!isOne || targets.size() < 2)
            return targets.join(listSeparator());
        const QString target = formatTemperature(first_K, unit);
        return m_haveSameObjects ? DifferenceWords::tr("all %1", "objects of a run; their target").arg(target)
                                 : DifferenceWords::tr("%1: %2", "objects, and their one target")
                                       .arg(names.join(listSeparator()), target);
    }

    QString materialOf(const ListedObject& object) const {
        const ObjectFacts& facts = m_objects.at(object.name);
        QStringList words;
        if (facts.hasMaterials && !object.material.empty())
            words << QString::fromStdString(object.material);
        if (facts.hasEmittances && std::isfinite(object.emittance))
            words << QStringLiteral("\u03b5 ") + QLocale().toString(object.emittance, 'g', 3);
        return words.isEmpty() ? QString()
                               : QString::fromStdString(object.name) + u' ' + words.join(listSeparator());
    }

    std::vector<const SessionHeader*> m_runs;
    std::map<std::string, ObjectFacts> m_objects;
    bool m_hasControllers = false;
    bool m_haveSameObjects = true;
};

/// What the list tells of a run besides its differences.
QString restOf(const SessionHeader& run) {
    const QString name = run.title.empty() ? QString::fromStdString(run.path) : givenName(run);
    return name + u'\n' + QString::fromStdString(run.labels.operatorName) + u'\n' +
           QString::fromStdString(run.labels.sample) + u'\n' + QString::fromStdString(run.labels.batch);
}

} // namespace

QString givenName(const SessionHeader& session) {
    const QString stem = QFileInfo(QString::fromStdString(session.path)).completeBaseName();
    return isRecordingStem(stem.toStdString()) ? QString() : stem;
}

QString listedName(const SessionHeader& session) {
    if (const QString given = givenName(session); !given.isEmpty() && !session.error)
        return given;
    return session.title.empty() ? QFileInfo(QString::fromStdString(session.path)).fileName()
                                 : QString::fromStdString(session.title);
}

QDateTime recordedAt(const SessionHeader& session) {
    const QDateTime created = QDateTime::fromString(QString::fromStdString(session.created), Qt::ISODate);
    return (created.isValid() ? created : QFileInfo(QString::fromStdString(session.path)).lastModified())
        .toLocalTime();
}

QString listedController(const SessionHeader& session) {
    const auto& known = controllerCatalogue();
    const auto found = std::ranges::find(known, session.controller,
                                         [](const ControllerEntry& entry) { return entry.kind.key(); });
    return found != known.end() ? controllerWord(found->kind) : QString::fromStdString(session.controller);
}

std::vector<QString> runDifferences(const std::vector<SessionHeader>& sessions, TemperatureUnit unit) {
    std::unordered_map<std::string, std::vector<std::size_t>> byTitle;
    for (std::size_t i = 0; i < sessions.size(); ++i)
        if (!sessions[i].error)
            byTitle[sessions[i].title].push_back(i);
    std::vector<QString> out(sessions.size());
    for (const auto& [title, places] : byTitle) {
        if (places.size() < 2)
            continue;
        std::vector<const SessionHeader*> runs;
        for (const std::size_t i : places)
            runs.push_back(&sessions[i]);
        const Alike alike(std::move(runs));
        std::map<QString, int> alikeRows;
        for (const std::size_t i : places) {
            out[i] = alike.of(sessions[i], unit);
            ++alikeRows[out[i] + u'\n' + restOf(sessions[i])];
        }
        for (const std::size_t i : places)
            if (alikeRows[out[i] + u'\n' + restOf(sessions[i])] > 1) {
                const QString file = QFileInfo(QString::fromStdString(sessions[i].path)).completeBaseName();
                out[i] += out[i].isEmpty() ? file : kBetween + file;
            }
    }
    return out;
}

std::vector<QString> runKeys(const std::vector<SessionHeader>& sessions, TemperatureUnit unit) {
    QStringList names, differences, operators, samples, batches, rigs, files;
    for (const QString& words : runDifferences(sessions, unit))
        differences << words;
    for (const SessionHeader& session : sessions) {
        names << listedName(session);
        operators << QString::fromStdString(session.labels.operatorName);
        samples << QString::fromStdString(session.labels.sample);
        batches << QString::fromStdString(session.labels.batch);
        rigs << rigWord(session.simulated);
        files << QFileInfo(QString::fromStdString(session.path)).completeBaseName();
    }
    QStringList keys;
    for (qsizetype i = 0; i < files.size(); ++i) {
        QStringList parts;
        for (const QStringList* words : {&names, &differences, &operators, &samples, &batches, &rigs})
            if (words->count(words->front()) < words->size() && !words->at(i).isEmpty())
                parts << words->at(i);
        keys << parts.join(kBetween);
    }
    std::vector<QString> out;
    out.reserve(sessions.size());
    for (qsizetype i = 0; i < files.size(); ++i)
        out.push_back(keys[i].isEmpty()         ? files[i]
                      : keys.count(keys[i]) > 1 ? keys[i] + kBetween + files[i]
                                                : keys[i]);
    return out;
}

} // namespace bask
