#pragma once
// How a thermal picture is drawn: palette, limits of the colours, isotherm, smoothing.

#include "engine/base/units.h"
#include "widgets/thermal/thermal_colours.h"

#include <QWidget>

#include <optional>

class QBoxLayout;
class QCheckBox;
class QComboBox;
class QLabel;

namespace bask {

class QuantitySpinBox;

enum class ThermalLimits {
    Objects, ///< the objects' pixels, with a margin
    Picture, ///< all pixels but a few
    Fixed,
};

/// In one row, or in two where that is too wide.
class ThermalControls : public QWidget {
    Q_OBJECT
public:
    explicit ThermalControls(QWidget* parent = nullptr);

    ThermalPalette colours() const;
    ThermalLimits limits() const;
    ThermalRange fixedRange() const;
    std::optional<Isotherm> isotherm() const;
    bool isZoomed() const;
    bool isSmooth() const;
    /// Tells the limits that are shown: fixed ones begin there, and an isotherm in their middle.
    void setShownRange(const ThermalRange& range);
    void setTemperatureUnit(TemperatureUnit unit);

    QSize minimumSizeHint() const override;

signals:
    void changed();

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void retranslateUi();
    void showFields();
    void keepApart();

    QBoxLayout* m_layout;
    QWidget *m_colours, *m_marks; ///< the two groups
    QComboBox *m_palette, *m_limits, *m_isotherm;
    QuantitySpinBox *m_min, *m_max, *m_isothermAt;
    QLabel* m_to;
    QCheckBox *m_zoom, *m_smooth;
    bool m_hasIsotherm = false; ///< its temperature was set
};

} // namespace bask
