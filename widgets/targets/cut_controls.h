#pragma once
// The choice of a plane through an object's field.

#include "engine/radiation/field_sampler.h"

#include <QStringList>
#include <QWidget>

#include <optional>
#include <vector>

class QComboBox;
class QLabel;

namespace bask {

class CoordinateSlider;

/// A plane through an object's field.
struct CutChoice {
    int object = 0;
    Coordinate axis = kY;  ///< normal to it
    double position = 0.0; ///< m or rad
    bool asTemperature = true;
};

/// One row: object, quantity, axis, and a slider with the place in words. Object names: "cutObject",
/// "cutQuantity", "cutAxis", "cutPlace" (slider: mm, or half degrees), "cutWord".
class CutControls : public QWidget {
    Q_OBJECT

public:
    explicit CutControls(QWidget* parent = nullptr);

    void setObjects(const QStringList& names);
    /// Sets the three axes of the field to be cut, and their coordinates at `home`: the start of a plane that
    /// is new, or was across another axis.
    void setAxes(const std::vector<FieldAxis>& axes, const Eigen::Vector3d& home);
    std::optional<int> object() const;
    /// The chosen cut; empty if none is wanted.
    std::optional<CutChoice> choice() const;

signals:
    void changed();

protected:
    void changeEvent(QEvent* event) override;

private:
    int coordinate() const;
    void place();
    void showRow();
    void retranslate();

    std::vector<FieldAxis> m_axes;
    Eigen::Vector3d m_home = Eigen::Vector3d::Zero();
    int m_placed = -1; ///< coordinate normal to the shown plane
    QStringList m_names;
    QComboBox* m_object; ///< first: no cut; then the objects
    QComboBox* m_quantity;
    QComboBox* m_axis;
    CoordinateSlider* m_place;
    QLabel* m_word;
};

} // namespace bask
