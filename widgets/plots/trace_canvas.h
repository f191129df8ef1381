#pragma once
// The QCustomPlot behind TracePlot; included by this folder's .cpp files only.

#include "widgets/plots/trace_plot.h"

#include <QElapsedTimer>
#include <QList>
#include <QTimer>

#include <optional>

#include <qcustomplot.h>

class QLabel;

namespace bask {

class TracePlot::Canvas : public QCustomPlot {
public:
    explicit Canvas(TracePlot* owner);

    struct Overlay {
        QString mark;
        QStringList objects;
        TraceStore traces;
        QList<QCPGraph*> graphs;
        QList<QCPItemText*> labels;
    };

    // Data and what is shown of it (trace_canvas.cpp)
    void setObjects(const QStringList& names);
    void setQuantity(Quantity quantity);
    void append(const std::vector<TraceSample>& samples);
    void showNewSamples();
    void setRun(std::shared_ptr<RecordedSession> run);
    void clearData();
    void setUnit(TemperatureUnit unit);
    void setLimits(const SpeedLimits& limits);
    void rebuild(); ///< rebuilds series, texts, pens and points
    double displayed(double value) const;
    bool isOfRun() const; ///< whether the quantity belongs to the run: its lines are not the objects'
    QString seriesName(int series) const;
    /// A line of the read-out, in the colour of the line that it tells of.
    struct ReadValue {
        QString words;
        QColor color;
    };
    /// Time, then each line of the run, of the right axis and of the runs over it.
    QList<ReadValue> readout(double time_s, std::optional<double> from_s) const;
    /// Returns the newest moment until then that has values, of any of the runs, else the first; empty if
    /// there is none.
    std::optional<double> momentAt(double time_s) const;
    double factor(Quantity of, int series) const;            ///< of displayed values
    QList<QPointF> allPoints(Quantity of, int series) const; ///< of the whole run, as displayed

    // Looks (trace_canvas_look.cpp)
    void restyle(bool dark);
    void retranslate();
    QString axisText() const;
    void placeAxisTexts();             ///< as much of them as the height has room for
    QColor inkOfRun(int series) const; ///< of a quantity of the run
    QPen penOfSeries(int series) const;
    QCPItemText* makeLineLabel(); ///< at the end of a line, right of the picture
    void placeLabels();
    enum class Density { Loose, Close, Dense }; ///< density of samples compared with pixels
    void fitPensToDensity();
    static QPen plainPen(const QPen& pen, Density density);
    void addMarker(double time_s, const QString& text);
    void clearMarkers();
    void placeMarkerTexts();
    void showMarkerTexts(bool visible);
    QString wordsOf(const QString& marker) const; ///< under others with the run's mark
    int markerStrip() const; ///< height of the strip of their words above the traces, px; 0 without

    // Further runs drawn over this one (trace_canvas_overlays.cpp)
    void addOverlay(const QString& mark, std::shared_ptr<RecordedSession> run);
    void clearOverlays();
    void rebuildOverlays();
    void styleOverlays(Density density);
    void markObject(QCPGraph* graph, int object) const;
    QString overlayName(const Overlay& overlay, int series) const;
    double lastTime_s() const; ///< last time of all runs

    // What is shown, for print and as a table (trace_canvas_export.cpp)
    QByteArray figure(const QString& unrecorded, FigureFormat format, const QString& comment,
                      const FigureLayout& layout);
    QString rigsOfRuns() const;
    QString nameOfRun(int place) const; ///< 0: the run itself, then those over it
    PlotTable table(const QString& mark);

    // The predicted run behind it (trace_canvas_prediction.cpp)
    void setPrediction(const PredictedRun& run);
    void showPrediction(bool visible);
    bool hasPrediction() const; ///< whether it is drawn in a plot of temperatures
    void rebuildPrediction();
    void addSpread(std::size_t object, const QVector<double>& keys);
    void stylePrediction();
    QString predictionWords() const; ///< empty if none is drawn
    void placePredictionWords();
    double wholeEnd_s() const; ///< end of the whole run as it is shown: the last time, or what is predicted
    QList<QPointF> predictedPoints(int series) const;

    // Ranges, mouse, keys (trace_canvas_interaction.cpp)
    void connectInteraction();
    void schedule();
    void redrawNow();
    void updateRanges();
    void setFollow(bool follow);
    void showTime(double from_s, double to_s);
    void showWhole();
    void zoomTime(double factor, double centre_s);
    bool handleKey(const QKeyEvent* event);
    void showCursor(double time_s);
    void hideCursor();
    void pinCursor(std::optional<double> time_s);
    void measureFrom(std::optional<int> x);
    void setPosition(std::optional<double> time_s);

    // A second quantity (trace_canvas_right.cpp)
    void setRight(std::optional<Quantity> wanted);
    void rebuildRight();
    void styleRight(Density density);
    QString rightName(int series) const;
    QString rightAxisText() const; ///< empty without one
    QPen penOfRight(int series) const;
    int rightAxisWidth() const; ///< 0 without one
    void fitRightAxis();

    inline static const QString kOwnMark = QStringLiteral("A"); ///< of the run itself, under others

    TracePlot* owner;
    Quantity quantity = Quantity::Temperature;
    TemperatureUnit unit = TemperatureUnit::Celsius;
    SpeedLimits limits;
    QStringList names;
    std::shared_ptr<TraceStore> traces = std::make_shared<TraceStore>(); ///< may be shared with other plots
    bool dark = false;
    bool follow = true;
    double window_s = 0.0;
    bool markerTexts = true;
    std::optional<double> position_s; ///< position of a replay
    std::optional<double> pinned_s;   ///< the first cursor

    struct Marker {
        double time_s;
        QString text;
        QCPItemLine* line;
        QCPItemText* label;
    };
    QList<Marker> markers;

    struct RightAxis {
        std::optional<Quantity> quantity; ///< never that of the left one
        QList<QCPGraph*> graphs;
        QList<QCPItemText*> labels;
    };
    RightAxis rightAxis;

    std::vector<Overlay> overlays;
    QStringList runNames; ///< of the run itself and those over it; without them, their files

    PredictedRun prediction;         ///< without samples: none
    bool isPredictionOfNext = false; ///< it came after the run that is shown
    bool isPredictionShown = true;

protected:
    void resizeEvent(QResizeEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    void updatePoints();
    void removeOverlayItems();
    QVector<QCPGraphData> pointsOf(const TraceStore& from, Quantity of, int series, const QCPRange& time,
                                   std::size_t pixels, int& reads) const;
    void fillGraph(QCPGraph* graph, const TraceStore& from, Quantity of, int series, int& reads) const;
    void updateTargets();
    void updateEmptyText();
    void fitMargins();
    std::pair<double, double> wantedValueRange() const;
    void onUserRange(const QCPRange& range);

    QList<QCPGraph*> m_series;
    QList<QCPGraph*> m_predicted; ///< one for each object, or none
    QList<QCPGraph*> m_spreads;   ///< lower and upper edge of each, or none
    QList<QCPGraph*> m_targets;
    QList<QCPGraph*> m_bandLow, m_bandHigh;
    QList<QCPItemText*> m_labels;
    QCPItemRect* m_errorBand = nullptr;
    QCPItemStraightLine* m_reference = nullptr; ///< zero of errors and rates, 100 % of speeds
    QCPItemText* m_empty = nullptr;
    int m_emptyStrip = 0;                    ///< height of its strip above predicted lines, px; 0 elsewhere
    QCPItemText* m_predictionText = nullptr; ///< says what the pale lines are
    QCPItemLine* m_cursor = nullptr;
    QCPItemLine* m_pinned = nullptr;
    QCPItemLine* m_position = nullptr;
    QLabel* m_readout = nullptr;

    QTimer m_timer;
    QTimer m_rest; ///< active while a person moves the time axis, and a moment longer
    QCPRange m_drawnRange;
    QElapsedTimer m_sinceReplot;
    bool m_pointsAreOld = true;
    bool m_isUnread = false; ///< part of the shown data is not read yet; it is read with the next frame
    QCPRange m_pointsRange;
    int m_pointsWidth = 0;
    bool m_isDrawn = false; ///< has been drawn once
    bool m_programRange = false;
    bool m_valueAuto = true;
    std::optional<double> m_cursor_s;
    QPoint m_pressed;
};

} // namespace bask
