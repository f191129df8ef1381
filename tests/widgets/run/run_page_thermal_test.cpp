// The thermal picture on the Run page.

#include "tests/widgets/thermal/thermal_scene.h"
#include "widgets/common/theme.h"
#include "widgets/plots/trace_plot.h"
#include "widgets/run/run_page.h"
#include "widgets/thermal/thermal_picture_view.h"

#include <QApplication>
#include <QComboBox>
#include <QTabWidget>
#include <QTableWidget>
#include <QTest>

#include <gtest/gtest.h>

namespace bask {
namespace {

Experiment experimentWith(bool hasCamera) {
    Experiment experiment;
    const double x_m[] = {0.0, -0.055, 0.055}, y_m[] = {0.05, -0.03, -0.035};
    for (std::size_t i = 0; i < test::kThermalNames.size(); ++i) {
        ObjectSpec object;
        object.name = test::kThermalNames[i].toStdString();
        object.shape = Disk{0.025};
        object.mounting << x_m[i], y_m[i], 0, 0, 0, 0;
        experiment.objects.push_back(object);
    }
    if (hasCamera)
        experiment.simulation.thermalCamera.emplace();
    return experiment;
}

// Catches a tab for a camera that there is not, one that is lost at an edit, and a picture of another rig.
TEST(RunPageThermalPicture, IsATabOfARigWithACamera) {
    RunPage page;
    auto& tabs = *page.findChild<QTabWidget*>(QStringLiteral("plotTabs"));
    auto& view = *page.findChild<ThermalPictureView*>(QStringLiteral("thermalPictureView"));
    const int plots = tabs.count();
    page.setExperiment(experimentWith(false));
    page.setThermalView(test::thermalScene());
    EXPECT_EQ(tabs.count(), plots);
    EXPECT_FALSE(view.isVisible());
    page.setExperiment(experimentWith(true));
    ASSERT_EQ(tabs.count(), plots + 1);
    EXPECT_EQ(tabs.tabText(plots), QStringLiteral("Thermal picture"));
    EXPECT_TRUE(view.sentence().contains(QStringLiteral("not given a picture yet")));
    page.resize(1180, 700);
    page.show();
    tabs.setCurrentIndex(plots);
    page.setThermalView(test::thermalScene());
    page.setTemperatureUnit(TemperatureUnit::Kelvin);
    EXPECT_TRUE(view.sentence().isEmpty());
    auto& list = *view.findChild<QTableWidget*>(QStringLiteral("thermalObjects"));
    EXPECT_EQ(list.item(2, 0)->text(), QStringLiteral("bunny"));
    EXPECT_TRUE(list.item(2, 1)->text().contains(QStringLiteral("\u00a0K ±")))
        << list.item(2, 1)->text().toStdString();
    page.setExperiment(experimentWith(true));
    EXPECT_EQ(tabs.currentIndex(), plots);
    EXPECT_EQ(tabs.count(), plots + 1);
    page.setExperiment(experimentWith(false));
    EXPECT_EQ(tabs.count(), plots);
}

// Keeps pictures of the page in both themes, and catches one that asks for more room than the others.
TEST(RunPageThermalPicture, Pictures) {
    for (const bool dark : {false, true}) {
        applyTheme(*qApp, dark ? Theme::Dark : Theme::Light);
        RunPage page;
        const int before = page.minimumSizeHint().height();
        page.setExperiment(experimentWith(true));
        EXPECT_LE(page.minimumSizeHint().height(), before + 60);
        page.setThermalView(test::thermalScene(0.6));
        page.resize(1280, 800);
        page.show();
        auto& tabs = *page.findChild<QTabWidget*>(QStringLiteral("plotTabs"));
        tabs.setCurrentIndex(tabs.count() - 1);
        for (const QSize size : {QSize(1280, 800), QSize(900, 560)}) {
            page.resize(size);
            QCoreApplication::processEvents();
            for (auto* plot : page.findChildren<TracePlot*>())
                plot->redraw();
            EXPECT_TRUE(page.grab().save(
                QStringLiteral("run_page_thermal_%1_%2.png").arg(size.width()).arg(dark ? "dark" : "light")));
        }
    }
    applyTheme(*qApp, Theme::Light);
}

} // namespace
} // namespace bask
