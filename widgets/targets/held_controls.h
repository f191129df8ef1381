#pragma once
// Sliders for the fixed coordinates while surfaces are drawn over the others.

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

/// A slider for each coordinate with its value in words, a button that plays it and one that restores the
/// pose's values. Passive: takes values, sends a person's changes. Object names: "heldX" to "heldZ",
/// "heldThetaX" to "heldThetaZ" (sliders), "heldWord..." (their labels), "playSweep", "heldAtPose".
class HeldControls : public QWidget {
    Q_OBJECT

public:
    explicit HeldControls(QWidget* parent = nullptr);

    /// Shows the sliders of these coordinates over the robot's range; nothing if there are none.
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
