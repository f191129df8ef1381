#pragma once
// A surfaces' view with an example and its verdict, and eyes for its picture.

#include "engine/experiment/experiment_file.h"
#include "engine/rig/rig_setup.h"
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

/// The shipped one in a quarter of its workspace, so that its surfaces come sooner.
inline const Experiment& narrowExample() {
    static const Experiment example = [] {
        Experiment read = readExperiment(BASK_EXAMPLES "/three-objects.json").value();
        read.robot.lower.head<2>().setConstant(-0.1);
        read.robot.upper.head<3>() << 0.1, 0.1, 0.2;
        return read;
    }();
    return example;
}

struct SurfacesTest : testing::Test {
    SurfacesView view;
    Experiment experiment = narrowExample();

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
        EXPECT_TRUE(waitForPicture([&](const QImage& seen) {
            now = seen;
            return differentPixels(now, before) > share * before.width() * before.height();
        }));
        return now;
    }
    /// Waits for a picture that is this one but for a share: labels may have found other places.
    bool becomes(const QImage& wanted, double share = 0.02) {
        return waitForPicture([&](const QImage& seen) {
            return differentPixels(seen, wanted) < share * wanted.width() * wanted.height();
        });
    }
    /// Most of a test's time is pictures: none is made before what is computed has arrived, nor too often.
    template <class Condition> bool waitForPicture(Condition condition) {
        return waitFor([&] {
            settle();
            if (condition(picture()))
                return true;
            QThread::msleep(50);
            return false;
        });
    }
    /// That of the experiment as it is, computed once a program.
    JointVerdict verdict() const {
        static std::vector<std::pair<Experiment, JointVerdict>> known;
        for (const auto& [of, verdict] : known)
            if (of == experiment)
                return verdict;
        return known.emplace_back(experiment, *jointFeasibility(feasibilityRequest(experiment))).second;
    }
    /// The surfaces of the example's verdict, drawn.
    QImage withSurfaces() {
        view.setVerdict(verdict());
        settle();
        return picture();
    }
    /// What is computed has arrived, and what had to wait for it.
    static void settle() {
        for (int i = 0; i < 3; ++i) {
            EXPECT_TRUE(QThreadPool::globalInstance()->waitForDone(120000));
            QApplication::processEvents();
        }
    }
    /// Whole, as on the screen, in the folder that the environment's BASK_SCREENSHOTS names, if it is set.
    void keep(const char* name) {
        const QString folder = qEnvironmentVariable("BASK_SCREENSHOTS");
        if (folder.isEmpty())
            return;
        waitFor([painted = QDeadlineTimer(100)] { return painted.hasExpired(); });
        EXPECT_TRUE(view.screen()->grabWindow(view.winId()).save(folder + u'/' + QLatin1String(name)));
    }
};

} // namespace bask::test
