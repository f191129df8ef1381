#pragma once
// Looks of a camera as the engine sends them, made up.

#include "engine/base/clock.h"
#include "engine/vision/vision_view.h"
#include "tests/support/board_views.h"

namespace bask::test {

/// The same picture again and again, a thirtieth of a second apart.
class VisionScene {
public:
    explicit VisionScene(const Board& set) : board(set) {
        auto grey = GreyPicture{1280, 720, std::vector<std::uint8_t>(std::size_t{1280} * 720, 90)};
        setPicture(std::move(grey));
    }

    void setPicture(GreyPicture picture) { m_picture = std::move(picture); }

    /// The next frame; without a pose the board is not in it.
    VisionView look(const std::optional<Pose>& X_CB = std::nullopt, double noise_px = 0.15) {
        auto frame = std::make_shared<CameraFrame>();
        frame->number = ++m_number;
        frame->time_s = static_cast<double>(m_number) / 30.0;
        frame->caught_s = SteadyClock().now_s() - 0.04;
        frame->picture = m_picture;
        VisionView view;
        view.cameraName = "camera 0";
        view.frame = frame;
        view.rate_Hz = 29.9;
        view.latency_s = 0.031;
        if (X_CB)
            view.board = viewOf(board, *X_CB, camera, noise_px, m_random);
        return view;
    }

    Board board;
    CameraModel camera = trueCamera();

private:
    GreyPicture m_picture;
    std::uint64_t m_number = 0;
    std::mt19937 m_random{12};
};

} // namespace bask::test
