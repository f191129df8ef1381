#pragma once
// How often each temperature occurs among pixels, as bars in the picture's colours.

#include "engine/base/units.h"
#include "widgets/thermal/thermal_colours.h"

#include <QWidget>

#include <optional>

namespace bask {

class ThermalHistogramPlot : public QWidget {
    Q_OBJECT
public:
    explicit ThermalHistogramPlot(QWidget* parent = nullptr);

    /// Sets whose pixels are counted, and in which colours they are drawn.
    void setHistogram(const QString& subject, std::optional<ThermalHistogram> histogram,
                      const ThermalLook& look);
    void setTemperatureUnit(TemperatureUnit unit);
    /// Returns the lines above the bars: subject and number of pixels; mean and standard deviation.
    QString title() const;
    QString summary() const;

    QSize sizeHint() const override { return {260, 120}; }
    QSize minimumSizeHint() const override { return {200, 70}; }

protected:
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void describe();
    void paintBars(QPainter& painter, const QRectF& place) const;
    void paintAxis(QPainter& painter, const QRectF& place) const;
    double to_K() const; ///< upper edge of the last bin

    QString m_subject;
    std::optional<ThermalHistogram> m_histogram;
    ThermalLook m_look;
    TemperatureUnit m_unit = TemperatureUnit::Celsius;
};

} // namespace bask
