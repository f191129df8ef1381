#include "widgets/common/countdown_bar.h"

#include "engine/base/message_code.h"

#include <QLabel>

#include <gtest/gtest.h>

namespace bask {
namespace {

PendingAction pending(double in_s) {
    return {{MessageCode::EventStopped, {}}, {MessageCode::ReasonSensorInvalid, {"hand"}}, in_s};
}

} // namespace

// Catches: an action that comes without a word, a bar that outlives its cause, and seconds that stand still.
TEST(CountdownBar, CountsDownWithTheCauseAndGoesWithIt) {
    QWidget window;
    CountdownBar bar(&window);
    const auto text = [&](const char* name) { return bar.findChild<QLabel*>(QLatin1String(name))->text(); };
    window.show();
    EXPECT_FALSE(bar.isVisible());
    bar.setPending(pending(12.4));
    EXPECT_TRUE(bar.isVisible());
    EXPECT_TRUE(text("countdown").startsWith(QStringLiteral("In 13 s, unless the cause is gone: ")))
        << text("countdown").toStdString();
    EXPECT_TRUE(text("countdownCause").contains(QStringLiteral("\"hand\"")))
        << text("countdownCause").toStdString();
    EXPECT_TRUE(bar.accessibleName().contains(QStringLiteral("\"hand\"")));
    bar.setPending(pending(0.2));
    EXPECT_TRUE(text("countdown").startsWith(QStringLiteral("In 1 s"))) << text("countdown").toStdString();
    bar.setPending({});
    EXPECT_FALSE(bar.isVisible());
}

// Catches: a line at its foot that says nothing of how much time is left.
TEST(CountdownBar, TheLineShortens) {
    CountdownBar bar;
    bar.resize(400, 60);
    const auto red = [&](double in_s) {
        bar.setPending(pending(in_s));
        const QImage picture = bar.grab().toImage();
        const QRgb line = picture.pixel(3, picture.height() - 3);
        int count = 0;
        for (int x = 0; x < picture.width(); ++x)
            count += picture.pixel(x, picture.height() - 3) == line ? 1 : 0;
        return count;
    };
    const int whole = red(20.0);
    const int half = red(10.0);
    EXPECT_GT(whole, 380);
    EXPECT_GT(half, 180);
    EXPECT_LT(half, 220);
}

} // namespace bask
