#include "app/report/report_record.h"

#include "app/report/html_text.h"
#include "app/report/report_figures.h"
#include "engine/base/message_code.h"
#include "engine/base/version.h"
#include "engine/base/words.h"
#include "engine/control/controller_catalogue.h"
#include "engine/exchange/vtk_version.h"
#include "engine/recording/alarm_history.h"
#include "engine/recording/recorded_session.h"
#include "engine/recording/session_header.h"
#include "engine/recording/simulation_pace.h"
#include "widgets/common/alarm_words.h"
#include "widgets/common/belief_words.h"
#include "widgets/common/display.h"
#include "widgets/common/metric_words.h"
#include "widgets/common/run_label_words.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLocale>
#include <QSysInfo>
#include <QTimeZone>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <span>

namespace bask {
namespace {

using html::facts;
using html::heading;
using html::paragraph;
using html::subheading;

struct RecordText {
    Q_DECLARE_TR_FUNCTIONS(bask::RunReport)
};

/// A line of the table of events.
struct Line {
    double time_s = 0.0;
    int number = 0; ///< in the figures
    QString kind, text;
    std::string operatorName{};
};

QString kindOf(MessageCode code) {
    const int priority = alarmPriority(code);
    return priority == 0 ? RecordText::tr("event") : RecordText::tr("alarm, priority %1").arg(priority);
}

QString time(double time_s) {
    return QLocale().toString(time_s, 'f', 1);
}

/// A value that has no words of its own: "environment_K 297.9733; offsets_K 0.0733, -0.1266".
QString plainValue(const QJsonValue& value) {
    QStringList parts;
    if (value.isObject()) {
        const QJsonObject object = value.toObject();
        for (auto field = object.begin(); field != object.end(); ++field)
            parts << field.key() + u' ' + plainValue(*field);
        return parts.join(QStringLiteral("; "));
    }
    if (value.isArray()) {
        for (const QJsonValue& item : value.toArray())
            parts << plainValue(item);
        return parts.join(listSeparator());
    }
    if (value.isDouble())
        return QLocale().toString(value.toDouble(), 'g', 10);
    return value.toVariant().toString();
}

QString listed(const QJsonValue& values, const std::function<QString(double)>& words) {
    QStringList parts;
    for (const QJsonValue& value : values.toArray())
        parts << words(value.toDouble());
    return parts.join(listSeparator());
}

bool isGains(const QString& key) {
    return std::ranges::any_of(controllerCatalogue(), [&](const ControllerEntry& entry) {
        return key == QLatin1String(entry.group);
    });
}

/// Of the controller with this key: the group of its gains; empty if there is none.
QString groupOf(const QString& kind) {
    for (const ControllerEntry& entry : controllerCatalogue())
        if (kind == QLatin1String(entry.kind.key()))
            return QString::fromLatin1(entry.group);
    return {};
}

QString utcText(const QDateTime& time) {
    return QLocale().toString(time.toUTC(), QStringLiteral("yyyy-MM-dd HH:mm:ss")) + QStringLiteral(" UTC");
}

QString utcText(double utc_s) {
    return utcText(QDateTime::fromSecsSinceEpoch(static_cast<qint64>(utc_s), QTimeZone::utc()));
}

constexpr double kNotRead = 1e12; ///< no time and no temperature

QString fieldText(const QString& key, const QJsonValue& value, TemperatureUnit unit) {
    const bool isNumber = std::abs(value.toDouble(kNotRead)) < kNotRead;
    const auto temperature = [unit](double t_K) { return formatTemperature(t_K, unit, 2); };
    if (key == QLatin1String("environment_K") && isNumber)
        return RecordText::tr("surroundings %1").arg(temperature(value.toDouble()));
    if (key == QLatin1String("offsets_K"))
        return RecordText::tr("offsets of the sensors %1").arg(listed(value, [unit](double d_K) {
            return formatDifference(d_K, unit, 2);
        }));
    if (key == QLatin1String("zeroed_utc_s") && isNumber)
        return RecordText::tr("zeroed %1").arg(utcText(value.toDouble()));
    if (key == QLatin1String("started_utc_s") && isNumber)
        return utcText(value.toDouble());
    if (key == QLatin1String("accept_infeasible"))
        return value.toBool() ? RecordText::tr("targets out of reach accepted") : QString();
    if (key == QLatin1String("targets_K"))
        return listed(value, temperature);
    if (key == QLatin1String("temperature_K") && isNumber)
        return temperature(value.toDouble());
    if (key == QLatin1String("factor") && isNumber)
        return QStringLiteral("\u00d7 ") + QLocale().toString(value.toDouble());
    if (key == QLatin1String("fault"))
        return value.toString() == QLatin1String("none")
                   ? RecordText::tr("none", "no simulated fault any more")
                   : QCoreApplication::translate(wordContext(ArgKind::Fault),
                                                 wordText(ArgKind::Fault, value.toString().toStdString()));
    if (key == QLatin1String("object") && value.isString())
        return value.toString();
    if (key == QLatin1String("on") && value.isBool())
        return value.toBool() ? QString() : RecordText::tr("ended", "a simulated fault");
    if (key == QLatin1String("kind"))
        for (const ControllerEntry& entry : controllerCatalogue())
            if (value.toString() == QLatin1String(entry.kind.key()))
                return controllerWord(entry.kind);
    return isGains(key) ? plainValue(value) : plainValue(QJsonObject{{key, value}});
}

QString commandName(const QString& name) {
    const std::pair<const char*, QString> named[] = {
        {"acknowledge", RecordText::tr("Acknowledge")},
        {"arm", RecordText::tr("Arm")},
        {"disarm", RecordText::tr("Disarm")},
        {"start", RecordText::tr("Start")},
        {"hold", RecordText::tr("Hold")},
        {"resume", RecordText::tr("Resume")},
        {"stop", RecordText::tr("Stop")},
        {"emergency-stop", RecordText::tr("STOP")},
        {"reset", RecordText::tr("Reset")},
        {"targets", RecordText::tr("Targets")},
        {"controller", RecordText::tr("Controller")},
        {"zero", RecordText::tr("Zero the sensors")},
        {"operator", RecordText::tr("Operator")},
        {"speed", RecordText::tr("Speed of the simulation")},
        {"source-temperature", RecordText::tr("Temperature of the source, as typed")},
        {"fault", RecordText::tr("Simulated fault")},
    };
    for (const auto& [known, word] : named)
        if (name == QLatin1String(known))
            return word;
    return name;
}

/// The alarm that a person had seen, by its key: a message's name, and its object or device if it has one.
QString acknowledgedText(const CommandRow& command, const std::vector<TraceEvent>& events,
                         TemperatureUnit unit) {
    const QString key = QJsonDocument::fromJson(QByteArray::fromStdString(command.value))
                            .object()
                            .value(QLatin1String("alarm"))
                            .toString();
    const TraceEvent* seen = nullptr;
    for (const TraceEvent& event : events) {
        const QString name = QString::fromLatin1(messageName(event.message.code));
        const bool isIt =
            name == key || (!event.message.args.empty() &&
                            name + u':' + QString::fromStdString(event.message.args.front().text()) == key);
        if (isIt && (seen == nullptr || event.time_s <= command.time_s))
            seen = &event;
    }
    Alarm alarm;
    if (seen != nullptr)
        alarm.message = seen->message;
    return seen != nullptr ? alarmHeadline(alarm, unit) : key;
}

/// "Arm: surroundings 24.82 \u00b0C; offsets of the sensors +0.07 K".
QString commandText(const CommandRow& command, const std::vector<TraceEvent>& events, TemperatureUnit unit) {
    const QString value = QString::fromStdString(command.value);
    const QJsonDocument read = QJsonDocument::fromJson(value.toUtf8());
    QStringList parts;
    if (command.name == "acknowledge") {
        parts << acknowledgedText(command, events, unit);
    } else if (command.name == "operator") {
        parts << read.object().value(QLatin1String("name")).toString();
    } else if (read.isObject()) {
        const QJsonObject fields = read.object();
        const QString kind = groupOf(fields.value(QLatin1String("kind")).toString());
        for (auto field = fields.begin(); field != fields.end(); ++field)
            if (field.key() == kind || !isGains(field.key()))
                parts << fieldText(field.key(), *field, unit);
    } else {
        parts << value;
    }
    parts.removeAll(QString());
    const QString name = commandName(QString::fromStdString(command.name));
    return parts.empty()
               ? name
               : RecordText::tr("%1: %2", "command: its values").arg(name, parts.join(QStringLiteral("; ")));
}

/// As recorded where the unit is the recorded one: another rounds to a tenth.
QString eventText(const Message& message, TemperatureUnit unit) {
    return asSentence(
        recordedText(message, unit == TemperatureUnit::Celsius ? std::nullopt : std::optional(unit)));
}

std::vector<Line> linesOf(const SessionRecord& session, TemperatureUnit unit) {
    std::vector<Line> lines;
    for (const CommandRow& command : session.commands) // before what came of them in the same step
        lines.push_back({command.time_s, 0, RecordText::tr("command"),
                         commandText(command, session.events, unit), command.operatorName});
    const std::vector<int> numbers = markedEvents(session.events);
    for (std::size_t k = 0; k < session.events.size(); ++k) {
        const TraceEvent& event = session.events[k];
        lines.push_back(
            {event.time_s, numbers[k], kindOf(event.message.code), eventText(event.message, unit)});
    }
    for (const TraceNote& note : session.notes)
        lines.push_back(
            {note.time_s, 0, RecordText::tr("note"), QString::fromStdString(note.text), note.operatorName});
    std::ranges::stable_sort(lines, {}, &Line::time_s);
    return lines;
}

bool isAltered(const RunReportInput& input) {
    return input.integrity && input.integrity->hasChain && !input.integrity->isIntact();
}

QString headWords(const RunReportInput& input) {
    if (isAltered(input))
        return RecordText::tr("not told: the recording was altered");
    return input.integrity && input.integrity->hasChain ? QString::fromStdString(input.integrity->head)
                                                        : RecordText::tr("not known");
}

/// Of the clock on the wall: minutes may lie between Arm, with which the recording begins, and Start.
QString beginWords(const SessionRecord& session) {
    const QDateTime created = QDateTime::fromString(QString::fromStdString(session.created), Qt::ISODate);
    const QString armed = created.isValid() ? utcText(created) : RecordText::tr("date not known");
    const auto started_s = startedUtc_s(session);
    if (!started_s)
        return armed;
    return RecordText::tr("from Arm at %1; Start at %2").arg(armed, utcText(*started_s));
}

int alarmCount(const SessionRecord& session) {
    return static_cast<int>(alarmSpells(session.events, 0.0).size());
}

} // namespace

QString outcomeWords(const SessionRecord& session) {
    if (isCutAfterStop(session))
        return cutAfterStopText();
    if (session.interrupted())
        return RecordText::tr(
            "Interrupted: the recording ended without a Stop. What had been written is reported.");
    if (session.outcome == kOutcomeInterrupted)
        return RecordText::tr(
            "Interrupted: the recording ended without a Stop, and was closed later. What had been "
            "written is reported.");
    if (session.outcome == "settled")
        return RecordText::tr("All objects settled.");
    if (session.outcome == "not-settled")
        return RecordText::tr("Not all objects settled.");
    if (session.outcome == "stopped")
        return RecordText::tr("Stopped."); // by whom is not recorded
    if (session.outcome == "emergency-stop")
        return RecordText::tr("Ended by STOP.");
    if (session.outcome == "fault")
        return RecordText::tr("Ended by a fault.");
    return QString::fromStdString(session.outcome);
}

QString summarySection(const RunReportInput& input) {
    const SessionRecord& session = input.session;
    const RunMetrics metrics = runMetrics(session);
    const QString alarms = RecordText::tr("%n alarm(s)", nullptr, alarmCount(session));
    QList<std::pair<QString, QString>> rows{
        {RecordText::tr("Outcome"), outcomeWords(session)},
        {RecordText::tr("Recorded"), beginWords(session)},
        {RecordText::tr("Control from Start until Stop"),
         RecordText::tr("%1 (min:s), %n sample(s)", nullptr, static_cast<int>(metrics.samples))
             .arg(formatDuration(metrics.duration_s))},
        {RecordText::tr("Controller"), controllerWord(session.experiment.controller.kind)},
        {RecordText::tr("Alarms"), session.events.empty() ? RecordText::tr("no event was recorded") : alarms},
        {RecordText::tr("Session file"), QFileInfo(QString::fromStdString(session.path)).fileName()}};
    const double last_s = session.samples.empty() ? 0.0 : session.samples.back().time_s;
    if (const auto pace = simulationPace(session, last_s))
        rows.insert(3, {RecordText::tr("Simulation"), paceWords(*pace)});
    const auto add = [&](const QString& name, const std::string& value) {
        if (!value.empty())
            rows.emplace_back(name, QString::fromStdString(value));
    };
    if (const QString wrong = wrongRatesText(session.experiment); !wrong.isEmpty())
        rows.emplace_back(RecordText::tr("Heat rates at Start"), wrong);
    add(RecordText::tr("Operator"), session.labels.operatorName);
    add(RecordText::tr("Sample"), session.labels.sample);
    add(RecordText::tr("Batch"), session.labels.batch);
    QString text = facts(rows);
    if (session.samples.empty())
        text += paragraph(
            RecordText::tr("No samples were recorded: there are no traces, trajectories and metrics."),
            "warning");
    if (isAltered(input))
        text +=
            paragraph(RecordText::tr("This recording was altered after it had been recorded, so nothing here "
                                     "is proven; bask verify tells where."),
                      "warning");
    return text;
}

namespace {

/// The view factors of an object in a run, of the samples in which both are known.
struct SeenShade {
    double F = 0.0, unshaded = 0.0, largestShare = 0.0;
    std::size_t samples = 0;

    void add(const ObjectSample& object) {
        if (!std::isfinite(object.viewFactor) || !std::isfinite(object.unshadedViewFactor))
            return;
        F += object.viewFactor;
        unshaded += object.unshadedViewFactor;
        ++samples;
        largestShare = std::fmax(largestShare, shadedShare(object)); // the other one where one is NaN
    }
};

QString percent(double share) {
    return QLocale().toString(100.0 * share, 'f', 1) + QStringLiteral("\u00a0%");
}

/// Nothing where no object lost a share worth a sentence.
QString shadeTable(const SessionRecord& session) {
    std::vector<SeenShade> seen(session.experiment.objects.size());
    for (const TraceSample& sample : session.controlledSamples())
        for (std::size_t i = 0; i < seen.size(); ++i)
            seen[i].add(sample.objects[i]);
    if (std::ranges::none_of(seen, [](const SeenShade& s) { return s.largestShare >= kMinToldShare; }))
        return {};
    html::Table table({RecordText::tr("Object"), RecordText::tr("Mean view factor"),
                       RecordText::tr("Without shade"), RecordText::tr("Taken by the others, mean"),
                       RecordText::tr("Taken by the others, largest")},
                      {1, 2, 3, 4});
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const SeenShade& s = seen[i];
        const QString name = QString::fromStdString(session.experiment.objects[i].name);
        if (s.samples == 0) {
            table.add({name, RecordText::tr("not known"), {}, {}, {}});
            continue;
        }
        const auto count = static_cast<double>(s.samples);
        table.add({name, QLocale().toString(s.F / count, 'f', 4),
                   QLocale().toString(s.unshaded / count, 'f', 4),
                   percent(s.unshaded > 0.0 ? 1.0 - s.F / s.unshaded : 0.0), percent(s.largestShare)});
    }
    return subheading(RecordText::tr("Shade of the objects on one another, from Start until Stop")) +
           table.text();
}

QString readByWords(ReadBy readBy) {
    switch (readBy) {
    case ReadBy::Contact:
        break;
    case ReadBy::Camera:
        return RecordText::tr("thermal camera");
    case ReadBy::Both:
        return RecordText::tr("sensor, checked by the thermal camera");
    }
    return RecordText::tr("sensor on the object");
}

/// Nothing for a rig without a thermal camera.
QString cameraTable(const SessionRecord& session, const TraceSample& last, TemperatureUnit unit) {
    if (!session.rig().hasThermalCamera || last.objects.empty())
        return {};
    html::Table table({RecordText::tr("Object"), RecordText::tr("Temperature by"), RecordText::tr("Measured"),
                       RecordText::tr("By the camera, ± 2 standard uncertainties"),
                       RecordText::tr("Largest difference across the face"), RecordText::tr("Pixels")},
                      {2, 3, 4, 5});
    for (std::size_t i = 0; i < last.objects.size(); ++i) {
        const ObjectSpec& object = session.experiment.objects[i];
        const CameraSample& camera = last.objects[i].camera;
        const bool isRead = std::isfinite(camera.T_K);
        table.add(
            {QString::fromStdString(object.name), readByWords(object.readBy),
             formatTemperature(last.objects[i].measured_K, unit),
             isRead ? formatReading(camera.T_K, camera.uncertainty_K, unit) : RecordText::tr("not read"),
             formatDifference(camera.spread_K, unit, 2),
             isRead ? QLocale().toString(camera.pixels, 'f', 0) : QString()});
    }
    return subheading(RecordText::tr("The thermal camera at the last sample until Stop")) + table.text();
}

/// One row for each object.
QString metricTable(const SessionRecord& session, const RunMetrics& run,
                    std::span<const ObjectMetric> metrics, TemperatureUnit unit) {
    QStringList header{RecordText::tr("Object")};
    QList<int> numbers;
    for (const ObjectMetric metric : metrics) {
        header << metricName(metric);
        numbers << static_cast<int>(header.size()) - 1;
    }
    html::Table table(header, numbers);
    for (std::size_t i = 0; i < run.objects.size(); ++i) {
        QStringList cells{QString::fromStdString(session.experiment.objects[i].name)};
        for (const ObjectMetric metric : metrics)
            cells << metricText(metric, run, i, unit);
        table.add(cells);
    }
    return table.text();
}

} // namespace

QString metricsSection(const SessionRecord& session, TemperatureUnit unit) {
    const RunMetrics metrics = runMetrics(session);
    QString text = heading(RecordText::tr("Metrics")) + metricTable(session, metrics, kReadMetrics, unit);
    QList<std::pair<QString, QString>> definitions;
    for (const ObjectMetric metric : kReadMetrics)
        definitions << std::pair(metricName(metric), metricDefinition(metric, metrics.band_K, unit));
    if (!metrics.trueObjects.empty()) {
        text += metricTable(session, metrics, kTrueMetrics, unit);
        definitions << std::pair(metricName(kTrueMetrics.front()) + QStringLiteral(", \u2026"),
                                 metricDefinition(kTrueMetrics.front(), metrics.band_K, unit));
    }
    QList<std::pair<QString, QString>> run;
    for (const RunMetric metric : kRunMetrics) {
        run << std::pair(metricName(metric), metricText(metric, metrics));
        definitions << std::pair(metricName(metric), metricDefinition(metric));
    }
    return text + facts(run) + shadeTable(session) + cameraTable(session, metrics.last, unit) +
           subheading(RecordText::tr("Definitions")) + facts(definitions);
}

QString eventsSection(const SessionRecord& session, TemperatureUnit unit) {
    QString text = heading(RecordText::tr("Alarms, events, notes and commands"));
    const std::vector<Line> lines = linesOf(session, unit);
    if (lines.empty())
        return text + paragraph(RecordText::tr("None was recorded."));
    QStringList header{RecordText::tr("No."), RecordText::tr("Time (s)"), RecordText::tr("Kind"),
                       RecordText::tr("What")};
    const bool isSigned =
        std::ranges::any_of(lines, [](const Line& line) { return !line.operatorName.empty(); });
    if (isSigned)
        header << RecordText::tr("Operator");
    html::Table table(header, {0, 1});
    for (std::size_t k = 0; k < lines.size() && k < kMaxReportRows; ++k) {
        QStringList cells{lines[k].number > 0 ? QString::number(lines[k].number) : QString(),
                          time(lines[k].time_s), lines[k].kind, lines[k].text};
        if (isSigned)
            cells << QString::fromStdString(lines[k].operatorName);
        table.add(cells);
    }
    text += table.text();
    if (const auto more = static_cast<int>(lines.size()) - kMaxReportRows; more > 0)
        text += paragraph(RecordText::tr(
            "%n more row(s) are in the session file; bask export --csv lists them.", nullptr, more));
    return text;
}

QString originSection(const RunReportInput& input) {
    const SessionRecord& session = input.session;
    return heading(RecordText::tr("Origin")) +
           facts({{RecordText::tr("Recorded by"), session.software.empty()
                                                      ? RecordText::tr("not known")
                                                      : QString::fromStdString(session.software)},
                  {RecordText::tr("Report made by"),
                   QStringLiteral("Bask %1, Qt %2, VTK %3, %4")
                       .arg(QStringLiteral(BASK_VERSION), QString::fromLatin1(qVersion()),
                            QString::fromStdString(versionOfVtk()), QSysInfo::prettyProductName())},
                  {RecordText::tr("Report made at"), utcText(input.now)},
                  {RecordText::tr("Session file"), QString::fromStdString(session.path)},
                  {RecordText::tr("Size of the session file"),
                   RecordText::tr("%1 bytes").arg(QLocale().toString(input.fileBytes))},
                  {QStringLiteral("SHA-256"),
                   input.sha256.isEmpty() ? RecordText::tr("not known") : input.sha256},
                  {RecordText::tr("Head of the hash chain (bask verify --head)"), headWords(input)}}) +
           (session.interrupted()
                ? paragraph(RecordText::tr("The checksum is of the file without the log beside it."), "quiet")
                : QString());
}

} // namespace bask
