// bask study: which study, with which options.

#include "app/commands/command_line.h"
#include "app/commands/parse_command.h"
#include "app/commands/studies.h"
#include "app/commands/study_output.h"
#include "engine/control/controller_catalogue.h"

#include <QCommandLineParser>

#include <cmath>
#include <optional>

namespace bask {
namespace {

constexpr int kMinElements = 10, kMaxElements = 20000;
constexpr int kMaxCount = 100000;
constexpr double kMaxRateError = 8.0; // as experiments have it
constexpr double kMaxConvection_W_m2K = 50.0, kMaxLag_s = 30.0, kMaxLatency_s = 2.0;
constexpr double kMaxUneven_percent = 50.0;
const QString kViewFactor = QStringLiteral("view-factor"), kClosedLoop = QStringLiteral("closed-loop"),
              kAlarms = QStringLiteral("alarms");

/// Reads options one by one and keeps the first complaint.
class Options {
public:
    explicit Options(const QCommandLineParser& parser) : m_parser(parser) {}

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
    /// Options of the other study.
    void none(const QStringList& names, const QString& study) {
        for (const QString& name : names)
            if (m_parser.isSet(name) && m_complaint.isEmpty())
                m_complaint = QStringLiteral("--%1 is no option of the study %2").arg(name, study);
    }

private:
    void refuse(const QString& name, const QString& expected) {
        if (m_complaint.isEmpty())
            m_complaint = QStringLiteral("--%1 %2 is not %3").arg(name, m_parser.value(name), expected);
    }

    const QCommandLineParser& m_parser;
    QString m_complaint;
};

int runViewFactor(const QCommandLineParser& parser, const QString& folder) {
    Options options(parser);
    options.none({"controller", "count", "seed", "source-model", "rate-error", "mounting", "convection",
                  "lag", "latency", "uneven", "kind", "first"},
                 kViewFactor);
    const int elements = options.wholeNumber("elements", kMinElements, kMaxElements);
    if (!options.complaint().isEmpty())
        return refuseStudy(options.complaint());
    return viewFactorStudyCommand(folder, elements);
}

/// As in files, but for the level servo's short name.
QStringList controllers() {
    QStringList names;
    for (const ControllerEntry& entry : controllerCatalogue())
        names << (entry.kind == ControllerKind::LevelServo ? QStringLiteral("level")
                                                           : QString::fromUtf8(entry.key));
    return names;
}

int runClosedLoop(const QCommandLineParser& parser, const QString& folder) {
    Options options(parser);
    options.none({"elements", "kind", "first"}, kClosedLoop);
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
    if (!options.complaint().isEmpty())
        return refuseStudy(options.complaint());
    return closedLoopStudyCommand(folder, request);
}

int runAlarms(const QCommandLineParser& parser, const QString& folder) {
    Options options(parser);
    options.none({"elements", "controller", "source-model", "rate-error", "mounting", "convection", "lag",
                  "latency", "uneven"},
                 kAlarms);
    static constexpr AlarmDraw kDraws[] = {AlarmDraw::Healthy, AlarmDraw::Faulty, AlarmDraw::Paper};
    AlarmRequest request;
    request.draw = kDraws[options.oneOf("kind", {"healthy", "faulty", "paper"})];
    request.count = options.wholeNumber("count", 1, kMaxCount);
    request.seed = options.seed();
    request.first = options.wholeNumber("first", 1, kMaxCount);
    if (!options.complaint().isEmpty())
        return refuseStudy(options.complaint());
    return alarmStudyCommand(folder, request);
}

void addOptions(QCommandLineParser& parser) {
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
}

} // namespace

int studyCommand(const QStringList& arguments) {
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
        "Exit code 3: an alarm was false, or a fault that showed itself was not found.");
    addOptions(parser);
    parser.addPositionalArgument("STUDY", "view-factor, closed-loop or alarms.");
    if (const auto code = parseCommand(parser, "study", arguments, 1))
        return *code;
    const QString study = parser.positionalArguments().front();
    const auto run = study == kViewFactor   ? runViewFactor
                     : study == kClosedLoop ? runClosedLoop
                     : study == kAlarms     ? runAlarms
                                            : nullptr;
    if (run == nullptr)
        return refuseStudy(QStringLiteral("there is no study \"%1\"; known: %2, %3, %4")
                               .arg(study, kViewFactor, kClosedLoop, kAlarms));
    const QString folder = parser.value("output");
    if (folder.isEmpty())
        return refuseStudy(QStringLiteral("-o DIR is needed"));
    return run(parser, folder);
}

} // namespace bask
