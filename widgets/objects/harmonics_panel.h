#pragma once
// How an object's outline becomes its shape: number of harmonics, chosen or found for a tolerance, or the
// outline itself; the residual of the fit in words and as a plot.

#include "engine/shape/shape.h"

#include <QWidget>

#include <optional>

class QCheckBox;
class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QSlider;

namespace bask {

class FourierFits;
class ResidualPlot;
class WholeNumberField;

/// Works on an outline; the fits run off the GUI thread. Dragging the slider gives `fitChanged`; releasing it
/// (or a key, the spin box, a click in the plot, a tolerance) gives `fitCommitted`. Object names:
/// "harmonicsSlider", "harmonicsSpin", "fewestHarmonics", "tolerance", "useOutline", "residual",
/// "toleranceVerdict", "takeClosest", "crossingWarning", "residualPlot".
class HarmonicsPanel : public QWidget {
    Q_OBJECT

public:
    explicit HarmonicsPanel(QWidget* parent = nullptr);

    /// Sets the outline of the shown object and its number of harmonics, 0 for the outline itself; an empty
    /// outline disables the panel and shows `why`.
    void setOutline(const Contour& outline, int harmonics, const QColor& color, const QString& why);
    /// Sets the holes in the outline: the search for the fewest harmonics must not damage them.
    void setHoles(const std::vector<Contour>& holes) { m_holes = holes; }

signals:
    void fitChanged(const bask::FourierFit& fit);
    void fitCommitted(const bask::FourierFit& fit);
    /// The outline itself was chosen as the shape; it is thinned if it has more corners than an object may
    /// have.
    void outlineCommitted(const bask::Contour& polygon);
    /// Distances of points of the outline (m, in its own coordinates) from the shown fit.
    void distancesReady(const bask::FourierFit& fit, const std::vector<Eigen::Vector2d>& points_m,
                        const std::vector<double>& distances_m);

protected:
    void changeEvent(QEvent* event) override;

private:
    void arrange();
    void connectAll();
    void choose(int harmonics, bool commit);
    void deliver();
    void tellDistances();
    void chooseFewest();
    void useOutline(bool use);
    void onFitReady(int harmonics);
    void refreshTexts();
    void refreshResidual();
    QString outlineText() const;
    void setVerdict(const QString& text, int closest = 0);

    FourierFits* m_fits;
    QLabel* m_caption;
    QSlider* m_slider;
    WholeNumberField* m_spin;
    QPushButton* m_fewest;
    QDoubleSpinBox* m_tolerance;
    QCheckBox* m_useOutline;
    QLabel* m_residual;
    QLabel* m_verdict; ///< result for the tolerance
    QPushButton* m_takeClosest;
    int m_closest = 0; ///< number of harmonics that it offers; 0: none
    QLabel* m_warningIcon;
    QLabel* m_warning;
    ResidualPlot* m_plot;
    QString m_why;
    std::vector<Contour> m_holes;
    bool m_waiting = false;                ///< the fit of the chosen number is not delivered yet
    bool m_commit = false;                 ///< deliver it as committed
    std::optional<double> m_sought_m = {}; ///< tolerance whose number of harmonics is being searched
};

} // namespace bask
