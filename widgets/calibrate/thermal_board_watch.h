#pragma once
// Shows the pictures of a thermal camera as those of a camera of light, with a board looked for in them.

#include "engine/calibration/board.h"
#include "engine/thermography/thermal_view.h"
#include "engine/vision/vision_view.h"
#include "widgets/common/latest_job.h"

#include <QObject>

#include <optional>

namespace bask {

/// Looks at one picture at a time, off the GUI thread; pictures that come meanwhile are left out.
class ThermalBoardWatch : public QObject {
    Q_OBJECT

public:
    explicit ThermalBoardWatch(QObject* parent = nullptr);
    ~ThermalBoardWatch() override;

    /// Sets the board to look for; without one nothing is looked at.
    void setBoard(const std::optional<Board>& board);
    void setView(const ThermalView& view);

signals:
    void looked(const bask::VisionView& view);

private:
    std::optional<Board> m_board;
    VisionView m_shown;
    double m_time_s = 0.0; ///< of the last picture that was looked at
    LatestJob<VisionView> m_looking;
};

} // namespace bask
