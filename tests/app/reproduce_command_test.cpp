// bask reproduce: the paper's experiments hold what the paper says, and the report says what came of them.

#include "app/commands/command_line.h"
#include "app/drawing/reproduction.h"
#include "engine/base/units.h"
#include "engine/experiment/experiment_file.h"
#include "engine/rig/rig_setup.h"
#include "tests/support/captured_command.h"

#include <QDir>
#include <QFile>
#include <QImage>
#include <QRegularExpression>
#include <QTemporaryDir>

#include <algorithm>
#include <map>
#include <set>

namespace bask::test {
namespace {

const QString kPaper = QStringLiteral(BASK_EXAMPLES "/paper");

/// MODEL of the files: everything that they have in common is written here once.
struct Row {
    const char* name;
    std::vector<double> targets_degC;
    double K = 0.0; ///< of the model-based law; 0: the adaptive law
    std::uint64_t seed = 1;
    double source_degC = 200.0;
};

const std::vector<Row>& rows() {
    static const std::vector<Row> kRows{
        {"target-coefficient-K-0.005", {50}, 0.005},
        {"target-coefficient-K-0.05", {50}, 0.05},
        {"target-coefficient-K-0.5", {50}, 0.5},
        {"target-coefficient-40", {40}, 0.05},
        {"target-coefficient-45", {45}, 0.05},
        {"target-coefficient-55", {55}, 0.05},
        {"target-coefficient-bare-aluminium", {50}, 0.05},
        {"two-objects-50-40", {50, 40}, 0.05},
        {"two-objects-60-40", {60, 40}, 0.05},
        {"two-objects-50-50", {50, 50}, 0.05},
        {"two-objects-80-40", {80, 40}, 0.05},
        {"three-objects-exp-1", {40, 40, 40}, 0.0, 1},
        {"three-objects-exp-2", {50, 40, 40}, 0.0, 2},
        {"three-objects-exp-3", {50, 50, 35}, 0.0, 3},
        {"three-objects-exp-4", {60, 60, 30}, 0.0, 4},
        {"three-objects-exp-5", {50, 45, 35}, 0.0, 5},
        {"three-objects-exp-6", {40, 45, 50}, 0.0, 6},
        {"three-objects-exp-7", {45, 45, 45}, 0.0, 7, 300.0},
        {"three-objects-exp-8", {45, 45, 45}, 0.0, 8},
        {"interference", {40, 40, 40}, 0.0, 9},
        {"unfeasible-targets-80-80-80", {80, 80, 80}},
        {"unfeasible-targets-70-35-35", {70, 35, 35}},
        {"unfeasible-isosurfaces-30-30", {30, 30}, 0.05},
        {"unfeasible-isosurfaces-30-40", {30, 40}, 0.05},
        {"unfeasible-isosurfaces-50-30", {50, 30}, 0.05},
    };
    return kRows;
}

Material paintedAluminium() {
    return {"painted aluminium, 1 mm", 0.9, 0.9, 904.0, 2700.0, 0.001, 1.0};
}

ObjectSpec circle(const char* name, double radius_m, double y_m) {
    ObjectSpec object;
    object.name = name;
    object.shape = Disk{radius_m};
    object.material = paintedAluminium();
    object.mounting[kY] = y_m;
    return object;
}

/// The three objects of the example that the whole project uses, with the paper's five harmonics and start
/// values.
std::vector<ObjectSpec> threeObjects(const Experiment& experiment) {
    QFile file(QStringLiteral(BASK_EXAMPLES "/three-objects.json"));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    const QByteArray text = file.readAll().replace("\"harmonics\": 10", "\"harmonics\": 5");
    auto example = experimentFromJson(text.toStdString(), "three-objects.json", BASK_EXAMPLES);
    EXPECT_TRUE(example);
    std::vector<ObjectSpec> objects = example->objects;
    Experiment asCircle = experiment;
    asCircle.objects = {circle("circle", 0.015, 0.0)};
    for (std::size_t i = 1; i < 3; ++i) {
        objects[i].estimatedRates = nominalRates(asCircle, experiment.environment_K).front();
        objects[i].origin.file = "../" + objects[i].origin.file;
    }
    return objects;
}

std::vector<ObjectSpec> objectsOf(const std::string& name, const Experiment& experiment) {
    if (name.starts_with("target")) {
        std::vector<ObjectSpec> one{circle("circle", 0.015, 0.0)};
        if (name.ends_with("bare-aluminium")) // the paper's table
            one[0].material = {"bare aluminium, 3 mm", 0.04, 0.04, 903.0, 2702.0, 0.003, 1.0};
        return one;
    }
    if (name.starts_with("two"))
        return {circle("left", 0.015, 0.04), circle("right", 0.015, -0.04)};
    if (name.starts_with("unfeasible-isosurfaces"))
        return {circle("small", 0.015, 0.02), circle("large", 0.045, -0.02)};
    return threeObjects(experiment);
}

Experiment expectedOf(const Row& row) {
    Experiment experiment;
    experiment.source = {Disk{0.10}, kelvinFromCelsius(row.source_degC), 0.25, 0.01, SourceModel::Paper, {}};
    experiment.environment_K = kelvinFromCelsius(25.0);
    experiment.objects = objectsOf(row.name, experiment);
    for (std::size_t i = 0; i < row.targets_degC.size(); ++i)
        experiment.objects.at(i).target_K = kelvinFromCelsius(row.targets_degC[i]);
    experiment.controller.kind = row.K > 0.0 ? ControllerKind::ModelBased : ControllerKind::Adaptive;
    if (row.K > 0.0)
        experiment.controller.modelBased = {0.2, row.K};
    else
        experiment.controller.estimatedRateErrorFactor = 4.0;
    experiment.controller.adaptive = {0.05, 0.15, 0.005, 1e-22};
    experiment.simulation.seed = row.seed;
    experiment.simulation.sensorOffset_K = 0.3;
    return experiment;
}

Experiment read(const std::string& name) {
    auto experiment = readExperiment(kPaper.toStdString() + '/' + name + ".json");
    EXPECT_TRUE(experiment) << (experiment ? "" : describe(experiment.error()));
    return experiment ? *experiment : Experiment{};
}

void expectClose(const HeatRates& found, const HeatRates& wanted, const std::string& name) {
    EXPECT_NEAR(found.lambda1 / wanted.lambda1, 1.0, 1e-12) << name;
    EXPECT_NEAR(found.lambda2 / wanted.lambda2, 1.0, 1e-12) << name;
    EXPECT_NEAR(found.lambda3 / wanted.lambda3, 1.0, 1e-12) << name;
}

// Catches: a target, a gain, a start value, a material, a place or a limit that is not the paper's or not the
// same in all files.
TEST(PaperExperiments, HoldWhatThePaperSays) {
    for (const Row& row : rows()) {
        const Experiment found = read(row.name);
        Experiment wanted = expectedOf(row);
        ASSERT_EQ(found.objects.size(), wanted.objects.size()) << row.name;
        for (std::size_t i = 0; i < found.objects.size(); ++i) {
            ASSERT_EQ(found.objects[i].estimatedRates.has_value(),
                      wanted.objects[i].estimatedRates.has_value())
                << row.name;
            if (found.objects[i].estimatedRates)
                expectClose(*found.objects[i].estimatedRates, *wanted.objects[i].estimatedRates, row.name);
            wanted.objects[i].estimatedRates = found.objects[i].estimatedRates;
        }
        // What a file may have of its own; the next test looks at it.
        wanted.title = found.title;
        wanted.simulation.durationLimit_s = found.simulation.durationLimit_s;
        wanted.sampling.period_s = found.sampling.period_s;
        wanted.source.temperatureProfile = found.source.temperatureProfile;
        wanted.source.tracked = found.source.tracked;
        wanted.simulation.sourceMotion = found.simulation.sourceMotion;
        if (std::string(row.name).starts_with("unfeasible-isosurfaces")) { // parallel, 3 cm from the source
            wanted.robot.free = {true, true, true, false, false, false};
            wanted.robot.lower[kZ] = 0.03;
            wanted.robot.lower[kThetaX] = found.robot.lower[kThetaX];
            wanted.robot.upper[kThetaX] = found.robot.upper[kThetaX];
        }
        EXPECT_EQ(found.source, wanted.source) << row.name;
        EXPECT_EQ(found.robot, wanted.robot) << row.name;
        EXPECT_EQ(found.controller, wanted.controller) << row.name;
        EXPECT_EQ(found.simulation, wanted.simulation) << row.name;
        for (std::size_t i = 0; i < found.objects.size(); ++i)
            EXPECT_EQ(found.objects[i], wanted.objects[i]) << row.name << ", object " << i;
        EXPECT_EQ(found, wanted) << row.name;
    }
}

// Catches: a source that is moved, heated or sampled otherwise where the paper does not do it.
TEST(PaperExperiments, OnlyTwoHaveASourceThatChanges) {
    for (const Row& row : rows()) {
        const Experiment experiment = read(row.name);
        const std::string name = row.name;
        EXPECT_EQ(experiment.simulation.sourceMotion.empty(), name != "interference") << name;
        EXPECT_EQ(experiment.source.tracked, name == "interference") << name;
        EXPECT_EQ(experiment.source.temperatureProfile.empty(), name != "three-objects-exp-8") << name;
        EXPECT_EQ(experiment.sampling.period_s, name.ends_with("bare-aluminium") ? 5.0 : 1.0) << name;
        EXPECT_GE(experiment.simulation.durationLimit_s, 1000.0) << name;
    }
    const TimeTable<double> ramp{{0.0, kelvinFromCelsius(200.0)}, {1000.0, kelvinFromCelsius(300.0)}};
    EXPECT_EQ(read("three-objects-exp-8").source.temperatureProfile, ramp);
}

std::set<std::string> filesIn(const QString& folder) {
    std::set<std::string> names;
    for (const QString& name : QDir(folder).entryList(QDir::Files))
        names.insert(name.toStdString());
    return names;
}

QByteArray contents(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

// Catches: a file that the program does not have inside, an older one, one that no figure shows or no test
// looks at.
TEST(PaperExperiments, AreAllInTheProgramInAFigureAndInTheTable) {
    const QTemporaryDir folder;
    const auto unpacked = unpackPaperExperiments(folder.path());
    ASSERT_TRUE(unpacked) << describe(unpacked.error());
    const std::set<std::string> names = filesIn(kPaper);
    EXPECT_EQ(filesIn(QString::fromStdString(*unpacked)), names);
    for (const std::string& name : names)
        EXPECT_EQ(contents(QString::fromStdString(*unpacked + '/' + name)),
                  contents(kPaper + '/' + QString::fromStdString(name)))
            << name;
    const auto figures = readPaperFigures(*unpacked, "");
    ASSERT_TRUE(figures) << describe(figures.error());
    std::set<std::string> shown{"expected.json"}, tabled{"expected.json"};
    for (const PaperFigure& figure : *figures)
        for (const PaperExperiment& experiment : figure.experiments) {
            EXPECT_TRUE(shown.insert(experiment.name + ".json").second) << experiment.name << " twice";
            for (const ExpectedEnding& expected : experiment.expected)
                EXPECT_FALSE(expected.reason.empty()) << experiment.name;
        }
    for (const Row& row : rows())
        tabled.insert(std::string(row.name) + ".json");
    EXPECT_EQ(shown, names);
    EXPECT_EQ(tabled, names);
}

/// Three objects at targets of 50, 40 and 40 degC that end with the end-effector at (0, y) over a source that
/// has been moved by (`aside`, 0).
std::string verdictAt(double y_m, double aside_m) {
    ReproducedExperiment experiment;
    experiment.paper.experiment = read("three-objects-exp-2");
    experiment.paper.paper = {RunEnding::Settled, "converges"};
    experiment.paper.expected = {ExpectedEnding{RunEnding::NotSettled, "Reason.", false}, {}};
    ReproducedRun& run = experiment.runs[kByThePaper];
    run.ending = RunEnding::NotSettled;
    TraceSample last;
    last.coordinates << aside_m, y_m, 0.1, 0.0, 0.0, 0.0;
    last.source[kX] = aside_m;
    run.samples = {last};
    return verdictWords(experiment, kByThePaper);
}

// Catches an edge that takes anything: a fault, a compromise, or a run that ends far from its targets.
TEST(Reproduction, AtTheEdgeIsInOrOutOfTheBandButNear) {
    const ExpectedEnding edge{RunEnding::NotSettled, "Reason.", true};
    EXPECT_TRUE(edge.holds(RunEnding::Settled, 0.4));
    EXPECT_TRUE(edge.holds(RunEnding::NotSettled, 0.9));
    EXPECT_FALSE(edge.holds(RunEnding::NotSettled, 1.1));
    EXPECT_FALSE(edge.holds(RunEnding::Fault, 0.1));
    EXPECT_FALSE(edge.holds(RunEnding::Compromise, 0.1));
    EXPECT_FALSE((ExpectedEnding{RunEnding::Settled, "Reason.", false}.holds(RunEnding::NotSettled, 0.1)));
}

// Catches: places in the robot's frame instead of the source's, mountings left out, the comparison the wrong
// way round.
TEST(Reproduction, TheTenQuickestEndAsRecorded) {
    static const std::set<std::string> kQuickest{"target-coefficient-40",
                                                 "target-coefficient-45",
                                                 "target-coefficient-55",
                                                 "target-coefficient-K-0.005",
                                                 "target-coefficient-K-0.05",
                                                 "target-coefficient-K-0.5",
                                                 "target-coefficient-bare-aluminium",
                                                 "two-objects-50-40",
                                                 "two-objects-50-50",
                                                 "two-objects-60-40"};
    auto figures = readPaperFigures(kPaper.toStdString(), {});
    ASSERT_TRUE(figures) << describe(figures.error());
    std::vector<PaperExperiment> experiments;
    for (PaperFigure& figure : *figures)
        for (PaperExperiment& each : figure.experiments)
            if (kQuickest.contains(each.name))
                experiments.push_back(std::move(each));
    ASSERT_EQ(experiments.size(), kQuickest.size());
    const auto results = reproduce(experiments, 0, [](int, int) {});
    ASSERT_TRUE(results) << describe(results.error());
    for (const ReproducedExperiment& result : *results)
        for (const std::size_t by : {kByThePaper, kByTheLevelServo})
            EXPECT_TRUE(result.asExpected(by)) << result.paper.name << ": " << verdictWords(result, by);
}

TEST(Reproduction, SaysWhetherTheHotterTargetIsCloserToTheAxis) {
    for (const double aside_m : {0.0, 0.05}) {
        const std::string closer = verdictAt(-0.05, aside_m);
        EXPECT_NE(closer.find("circle 0.0, bunny 8.7, hand 8.7; as in the paper"), std::string::npos)
            << closer;
        const std::string farther = verdictAt(0.02, aside_m);
        EXPECT_NE(farther.find("circle 7.0, bunny 4.4, hand 4.4; not as in the paper"), std::string::npos)
            << farther;
    }
}

/// A folder with one short experiment, which nobody can settle in its time.
class ReproduceCommand : public testing::Test {
protected:
    static constexpr const char* kName = "target-coefficient-40";

    void SetUp() override {
        auto experiment = readExperiment((kPaper + "/target-coefficient-40.json").toStdString());
        ASSERT_TRUE(experiment);
        experiment->simulation.durationLimit_s = 60.0;
        ASSERT_TRUE(QDir().mkpath(path("in")));
        ASSERT_TRUE(writeExperiment(*experiment, path("in/target-coefficient-40.json").toStdString()));
        expect("not settled");
    }
    void expect(const char* outcome) {
        QFile file(path("in/expected.json"));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(QByteArray(R"({"figures": [
            {"name": "quick", "title": "A <quick> one", "paper": "a & b.", "plots": ["errors", "norm", "paths"],
             "experiments": [{"name": "target-coefficient-40",
               "paper": {"outcome": "settled", "reason": "converges"},
               "paper_controller": {"outcome": "not settled", "reason": "Too short."},
               "level_servo": {"outcome": ")") +
                   outcome + R"(", "reason": "Too short."}}]},
            {"name": "surfaces", "title": "Surfaces", "paper": "shells.", "plots": ["subsets"],
             "experiments": []}]})");
    }
    QString path(const char* name) const { return m_folder.filePath(QLatin1String(name)); }
    Captured reproduce(const QStringList& more = {"--only", "quick"}) const {
        return captured(reproduceCommand, QStringList{"-o", path("out"), "--experiments", path("in")} + more);
    }
    QString report() const { return QString::fromUtf8(contents(path("out/report.html"))); }

private:
    QTemporaryDir m_folder;
};

// Catches: a report that needs other files or the network, pictures that are none, text that breaks the HTML,
// numbers that are not the runs'.
TEST_F(ReproduceCommand, WritesOneFileThatNeedsNoOther) {
    const Captured answer = reproduce();
    ASSERT_EQ(answer.code, 0) << answer.out << answer.err;
    EXPECT_NE(answer.out.find("all outcomes are as recorded"), std::string::npos) << answer.out;
    const QString html = report();
    EXPECT_FALSE(html.contains(QRegularExpression(
        QStringLiteral("https?:|//cdn|<link|<script|@import|url\\(|src=\"(?!data:image/png;base64,)"))));
    EXPECT_TRUE(html.contains(QStringLiteral("A &lt;quick&gt; one")));
    EXPECT_TRUE(html.contains(QStringLiteral("2 of 2 outcomes are as recorded")));
    EXPECT_TRUE(html.contains(QStringLiteral("Differs from the paper (there: converges): not settled")));
    int pictures = 0;
    QRegularExpression picture(QStringLiteral("<img[^>]*alt=\"([^\"]+)\"[^>]*base64,([^\"]*)\""));
    for (auto match = picture.globalMatch(html); match.hasNext(); ++pictures) {
        const auto found = match.next();
        const QImage image = QImage::fromData(QByteArray::fromBase64(found.captured(2).toLatin1()), "PNG");
        ASSERT_GE(image.width(), 1000) << found.captured(1).toStdString();
        std::set<QRgb> colours;
        for (int y = 0; y < image.height(); y += 3)
            for (int x = 0; x < image.width(); x += 3)
                colours.insert(image.pixel(x, y));
        EXPECT_GT(colours.size(), 20U) << found.captured(1).toStdString();
    }
    EXPECT_EQ(pictures, 2 + 1 + 2);
    EXPECT_FALSE(html.contains(QStringLiteral("Surfaces"))) << "a figure that was not asked for";
}

// Catches: runs without a row a second, columns that do not match the header, other numbers than the table's.
TEST_F(ReproduceCommand, WritesEachRunAsCsv) {
    const Captured answer = reproduce();
    ASSERT_EQ(answer.code, 0) << answer.err;
    EXPECT_EQ(QDir(path("out")).entryList(QDir::Files).size(), 3);
    for (const char* name : {"model-based", "level-servo"}) {
        const QByteArray csv =
            contents(path("out/target-coefficient-40_") + QLatin1String(name) + QStringLiteral(".csv"));
        QList<QByteArray> lines = csv.trimmed().split('\n');
        ASSERT_TRUE(lines.front().startsWith("# Bask reproduction")) << lines.front().toStdString();
        lines.removeFirst();
        EXPECT_NEAR(static_cast<double>(lines.size()), 62.0, 1.0);
        for (const QByteArray& line : lines)
            EXPECT_EQ(line.count(','), lines.front().count(','));
        const auto column = lines.front().split(',').indexOf("\"circle true_degC\"");
        ASSERT_GE(column, 0);
        const double error_K = lines.back().split(',')[column].toDouble() - 40.0;
        char words[32];
        std::snprintf(words, sizeof words, "%+.2f", error_K);
        EXPECT_NE(answer.out.find(words), std::string::npos) << words << " is not in\n" << answer.out;
    }
}

// Catches: an outcome that is not the recorded one and passes, or does not say which.
TEST_F(ReproduceCommand, AWrongExpectationIsSaidAndGivesThree) {
    expect("best compromise");
    const Captured answer = reproduce();
    EXPECT_EQ(answer.code, 3);
    EXPECT_NE(answer.out.find("not as recorded: target-coefficient-40, level-servo: not settled instead of "
                              "best compromise"),
              std::string::npos)
        << answer.out;
    EXPECT_TRUE(report().contains(QStringLiteral("1 of 2 outcomes are as recorded")));
    EXPECT_TRUE(report().contains(QStringLiteral("not settled, not as recorded")));
}

// Catches: figures of the program itself that need experiments, or cannot be asked for alone.
TEST_F(ReproduceCommand, DrawsAFigureWithoutExperiments) {
    const Captured answer = captured(reproduceCommand, {"-o", path("out"), "--only", "isosurface"});
    EXPECT_EQ(answer.code, 0) << answer.err;
    EXPECT_EQ(report().count(QStringLiteral("<img")), 1);
    EXPECT_EQ(QDir(path("out")).entryList(QDir::Files), QStringList{"report.html"});
}

// Catches: files written outside the folder, a crash or a wrong plot seen only after all the runs.
TEST_F(ReproduceCommand, RefusesADamagedListBeforeItRuns) {
    ASSERT_TRUE(QFile::copy(path("in/target-coefficient-40.json"), path("evil.json")));
    const char* experiment = R"({"name": "%1", "paper": {"outcome": "settled", "reason": ""},
        "paper_controller": {"outcome": "settled", "reason": ""}, "level_servo": {"outcome": "settled", "reason": ""}})";
    const struct {
        const char *plot, *name, *words;
    } cases[] = {{"errors", "../evil", "name of a file"}, {"errors", ".", "name of a file"},
                 {"wrong", kName, "known: overlay"},      {"overlay", nullptr, "an empty list"},
                 {"errors", nullptr, "an empty list"},    {"surfaces", nullptr, "an empty list"}};
    for (const auto& [plot, name, words] : cases) {
        QFile file(path("in/expected.json"));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(QStringLiteral(R"({"figures": [{"name": "f", "title": "t", "paper": "p", "plots": ["%1"],
                                      "experiments": [%2]}]})")
                       .arg(QLatin1String(plot), name ? QString(experiment).arg(name) : QString())
                       .toUtf8());
        file.close();
        const Captured answer = reproduce({});
        EXPECT_EQ(answer.code, 2) << words;
        EXPECT_NE(answer.err.find(words), std::string::npos) << answer.err;
        EXPECT_FALSE(QDir(path("out")).exists());
    }
}

// Catches: wrong words taken for right ones, names that are not listed, files of others that are replaced.
TEST_F(ReproduceCommand, RefusesWrongWordsAndForeignFiles) {
    for (const QStringList& more :
         {QStringList{"--only", "nothing"}, QStringList{"one-too-many"}, QStringList{"--quick"}}) {
        const Captured answer = reproduce(more);
        EXPECT_EQ(answer.code, 2) << more.join(u' ').toStdString();
    }
    const Captured unknown = captured(reproduceCommand, {"-o", path("out"), "--only", "nothing"});
    EXPECT_EQ(unknown.code, 2);
    for (const char* name : {"three-objects-exp-8", "isosurface", "interference"})
        EXPECT_NE(unknown.err.find(name), std::string::npos) << unknown.err;
    EXPECT_EQ(captured(reproduceCommand, QStringList{}).code, 2);
    EXPECT_EQ(captured(reproduceCommand, {"-o", path("out"), "--experiments", path("nowhere")}).code, 2);
    EXPECT_FALSE(QDir(path("out")).exists());

    expect("splendid");
    const Captured splendid = reproduce();
    EXPECT_EQ(splendid.code, 2);
    EXPECT_NE(splendid.err.find("best compromise"), std::string::npos) << splendid.err;

    expect("not settled");
    ASSERT_TRUE(QDir().mkpath(path("out")));
    QFile mine(path("out/report.html"));
    ASSERT_TRUE(mine.open(QIODevice::WriteOnly));
    mine.write("mine");
    mine.close();
    EXPECT_EQ(reproduce().code, 2);
    EXPECT_EQ(contents(path("out/report.html")), QByteArray("mine"));
}

} // namespace
} // namespace bask::test
