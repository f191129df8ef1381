// Reports and figures of sessions, by the subcommands.

#include "app/commands/command_line.h"
#include "app/drawing/session_outputs.h"
#include "app/report/report_record.h"
#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/control/controller_catalogue.h"
#include "engine/model/experiment_parameters.h"
#include "engine/recording/session_header.h"
#include "tests/engine/recording/recording.h"
#include "tests/support/captured_command.h"

#include <gtest/gtest.h>

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QImage>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTextDocument>

#include <algorithm>
#include <cmath>
#include <limits>

namespace bask {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// A warming to the targets in two minutes, on a simulated or a real rig.
TraceSample warming(const Experiment& experiment, int k, bool simulated) {
    TraceSample sample = test::madeUpSample(experiment, k);
    sample.time_s = 0.5 * k;
    sample.coordinates << 0.03 * std::cos(0.02 * k), 0.03 * std::sin(0.02 * k), 0.1, 0.0, 0.0, 0.0;
    sample.source.setZero();
    for (ObjectSample& object : sample.objects) {
        object.measured_K = object.target_K - 15.0 * std::exp(-sample.time_s / 20.0);
        object.estimated_K = object.measured_K;
        object.true_K = simulated ? object.measured_K + 0.01 : kNaN;
        object.valid = k < 50 || k > 60;
    }
    return sample;
}

class RunReport : public ::testing::Test {
protected:
    QString path(const char* name) const { return m_folder.filePath(name); }

    /// Records a session; without an outcome it is an interrupted one.
    QString recorded(const Experiment& experiment, int samples, const std::string& outcome,
                     bool simulated = true) const {
        const QString file = path("run.bask");
        QFile::remove(file);
        auto writer = SessionWriter::create(file.toStdString(), experiment, simulated);
        EXPECT_TRUE(writer);
        EXPECT_TRUE((*writer)->add(CommandRow{
            0.0, "arm",
            R"({"environment_K":297.97,"offsets_K":[0.07,-0.126],"zeroed_utc_s":1795426034.927})"}));
        EXPECT_TRUE((*writer)->add(CommandRow{0.0, "start", R"({"accept_infeasible":false})"}));
        EXPECT_TRUE((*writer)->add(CommandRow{0.0, "targets", R"({"targets_K":[313.15,320.65]})"}));
        EXPECT_TRUE((*writer)->add(CommandRow{
            0.0, "controller",
            R"({"kind":"level-servo","level_servo":{"time_constant_s":20},"adaptive":{"mu_1_s":1},"damping":0.5})"}));
        EXPECT_TRUE((*writer)->add(CommandRow{0.0, "later", R"({"a_K":[1.5,-2],"b":true})"}));
        EXPECT_TRUE((*writer)->add(CommandRow{0.0, "speed", R"({"factor":4.0})"}));
        EXPECT_TRUE((*writer)->add(CommandRow{0.0, "source-temperature", R"({"temperature_K":453.15})"}));
        EXPECT_TRUE((*writer)->add(CommandRow{0.0, "fault", R"({"fault":"sensor-lost","object":"right"})"}));
        EXPECT_TRUE((*writer)->add(CommandRow{0.0, "fault", R"({"fault":"source-lost","on":false})"}));
        EXPECT_TRUE((*writer)->add(CommandRow{0.0, "stop", ""}));
        EXPECT_TRUE((*writer)->add(TraceEvent{0.0, {MessageCode::EventStarted, {}}}));
        for (int k = 0; k < samples; ++k)
            EXPECT_TRUE((*writer)->add(warming(experiment, k, simulated)));
        EXPECT_TRUE((*writer)->add(TraceEvent{30.0, {MessageCode::ReasonSensorInvalid, {"right"}}}));
        EXPECT_TRUE(
            (*writer)->add(CommandRow{30.5, "acknowledge", R"({"alarm":"ReasonSensorInvalid:right"})"}));
        EXPECT_TRUE((*writer)->add(TraceNote{31.0, "<script>alert(1)</script> noted"}));
        if (!outcome.empty()) {
            EXPECT_TRUE((*writer)->finish(outcome));
        }
        return file;
    }

    /// The report's text as it was written.
    QByteArray report(const QString& session, const char* name = "report.html") const {
        const auto done = test::captured(reportCommand, {session, "-o", path(name)});
        EXPECT_EQ(done.code, kExitDone) << done.err;
        QFile file(path(name));
        EXPECT_TRUE(file.open(QIODevice::ReadOnly));
        return file.readAll();
    }

    /// What a person reads of it.
    static QString readable(const QByteArray& html) {
        QTextDocument document;
        document.setHtml(QString::fromUtf8(html));
        return document.toPlainText().replace(QChar(0x00a0), u' ');
    }

    QTemporaryDir m_folder;
};

// Catches a limit that a run had and its report does not tell.
TEST_F(RunReport, ListsEverySafetyLimitThatIsSet) {
    Experiment experiment = test::twoDisks();
    experiment.safety.pauseLimit_s = 12.5;
    experiment.safety.sourceTrip_K = kelvinFromCelsius(234.5);
    const QString text = readable(report(recorded(experiment, 240, "settled")));
    for (const Parameter<SafetySpec>& limit : safetyParameters())
        EXPECT_EQ(text.contains(QString::fromUtf8(limit.label)), limit.get(experiment.safety).has_value())
            << limit.name;
    EXPECT_TRUE(text.contains("12.5 s")) << text.toStdString();
    EXPECT_TRUE(text.contains("234.5 °C"));
}

// Catches a report of an altered recording that looks like any other, and one that calls a true one altered.
TEST_F(RunReport, SaysThatTheRecordingWasAltered) {
    auto session = readSession(recorded(test::twoDisks(), 240, "settled").toStdString());
    ASSERT_TRUE(session);
    RunReportInput input = reportInput(*session, TemperatureUnit::Celsius);
    ASSERT_TRUE(input.integrity);
    ASSERT_TRUE(input.integrity->isIntact());
    const QString head = QString::fromStdString(input.integrity->head);
    QString text = readable(runReportHtml(input));
    EXPECT_TRUE(text.contains(head));
    EXPECT_FALSE(text.contains(QStringLiteral("altered")));
    input.integrity->allFindings = 1;
    text = readable(runReportHtml(input));
    EXPECT_FALSE(text.contains(head));
    EXPECT_TRUE(text.contains(QStringLiteral("This recording was altered")));
}

TEST_F(RunReport, HasEverySectionAndTellsTheNumbers) {
    const QString session = recorded(test::twoDisks(), 240, "settled");
    const QByteArray html = report(session);
    const QString text = readable(html);
    for (const char* section : {"two disks, \"quoted\", with a comma", "Metrics", "Definitions",
                                "Traces and trajectories", "Set-up", "Feasibility of the targets",
                                "Calibration", "Alarms, events, notes and commands", "Origin"})
        EXPECT_TRUE(text.contains(section)) << section;
    EXPECT_TRUE(text.contains("SIMULATED"));
    EXPECT_TRUE(text.contains("All objects settled."));
    EXPECT_TRUE(text.contains("for 30 s by the controller's estimates")) << "which is not the settling time";
    EXPECT_TRUE(text.contains(QString::fromUtf8("\u00b1 0.18 K"))) << "0.25 K by the root of two sensors";
    EXPECT_TRUE(text.contains("The sensor of \"right\"")) << text.toStdString();
    EXPECT_TRUE(text.contains("alarm, priority 3"));
    for (const char* command :
         {"Arm: surroundings 24.82 °C; offsets of the sensors +0.07 K, "
          "\u22120.13 K; zeroed 2026-11-23 09:27:14 UTC",
          "\nStart\n", "Targets: 40.00 °C, 47.50 °C",
          "Controller: damping 0.5; Level servo; time_constant_s 20\n", "later: a_K 1.5, -2; b true",
          "Speed of the simulation: \u00d7 4", "Temperature of the source, as typed: 180.00 °C",
          "Simulated fault: Sensor lost; right", "Simulated fault: Heat source lost; ended",
          "Acknowledge: The sensor of \"right\""})
        EXPECT_TRUE(text.contains(QString::fromUtf8(command))) << command << text.toStdString();
    EXPECT_TRUE(text.contains("40.0 °C"));
    const double step_K = 15.0 - 0.01; // of the true temperature
    const double rise_s = 20.0 * std::log((0.9 * step_K + 0.01) / (0.1 * step_K + 0.01));
    EXPECT_TRUE(text.contains(QString::number(rise_s, 'f', 1) + " s")) << text.toStdString();
    QFile file(session);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const QByteArray sha = QCryptographicHash::hash(file.readAll(), QCryptographicHash::Sha256).toHex();
    EXPECT_TRUE(text.contains(sha)) << "of the file as it lies there";
    EXPECT_TRUE(text.contains(QString("Qt ") + qVersion()));
}

// Catches a controller of the catalogue whose gains the report leaves out, and those of all others that it
// lists.
TEST_F(RunReport, TellsTheGainsOfTheChosenControllerAlone) {
    SessionRecord session;
    session.experiment = test::twoDisks();
    for (const ControllerEntry& chosen : controllerCatalogue()) {
        std::string value = std::string(R"({"kind":")") + chosen.kind.key() + '"';
        for (const ControllerEntry& each : controllerCatalogue())
            value += std::string(",\"") + each.group + R"(":{"gain_of_)" + each.group + R"(":1.5})";
        session.commands = {CommandRow{0.0, "controller", value + '}'}};
        const QString text = readable(eventsSection(session, TemperatureUnit::Celsius).toUtf8());
        for (const ControllerEntry& each : controllerCatalogue())
            EXPECT_EQ(text.contains(QStringLiteral("gain_of_") + QLatin1String(each.group)), &each == &chosen)
                << text.toStdString();
    }
}

// Catches: a report that needs other files or the network, or that runs what somebody noted.
TEST_F(RunReport, IsSelfContainedAndEscapesWhatWasTyped) {
    const QByteArray html = report(recorded(test::twoDisks(), 240, "settled"));
    EXPECT_FALSE(html.contains("<script"));
    EXPECT_TRUE(html.contains("&lt;script&gt;"));
    EXPECT_TRUE(readable(html).contains("within ±15.0 K")) << "the errors' figure is not cut";
    int figures = 0;
    auto sources = QRegularExpression("src=\"([^\"]*)\"").globalMatch(QString::fromUtf8(html));
    while (sources.hasNext()) {
        const QString source = sources.next().captured(1);
        ASSERT_TRUE(source.startsWith("data:image/png;base64,")) << source.left(60).toStdString();
        const QImage image = QImage::fromData(QByteArray::fromBase64(source.mid(22).toLatin1()));
        EXPECT_GT(image.width(), 1000);
        ++figures;
    }
    EXPECT_EQ(figures, 5);
    EXPECT_FALSE(html.contains("href=") || html.contains("url("));
}

// Catches a source that warmed up during the run, and minutes between Arm and Start, of which nothing is
// told.
TEST_F(RunReport, TellsTheSourceAndTheMomentOfStart) {
    auto session = readSession(recorded(test::twoDisks(), 240, "settled").toStdString());
    ASSERT_TRUE(session);
    QString text = readable(runReportHtml(reportInput(*session, TemperatureUnit::Celsius)));
    EXPECT_FALSE(text.contains("Start at")) << "an older recording does not say it";
    session->created = "2026-11-29T22:17:32Z";
    std::ranges::find(session->commands, "start", &CommandRow::name)->value =
        R"({"environment_K":297.97,"started_utc_s":1795991862.4})";
    for (TraceSample& sample : session->samples)
        sample.source_K = kelvinFromCelsius(107.0 + sample.time_s);
    session->events.push_back({60.2, {MessageCode::EventSettled, {}}});
    session->experiment.source.temperature_K = kelvinFromCelsius(200.0);
    text = readable(runReportHtml(reportInput(*session, TemperatureUnit::Celsius)));
    for (const char* told :
         {"from Arm at 2026-11-29 22:17:32 UTC; Start at 2026-11-29 ",
          "at Start 107.0 °C (set point 200.0 °C)", "settled at 60.2 s 167.5 °C (set point 200.0 °C)",
          "at the end of control 226.5 °C (set point 200.0 °C)"})
        EXPECT_TRUE(text.contains(told)) << told << "\n" << text.toStdString();
}

TEST_F(RunReport, APdfHasPages) {
    const QByteArray pdf = report(recorded(test::twoDisks(), 240, "settled"), "report.pdf");
    EXPECT_TRUE(pdf.startsWith("%PDF"));
    EXPECT_TRUE(pdf.trimmed().endsWith("%%EOF"));
    const auto pages = QString::fromLatin1(pdf).count(QRegularExpression("/Type /Page\\b"));
    EXPECT_GE(pages, 4);
    EXPECT_LE(pages, 12);
}

TEST_F(RunReport, ARealRigIsNotCalledSimulated) {
    const QString text = readable(report(recorded(test::twoDisks(), 240, "stopped", false)));
    EXPECT_FALSE(text.contains("SIMULATED"));
    EXPECT_TRUE(text.contains("LIVE"));
    EXPECT_TRUE(text.contains("Stopped."));
    EXPECT_FALSE(text.contains("operator")) << "may have been a recipe's Stop";
}

// Catches: an outcome in the file's own English word.
TEST_F(RunReport, EveryOutcomeHasItsWords) {
    SessionRecord session;
    for (const auto& [outcome, words] : std::vector<std::pair<const char*, const char*>>{
             {"settled", "All objects settled."},
             {"not-settled", "Not all objects settled."},
             {"stopped", "Stopped."},
             {"emergency-stop", "Ended by STOP."},
             {"fault", "Ended by a fault."},
             {"", "Interrupted: the recording ended without a Stop. What had been written is reported."},
             {kOutcomeInterrupted, "Interrupted: the recording ended without a Stop, and was closed later. "
                                   "What had been written is reported."}}) {
        session.outcome = outcome;
        EXPECT_EQ(outcomeWords(session), QString(words));
    }
    // The retreat follows a Stop, and the record goes on after STOP.
    session.events = {{40.0, {MessageCode::EventEmergencyStop, {}}}};
    for (const char* outcome : {"", kOutcomeInterrupted}) {
        session.outcome = outcome;
        EXPECT_EQ(outcomeWords(session),
                  "The run had been stopped; what followed is not recorded to its end.");
    }
    session.outcome = "emergency-stop";
    EXPECT_EQ(outcomeWords(session), "Ended by STOP.");
}

TEST_F(RunReport, SaysWhatAnInterruptedOrEmptyRunLacks) {
    const QString interrupted = readable(report(recorded(test::twoDisks(), 20, "")));
    EXPECT_TRUE(interrupted.contains("Interrupted: the recording ended without a Stop."));
    EXPECT_TRUE(interrupted.contains("not settled"));
    const QString empty = readable(report(recorded(test::twoDisks(), 0, "fault")));
    EXPECT_TRUE(empty.contains("No samples were recorded"));
    EXPECT_TRUE(empty.contains("Ended by a fault."));
    EXPECT_FALSE(empty.contains("Traces and trajectories"));
    EXPECT_TRUE(report(recorded(test::twoDisks(), 1, "fault"), "one.pdf").startsWith("%PDF"));
    EXPECT_TRUE(report(recorded(test::twoDisks(), 0, ""), "none.pdf").startsWith("%PDF"));
}

// Catches a gain in another unit than the experiment's file has it in, and a material that is told in part.
TEST_F(RunReport, TellsGainsAndMaterialsWithTheirUnits) {
    Experiment experiment = test::twoDisks();
    experiment.controller.kind = ControllerKind::Adaptive;
    experiment.controller.adaptive.K = 0.25;
    experiment.objects[0].material.specificHeat_J_kgK = 911.0;
    experiment.objects[0].material.density_kg_m3 = 2755.0;
    const QString text = readable(report(recorded(experiment, 240, "not-settled")));
    EXPECT_TRUE(text.contains("K = 0.25 1/K")) << text.toStdString();
    for (const char* said : {"Specific heat (J/(kg K))", "911", "Density (kg/m\u00b3)", "2755"})
        EXPECT_TRUE(text.contains(QString::fromUtf8(said))) << said << text.toStdString();
}

// Catches a report that does not say where the values of a material are from and how good they are.
TEST_F(RunReport, TellsWhereAMaterialIsFrom) {
    Experiment experiment = test::twoDisks();
    experiment.objects[0].material.name = "our paint";
    experiment.objects[0].material.source = "DSC <sample 12>";
    experiment.objects[0].material.date = "2026-11-23";
    experiment.objects[0].material.emittance = 0.87;
    experiment.objects[0].material.uncertainties = {{"emittance", 0.0174}, {"thickness", 2e-5}};
    SessionRecord session;
    session.path = "run.bask";
    session.experiment = experiment;
    const QString html = runReportHtml(reportInput(session, TemperatureUnit::Celsius));
    EXPECT_TRUE(html.contains("our paint, DSC &lt;sample 12&gt;, 2026-11-23")) << html.toStdString();
    const QString text = readable(html.toUtf8());
    EXPECT_TRUE(text.contains(QString::fromUtf8("0.87 \u00b1 0.017"))) << text.toStdString();
    EXPECT_TRUE(text.contains(QString::fromUtf8("1 \u00b1 0.02"))) << text.toStdString(); // in mm
}

// Catches a comparison of controllers of which one began with wrong heat rates and the report does not say
// so.
TEST_F(RunReport, TellsTheHeatRatesWithWhichTheControllerBegan) {
    SessionRecord session;
    session.path = "run.bask";
    session.experiment = test::twoDisks();
    session.experiment.controller.estimatedRateErrorFactor = 1.0;
    session.samples = {test::madeUpSample(session.experiment, 9)};
    session.samples[0].objects[0].lambda1 = 0.1234;
    const auto text = [&session] {
        return readable(runReportHtml(reportInput(session, TemperatureUnit::Celsius)));
    };
    const QString right = text();
    EXPECT_TRUE(right.contains("Heat rates with which the controller began")) << right.toStdString();
    EXPECT_TRUE(right.contains("0.1234"));
    EXPECT_FALSE(right.contains("wrong by up to"));
    session.experiment.controller.estimatedRateErrorFactor = 4.0;
    const QString wrong = QString::fromUtf8("heat rates wrong by up to \u00d74, as the experiment asks");
    EXPECT_TRUE(text().contains(wrong)) << text().toStdString();
    for (ObjectSpec& object : session.experiment.objects)
        object.estimatedRates = HeatRates{0.2, 2e-11, 0.16};
    EXPECT_FALSE(text().contains(wrong)) << "given ones are taken as they stand";
}

// Catches times of a fast simulation that contradict each other without a word.
TEST_F(RunReport, TellsThatTheSimulationRanFast) {
    SessionRecord session;
    session.path = "run.bask";
    session.experiment = test::twoDisks();
    session.simulated = true;
    session.created = "2026-11-29T22:08:19Z";
    session.finished = "2026-11-29T22:09:16Z";
    session.samples = {test::madeUpSample(session.experiment, 0)};
    const auto text = [&session] {
        return readable(runReportHtml(reportInput(session, TemperatureUnit::Celsius)));
    };
    EXPECT_FALSE(text().contains("Faster than real time"));
    session.samples[0].time_s = 532.0;
    EXPECT_TRUE(
        text().contains("Faster than real time: 8:52 (min:s) of the simulated rig in 0:57 by the clock"))
        << text().toStdString();
}

// Catches an angle that is told as a length.
TEST_F(RunReport, TheMarginIsInTheUnitOfItsLimit) {
    SessionRecord session;
    session.path = "run.bask";
    session.experiment = test::twoDisks();
    RunReportInput input = reportInput(session, TemperatureUnit::Celsius);
    input.verdict.emplace();
    input.verdict->anyPose = input.verdict->feasible = true;
    input.verdict->margin = {radFromDeg(32.8) * kRadianLength_m, Limit::Workspace, kThetaX};
    const QString text = readable(runReportHtml(input));
    EXPECT_TRUE(
        text.contains(QString::fromUtf8("margin 32.8\u00b0 to the nearest limit (workspace \u03b8x)")))
        << text.toStdString();
}

TEST_F(RunReport, TellsTargetsThatCannotBeHeld) {
    Experiment experiment = test::twoDisks();
    experiment.objects[0].target_K = 380.0;
    const QString text = readable(report(recorded(experiment, 240, "not-settled")));
    EXPECT_TRUE(text.contains("The targets cannot be held together")) << text.toStdString();
    EXPECT_TRUE(text.contains("Not all objects settled."));
}

TEST_F(RunReport, CountsTheEventsThatItLeavesOut) {
    SessionRecord session;
    session.path = "run.bask";
    session.experiment = test::twoDisks();
    for (int k = 0; k < 5000; ++k)
        session.events.push_back({0.1 * k, {MessageCode::EventHeld, {}}});
    const QString text = readable(runReportHtml(reportInput(session, TemperatureUnit::Celsius)));
    EXPECT_TRUE(text.contains("4600 more row")) << text.toStdString();
}

TEST_F(RunReport, RefusesInWordsAndLeavesNothingBehind) {
    const QString session = recorded(test::twoDisks(), 5, "settled");
    QFile mine(path("mine.html"));
    ASSERT_TRUE(mine.open(QIODevice::WriteOnly) && mine.write("<html>my own</html>") > 0);
    mine.close();
    const auto before =
        QDir(m_folder.path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
    for (const QStringList& arguments :
         {QStringList{session}, QStringList{session, "-o", path("report.txt")},
          QStringList{session, "-o", path("none/report.html")}, QStringList{session, "-o", path("mine.html")},
          QStringList{path("none.bask"), "-o", path("report.html")},
          QStringList{path("mine.html"), "-o", path("report.html")},
          QStringList{session, "-o", path("report.html"), "--language", "xx"}}) {
        const auto done = test::captured(reportCommand, arguments);
        EXPECT_EQ(done.code, kExitBadInput) << arguments.join(' ').toStdString();
        EXPECT_NE(done.err, "") << arguments.join(' ').toStdString();
    }
    EXPECT_EQ(QDir(m_folder.path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot),
              before);
    report(session);
    report(session); // its own is replaced
}

// Catches: shade that the figures and the report of a run leave out.
TEST_F(RunReport, ShadeHasAFigureWhereThereCanBeSome) {
    Experiment experiment = test::twoDisks();
    experiment.objects[1].mounting = experiment.objects[0].mounting;
    experiment.objects[1].mounting[kZ] = -0.02;
    const QString session = recorded(experiment, 240, "settled");
    const auto done = test::captured(exportCommand, {session, "--figures", path("figures")});
    ASSERT_EQ(done.code, kExitDone) << done.err;
    QFile shade(path("figures/shade.svg"));
    ASSERT_TRUE(shade.open(QIODevice::ReadOnly));
    EXPECT_TRUE(shade.readAll().contains("Shade (%)"));
    EXPECT_TRUE(report(session).contains("take from each object"));
}

TEST_F(RunReport, FiguresAreDrawnInThreeFormatsWithChineseLetters) {
    Experiment experiment = test::twoDisks();
    experiment.objects[0].name = "\xE9\x93\x9D\xE7\x89\x87";
    const QString session = recorded(experiment, 240, "settled");
    const auto done = test::captured(exportCommand, {session, "--figures", path("figures")});
    ASSERT_EQ(done.code, kExitDone) << done.err;
    EXPECT_EQ(QDir(path("figures")).entryList(QDir::Files).size(), 15 + 1) << "and what describes them";
    EXPECT_FALSE(QFile::exists(path("figures/shade.svg"))) << "the disks lie in one plane";
    QFile svg(path("figures/temperatures.svg")), pdf(path("figures/temperatures.pdf"));
    ASSERT_TRUE(svg.open(QIODevice::ReadOnly) && pdf.open(QIODevice::ReadOnly));
    EXPECT_TRUE(svg.readAll().contains("\xE9\x93\x9D\xE7\x89\x87")) << "letters, not outlines";
    EXPECT_TRUE(pdf.readAll().startsWith("%PDF"));
    const QImage png(path("figures/temperatures.png"));
    EXPECT_NEAR(png.width(), 183.0 / 25.4 * 300.0, 3.0) << "two columns, in whole points";
    QFile errors(path("figures/errors.svg"));
    ASSERT_TRUE(errors.open(QIODevice::ReadOnly));
    const QString drawn = QString::fromUtf8(errors.readAll());
    EXPECT_FALSE(drawn.contains("<image")) << "numbers are letters, too";
    EXPECT_TRUE(drawn.contains(QRegularExpression(QStringLiteral(">[-\\x{2212}]1\\d<"))))
        << "all errors are shown, from -15 K on";
    EXPECT_EQ(test::captured(exportCommand, {session, "--figures", path("figures")}).code, kExitDone)
        << "its own are replaced";
    QFile mine(path("figures/errors.png"));
    ASSERT_TRUE(mine.open(QIODevice::WriteOnly) && mine.write("mine") > 0);
    mine.close();
    EXPECT_EQ(test::captured(exportCommand, {session, "--figures", path("figures")}).code, kExitBadInput);
}

// Catches: a width that is not taken, or that no paper has, and options without an effect.
TEST_F(RunReport, FiguresHaveTheWidthThatIsAskedFor) {
    const QString session = recorded(test::twoDisks(), 12, "settled");
    const auto done = test::captured(
        exportCommand, {session, "--figures", path("narrow"), "--figure-width", "89", "--no-heading"});
    ASSERT_EQ(done.code, kExitDone) << done.err;
    for (const char* name : {"temperatures", "errors", "trajectory"}) {
        const QImage png(path("narrow") + '/' + name + ".png");
        EXPECT_NEAR(1e3 * png.width() / std::max(1, png.dotsPerMeterX()), 89.0, 0.2) << name;
        QFile svg(path("narrow") + '/' + name + ".svg");
        ASSERT_TRUE(svg.open(QIODevice::ReadOnly));
        const QByteArray drawn = svg.readAll();
        EXPECT_TRUE(drawn.contains("<svg width=\"88.9")) << name << drawn.left(200).toStdString();
        EXPECT_EQ(drawn.count("SIMULATED"), 1) << name;
    }
    for (const char* width : {"5", "1000", "wide", "nan", ""})
        EXPECT_EQ(
            test::captured(exportCommand, {session, "--figures", path("no"), "--figure-width", width}).code,
            kExitBadInput)
            << width;
    EXPECT_EQ(test::captured(exportCommand, {session, "--csv", path("no"), "--no-heading"}).code,
              kExitBadInput);
}

TEST_F(RunReport, EveryFormOfExportAtOnce) {
    const QString session = recorded(test::twoDisks(), 12, "settled");
    const auto done = test::captured(exportCommand, {session, "--csv", path("out"), "--nexus", path("out"),
                                                     "--vtk", path("out"), "--figures", path("out")});
    ASSERT_EQ(done.code, kExitDone) << done.err;
    for (const QString& file : QString::fromStdString(done.out).split('\n', Qt::SkipEmptyParts))
        EXPECT_TRUE(QFile::exists(file)) << file.toStdString();
    for (const char* name : {"traces.csv", "run.nxs", "outlines.pvd", "errors.svg"})
        EXPECT_TRUE(QFile::exists(path("out") + '/' + name)) << name;
}

// Catches: a report that hides that an object stood in another's light, or tells it of objects that cannot.
TEST_F(RunReport, TellsTheShadeOfTheObjects) {
    Experiment experiment = test::twoDisks();
    EXPECT_FALSE(readable(report(recorded(experiment, 240, "settled"))).contains("of the light of"));
    experiment.objects[1].mounting[kX] = -0.03;
    experiment.objects[1].mounting[kZ] = 0.04;
    const QString text = readable(report(recorded(experiment, 240, "settled")));
    EXPECT_TRUE(text.contains(
        QRegularExpression("left, the takes [0-9.]+ % of the light of right at the start pose\\.")))
        << text.toStdString();
    EXPECT_TRUE(text.contains("of the light of right at this pose."));
    EXPECT_TRUE(text.contains("Shade of the objects on one another, from Start until Stop"));
    EXPECT_TRUE(text.contains("Taken by the others, largest"));
}

} // namespace
} // namespace bask
