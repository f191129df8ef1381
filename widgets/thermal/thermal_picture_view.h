#pragma once
// The picture of a thermal camera with what is read from it: colours, outlines, a spot, an isotherm, the
// objects' temperatures and how their pixels are distributed.

#include "engine/base/units.h"
#include "engine/thermography/thermal_view.h"
#include "widgets/thermal/thermal_range.h"

#include <QElapsedTimer>
#include <QWidget>

#include <optional>
#include <vector>

class QBoxLayout;
class QLabel;
class QTimer;

namespace bask {

class ThermalCanvas;
class ThermalControls;
class ThermalHistogramPlot;
class ThermalObjectList;

/// A problem, or a picture older than kOldAfter_s, is told over the last picture, which is dimmed and
/// hatched; a recorded one is as old as it is. Object names: "thermalCanvas", "thermalObjects",
/// "thermalHistogram"; "thermalPalette", "thermalLimits", "thermalMin", "thermalMax", "thermalIsotherm",
/// "thermalIsothermAt", "thermalZoom", "thermalSmooth"; "thermalStatus", "thermalLegend".
class ThermalPictureView : public QWidget {
    Q_OBJECT
public:
    static constexpr double kOldAfter_s = 3.0; ///< longer than a shutter event

    explicit ThermalPictureView(QWidget* parent = nullptr);

    /// Sets the objects' names, in the experiment's order, which is that of their colours in traces.
    void setNames(const std::vector<QString>& names);
    void setTemperatureUnit(TemperatureUnit unit);
    /// Shows pictures of a record: they have a time in the run instead of an age.
    void setRecorded();

    ThermalRange limits() const { return m_shown.value_or(ThermalRange{}); } ///< of the colours
    QString sentence() const;   ///< text over the picture; empty while the camera answers
    QString statusText() const; ///< text below the picture: camera, size, rate, age

    QSize minimumSizeHint() const override { return {500, 150}; }

public slots:
    /// Cheap while it is not seen.
    void setView(const bask::ThermalView& view);

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    double age_s() const;
    QString leftOutText() const; ///< which picture was left out last, and why
    void refresh();
    void refreshLimits();
    void refreshNotice();
    void refreshHistogram();
    void arrange();

    ThermalView m_view;
    QElapsedTimer m_since;               ///< the view came
    double m_period_s = 0.0;             ///< of pictures, smoothed; 0 before the second
    std::optional<ThermalRange> m_whole; ///< of the picture
    std::optional<ThermalRange> m_shown; ///< by the colours
    TemperatureUnit m_unit = TemperatureUnit::Celsius;
    bool m_isRecorded = false;

    ThermalControls* m_controls;
    ThermalCanvas* m_canvas;
    ThermalObjectList* m_list;
    ThermalHistogramPlot* m_histogram;
    QLabel *m_status, *m_legend; ///< below the picture
    QBoxLayout* m_panel;         ///< list and histogram
    QTimer* m_age;
};

} // namespace bask
