#pragma once
// Calibration boards in thermal pictures: their fields differ in emittance or temperature, in either sense,
// and the pictures have few pixels.

#include "engine/calibration/board_finder.h"
#include "engine/shape/marker.h"
#include "engine/thermography/thermal_picture.h"

#include <optional>
#include <string>

namespace bask {

/// Returns a picture in grey: dark where it is cold. All but the coldest and the warmest percent of its
/// pixels are between the two ends. Pixels without a temperature are grey.
GreyPicture greyPicture(const ThermalPicture& picture);

struct ThermalBoard {
    Result<BoardView> view;
    std::optional<Board> seen; ///< the board that was found, else the one that boardSeen() tells
};

/// Looks for a board whose dark fields look colder or warmer than the others, in a picture that is enlarged
/// for it; corners are those of the picture itself. Errors: those of findBoard.
ThermalBoard findThermalBoard(const GreyPicture& picture, const Board& board, const std::string& where);

} // namespace bask
