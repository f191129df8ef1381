#pragma once
// Traces of a run over time, one line for each object, with targets, tolerance band, limits, notes and two
// cursors.

#include "engine/base/units.h"
#include "engine/model/predicted_run.h"
#include "engine/model/trace.h"
#include "widgets/plots/figure_format.h"
#include "widgets/plots/trace_store.h"

#include <QByteArray>
#include <QList>
#include <QPointF>
#include <QStringList>
#include <QWidget>

#include <memory>
#include <optional>

namespace bask {

class RecordedSession;
struct PlotTable;

/// Follows the newest sample until a person zooms or drags; data is never lost by that. Wheel: zoom time;
/// Ctrl+wheel or the wheel over the value axis: zoom values; drag: move; double click: whole picture, live
/// again. Pointing reads the values at a moment, a click pins the first of two cursors, from which the other
/// then tells the differences. Keys: arrows, +, -,
/// Home (whole run), End (live), Esc. Invalid samples leave a gap. Where samples are denser than pixels their
/// extremes are drawn. Memory stays bounded however long a run goes on (TraceStore). Redraws at most 33
/// times a second, and only while visible. Object name "tracePlot" unless given another; the drawing area
/// inside is "tracePlotCanvas".
class TracePlot : public QWidget {
    Q_OBJECT
public:
    explicit TracePlot(Quantity quantity, QWidget* parent = nullptr);
    explicit TracePlot(QWidget* parent = nullptr); ///< of temperatures
    ~TracePlot() override;

    /// Names the lines and clears the data.
    void setObjects(const QStringList& names);
    void setQuantity(Quantity quantity);
    Quantity quantity() const;
    /// Shows a second quantity of the run on the right axis, with a scale of its own; none, or the left one,
    /// for no right axis. Of runs drawn over this one it is not shown.
    void setRightQuantity(std::optional<Quantity> quantity);
    std::optional<Quantity> rightQuantity() const;
    void setSpeedLimits(const SpeedLimits& limits);

    /// Shows the traces of `store`, which other plots may share, with one line for each of its objects. Code
    /// that appends to it must call showNewSamples() of each plot.
    void setStore(std::shared_ptr<TraceStore> store);
    void showNewSamples();
    void append(const std::vector<TraceSample>& samples); ///< samples not later than the last one are ignored
    void setSamples(const std::vector<TraceSample>& samples); ///< a whole run, shown whole
    /// Shows a whole recorded run of any length; its samples are read when they are shown. Its objects give
    /// the names of the lines.
    void setRun(std::shared_ptr<RecordedSession> run);
    void clear(); ///< removes samples and markers

    /// Adds a vertical line with a short text above it, where it hides no trace.
    void addMarker(double time_s, const QString& text);
    void clearMarkers();
    void setMarkerTextsVisible(bool visible);

    /// Draws another run over this one, both from their Start: colours and markers by the objects' names,
    /// dashes by the run, its mark (a letter from "B" on; the run itself is "A") at the ends of its lines.
    /// clear() does not remove it.
    void addOverlay(const QString& mark, std::shared_ptr<RecordedSession> run);
    void clearOverlays();
    /// Sets what figures call the runs, beside their marks: the run itself, then those over it. Those without
    /// a name are called by their files.
    void setRunNames(const QStringList& names);
    /// Dashes of the overlay at a place, from 0; the first four differ much, also in black and white.
    static QList<qreal> overlayDashes(int place);

    /// Draws a predicted run behind the measured one, from its Start: pale dotted lines in a plot of
    /// temperatures, which stand alone until the first sample. Plots of other quantities only show the whole
    /// run as long as it is predicted, so that plots above each other line up. One without samples removes
    /// it, as setObjects() does; clear() does not. One that comes after a measured run is of the next, and is
    /// drawn once clear() has taken that away.
    void setPrediction(const PredictedRun& run);
    void setPredictionVisible(bool visible);

    /// Shows a line at the moment of a replay; moving it does not redraw the traces.
    void setPosition(std::optional<double> time_s);

    void setTemperatureUnit(TemperatureUnit unit);
    void setTheme(bool dark); ///< only needed to differ from the palette, which it follows

    bool followsLive() const;
    void setFollowLive(bool follow);
    /// Sets the length of the shown time while following; 0 shows the whole run.
    void setFollowWindow_s(double window_s);
    /// How far the right edge lies behind the newest sample, s; 0 while following.
    double behind_s() const;
    /// Shows a time range and stops following.
    void setTimeRange(double from_s, double to_s);
    double visibleFrom_s() const;
    double visibleTo_s() const;

    // The visible content, as values.
    int seriesCount() const;
    QString seriesName(int series) const;
    QList<QPointF> seriesPoints(int series) const;    ///< (s, display unit); y is NaN in a gap
    QList<QPointF> predictedPoints(int series) const; ///< as drawn (s, display unit); empty if none is
    /// Returns the words at the predicted lines, which also say how they end; empty if there are none.
    QString predictionLabel() const;
    double visibleLowest() const; ///< lower end of the value axis, display unit
    double visibleHighest() const;
    QString valueAxisLabel() const;
    QString shownAxisLabel() const; ///< as much of it as the height has room for
    QList<QPointF> rightPoints(int series) const;
    double rightLowest() const; ///< lower end of the right axis, display unit
    double rightHighest() const;
    QString rightAxisLabel() const; ///< empty without one
    QStringList markerTexts() const;
    QStringList overlayLabels() const;
    std::optional<double> position_s() const;
    /// Returns the time of the pinned cursor; none if there is none.
    std::optional<double> cursor_s() const;
    /// Returns the values at the newest row until a time in one line, as the cursor shows them, of each run
    /// that is drawn; with the time of a pinned cursor also the values there, and the differences from them.
    QString readout(double time_s, std::optional<double> pinned_s = std::nullopt) const;

    /// Draws at once, also while hidden; only needed for pictures and measurements.
    void redraw();
    /// Pins the first cursor under a point of the plot; without one where the other cursor is, else at the
    /// moment of the replay or of the newest sample.
    void measureFrom(std::optional<QPoint> at = std::nullopt);
    /// Takes the pinned cursor away.
    void takeCursorAway();
    /// Whether there is nothing to export: no samples, overlays or predicted lines.
    bool isEmpty() const;
    /// Returns what is shown as a figure for print, on a light ground: the shown time, all runs over each
    /// other with their names, the right axis, a legend. `unrecorded` says which run it is if that is no
    /// recorded one. Marked moments need the heading, which says what they are. Reads for a second at most,
    /// and draws extremes of what is not read. `comment` is stored in it.
    QByteArray figure(const QString& unrecorded, FigureFormat format, const QString& comment,
                      const FigureLayout& layout = {}) const;
    /// Returns what is shown as a table in English: the shown time of each run in columns beside each other,
    /// with targets and the right axis, temperatures in degC, all else in SI. The samples of recorded runs
    /// are read when it is made to CSV. The header of its last column is `mark`.
    PlotTable table(const QString& mark) const;

    QSize sizeHint() const override { return {560, 240}; }
    QSize minimumSizeHint() const override { return {220, 90}; }

signals:
    void followLiveChanged(bool follow);
    /// A person moved or zoomed the time axis.
    void timeRangeChosen(double from_s, double to_s);
    /// A person clicked at a moment of the run.
    void momentClicked(double time_s);

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    class Canvas;
    std::unique_ptr<Canvas> m_canvas;
};

} // namespace bask
