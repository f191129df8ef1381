#include "widgets/calibrate/thermal_board_watch.h"

#include "engine/base/clock.h"
#include "engine/base/message_code.h"
#include "engine/thermography/thermal_board.h"

namespace bask {

ThermalBoardWatch::ThermalBoardWatch(QObject* parent) : QObject(parent) {}

ThermalBoardWatch::~ThermalBoardWatch() = default;

void ThermalBoardWatch::setBoard(const std::optional<Board>& board) {
    m_board = board;
    m_looking.forget();
}

void ThermalBoardWatch::setView(const ThermalView& view) {
    if (!m_board)
        return;
    if (view.problem.code != MessageCode::None || !view.picture) {
        m_shown.problem = view.problem;
        m_shown.board.reset();
        return emit looked(m_shown);
    }
    if (m_looking.busy() || view.time_s == m_time_s || isConstant(*view.picture))
        return; // a closed shutter shows no board
    VisionView next;
    next.cameraName = view.cameraName;
    if (view.time_s > m_time_s && m_shown.frame)
        next.rate_Hz = 1.0 / (view.time_s - m_time_s);
    m_time_s = view.time_s;
    const std::uint64_t number = m_shown.frame ? m_shown.frame->number + 1 : 1;
    m_looking.run(
        [view, next, number, board = *m_board, seen_s = SteadyClock().now_s()] {
            VisionView shown = next;
            auto frame = std::make_shared<CameraFrame>();
            frame->time_s = view.time_s;
            frame->caught_s = seen_s - view.age_s;
            frame->number = number;
            frame->picture = greyPicture(*view.picture);
            ThermalBoard found = findThermalBoard(frame->picture, board, view.cameraName);
            shown.frame = std::move(frame);
            shown.board = std::move(found.view);
            shown.boardSeen = found.seen;
            shown.latency_s = SteadyClock().now_s() - shown.frame->caught_s;
            return shown;
        },
        [this](VisionView shown) {
            m_shown = std::move(shown);
            emit looked(m_shown);
        });
}

} // namespace bask
