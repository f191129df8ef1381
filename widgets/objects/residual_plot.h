#pragma once
// Residual of the Fourier outline (rms and largest, mm, logarithmic) against its number of harmonics.

#include "engine/shape/fourier_contour.h"

#include <QWidget>

#include <array>

namespace bask {

/// Values arrive one by one; a click requests the number of harmonics under the pointer.
class ResidualPlot : public QWidget {
    Q_OBJECT

public:
    explicit ResidualPlot(QWidget* parent = nullptr);

    void clear();
    /// rms and largest residual in m, of a fit with `harmonics` harmonics.
    void setResidual(int harmonics, double rms_m, double max_m);
    void setCurrent(int harmonics);
    void setColor(const QColor& color);

    QSize minimumSizeHint() const override { return {220, 110}; }
    QSize sizeHint() const override { return {420, 130}; }

signals:
    void harmonicsClicked(int harmonics);

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;

private:
    struct Residual {
        double rms_mm = 0.0; ///< 0 if not known yet
        double max_mm = 0.0;
    };
    struct Axes;
    Axes axes() const;
    void retranslate();
    void paintAxes(QPainter& painter, const Axes& axes) const;
    void paintCurve(QPainter& painter, const Axes& axes, double Residual::*value) const;

    std::array<Residual, kMaxHarmonics + 1> m_residuals{};
    int m_current = 0;
    QColor m_color;
};

} // namespace bask
