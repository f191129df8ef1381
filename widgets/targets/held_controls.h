#pragma once
// Sliders for what is held while surfaces are drawn over the other coordinates.

#include "engine/control/robot_limits.h"
#include "engine/exchange/target_surfaces.h"

#include <QWidget>

#include <array>
#include <vector>

class QBoxLayout;
class QLabel;
class QPushButton;
class QToolButton;

namespace bask {

class CoordinateSlider;

/// A slider a coordinate with its value in words, a button that plays it and one that goes back to the pose's
/// values. Setters in, signals of what a person does out. Object names: "heldX" to "heldZ", "heldThetaX" to
/// "heldThetaZ" (sliders), "heldWord..." (their labels), "playSweep", "heldAtPose".
class HeldControls : public QWidget {
    Q_OBJECT

public:
    explicit HeldControls(QWidget* parent = nullptr);

    /// Shows the sliders of these over the robot's range; of none, nothing is shown.
    void setCoordinates(const std::vector<Coordinate>& coordinates, const RobotLimits& robot);
    /// Shows values; `isManual`: they are not the pose's.
    void setFixed(const Vector6d& fixed, bool isManual);
    void setPlaying(bool playing);

signals:
    void fixedManually(int coordinate, double value);
    void poseWanted();
    void playWanted(bool play);

protected:
    void changeEvent(QEvent* event) override;

private:
    struct Cell {
        QBoxLayout* layout;
        QLabel* word;
        CoordinateSlider* slider;
    };
    void showWord(int coordinate, double value);
    void retranslate();

    QToolButton* m_play;
    std::array<Cell, 6> m_cells{};
    QPushButton* m_atPose;
};

} // namespace bask
