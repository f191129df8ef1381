#pragma once
// Which axis of the robot's controller drives which coordinate, in which direction, from where.

#include "engine/protocols/axis_map.h"

#include <QWidget>

#include <array>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;

namespace bask {

/// One row for each coordinate. Object names end in the coordinate's ("theta_x"): "axis.", "reversed.",
/// "origin.".
class AxisTable : public QWidget {
    Q_OBJECT

public:
    explicit AxisTable(QWidget* parent = nullptr);

    void setAxes(const std::vector<AxisSpec>& axes);
    /// Returns the axes in the order in which controllers report them: X Y Z A B C R.
    std::vector<AxisSpec> axes() const;

protected:
    void changeEvent(QEvent* event) override;

private:
    struct Row {
        QComboBox* letter;
        QCheckBox* reversed;
        QDoubleSpinBox* origin;
        AxisSpec given; ///< so that an origin that is not edited keeps its digits
    };
    void retranslate();

    std::array<Row, 6> m_rows{};
    QLabel *m_axisLabel, *m_originLabel;
};

} // namespace bask
