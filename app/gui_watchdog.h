#pragma once
// Measures how long the GUI thread is not available: the longest gap between ticks of a 5 ms timer, without
// painting.

#include <QApplication>
#include <QElapsedTimer>
#include <QTimer>

#include <vector>

namespace bask {

/// A QApplication that measures its painting time.
class MeasuredApplication : public QApplication {
    Q_OBJECT

public:
    using QApplication::QApplication;
    bool notify(QObject* receiver, QEvent* event) override;

    double paintTime_s() const { return m_paint_s; }
    bool painting() const { return m_depth > 0; }

private:
    int m_depth = 0;
    double m_paint_s = 0.0;
    QElapsedTimer m_timer;
};

/// Runs during its lifetime; needs a MeasuredApplication to exclude painting.
class GuiWatchdog : public QObject {
    Q_OBJECT

public:
    static constexpr int kTick_ms = 5;

    explicit GuiWatchdog(QObject* parent = nullptr);

    void restart();
    double longestBlock_s() const { return m_longest_s; }
    /// Every gap so far, for percentiles.
    const std::vector<double>& blocks_s() const { return m_blocks_s; }

private:
    void tick();

    QTimer m_timer;
    QElapsedTimer m_clock;
    double m_paintBefore_s = 0.0;
    double m_longest_s = 0.0;
    std::vector<double> m_blocks_s;
};

} // namespace bask
