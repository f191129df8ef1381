#include "widgets/objects/fourier_fits.h"

#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace bask {
namespace {

/// A wavy ring of `n` points, about 7 cm across.
Contour wavyRing(int n, int waves) {
    Contour contour;
    for (int k = 0; k < n; ++k) {
        const double phi = 2.0 * std::numbers::pi * k / n;
        const double r = 0.03 + 0.005 * std::cos(waves * phi);
        contour.points_m.emplace_back(r * std::cos(phi), r * std::sin(phi));
    }
    return contour;
}

bool waitFor(const std::function<bool()>& condition) {
    return QTest::qWaitFor(condition, 120000);
}

// Catches a worker that leaves a number of harmonics out or never finishes.
TEST(FourierFits, FitsEveryNumberOfHarmonics) {
    FourierFits fits;
    fits.setOutline(wavyRing(500, 7));
    ASSERT_TRUE(waitFor([&] { return fits.complete(); }));
    double before_m = 1.0;
    for (int h = 1; h <= kMaxHarmonics; ++h) {
        ASSERT_TRUE(fits.fit(h)) << h;
        EXPECT_EQ(fits.fit(h)->fit.contour.harmonics(), h);
        EXPECT_LE(fits.fit(h)->fit.rms_m, before_m + 1e-9) << h;
        before_m = fits.fit(h)->fit.rms_m;
    }
}

// Catches fits of an outline that was replaced turning up under the new one.
TEST(FourierFits, NewOutlineDropsTheFitsOfTheOld) {
    FourierFits fits;
    fits.setOutline(wavyRing(3000, 3));
    fits.setOutline(wavyRing(400, 9));
    ASSERT_TRUE(waitFor([&] { return fits.complete(); }));
    const FourierFit expected = fitFourier(wavyRing(400, 9), 8).value();
    EXPECT_EQ(fits.fit(8)->fit.contour, expected.contour);
}

// Catches a fit of a huge outline running on the GUI thread.
TEST(FourierFits, GuiThreadIsFreeWhileAHugeOutlineIsFitted) {
    const Contour huge = wavyRing(60000, 11);
    FourierFits fits;
    QSignalSpy ready(&fits, &FourierFits::fitReady);
    QElapsedTimer timer;
    timer.start();
    fits.setOutline(huge);
    fits.want(40);
    EXPECT_LT(timer.elapsed(), 5000) << "all its fits take many seconds";
    ASSERT_TRUE(waitFor([&] { return fits.fit(40).has_value(); }));
    // The wanted number comes before the ones that were not asked for.
    EXPECT_LT(ready.count(), kMaxHarmonics / 2);
}

// Catches a job that posts into a destroyed object.
TEST(FourierFits, CanBeDestroyedInTheMiddle) {
    for (int i = 0; i < 20; ++i) {
        auto fits = std::make_unique<FourierFits>();
        fits->setOutline(wavyRing(2000, 5));
        fits.reset();
    }
    QCoreApplication::processEvents();
    SUCCEED();
}

} // namespace
} // namespace bask
