#include "app/studies/study_request.h"

#include "app/commands/parse_command.h"
#include "app/studies/study_output.h"
#include "engine/control/controller_catalogue.h"

#include <QCommandLineParser>
#include <nlohmann/json.hpp>

#include <cmath>
#include <optional>

namespace bask {
namespace {

constexpr int kMinElements = 10, kMaxElements = 20000;
constexpr int kMaxCount = 1'000'000;
constexpr double kMaxRateError = 8.0; // as experiments have it
constexpr double kMaxConvection_W_m2K = 50.0, kMaxLag_s = 30.0, kMaxLatency_s = 2.0;
constexpr double kMaxUneven_percent = 50.0;
const QString kViewFactor = QStringLiteral("view-factor"), kClosedLoop = QStringLiteral("closed-loop"),
              kAlarms = QStringLiteral("alarms");

/// Options that every study has.
const QStringList kCommon{QStringLiteral("h"), QStringLiteral("help"), QStringLiteral("o"),
                          QStringLiteral("output")};
/// Of how a study's runs are computed, not of what they are.
const QStringList kHow{QStringLiteral("shard"), QStringLiteral("resume"), QStringLiteral("threads"),
                       QStringLiteral("processor")};

/// Reads options one by one and keeps the first complaint.
class Options {
public:
    /// `own` are those of the study; others are refused.
    Options(const QCommandLineParser& parser, const QString& study, const QStringList& own)
        : m_parser(parser) {
        for (const QString& name : parser.optionNames())
            if (!own.contains(name) && !kCommon.contains(name) && m_complaint.isEmpty())
                m_complaint = QStringLiteral("--%1 is no option of the study %2").arg(name, study);
    }

    const QString& complaint() const { return m_complaint; }

    int wholeNumber(const QString& name, int min, int max) {
        bool isNumber = false;
        const int value = m_parser.value(name).toInt(&isNumber);
        if (!isNumber || value < min || value > max)
            refuse(name, QStringLiteral("a whole number from %1 to %2").arg(min).arg(max));
        return value;
    }
    std::uint64_t seed() {
        bool isNumber = false;
        const std::uint64_t value = m_parser.value("seed").toULongLong(&isNumber);
        if (!isNumber)
            refuse("seed", QStringLiteral("a whole number from 0"));
        return value;
    }
    double number(const QString& name, double min, double max) {
        bool isNumber = false;
        const double value = m_parser.value(name).toDouble(&isNumber);
        if (!isNumber || !(value >= min && value <= max))
            refuse(name, QStringLiteral("a number from %1 to %2").arg(min).arg(max));
        return value;
    }
    /// Index of the value in `words`.
    int oneOf(const QString& name, const QStringList& words) {
        const auto index = words.indexOf(m_parser.value(name));
        if (index < 0)
            refuse(name, QStringLiteral("one of ") + words.join(QStringLiteral(", ")));
        return static_cast<int>(std::max<qsizetype>(index, 0));
    }

private:
    void refuse(const QString& name, const QString& expected) {
        if (m_complaint.isEmpty())
            m_complaint = QStringLiteral("--%1 %2 is not %3").arg(name, m_parser.value(name), expected);
    }

    const QCommandLineParser& m_parser;
    QString m_complaint;
};

/// The request, or the first complaint in the name of the command that asks.
template <class Request>
AskedStudy checked(const char* command, const Options& options, Request request, const QString& folder,
                   const ShardOptions& shard) {
    if (!options.complaint().isEmpty())
        return refuse(command, options.complaint());
    return StudyRequest{std::move(request), folder, shard};
}

AskedStudy readViewFactor(const QCommandLineParser& parser, const QString& folder) {
    Options options(parser, kViewFactor, {"elements"});
    const ViewFactorRequest request{options.wholeNumber("elements", kMinElements, kMaxElements)};
    return checked("study", options, request, folder, {});
}

/// As in files, but for the level servo's short name.
QStringList controllers() {
    QStringList names;
    for (const ControllerEntry& entry : controllerCatalogue())
        names << (entry.kind == ControllerKind::LevelServo ? QStringLiteral("level")
                                                           : QString::fromUtf8(entry.kind.key()));
    return names;
}

const QStringList kClosedLoopOptions{"controller", "source-model", "mounting", "rate-error", "convection",
                                     "lag",        "latency",      "uneven",   "count",      "seed"};
const QStringList kAlarmOptions{"kind", "read-by", "count", "seed", "first"};

/// What was asked for, of a study that can be divided, as PartHeader::work.
std::string asked(const QCommandLineParser& parser, const QString& study, const QStringList& options) {
    nlohmann::json work{{"study", study.toStdString()}};
    for (const QString& name : options)
        work[name.toStdString()] = parser.value(name).toStdString();
    return work.dump();
}

AskedStudy readClosedLoop(const QCommandLineParser& parser, const char* command, const QString& folder,
                          const ShardOptions& shard) {
    Options options(parser, kClosedLoop, kClosedLoopOptions + kHow);
    static constexpr SourceModel kModels[] = {SourceModel::Gray, SourceModel::Paper};
    static constexpr StudyMounting kMountings[] = {StudyMounting::Triangle, StudyMounting::Line,
                                                   StudyMounting::Random, StudyMounting::Heights};
    ClosedLoopRequest request;
    request.controller =
        controllerCatalogue()[static_cast<std::size_t>(options.oneOf("controller", controllers()))].kind;
    request.sourceModel = kModels[options.oneOf("source-model", {"gray", "paper"})];
    request.mounting = kMountings[options.oneOf("mounting", {"triangle", "line", "random", "heights"})];
    request.rateError = options.number("rate-error", 1.0, kMaxRateError);
    request.convection_W_m2K = options.number("convection", 0.0, kMaxConvection_W_m2K);
    request.sensorLag_s = options.number("lag", 0.0, kMaxLag_s);
    request.robotLatency_s = options.number("latency", 0.0, kMaxLatency_s);
    request.uneven = 0.01 * options.number("uneven", 0.0, kMaxUneven_percent);
    request.count = options.wholeNumber("count", 1, kMaxCount);
    request.seed = options.seed();
    request.asked = asked(parser, kClosedLoop, kClosedLoopOptions);
    return checked(command, options, std::move(request), folder, shard);
}

AskedStudy readAlarms(const QCommandLineParser& parser, const char* command, const QString& folder,
                      const ShardOptions& shard) {
    Options options(parser, kAlarms, kAlarmOptions + kHow);
    static constexpr AlarmDraw kDraws[] = {AlarmDraw::Healthy, AlarmDraw::Faulty, AlarmDraw::Paper};
    static constexpr ReadBy kReadBy[] = {ReadBy::Contact, ReadBy::Camera, ReadBy::Both};
    AlarmRequest request;
    request.draw = kDraws[options.oneOf("kind", {"healthy", "faulty", "paper"})];
    request.readBy = kReadBy[options.oneOf("read-by", {"contact", "camera", "both"})];
    request.count = options.wholeNumber("count", 1, kMaxCount);
    request.seed = options.seed();
    request.first = options.wholeNumber("first", 1, kMaxCount);
    request.asked = asked(parser, kAlarms, kAlarmOptions);
    return checked(command, options, std::move(request), folder, shard);
}

AskedStudy readDivided(const QCommandLineParser& parser, const QString& study, const char* command,
                       const QString& folder, const ShardOptions& shard) {
    return study == kClosedLoop ? readClosedLoop(parser, command, folder, shard)
                                : readAlarms(parser, command, folder, shard);
}

void addStudyOptions(QCommandLineParser& parser) {
    parser.addOption({{"h", "help"}, "Displays this help."});
    parser.addOption({{"o", "output"}, "Folder for the files; made if it is not there. Required.", "DIR"});
    parser.addOption({"elements",
                      "view-factor: most elements on each face of the surface integral, 10 to 20000.", "N",
                      "20000"});
    parser.addOptions(
        {{"controller",
          QStringLiteral("closed-loop: one of %1.").arg(controllers().join(QStringLiteral(", "))), "NAME",
          "level"},
         {"count", "closed-loop, alarms: number of runs.", "N", "200"},
         {"seed", "closed-loop, alarms: of everything that is drawn.", "N", "1"},
         {"first", "alarms: number of the first run, to repeat one of a table (with --count 1).", "N", "1"},
         {"kind",
          "alarms: healthy, faulty (each fault in turn) or paper (the paper's experiments, each by its own\n"
          "controller and by the level servo, seed after seed).",
          "NAME", "healthy"},
         {"read-by",
          "alarms: what tells the objects' temperatures: contact (sensors), camera (a simulated thermal\n"
          "camera) or both (sensors, with the camera as a second opinion).",
          "NAME", "contact"},
         {"source-model", "closed-loop: gray or paper.", "NAME", "gray"},
         {"rate-error", "closed-loop: estimated rates are wrong by random factors within this one, 1 to 8.",
          "FACTOR", "4"},
         {"mounting",
          "closed-loop: the objects on a triangle, a line, at random places, or there at random heights and\n"
          "tilts (heights).",
          "NAME", "triangle"},
         {"convection", "closed-loop: h of each run, drawn up to this and unknown, 0 to 50 W/(m2 K).", "H",
          "0"},
         {"lag", "closed-loop: lag of the sensors, drawn up to this, 0 to 30 s.", "S", "0"},
         {"latency", "closed-loop: latency of the robot, drawn up to this, 0 to 2 s.", "S", "0"},
         {"uneven",
          "closed-loop: the simulated source is uneven, which the controller does not know: seven parts, "
          "each "
          "hotter or colder by up to so much of its temperature above the room, drawn up to this, 0 to 50 %.",
          "PERCENT", "0"}});
    addShardOptions(parser);
}

} // namespace

AskedStudy readStudy(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription(
        "view-factor repeats the study of the paper's Appendix B on Bask's bunny over a disk at 5 cm: the\n"
        "surface integral with n elements, the Fourier method with h harmonics and Bask's own solver, each\n"
        "with value, error and time. Writes view_factor_study.csv and four figures, and prints a summary.\n\n"
        "closed-loop lets a controller bring three objects to random targets that a pose holds, from random\n"
        "starts, with wrong estimates of the materials. Writes closed_loop_study.csv and three figures;\n"
        "prints each failure with its reason, the success rate, the settling time over the least that\n"
        "physics allows, and the overshoot.\n\n"
        "alarms runs experiments at random, healthy or with a fault, and holds each alarm against what the\n"
        "simulated plant truly does. Writes alarm_study_KIND.csv; prints false trips and false words an "
        "hour,\n"
        "rate and time of detection by fault, the hottest object over its trip limit, alarms by priority.\n"
        "Exit code 3: an alarm was false, or a fault that showed itself was not found.\n\n"
        "closed-loop and alarms can be divided among processes with --shard: the same files, byte for byte,\n"
        "come out of bask merge, whatever the number of shards.");
    addStudyOptions(parser);
    parser.addPositionalArgument("STUDY", "view-factor, closed-loop or alarms.");
    if (const auto code = parseCommand(parser, "study", arguments, 1))
        return *code;
    const QString study = parser.positionalArguments().front();
    if (study != kViewFactor && study != kClosedLoop && study != kAlarms)
        return refuseStudy(QStringLiteral("there is no study \"%1\"; known: %2, %3, %4")
                               .arg(study, kViewFactor, kClosedLoop, kAlarms));
    const QString folder = parser.value("output");
    if (folder.isEmpty())
        return refuseStudy(QStringLiteral("-o DIR is needed"));
    if (study == kViewFactor)
        return readViewFactor(parser, folder);
    const auto shard = readShardOptions(parser);
    if (!shard)
        return refuseStudy(shard.error());
    return readDivided(parser, study, "study", folder, *shard);
}

AskedStudy readMergedStudy(const nlohmann::json& work, const QString& folder) {
    QStringList arguments{QStringLiteral("bask")};
    QString study;
    const QString unknown = QStringLiteral("the parts are of a study that this Bask does not know");
    for (const auto& [key, value] : work.items())
        if (!value.is_string())
            return refuse("merge", unknown);
        else if (key == "study")
            study = QString::fromStdString(value.get<std::string>());
        else if (key != "software" && key != "processor")
            arguments << "--" + QString::fromStdString(key)
                      << QString::fromStdString(value.get<std::string>());
    QCommandLineParser parser;
    addStudyOptions(parser);
    if (!parser.parse(arguments) || (study != kClosedLoop && study != kAlarms))
        return refuse("merge", unknown);
    return readDivided(parser, study, "merge", folder, {});
}

} // namespace bask
