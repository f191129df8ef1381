// The sample shapes that the program carries.

#include "app/resources.h"
#include "engine/shape/contour_import.h"
#include "engine/shape/svg_outlines.h"

#include <QDir>
#include <QFile>

#include <gtest/gtest.h>

#include <cmath>

namespace bask {
namespace {

// Catches a sample that is not in the binary or cannot be read from there, and one too large for a plate.
TEST(SampleShapes, AreReadFromTheBinary) {
    initResources();
    const QDir folder(QStringLiteral(":/samples"));
    EXPECT_EQ(folder.entryList(),
              (QStringList{"bunny.csv", "circle.svg", "gear.svg", "hand.csv", "leaf.svg"}));
    for (const QFileInfo& sample : folder.entryInfoList()) {
        QFile file(sample.filePath());
        ASSERT_TRUE(file.open(QIODevice::ReadOnly));
        const std::string bytes = file.readAll().toStdString(), name = sample.fileName().toStdString();
        const auto outlines = sample.suffix() == QStringLiteral("svg")
                                  ? svgOutlines(bytes, name, kSvgTolerance_m)
                                  : csvOutlines(bytes, name, std::nullopt);
        ASSERT_TRUE(outlines) << name;
        const auto contour = contourOf(outlines->outlines[0], name);
        ASSERT_TRUE(contour) << name;
        const double across_m = 2.0 * std::sqrt(contourArea(*contour) / 3.14159);
        EXPECT_GT(across_m, 0.04) << name;
        EXPECT_LT(across_m, 0.08) << name;
    }
}

} // namespace
} // namespace bask
