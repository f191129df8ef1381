#pragma once
// The whole window on the simulated rig, driven as a person would: by mouse and keys.

#include "app/main_window.h"
#include "tests/support/wait_for.h"

#include <QTemporaryDir>
#include <QTest>

#include <gtest/gtest.h>

#include <memory>

namespace bask::test {

class WindowTest : public testing::Test {
protected:
    void SetUp() override;
    void TearDown() override;

    /// A shown window with the first example loaded, and `file` as on the command line. Settings are new
    /// unless kept from before.
    void openWindow(QSize size = {1280, 800}, const QString& file = {});
    void closeWindow();
    /// Simulated time runs 20 times as fast, chosen with the keyboard on the Run page.
    void goFast();

    /// Arms and starts, at 20 times the speed; waits for so many samples.
    void startRun(std::size_t count);
    /// Opens a recording in Review.
    void openRecording(const QString& path);
    /// Fills tables, tiles and lists.
    void holdARunAndOpenIt();
    /// Layouts, one after the other.
    void waitForLayouts();

    template <class Widget> Widget* find(const char* name) {
        auto* found = window->findChild<Widget*>(QLatin1String(name));
        EXPECT_NE(found, nullptr) << name;
        return found;
    }
    void click(const char* name);
    bool waitForState(RunState state, int limit_ms = 300000);
    /// Waits until the rig is ready and ends the engine. What is shown stays as it is until a test sends a
    /// snapshot of its own, made from the returned one.
    Snapshot freeze();
    RunState state() const { return window->lastSnapshot().state; }

    /// Keeps a picture of the window as it is on the screen, in the folder that the environment's
    /// BASK_SCREENSHOTS names, if it is set.
    void keepPicture(const QString& name);
    void keepPictures(const QString& prefix);

    std::unique_ptr<MainWindow> window;
    std::vector<TraceSample> samples; ///< of the present run, from snapshots

private:
    QTemporaryDir m_settings; ///< one a test
};

} // namespace bask::test
