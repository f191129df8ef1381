#include "widgets/common/theme.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace bask;

namespace {

double luminance(const QColor& color) {
    const auto linear = [](double c) {
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) + 0.0722 * linear(color.blueF());
}

double contrast(const QColor& a, const QColor& b) {
    const double la = luminance(a), lb = luminance(b);
    return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

} // namespace

// Catches text and lines that cannot be read on their ground (WCAG: 4.5 for text, 3 for lines).
TEST(Theme, ContrastInLightAndDark) {
    for (const bool dark : {false, true}) {
        const QPalette palette = themePalette(dark);
        EXPECT_EQ(isDark(palette), dark);
        for (auto ground : {QPalette::Window, QPalette::Base, QPalette::Button}) {
            EXPECT_GE(contrast(palette.color(QPalette::Text), palette.color(ground)), 7.0);
            EXPECT_GE(contrast(secondaryText(dark), palette.color(ground)), 4.5);
            EXPECT_GE(contrast(unknownColor(dark), palette.color(ground)), 4.5);
        }
        EXPECT_GE(contrast(palette.color(QPalette::HighlightedText), palette.color(QPalette::Highlight)),
                  4.5);
        for (int i = 0; i < 5; ++i)
            EXPECT_GE(contrast(seriesColor(i, dark), palette.color(QPalette::Base)), 3.0)
                << i << (dark ? " dark" : " light");
    }
}

// Catches two objects that look the same: colour and dash together differ for six.
TEST(Theme, SixObjectsDiffer) {
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < i; ++j)
            EXPECT_FALSE(seriesColor(i, false) == seriesColor(j, false) &&
                         seriesDashes(i) == seriesDashes(j));
}

// Catches what is not known, or over, drawn like an alarm that holds, by colour or in shades of grey.
TEST(Theme, UnknownAndOverAreShapesOfTheirOwn) {
    for (const bool dark : {false, true}) {
        QList<QImage> seen;
        const auto isNew = [&](const QPixmap& mark) {
            const QImage picture = mark.toImage().convertToFormat(QImage::Format_Grayscale8);
            const bool is = !seen.contains(picture);
            seen << picture;
            return is;
        };
        EXPECT_TRUE(isNew(unknownPixmap(dark, 16, 1.0)));
        for (int priority = 1; priority <= 3; ++priority) {
            EXPECT_NE(unknownColor(dark), alarmColor(priority, dark));
            EXPECT_TRUE(isNew(alarmPixmap(priority, dark, 16, 1.0))) << priority;
            EXPECT_TRUE(isNew(alarmPixmap(priority, dark, 16, 1.0, true))) << priority << ", over";
        }
    }
}
