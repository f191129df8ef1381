#pragma once
// A surfaces' view with an example and its verdict, and eyes for its picture.

#include "engine/runtime/rig_setup.h"
#include "tests/support/wait_for.h"
#include "widgets/scene/target_scene.h"
#include "widgets/targets/surfaces_view.h"

#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QScreen>
#include <QSlider>
#include <QTest>
#include <QThreadPool>

#include <gtest/gtest.h>

namespace bask::test {

inline int differentPixels(const QImage& a, const QImage& b) {
    int different = 0;
    for (int y = 0; y < std::min(a.height(), b.height()); ++y)
        for (int x = 0; x < std::min(a.width(), b.width()); ++x)
            different += a.pixel(x, y) != b.pixel(x, y);
    return different;
}

struct SurfacesTest : testing::Test {
    SurfacesView view;
    Experiment experiment = readExperiment(BASK_EXAMPLES "/three-objects.json").value();

    SurfacesTest() {
        view.resize(700, 560);
        view.setExperiment(experiment);
        view.show();
        QApplication::processEvents();
    }
    TargetScene* scene() { return view.findChild<TargetScene*>("targetScene"); }
    template <class Widget> Widget* find(const char* name) {
        auto* found = view.findChild<Widget*>(QLatin1String(name));
        EXPECT_NE(found, nullptr) << name;
        return found;
    }
    QImage picture() { return scene()->image({600, 400}); }
    /// Waits for a picture that differs from `before` in more than a share of it.
    QImage changed(const QImage& before, double share = 0.02) {
        QImage now;
        EXPECT_TRUE(waitFor([&] {
            now = picture();
            return differentPixels(now, before) > share * before.width() * before.height();
        }));
        return now;
    }
    /// Waits for a picture that is this one but for a hundredth.
    bool becomes(const QImage& wanted) {
        return waitFor(
            [&] { return differentPixels(picture(), wanted) < wanted.width() * wanted.height() / 100; });
    }
    /// The surfaces of the example's verdict, drawn.
    QImage withSurfaces() {
        view.setVerdict(*jointFeasibility(feasibilityRequest(experiment)));
        settle();
        return picture();
    }
    /// What is computed has arrived, and what had to wait for it.
    static void settle() {
        for (int i = 0; i < 3; ++i) {
            EXPECT_TRUE(QThreadPool::globalInstance()->waitForDone(20000));
            QApplication::processEvents();
        }
    }
    /// Whole, as on the screen, where tests run.
    void keep(const char* name) {
        waitFor([painted = QDeadlineTimer(100)] { return painted.hasExpired(); });
        EXPECT_TRUE(view.screen()->grabWindow(view.winId()).save(QLatin1String(name)));
    }
};

} // namespace bask::test
