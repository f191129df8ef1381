#include "widgets/common/stop_button.h"
#include "widgets/common/theme.h"

#include <QMenu>
#include <QPushButton>
#include <QStyle>

#include <gtest/gtest.h>

#include <algorithm>
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
        for (int i = 0; i < 8; ++i)
            for (const QColor& line : {seriesColor(i, dark), paleSeriesColor(i, dark)})
                EXPECT_GE(contrast(line, palette.color(QPalette::Base)), 3.0)
                    << i << (dark ? " dark" : " light");
    }
}

// Catches: words and lines on a ground of their own, alternate rows, tips and tints of states, and captions
// of empty fields and links that are too pale.
TEST(Theme, ContrastOfEverySmallerPair) {
    for (const bool dark : {false, true}) {
        SCOPED_TRACE(dark ? "dark" : "light");
        const QPalette palette = themePalette(dark);
        const auto of = [&](QPalette::ColorRole role) { return palette.color(role); };
        EXPECT_GE(contrast(of(QPalette::PlaceholderText), of(QPalette::Base)), 4.5);
        EXPECT_GE(contrast(of(QPalette::ToolTipText), of(QPalette::ToolTipBase)), 4.5);
        EXPECT_GE(contrast(of(QPalette::ButtonText), of(QPalette::Button)), 4.5);
        for (auto ground : {QPalette::Window, QPalette::Base, QPalette::AlternateBase}) {
            EXPECT_GE(contrast(of(QPalette::WindowText), of(ground)), 4.5) << ground;
            EXPECT_GE(contrast(secondaryText(dark), of(ground)), 4.5) << ground;
            EXPECT_GE(contrast(of(QPalette::Link), of(ground)), 4.5) << ground;
            EXPECT_GE(contrast(accentColor(dark), of(ground)), 4.5) << ground << ": words of REPLAY and LIVE";
            for (int object = 0; object < 5; ++object)
                EXPECT_GE(contrast(seriesColor(object, dark), of(ground)), 3.0) << ground << ' ' << object;
        }
        for (auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
            EXPECT_GE(contrast(palette.color(QPalette::Disabled, role), of(QPalette::Window)), 2.5)
                << "less than others, but not nothing";
    }
}

// Catches: a figure that is not read on its mark, a mark that is not seen, and words lost on a chip's tint.
TEST(Theme, ContrastOfAlarms) {
    constexpr double kStrongestTint = 0.30; // of a fault's chip under the mouse
    for (const bool dark : {false, true}) {
        const QPalette palette = themePalette(dark);
        const QColor text = palette.color(QPalette::WindowText);
        for (int priority = 1; priority <= 3; ++priority) {
            SCOPED_TRACE(testing::Message() << priority << (dark ? ", dark" : ", light"));
            const QColor colour = alarmColor(priority, dark);
            EXPECT_GE(contrast(alarmInkColor(priority, dark), colour), 4.5);
            for (auto ground : {QPalette::Window, QPalette::Base}) {
                EXPECT_GE(contrast(alarmEdgeColor(priority, dark), palette.color(ground)), 3.0) << ground;
                EXPECT_GE(contrast(text, mixed(colour, palette.color(ground), kStrongestTint)), 4.5)
                    << ground;
            }
        }
        for (const QColor& colour : {unknownColor(dark), accentColor(dark)}) {
            const QColor tint = mixed(colour, palette.color(QPalette::Window), kStrongestTint);
            EXPECT_GE(contrast(text, tint), 4.5) << colour.name().toStdString();
        }
    }
}

// Catches: STOP as a shape that is dim on its ground.
TEST(Theme, StopStandsOutFromItsGround) {
    for (const bool dark : {false, true}) {
        QWidget ground;
        ground.setPalette(themePalette(dark));
        StopButton stop(&ground);
        stop.setFocusPolicy(Qt::NoFocus);
        stop.move(20, 20);
        stop.resize(stop.sizeHint());
        ground.resize(200, 100);
        const QImage seen = ground.grab().toImage();
        const QColor around = seen.pixelColor(10, 20 + stop.height() / 2),
                     edge = seen.pixelColor(20 + 1, 20 + stop.height() / 2);
        EXPECT_GE(contrast(edge, around), 3.0) << (dark ? "dark " : "light ") << edge.name().toStdString()
                                               << " on " << around.name().toStdString();
    }
}

// Catches: an edge that is declared and not drawn.
TEST(Theme, AYellowMarkHasItsEdge) {
    const QImage mark = alarmPixmap(3, false, 40, 1.0).toImage();
    int darkest = 255;
    for (int x = 0; x < 3; ++x)
        if (const QColor colour = mark.pixelColor(x, 20); colour.alpha() > 200)
            darkest = std::min(darkest, colour.red());
    EXPECT_LT(darkest, alarmColor(3, false).red() - 40);
    EXPECT_EQ(mark.pixelColor(5, 20), alarmColor(3, false)) << "inside it is as yellow as ever";
}

// Catches words that touch the arrow of their menu, and buttons that are wider for nothing.
TEST(Theme, AMenuButtonHasRoomBetweenItsWordsAndItsArrow) {
    constexpr int kMinRoom_px = 8; // on both sides of the words
    const auto room = [](const QString& text, bool hasMenu) {
        QMenu menu;
        QPushButton button(text);
        if (hasMenu)
            button.setMenu(&menu);
        const int arrow =
            hasMenu ? button.style()->pixelMetric(QStyle::PM_MenuButtonIndicator, nullptr, &button) : 0;
        return button.sizeHint().width() - arrow -
               button.fontMetrics().size(Qt::TextShowMnemonic, text).width();
    };
    const QString words = QStringLiteral("Export figure of all runs"), word = QStringLiteral("A");
    EXPECT_GE(room(words, true), 2 * kMinRoom_px);
    EXPECT_LT(room(words, false), room(words, true));
    EXPECT_LE(room(word, true), room(word, false)) << "room enough";
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
