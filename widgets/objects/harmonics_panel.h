#pragma once
// Number of harmonics of an object's outline: slider, spin box, residual in mm, crossing warning, residual
// plot.

#include "engine/shape/fourier_contour.h"

#include <QWidget>

class QLabel;
class QSlider;
class QSpinBox;

namespace bask {

class FourierFits;
class ResidualPlot;

/// Works on an outline; the fits run off the GUI thread. While the slider is dragged `fitChanged` follows;
/// letting it go (or a key, the spin box, a click in the plot) gives `fitCommitted`. Object names:
/// "harmonicsSlider", "harmonicsSpin", "residual", "crossingWarning", "residualPlot".
class HarmonicsPanel : public QWidget {
    Q_OBJECT

public:
    explicit HarmonicsPanel(QWidget* parent = nullptr);

    /// Outline of the object shown and the number in use; an empty outline disables the panel and tells
    /// `why`.
    void setOutline(const Contour& outline, int harmonics, const QColor& color, const QString& why);

signals:
    void fitChanged(const bask::FourierFit& fit);
    void fitCommitted(const bask::FourierFit& fit);

protected:
    void changeEvent(QEvent* event) override;

private:
    void choose(int harmonics, bool commit);
    void deliver();
    void onFitReady(int harmonics);
    void refreshTexts();

    FourierFits* m_fits;
    QLabel* m_caption;
    QSlider* m_slider;
    QSpinBox* m_spin;
    QLabel* m_residual;
    QLabel* m_warningIcon;
    QLabel* m_warning;
    ResidualPlot* m_plot;
    QString m_why;
    bool m_waiting = false; ///< the chosen number's fit has not been delivered
    bool m_commit = false;  ///< deliver it as committed
};

} // namespace bask
