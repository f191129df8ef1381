#include "app/commands/command_line.h"

#include <QFile>
#include <QTemporaryDir>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <numbers>
#include <sstream>

namespace bask {
namespace {

using nlohmann::json;

/// Runs the command on a file with `text`.
class ViewFactorCommand : public testing::Test {
protected:
    int run(const std::string& text) {
        std::ofstream(path("cases.json").toStdString()) << text;
        return viewFactorCommand({path("cases.json"), "-o", path("results.json")});
    }
    json results() {
        std::ifstream file(path("results.json").toStdString());
        return json::parse(file)["results"];
    }
    QString path(const char* name) const { return m_folder.filePath(name); }

    /// One good case as text with `from` replaced by `to`.
    static std::string caseWith(const std::string& from = {}, const std::string& to = {}) {
        std::string text = R"({"id":"one","source":{"type":"disk","radius_m":0.15},)"
                           R"("object":{"type":"disk","radius_m":0.015},"pose":{"translation_m":[0,0,0.05],)"
                           R"("rotation_vector_rad":[0,0,0]}})";
        if (!from.empty()) {
            EXPECT_NE(text.find(from), std::string::npos) << from;
            text.replace(text.find(from), from.size(), to);
        }
        return text;
    }
    static std::string withObject(const std::string& object) {
        return caseWith(R"({"type":"disk","radius_m":0.015})", object);
    }

    static std::string withBlocker(const std::string& shape, const std::string& height,
                                   const std::string& turn = "0") {
        return caseWith(R"("id":"one")", R"("id":"one","blockers":[{"shape":)" + shape +
                                             R"(,"pose":{"translation_m":[0,0,)" + height +
                                             R"(],"rotation_vector_rad":[)" + turn + R"(,0,0]}}])");
    }

    static std::string withSource(const std::string& source) {
        return caseWith(R"({"type":"disk","radius_m":0.15})", source);
    }

private:
    QTemporaryDir m_folder;
};

// Catches: digits lost between the solver and the file, results out of order, expected values refused as
// unknown keys.
TEST_F(ViewFactorCommand, answersTheReferenceFileInOrder) {
    std::ifstream file(BASK_TEST_DATA "/view_factors.json");
    std::stringstream text;
    text << file.rdbuf();
    ASSERT_EQ(run(text.str()), kExitDone);
    const json cases = json::parse(text.str())["cases"];
    const json answers = results();
    ASSERT_EQ(answers.size(), cases.size());
    for (std::size_t i = 0; i < cases.size(); ++i) {
        EXPECT_EQ(answers[i]["id"], cases[i]["id"]);
        ASSERT_FALSE(answers[i].contains("error")) << answers[i];
        EXPECT_NEAR(answers[i]["view_factor"].get<double>(), cases[i]["view_factor"].get<double>(),
                    cases[i]["source"]["type"] == "disk" ? 1e-13 : 1e-9);
        EXPECT_EQ(answers[i]["visibility"], cases[i]["visibility"]);
        EXPECT_EQ(answers[i]["gradient"].size(), 6u);
        EXPECT_TRUE(answers[i]["error_estimate"].is_number());
    }
}

// Catches: blockers read over, shade in the wrong field, a case without blockers answered in other words.
TEST_F(ViewFactorCommand, countsBlockers) {
    const std::string blocker = withBlocker(R"({"type":"disk","radius_m":0.01})", "0.02");
    ASSERT_EQ(run(R"({"cases":[)" + blocker + "," + caseWith() + "," +
                  caseWith(R"("id":"one")", R"("id":"one","blockers":[])") + "]}"),
              kExitDone);
    const json answers = results();
    ASSERT_EQ(answers.size(), 3U);
    const double unshaded = answers[1]["view_factor"];
    EXPECT_EQ(answers[0]["unshaded"], unshaded);
    EXPECT_LT(answers[0]["view_factor"].get<double>(), unshaded - 0.01);
    EXPECT_EQ(answers[0]["gradient_rigid"].size(), 6U);
    EXPECT_NE(answers[0]["gradient"], answers[0]["gradient_rigid"]);
    EXPECT_FALSE(answers[1].contains("unshaded"));
    EXPECT_EQ(answers[2]["view_factor"], unshaded);
    EXPECT_EQ(answers[2]["gradient"], answers[2]["gradient_rigid"]);
}

// Catches: holes passed over as if they were an unknown key, in either face.
TEST_F(ViewFactorCommand, countsHolesOff) {
    const std::string pierced = R"({"type":"disk","radius_m":0.05,"holes_m":[[[0,0],[0.02,0],[0,0.02]]]})";
    const std::string plain = R"({"type":"disk","radius_m":0.05})";
    const std::string hole = R"({"type":"polygon","points_m":[[0,0],[0.02,0],[0,0.02]]})";
    const auto exchange = [&](const std::string& text, double area) {
        EXPECT_EQ(run("{\"cases\":[" + text + "]}"), kExitDone);
        return results()[0].at("view_factor").get<double>() * area;
    };
    const double disk = std::numbers::pi * 0.05 * 0.05, triangle = 2e-4;
    EXPECT_NEAR(exchange(withObject(pierced), disk - triangle),
                exchange(withObject(plain), disk) - exchange(withObject(hole), triangle), 1e-12);
    EXPECT_NEAR(exchange(withSource(pierced), 1.0),
                exchange(withSource(plain), 1.0) - exchange(withSource(hole), 1.0), 1e-8);
}

// Catches: one bad case that takes the others down with it, or is answered as if it were good.
TEST_F(ViewFactorCommand, refusesBadCasesOneByOne) {
    const std::pair<std::string, std::string> bad[] = {
        {caseWith("0.15", "-0.15"), "source.radius_m"},
        {withSource(R"({"type":"disk","radius_m":0.1,"holes_m":7})"), "source.holes_m"},
        {withSource(R"({"type":"disk","radius_m":0.1,"holes_m":[[[0,0],[0.2,0],[0,0.2]]]})"),
         "source.holes_m[0]"},
        {withObject(R"({"type":"disk","radius_m":0.1,"holes_m":[[[0,0],[0.02,0]]]})"), "object.holes_m[0]"},
        {caseWith("0.15", "0"), "source.radius_m"},
        {caseWith("0.15", "NaN"), "source.radius_m"},
        {caseWith("0.015", "1e999"), "object.radius_m"},
        {caseWith("0.015", "1e300"), "object.radius_m"},
        {caseWith("0.015", "\"big\""), "object.radius_m"},
        {caseWith("0.05]", "-Infinity]"), "pose.translation_m[2]"},
        {caseWith("[0,0,0.05]", "[0,0]"), "pose.translation_m"},
        {caseWith("[0,0,0.05]", "{}"), "pose.translation_m"},
        {caseWith("[0,0,0]", "[0,null,0]"), "pose.rotation_vector_rad[1]"},
        {caseWith(R"("rotation_vector_rad")", R"("turn")"), "rotation_vector_rad"},
        {caseWith(R"("pose")", R"("place")"), "pose"},
        {caseWith(R"("source")", R"("heater")"), "source"},
        {caseWith(R"("id":"one",)", ""), "id"},
        {caseWith(R"("id":"one")", R"("id":null)"), "id"},
        {caseWith(R"("id":"one")", R"("id":"one","blocker":[])"), "blocker"},
        {caseWith(R"("id":"one")", R"("id":"one","blockers":7)"), "blockers"},
        {caseWith(R"("id":"one")", R"("id":"one","blockers":[{"shape":{"type":"disk","radius_m":0.01}}])"),
         "blockers[0]: the key \"pose\""},
        {withBlocker(R"({"type":"disk","radius_m":-1})", "0.02"), "blockers[0].shape.radius_m"},
        {withBlocker(R"({"type":"disk","radius_m":0.01},"place":1)", "0.02"), "place"},
        {withBlocker(R"({"type":"disk","radius_m":0.01})", "0.05", "1.5"), "passes through the object"},
        {withBlocker(R"({"type":"disk","radius_m":0.01})", "0.001", "1.5"), "passes through the source"},
        {"[]", "object"},
        {"17", "object"},
        {withObject(R"({"type":"square"})"), "square"},
        {withObject(R"({"radius_m":1})"), "type"},
        {withObject(R"({"type":"polygon","points_m":[[0,0],[1,1]]})"), "points"},
        {withObject(R"({"type":"polygon","points_m":[[0,0],[0.1,0.1],[0.1,0],[0,0.1]]})"), "crosses"},
        {withObject(R"({"type":"polygon","points_m":[[0,0],[0.1,0],[0.2,0]]})"), "object.points_m"},
        {withObject(R"({"type":"polygon","points_m":[[0,0],[0.1],[0.2,0]]})"), "object.points_m[1]"},
        {withObject(R"({"type":"polygon","points_m":7})"), "object.points_m"},
        {withObject(R"({"type":"fourier","coefficients":[]})"), "no area"},
        {withObject(R"({"type":"fourier","coefficients":[[1,0,0]]})"), "object"},
        {withObject(R"({"type":"fourier","coefficients":[[1,0.01,0],[1,0.01,0]]})"), "object.coefficients"},
        {withObject(R"({"type":"fourier","coefficients":[[1.5,0.01,0]]})"), "object.coefficients"},
        {withObject(R"({"type":"fourier","coefficients":[[1,0.01,0],[500,0.001,0]]})"), "harmonics"},
        {withObject(R"({"type":"fourier","coefficients":[[1,0.01,0],[-1,0.01,0]]})"), "no area"},
        {withObject(R"({"type":"fourier","coefficients":[[1,0.01]]})"), "object.coefficients[0]"},
        {withObject(R"({"type":"fourier","coefficients":[[1,0.01,0],[2,0.02,0]]})"),
         "object.coefficients: the outline crosses itself so far"},
        {withSource(R"({"type":"square"})"), "source.type"},
        {withSource(R"({"type":7})"), "source.type"},
        {withSource(R"({"type":"polygon","points_m":[[0,0],[0.1,0.1],[0.1,0],[0,0.1]]})"), "crosses"},
        {withSource(R"({"type":"polygon","points_m":[[0,0],[0.1],[0.2,0]]})"), "source.points_m[1]"},
        {withSource(R"({"type":"fourier","coefficients":[[1,0,0]]})"), "source"},
        {withSource(R"({"type":"fourier","coefficients":[[2,0.1,0]]})"), "source.coefficients"},
        {withSource(R"({"type":"fourier","coefficients":[[1,0.1,0],[-2,0.06,0]]})"),
         "source.coefficients: the outline crosses itself so far"},
    };
    std::string text = R"({"note":"NaN and 1e999 in text stay","cases":[)" + caseWith();
    for (const auto& [one, words] : bad)
        text += ',' + one;
    ASSERT_EQ(run(text + "]}"), kExitDone);
    const json answers = results();
    ASSERT_EQ(answers.size(), std::size(bad) + 1);
    EXPECT_NEAR(answers[0]["view_factor"].get<double>(), 0.89918413173929207, 1e-13);
    for (std::size_t i = 0; i < std::size(bad); ++i) {
        const json& answer = answers[i + 1];
        ASSERT_TRUE(answer.contains("error") && !answer.contains("view_factor")) << bad[i].first;
        EXPECT_NE(answer["error"].get<std::string>().find(bad[i].second), std::string::npos) << answer;
    }
}

// Catches: a clockwise outline taken as an area with the wrong sign; an outline moved to its centroid.
TEST_F(ViewFactorCommand, reversesClockwiseOutlinesAndLeavesThemWhereTheyAre) {
    const std::string clockwisePolygon = R"([[0.02,0.05],[0.05,0.02],[0.02,0.02]])";
    const std::string polygon = R"([[0.02,0.02],[0.05,0.02],[0.02,0.05]])";
    const std::string moved = caseWith("[0,0,0.05]", "[0.03,0.02,0.05]");
    ASSERT_EQ(run(R"({"cases":[)" + withObject(R"({"type":"polygon","points_m":)" + polygon + "}") + ',' +
                  withObject(R"({"type":"polygon","points_m":)" + clockwisePolygon + "}") + ',' + moved +
                  ',' + withObject(R"({"type":"fourier","coefficients":[[0,0.03,0.02],[1,0.015,0]]})") + ',' +
                  withObject(R"({"type":"fourier","coefficients":[[0,0.03,0.02],[-1,0.015,0]]})") + "]}"),
              kExitDone);
    const json answers = results();
    const auto value = [&](std::size_t i) { return answers[i]["view_factor"].get<double>(); };
    EXPECT_NEAR(value(0), value(1), 1e-14);
    EXPECT_NEAR(value(2), value(3), 1e-12);
    EXPECT_NEAR(value(2), value(4), 1e-12);
}

// Catches: a disk written in another way that gives another answer; a source moved to its centroid.
TEST_F(ViewFactorCommand, takesSourcesOfEveryTypeAsTheyStand) {
    std::string ring;
    for (int k = 0; k < 2000; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / 2000.0;
        ring += (k == 0 ? "[" : ",[") + std::to_string(0.03 + 0.15 * std::cos(angle)) + ',' +
                std::to_string(0.02 + 0.15 * std::sin(angle)) + ']';
    }
    const std::string moved = "[0.03,0.02,0.05]";
    std::string fourier = withSource(R"({"type":"fourier","coefficients":[[0,0.03,0.02],[1,0.15,0]]})");
    std::string polygon = withSource(R"({"type":"polygon","points_m":[)" + ring + "]}");
    for (std::string* text : {&fourier, &polygon})
        text->replace(text->find("[0,0,0.05]"), 10, moved);
    ASSERT_EQ(run(R"({"cases":[)" + caseWith() + ',' + fourier + ',' + polygon + "]}"), kExitDone);
    const json answers = results();
    for (std::size_t i = 0; i < 3; ++i)
        ASSERT_TRUE(answers[i].contains("view_factor")) << answers[i];
    const auto value = [&](std::size_t i) { return answers[i]["view_factor"].get<double>(); };
    EXPECT_NEAR(value(1), value(0), 1e-9);
    EXPECT_NEAR(value(2), value(0), 1e-5);
}

// Catches: an outline refused here that experiments take, as five harmonics of the hand, which cross a
// little.
TEST_F(ViewFactorCommand, takesTheHandFittedWithFewHarmonicsAsExperimentsDo) {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const int fitted = fitContourCommand({BASK_EXAMPLES "/contours/hand_1200.png", "--scale", "15",
                                          "--harmonics", "5", "-o", path("hand.json")});
    testing::internal::GetCapturedStdout();
    EXPECT_NE(testing::internal::GetCapturedStderr().find("crosses itself"), std::string::npos);
    ASSERT_EQ(fitted, kExitDone);
    std::ifstream file(path("hand.json").toStdString());
    std::stringstream hand;
    hand << file.rdbuf();
    ASSERT_EQ(run(R"({"cases":[)" + withObject(hand.str()) + "]}"), kExitDone);
    EXPECT_TRUE(results()[0].contains("view_factor")) << results()[0];
}

// Catches: the cases, or a file that is something else, lost to the results.
TEST_F(ViewFactorCommand, replacesNothingButResults) {
    ASSERT_EQ(run("{\"cases\":[]}"), kExitDone);
    EXPECT_EQ(run("{\"cases\":[]}"), kExitDone) << "its own results are replaced";
    EXPECT_EQ(viewFactorCommand({path("cases.json"), "-o", path("cases.json")}), kExitBadInput);
    std::ofstream(path("other.json").toStdString()) << "{\"cases\":[1]}";
    EXPECT_EQ(viewFactorCommand({path("cases.json"), "-o", path("other.json")}), kExitBadInput);
    EXPECT_EQ(QFile(path("other.json")).size(), 13);
    EXPECT_EQ(viewFactorCommand({path("cases.json"), "-o", "/dev/null"}), kExitBadInput);
}

// Catches: success reported, or a crash, for a file that holds no cases; a result file left behind by it.
TEST_F(ViewFactorCommand, refusesFilesWithoutCases) {
    for (const char* text : {"", "   ", "not json", "{\"cases\":[", "[]", "{}", "{\"cases\":{}}",
                             "{\"cases\":5}", "\xff\xfe", "{\"cases\":[\"\xff\"]}"}) {
        EXPECT_EQ(run(text), kExitBadInput) << text;
        EXPECT_FALSE(QFile::exists(path("results.json"))) << text;
    }
    EXPECT_EQ(viewFactorCommand({path("absent.json")}), kExitBadInput);
    EXPECT_EQ(viewFactorCommand({}), kExitBadInput);
    EXPECT_EQ(viewFactorCommand({"--wrong"}), kExitBadInput);
    EXPECT_EQ(viewFactorCommand({"--help"}), kExitDone);
    EXPECT_EQ(run("{\"cases\":[]}"), kExitDone);
    EXPECT_EQ(results().size(), 0u);
    EXPECT_EQ(viewFactorCommand({path("cases.json"), "-o", path("no/such/folder.json")}), kExitBadInput);
}

} // namespace
} // namespace bask
