#include "engine/base/message_code.h"
#include "engine/shape/svg_outlines.h"

#include "engine/shape/contour_file.h"
#include "engine/shape/svg_filter.h"
#include "tests/engine/shape/shape_samples.h"
#include "tests/support/sanitized.h"

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>
#include <sys/resource.h>

#include <ctime>
#include <random>
#include <thread>

namespace bask {
namespace {

constexpr double kPixel_m = 0.0254 / 96.0;

std::string svgPath(const std::string& name) {
    return test::dataPath("svg/" + name);
}

nlohmann::json expectedFiles() {
    std::ifstream in(svgPath("expected.json"));
    return nlohmann::json::parse(in);
}

Eigen::AlignedBox2d outlineBox(const FileOutline& outline) {
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector2d& p : outline.points_m)
        box.extend(p);
    return box;
}

std::string drawing(const std::string& content, const std::string& attributes = "") {
    return R"(<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" )" +
           attributes + ">" + content + "</svg>";
}

OutlineFile outlinesOf(const std::string& bytes, double tolerance_m = kSvgTolerance_m) {
    auto file = svgOutlines(bytes, "drawing", tolerance_m);
    EXPECT_TRUE(file.ok()) << describe(file.error());
    return file.ok() ? *file : OutlineFile{};
}

MessageCode refusalOf(const std::string& bytes) {
    const auto file = svgOutlines(bytes, "drawing");
    return file.ok() ? MessageCode::None : file.error().code();
}

// Box of a drawing's only outline in mm: xmin, ymin, width, height.
Eigen::Vector4d onlyBox_mm(const std::string& bytes) {
    const OutlineFile file = outlinesOf(bytes);
    EXPECT_EQ(file.outlines.size(), 1U);
    if (file.outlines.empty())
        return Eigen::Vector4d::Zero();
    const Eigen::AlignedBox2d box = outlineBox(file.outlines.front());
    return 1e3 * Eigen::Vector4d(box.min().x(), box.min().y(), box.sizes().x(), box.sizes().y());
}

std::string textTimes(const std::string& text, int times) {
    std::string all;
    for (int k = 0; k < times; ++k)
        all += text;
    return all;
}

// ---- Files of several programs against values made with another SVG library

class SvgFile : public testing::TestWithParam<std::string> {};

// Is the outline of the expected area, perimeter and box within 0.2 %? `box` is x and y of two corners, y
// down.
bool fits(const FileOutline& outline, const nlohmann::json& expected, double height_px) {
    const double length = expected["perimeter"].get<double>() * kPixel_m;
    const double area = expected.value("area", 0.0) * kPixel_m * kPixel_m;
    const auto box = expected["box"].get<std::vector<double>>();
    const Eigen::AlignedBox2d got = outlineBox(outline);
    const Eigen::Vector4d want(box[0], height_px - box[3], box[2], height_px - box[1]);
    const Eigen::Vector4d have(got.min().x(), got.min().y(), got.max().x(), got.max().y());
    const double size = std::max(box[2] - box[0], box[3] - box[1]) * kPixel_m;
    return outline.closed == expected.contains("area") && std::abs(outline.area_m2() - area) <= 2e-3 * area &&
           std::abs(outline.perimeter_m() - length) <= 2e-3 * length &&
           (have - kPixel_m * want).cwiseAbs().maxCoeff() <= 2e-3 * size;
}

// Catches any mistake in units, view box, transforms, curves, arcs, shapes, use, CSS or the choice of what is
// closed.
TEST_P(SvgFile, GivesTheExpectedOutlines) {
    const nlohmann::json expected = expectedFiles()[GetParam()];
    const auto file = readSvgOutlines(svgPath(GetParam()));
    ASSERT_TRUE(file.ok()) << describe(file.error());
    for (const char* kind : {"closed", "open"})
        for (const auto& want : expected.value(kind, nlohmann::json::array()))
            EXPECT_TRUE(std::ranges::any_of(
                file->outlines,
                [&](const FileOutline& outline) { return fits(outline, want, expected["size"][1]); }))
                << kind << " " << want;
    ASSERT_FALSE(file->outlines.empty());
    const auto& largest = expected[file->outlines.front().closed ? "closed" : "open"][0];
    EXPECT_TRUE(fits(file->outlines.front(), largest, expected["size"][1])) << "not the largest first";
}

std::vector<std::string> expectedNames() {
    std::vector<std::string> names;
    const nlohmann::json files = expectedFiles();
    for (const auto& [name, values] : files.items())
        names.push_back(name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(All, SvgFile, testing::ValuesIn(expectedNames()), [](const auto& each) {
    std::string name = each.param;
    std::ranges::replace_if(
        name, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
    return name;
});

// Catches a file that is dropped from the table without notice.
TEST(SvgOutlines, AllFilesAreExpectedToSaySomething) {
    EXPECT_EQ(expectedNames().size(), 28U);
}

// Catches broken files that are read in part, and refusals without their reason.
TEST(SvgOutlines, BrokenFilesAreRefusedWithTheirReason) {
    EXPECT_EQ(readSvgOutlines(svgPath("bad_truncated.svg")).error().code(), MessageCode::XmlBroken);
    EXPECT_EQ(readSvgOutlines(svgPath("empty.svg")).error().code(), MessageCode::FileEmpty);
    EXPECT_EQ(readSvgOutlines(svgPath("none.svg")).error().code(), MessageCode::FileNotFound);
    EXPECT_EQ(refusalOf(""), MessageCode::XmlBroken);
    EXPECT_EQ(refusalOf("0,0\n1,0\n1,1\n"), MessageCode::XmlBroken);
    EXPECT_EQ(refusalOf("<html/>"), MessageCode::NotSvg);
    EXPECT_EQ(refusalOf(drawing("")), MessageCode::NoOutline);
    EXPECT_EQ(svgOutlines(drawing(""), "", 0.0).error().code(), MessageCode::ValueNotPositive);
    EXPECT_EQ(svgOutlines(drawing(""), "", std::nan("")).error().code(), MessageCode::ValueNotPositive);
}

// Catches a hole that is not told apart from an outline beside it.
TEST(SvgOutlines, HolesAreMarked) {
    const auto rabbit = readSvgOutlines(svgPath("rabbit_mdi.svg"));
    ASSERT_TRUE(rabbit.ok());
    ASSERT_EQ(rabbit->outlines.size(), 2U);
    EXPECT_FALSE(rabbit->outlines[0].hole);
    EXPECT_TRUE(rabbit->outlines[1].hole);
    const auto overlay =
        outlinesOf(drawing(R"(<rect width="9" height="9"/><rect x="2" y="2" width="5" height="5"/>)"));
    EXPECT_FALSE(overlay.outlines[1].hole) << "another shape on top is no hole";
}

// ---- Lengths

// Catches units taken for pixels, as QtSvg does, and QtSvg's 90 dpi.
TEST(SvgOutlines, LengthsHaveTheirUnits) {
    const std::string rect = R"(<rect width="96" height="48"/>)";
    const Eigen::Vector4d inch(0.0, 0.0, 25.4, 12.7);
    EXPECT_TRUE(onlyBox_mm(drawing(rect, R"(width="96" height="48")")).isApprox(inch, 1e-9));
    for (const std::string size :
         {R"(width="1in" height="0.5in")", R"(width="25.4mm" height="12.7mm")",
          R"(width="2.54cm" height="1.27CM")", R"(width="72pt" height="36pt")", R"(width="6pc" height="3pc")",
          R"(width="96px" height="48px")", R"(width="101.6Q")", R"(height="+.5e0in")", R"(width="100%")",
          R"(width="auto")", ""})
        EXPECT_TRUE(onlyBox_mm(drawing(rect, size + R"( viewBox="0,0 96 48")")).isApprox(inch, 1e-9)) << size;
    EXPECT_TRUE(onlyBox_mm(drawing(R"(<rect x="1mm" y="0" width="20mm" height="0.5in"/>)", R"(height="1in")"))
                    .isApprox(Eigen::Vector4d(1.0, 12.7, 20.0, 12.7), 1e-9));
    EXPECT_TRUE(onlyBox_mm(drawing(R"(<rect width="50%" height="25%"/>)", R"(width="80mm" height="40mm")"))
                    .isApprox(Eigen::Vector4d(0.0, 30.0, 40.0, 10.0), 1e-9));
}

// Catches a drawing whose size in mm is guessed without the operator being told, and the other way round.
TEST(SvgOutlines, SizesInPixelsAreTold) {
    const OutlineFile pixels = outlinesOf(drawing("<rect width='1' height='1'/>", "width='5px'"));
    ASSERT_EQ(pixels.warnings.size(), 1U);
    EXPECT_EQ(pixels.warnings[0].code, MessageCode::SvgSizeInPixels);
    EXPECT_EQ(pixels.unit, "px");
    const OutlineFile metric = outlinesOf(drawing("<rect width='1' height='1'/>", "width='5mm'"));
    EXPECT_TRUE(metric.warnings.empty());
    EXPECT_EQ(metric.unit, "mm");
}

// Catches sizes that would scale the outline by nothing or by a guess.
TEST(SvgOutlines, UnusableSizesAreRefused) {
    const std::string rect = "<rect width='1' height='1'/>";
    for (const std::string size :
         {"width='0mm'", "height='-4cm'", "width='5 furlong'", "width='nan'", "width='1e999mm'",
          "viewBox='0 0 0 5'", "viewBox='0 0 5'", "viewBox='0 0 nan 5'"})
        EXPECT_EQ(refusalOf(drawing(rect, size)), MessageCode::SvgSizeUnusable) << size;
    EXPECT_EQ(refusalOf(drawing(rect, "width='1e9mm' height='1e9mm' viewBox='0 0 1 1'")),
              MessageCode::DrawingTooWide);
}

// Catches a wrong fit of the view box, which moves and scales the outline.
TEST(SvgOutlines, PreserveAspectRatioIsObeyed) {
    const auto box = [](const std::string& preserve) {
        return onlyBox_mm(
            drawing("<rect width='10' height='10'/>", "width='40mm' height='20mm' viewBox='0 0 10 10' "
                                                      "preserveAspectRatio='" +
                                                          preserve + "'"));
    };
    EXPECT_TRUE(box("").isApprox(Eigen::Vector4d(10, 0, 20, 20), 1e-9));
    EXPECT_TRUE(box("xMinYMin meet").isApprox(Eigen::Vector4d(0, 0, 20, 20), 1e-9));
    EXPECT_TRUE(box("xMaxYMid").isApprox(Eigen::Vector4d(20, 0, 20, 20), 1e-9));
    EXPECT_TRUE(box("none").isApprox(Eigen::Vector4d(0, 0, 40, 20), 1e-9));
    EXPECT_TRUE(box("xMidYMin slice").isApprox(Eigen::Vector4d(0, -20, 40, 40), 1e-9));
}

// ---- Structure

// Catches what QtSvg leaves out or takes for the drawing's end: nested drawings, symbols, uses with a size.
TEST(SvgOutlines, NestedDrawingsSymbolsAndUsesAreRead) {
    const std::string page = "width='100mm' height='100mm' viewBox='0 0 100 100'";
    EXPECT_TRUE(onlyBox_mm(drawing("<svg x='10' y='20' width='50' height='50' viewBox='0 0 5 5'>"
                                   "<rect width='1' height='2'/></svg>",
                                   page))
                    .isApprox(Eigen::Vector4d(10, 60, 10, 20), 1e-6));
    EXPECT_TRUE(onlyBox_mm(drawing("<symbol id='s' viewBox='0 0 5 5'><rect width='1' height='2'/></symbol>"
                                   "<use href='#s' x='10' y='20' width='50' height='50'/>",
                                   page))
                    .isApprox(Eigen::Vector4d(10, 60, 10, 20), 1e-6));
    EXPECT_TRUE(onlyBox_mm(drawing("<use xlink:href='#later' x='5' transform='scale(2)'/>"
                                   "<defs><rect id='later' width='10' height='20'/></defs>",
                                   page))
                    .isApprox(Eigen::Vector4d(10, 60, 20, 40), 1e-6));
    EXPECT_TRUE(
        onlyBox_mm(drawing("<a><g transform='translate(10,0)'><rect width='1' height='100'/></g></a>", page))
            .isApprox(Eigen::Vector4d(10, 0, 1, 100), 1e-6));
}

// Catches an outline of something that nobody sees.
TEST(SvgOutlines, WhatIsNotSeenIsNotThere) {
    const std::string shape = "width='9' height='9'/>";
    for (const std::string hidden :
         {"<rect display='none' ", "<rect style='display:none' ", "<rect class='gone' ",
          "<rect class='unseen' ", "<rect style='fill:red; visibility : hidden' ",
          "<rect visibility='hidden' ", "<rect opacity='0' ", "<rect fill='none' ",
          "<rect fill='none' stroke='red' stroke-width='0' "})
        EXPECT_EQ(refusalOf(drawing(hidden + shape +
                                    "<style>.gone{display:none} .unseen{visibility:hidden}</style>")),
                  MessageCode::NoOutline)
            << hidden;
    for (const std::string holder : {"g display='none'", "defs", "clipPath", "mask", "pattern", "marker",
                                     "symbol", "foreignObject", "metadata", "other", "title"})
        EXPECT_EQ(refusalOf(drawing("<" + holder + "><rect " + shape + "</" +
                                    holder.substr(0, holder.find(' ')) + ">")),
                  MessageCode::NoOutline)
            << holder;
}

// Catches shapes that are lost with the paint that QtSvg cannot make.
TEST(SvgOutlines, ShapesPaintedWithPatternsAndGradientsAreThere) {
    for (const std::string paint : {"pattern", "linearGradient", "radialGradient"})
        for (const std::string how : {"fill='url(#p)'", "style='fill:url(#p)'", "class='c'"})
            EXPECT_EQ(outlinesOf(drawing("<style>.c{fill:url(#p)}</style><rect width='9' height='9' " + how +
                                         "/><" + paint + " id='p'/>"))
                          .outlines.size(),
                      1U)
                << paint << how;
}

// Catches an outline taken twice, for its fill and its stroke, and open lines that are closed or the reverse.
TEST(SvgOutlines, FilledOutlinesAreClosedStrokedOnesWhereTheirEndsMeet) {
    const auto closed = [](const std::string& shape) {
        const OutlineFile file = outlinesOf(drawing(shape));
        EXPECT_EQ(file.outlines.size(), 1U) << shape;
        return !file.outlines.empty() && file.outlines[0].closed;
    };
    EXPECT_TRUE(closed("<path d='M0 0h9v9'/>"));
    EXPECT_TRUE(closed("<path d='M0 0h9v9' stroke='red'/>"));
    EXPECT_TRUE(closed("<polyline points='0,0 9,0 9,9' stroke='red'/>"));
    EXPECT_TRUE(closed("<polygon points='0,0 9,0 9,9' stroke='red' fill='none'/>"));
    EXPECT_TRUE(closed("<path d='M0 0h9v9z' stroke='red' fill='none'/>"));
    EXPECT_TRUE(closed("<path d='M0 0h9v9L.0001 0' stroke='red' fill='none'/>"));
    EXPECT_FALSE(closed("<path d='M0 0h9v9' stroke='red' fill='none'/>"));
    EXPECT_FALSE(closed("<polyline points='0,0 9,0 9,9' stroke='red' fill='none'/>"));
    EXPECT_FALSE(closed("<line x2='9' y2='9' stroke='red'/>"));
    const std::string twice = "<path d='M0 0h9v9' stroke='red' fill='none'/>";
    EXPECT_EQ(outlinesOf(drawing(twice + twice)).outlines.size(), 2U);
}

// ---- Accuracy

// Catches a tolerance that is in other units than metres, and small outlines that lose their form to it.
TEST(SvgOutlines, CurvesAreFlattenedToTheTolerance) {
    const double radius_m = 0.05, ownError_m = 3e-4 * radius_m;
    std::size_t coarsePoints = 0;
    for (const double tolerance_m : {1e-4, 1e-6}) {
        const auto file = outlinesOf(
            drawing("<circle cx='50' cy='50' r='50'/>", "width='100mm' viewBox='0 0 100 100'"), tolerance_m);
        ASSERT_EQ(file.outlines.size(), 1U);
        const auto& points = file.outlines[0].points_m;
        for (std::size_t k = 0; k < points.size(); ++k) {
            const Eigen::Vector2d middle = 0.5 * (points[k] + points[(k + 1) % points.size()]);
            EXPECT_NEAR((middle - Eigen::Vector2d(radius_m, radius_m)).norm(), radius_m,
                        std::min(tolerance_m, 1e-4 * 2.9 * radius_m) + ownError_m);
        }
        EXPECT_GT(points.size(), 2 * coarsePoints);
        coarsePoints = points.size();
    }
    const auto small =
        outlinesOf(drawing("<circle cx='50' cy='50' r='50'/>", "width='0.1mm' viewBox='0 0 100 100'"));
    EXPECT_NEAR(small.outlines[0].area_m2(), std::numbers::pi * 25e-10, 2e-3 * std::numbers::pi * 25e-10);
}

// Catches QtSvg's silent cut of a path after 32,767 parts.
TEST(SvgOutlines, LongPathsAreReadWholeOrRefused) {
    std::string straight, curved = "M0 0";
    for (int k = 0; k < 60'000; ++k) {
        const double t = 2.0 * std::numbers::pi * k / 60'000;
        straight += (k == 0 ? "M" : "L") + std::to_string(100 + 50 * std::cos(t)) + "," +
                    std::to_string(100 + 50 * std::sin(t)) + " ";
        curved += "q1 1 2 0";
    }
    const OutlineFile file = outlinesOf(drawing("<path id='long' d='" + straight + "Z'/>"));
    ASSERT_EQ(file.outlines.size(), 1U);
    EXPECT_NEAR(file.outlines[0].area_m2(), std::numbers::pi * 2500 * kPixel_m * kPixel_m, 1e-8);
    EXPECT_EQ(refusalOf(drawing("<path d='" + curved + "'/>")), MessageCode::PathTooLong);
}

// ---- What a file must not be able to do

// Catches a crash where fonts are asked for without a QGuiApplication, and other files that are opened.
TEST(SvgOutlines, TextAndPicturesAreLeftOutAndTold) {
    const std::string other = test::writeFile(".png", "not a picture");
    const OutlineFile file = outlinesOf(
        drawing("<style>text,rect{font:12px serif} @import url(/nowhere.css);</style><text "
                "font-family='Arial'>a<tspan>b</tspan>"
                "</text><image xlink:href='file://" +
                    other + "' width='9' height='9'/>" +
                    "<rect width='9' height='9' style='font-size:3px;font-family:Arial' font-weight='bold'/>",
                "style='font:bold 3px serif'"));
    EXPECT_EQ(file.outlines.size(), 1U);
    ASSERT_EQ(file.warnings.size(), 2U);
    EXPECT_EQ(file.warnings[1], (Message{MessageCode::ElementsUnread, {"text, image"}}));
    EXPECT_EQ(refusalOf(drawing("<use xlink:href='file://" + other + "#a'/><rect width='9' height='9'/>")),
              MessageCode::SvgUseOfNothing);
    EXPECT_EQ(refusalOf("<!DOCTYPE svg [<!ENTITY x SYSTEM \"file://" + other +
                        "\">]><svg><path d=\"M0 0h9v9\"/><path d=\"&x;\"/></svg>"),
              MessageCode::XmlBroken);
}

// Of this process, so that a busy machine fails nothing.
double processorTime_s() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

struct HostileSvg {
    std::string name;
    MessageCode code;
    std::string bytes;
};

std::string laughingEntities() {
    std::string text = R"(<!DOCTYPE svg [<!ENTITY a "aaaaaaaaaa">)";
    for (char c = 'b'; c < 'm'; ++c)
        text += std::string("<!ENTITY ") + c + " \"" +
                textTimes(std::string("&") + static_cast<char>(c - 1) + ";", 10) + "\">";
    return text + "]><svg><path d=\"&l;\"/></svg>";
}

std::string laughingUses(int times, int levels, const std::string& last = "<rect width='1' height='1'/>") {
    std::string text = "<g id='a0'>" + last + "</g>";
    for (int k = 1; k <= levels; ++k)
        text += "<g id='a" + std::to_string(k) + "'>" +
                textTimes("<use href='#a" + std::to_string(k - 1) + "'/>", times) + "</g>";
    return drawing(text);
}

// The same text in UTF-16.
std::string wide(const std::string& text) {
    std::string bytes = "\xFF\xFE";
    for (const char c : text) {
        bytes += c;
        bytes += '\0';
    }
    return bytes;
}

std::string manyAttributes(int count) {
    std::string text;
    for (int k = 0; k < count; ++k)
        text += "a" + std::to_string(k) + " CDATA 'x' ";
    return text;
}

std::vector<HostileSvg> hostileSvgs() {
    const std::string entity = "<!DOCTYPE svg [<!ENTITY e \"" + textTimes("x", 4000) + "\">]>";
    const std::string rect = "<rect class='a' width='1' height='1'/>";
    return {
        {"entities of entities", MessageCode::XmlBroken, laughingEntities()},
        {"one entity often", MessageCode::DrawingTooFull, entity + drawing(textTimes("&e;", 200'000))},
        {"one entity often in UTF-16", MessageCode::DrawingTooFull,
         wide(entity + drawing(textTimes("&e;", 200'000)))},
        {"default attributes", MessageCode::DrawingTooFull,
         "<!DOCTYPE svg [<!ATTLIST svg " + manyAttributes(200'000) + ">]>" + drawing(rect)},
        {"many entities", MessageCode::DrawingTooFull,
         "<!DOCTYPE svg [" + textTimes("<!ENTITY e 'x'>", 600'000) + "]><svg/>"},
        {"uses of uses", MessageCode::DrawingTooFull, laughingUses(10, 12)},
        {"uses of uses of nothing", MessageCode::DrawingTooFull, laughingUses(10, 12, "")},
        {"chain of uses", MessageCode::XmlTooDeep, laughingUses(1, 40'000)},
        {"use of itself", MessageCode::SvgUseOfItself, drawing("<use id='u' href='#u'/>")},
        {"uses of each other", MessageCode::SvgUseOfItself,
         drawing("<g id='a'><use href='#b'/></g><g id='b'><use href='#a'/></g>")},
        {"use of a large shape", MessageCode::DrawingTooFull,
         drawing("<polygon id='p' points='" + textTimes("1 2 3 1 ", 100'000) + "'/>" +
                 textTimes("<use href='#p'/>", 50'000))},
        {"deep", MessageCode::XmlTooDeep, drawing(textTimes("<g>", 300'000) + textTimes("</g>", 300'000))},
        {"many elements", MessageCode::DrawingTooFull, drawing(textTimes("<rect/>", 1'000'000))},
        {"many attributes", MessageCode::DrawingTooFull, "<svg " + textTimes("a='' ", 1'000'000) + "/>"},
        {"many points", MessageCode::DrawingTooFull,
         drawing("<polygon points='" + textTimes("1 2 3 1 ", 1'500'000) + "'/>")},
        {"many arcs", MessageCode::DrawingTooFull,
         drawing(textTimes("<path d='M0 0" + textTimes("a1 1 0 001 1", 1800) + "'/>", 600))},
        {"points from use", MessageCode::DrawingTooFull,
         drawing("<circle id='c' r='9'/><g id='d'>" + textTimes("<use href='#c'/>", 300) + "</g>" +
                 textTimes("<use href='#d'/>", 300))},
        {"many parts", MessageCode::PathTooLong,
         drawing("<path d='M0 0" + textTimes("h1v1", 3'000'000) + "'/>")},
        {"many rules", MessageCode::DrawingTooFull,
         drawing("<style>" + textTimes(".a{fill:red}", 1'000'000) + "</style>" + textTimes(rect, 1000))},
        {"long rule", MessageCode::DrawingTooFull,
         drawing("<style>rect{fill:" + textTimes("a ", 100'000) + "}</style>" + textTimes(rect, 3000))},
        {"not a number", MessageCode::SvgPathDamaged, drawing("<path d='Mnan nanLnan nanL inf 1e999z'/>")},
        {"infinite", MessageCode::SvgPathDamaged,
         drawing("<path d='M0 0L1e400 5L1e-400 1e308L-1e308 1e308z' transform='scale(1e308)'/>")},
        {"wide", MessageCode::DrawingTooWide, drawing("<path d='M0 0h99999999v1z'/>")},
        {"long number", MessageCode::SvgLengthDamaged,
         drawing("<rect width='" + textTimes("1", 4'000'000) + "' height='1'/>")},
        {"large", MessageCode::DrawingTooFull, std::string(20'000'000, ' ')},
    };
}

// Catches a hang, a crash or a flood of memory by a drawing made for it.
TEST(SvgOutlines, HostileDrawingsAreRefusedSoon) {
    for (const HostileSvg& hostile : hostileSvgs()) {
        const double start_s = processorTime_s();
        const auto file = svgOutlines(hostile.bytes, "drawing");
        const double seconds = processorTime_s() - start_s;
        EXPECT_EQ(file.ok() ? MessageCode::None : file.error().code(), hostile.code) << hostile.name;
        EXPECT_LT(seconds, test::kIsSanitized ? 60.0 : 6.0) << hostile.name;
    }
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    if (!test::kIsSanitized) {
        EXPECT_LT(usage.ru_maxrss, 700 * 1024) << "KiB";
    }
}

// Catches an ordinary large drawing that is refused, or read too slowly to wait for.
TEST(SvgOutlines, LargeDrawingIsReadInTwoSeconds) {
    const double start_s = processorTime_s();
    const auto file = readSvgOutlines(svgPath("huge_bamboo.svg"));
    const double seconds = processorTime_s() - start_s;
    ASSERT_TRUE(file.ok());
    EXPECT_EQ(file->outlines.size(), 6342U);
    EXPECT_LT(seconds, 2.0);
}

// Catches path data that break off, of which QtSvg draws the part before: another shape.
TEST(SvgOutlines, DamagedPathDataAreRefused) {
    const auto file = readSvgOutlines(svgPath("resvg_invalid_data_in_L.svg"));
    ASSERT_FALSE(file.ok());
    EXPECT_EQ(file.error().code(), MessageCode::SvgPathDamaged);
    const auto path = [](const std::string& data) { return drawing("<path d=\"" + data + "\"/>"); };
    for (const char* data :
         {"M 10 10 L 90 10 L 90 Z", "M 10 10 L 90 10 foo", "L 10 10 90 10 Z", "M 10 10 L 90 1e Z",
          "M 10 10 A 5 5 0 2 0 20 20 Z", "M 10 10 C 1 2 3 4 5 Z", "10 10", "M 10 10 L 5 5 #",
          "M 10 10 L 1e300 10 20 20 Z", "M 10 10 L -1e400 10 20 20 Z"})
        EXPECT_EQ(refusalOf(path(data)), MessageCode::SvgPathDamaged) << data;
    for (const char* data :
         {"M10 10h5v5H10z", " M10,10,20-5.5.5e1 30zm5 5l1 0 0 1z", "M1 1a5 5 0 013 3.5z",
          "M.5.5L1e1,1E+1\n-3-3z", "M1 1L1e-400 9 9 9z", "m1 1 2 2 3 0t4 4q1 1 2 2s3 3 4 4c1 1 2 2 3 3Z"})
        EXPECT_NE(refusalOf(path(data)), MessageCode::SvgPathDamaged) << data;
    EXPECT_NE(refusalOf(drawing("<path d=''/><rect width='5' height='5'/>")), MessageCode::SvgPathDamaged);
}

std::string toldOf(const std::string& bytes) {
    const auto file = svgOutlines(bytes, "drawing");
    return file.ok() ? "" : describe(file.error());
}

// Catches points that break off. SVG says to draw up to the error, for a picture to look at; for a contour
// that is cut, that is another shape.
TEST(SvgOutlines, DamagedPointsAreRefused) {
    const auto file = readSvgOutlines(svgPath("resvg_polygon_invalid.svg"));
    ASSERT_FALSE(file.ok());
    EXPECT_NE(describe(file.error()).find("line 8: the points of <polygon> are damaged from \"text\" on"),
              std::string::npos)
        << describe(file.error());
    for (const std::string element : {"polygon", "polyline"}) {
        const auto told = [&](const std::string& points) {
            return toldOf(drawing("<" + element + " points='" + points + "'/>"));
        };
        for (const char* points : {"0,0 9,0 9,9 5", "0,0 9,0 9,9 x", "0 0,,9 0 9 9", "0 0 9 0 9 9;",
                                   "nan 0 1 1 2 0", "0 0 1e300 0 9 9"})
            EXPECT_NE(told(points).find("the points of <" + element + ">"), std::string::npos) << points;
        for (const char* points : {"0,0 9,0 9,9", " 0 0 9-.5.5 9e0\n", "0,0,9,0,9,9,", "+1+1 5+1,5 5."})
            EXPECT_EQ(told(points), "") << points;
        EXPECT_EQ(refusalOf(drawing("<" + element + " points=''/>")), MessageCode::NoOutline);
    }
}

// Catches lengths that are dropped, so that a shape is drawn with another.
TEST(SvgOutlines, LengthsThatAreNoneAreRefused) {
    EXPECT_EQ(toldOf(drawing("\n<rect width='9' height='9 furlong'/>")),
              "drawing: line 2: the height of <rect>, \"9 furlong\", is no length; write a number, with px, "
              "mm, cm, "
              "in, pt, pc or % if it has a unit");
    const std::string symbol = "<symbol id='s'><rect width='9' height='9'/></symbol>";
    for (const std::string shape :
         {"<rect width='calc(5px + 4px)' height='9'/>", "<rect width='9' height='9' rx='2rem'/>",
          "<circle r='9,5'/>", "<circle r='9' cx='1..5'/>", "<ellipse rx='9' ry='--9'/>",
          "<line x1='one' y2='9' stroke='red'/>", "<svg width='wide'><rect width='9' height='9'/></svg>",
          "<use href='#s' x='5 m'/>"})
        EXPECT_EQ(refusalOf(drawing(symbol + shape)), MessageCode::SvgLengthDamaged) << shape;
    EXPECT_EQ(refusalOf(drawing("<svg viewBox='0 0 5'><rect width='9' height='9'/></svg>")),
              MessageCode::SvgSizeUnusable);
    for (const std::string shape :
         {"<rect width=' 9 ' height='9MM' rx='auto' x=''/>", "<rect width='50%' height='+1e1'/>",
          "<circle r='.5em' x='none of its own'/>", "<ellipse rx='9.' ry='9'/>",
          "<svg width='auto' viewBox='0 0 5 5'><rect width='9' height='9'/></svg>"})
        EXPECT_EQ(refusalOf(drawing(shape, "width='9mm' height='9mm'")), MessageCode::None) << shape;
}

// Catches a transform that QtSvg reads up to its damage: a shape that is as large as it was, or elsewhere.
TEST(SvgOutlines, DamagedTransformsAreRefused) {
    const auto told = [](const std::string& transform) {
        return toldOf(drawing("<g transform='" + transform + "'><rect width='9' height='9'/></g>"));
    };
    EXPECT_EQ(told("translate(5 5) scale(2"),
              "drawing: line 1: the transform of <g> is damaged from \"scale(2\" on");
    for (const char* transform :
         {"scale(2,3,4)", "scale()", "rotate(45deg)", "rotate(45 1)", "matrix(1 0 0 1 0)", "scle(2)",
          "scale 2", "translate(5px, 5px)", "scale(2) x", "Scale(2)", "scale(two)"})
        EXPECT_NE(told(transform).find("the transform of <g>"), std::string::npos) << transform;
    for (const char* transform :
         {"", " ", "none", "scale(2)", "scale (2)", "matrix(1 0,0 1-5.5.5)", "rotate( 45 , 1 1 )",
          "translate(5),scale(2 3) , skewX(1)\nskewY(-1e1)", "rotate(45)scale(2)"})
        EXPECT_EQ(told(transform), "") << transform;
    EXPECT_TRUE(onlyBox_mm(drawing("<rect width='96' height='96' transform='scale (2)translate(0,-96)'/>"))
                    .isApprox(Eigen::Vector4d(0.0, 0.0, 50.8, 50.8), 1e-9));
}

// Catches a use of what is not there, which draws nothing: a part of the shape is missing, and nobody told.
TEST(SvgOutlines, UsesOfNothingAreRefused) {
    const std::string rect = "<rect id='r' width='9' height='9'/>";
    EXPECT_EQ(toldOf(drawing(rect + "\n<g>\n<use href='#gone'/></g>")),
              "drawing: line 3: <use> draws \"#gone\", which is not in the drawing (no other file is "
              "opened); put it "
              "there, or take the <use> out");
    for (const std::string use : {"<use xlink:href='#gone'/>", "<use href='other.svg#r'/>", "<use href='r'/>",
                                  "<symbol id='s'><use href='#gone'/></symbol><use href='#s'/>",
                                  "<defs><g id='a'><use href='#gone'/></g></defs><use href='#a'/>"})
        EXPECT_EQ(refusalOf(drawing(rect + use)), MessageCode::SvgUseOfNothing) << use;
    for (const std::string use :
         {"<defs><use href='#gone'/></defs>", "<symbol id='s'><use href='#gone'/></symbol>",
          "<defs><g id='a'><use href='#gone'/></g></defs>", "<g display='none'><use href='#gone'/></g>",
          "<use href='#gone' style='display: none'/>", "<clipPath><use href='#gone'/></clipPath>", "<use/>",
          "<defs><g id='a'><use href='#gone'/></g><g id='b'><use href='#a'/></g></defs>"})
        EXPECT_EQ(refusalOf(drawing(rect + use)), MessageCode::None) << use;
    const OutlineFile text = outlinesOf(drawing(rect + "<clipPath><path id='p' d='M0 0h1v1z'/></clipPath>"
                                                       "<use href='#p'/>"));
    ASSERT_FALSE(text.warnings.empty());
    EXPECT_EQ(text.warnings.back(), (Message{MessageCode::ElementsUnread, {"clipPath, use"}}));
}

// Catches a drawing that draws itself, and is accepted without that part.
TEST(SvgOutlines, UsesThatDrawWhatHoldsThemAreRefused) {
    const auto file = readSvgOutlines(svgPath("resvg_use_self_recursive.svg"));
    ASSERT_FALSE(file.ok());
    EXPECT_EQ(file.error().code(), MessageCode::SvgUseOfItself);
    EXPECT_EQ(
        refusalOf(drawing("<g id='a'><use xlink:href='#b'/></g>\n<g id='b'><use xlink:href='#a'/></g>")),
        MessageCode::SvgUseOfItself);
    EXPECT_EQ(refusalOf(drawing("<rect id='a' width='5' height='5'/><use xlink:href='#a'/>")),
              MessageCode::None);
}

// Catches crashes on files that break off or are damaged; their answer may be anything.
TEST(SvgOutlines, DamagedFilesNeverCrash) {
    std::mt19937 random(5);
    for (const std::string name :
         {"cad_slot_mm_negscale.svg", "resvg_css_transform.svg", "resvg_entity_rect.svg",
          "resvg_use_self_recursive.svg", "gear_transform.svg", "resvg_windows1251.svg"}) {
        const auto whole = readFileBytes(svgPath(name), kLargestSvg);
        ASSERT_TRUE(whole.ok());
        for (std::size_t length = 0; length < whole->size(); length += 1 + whole->size() / 200)
            (void)svgOutlines(whole->substr(0, length), name);
        for (int k = 0; k < 300; ++k) {
            std::string bytes = *whole;
            for (int flips = 1 + k % 4; flips > 0; --flips)
                bytes[random() % bytes.size()] = static_cast<char>(random());
            const auto file = svgOutlines(bytes, name);
            for (const FileOutline& outline : file.ok() ? file->outlines : std::vector<FileOutline>())
                for (const Eigen::Vector2d& p : outline.points_m)
                    ASSERT_TRUE(p.allFinite()) << name << k;
        }
    }
}

// Catches state shared between readers: the page reads files in a pool.
TEST(SvgOutlines, ReadsInSeveralThreadsAtOnce) {
    const auto alone = readSvgOutlines(svgPath("bunny_10cm.svg"));
    ASSERT_TRUE(alone.ok());
    std::vector<std::thread> threads;
    std::vector<int> same(4, 0);
    for (int& each : same)
        threads.emplace_back([&each, &alone] {
            const auto file = readSvgOutlines(svgPath("bunny_10cm.svg"));
            each = file.ok() && file->outlines.size() == alone->outlines.size() &&
                   file->outlines[1].points_m == alone->outlines[1].points_m;
        });
    for (std::thread& thread : threads)
        thread.join();
    EXPECT_EQ(same, std::vector<int>(4, 1));
}

} // namespace
} // namespace bask
