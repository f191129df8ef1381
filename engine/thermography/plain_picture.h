#pragma once
// Tells a picture for people from temperatures: a YUYV camera sends both, one above the other, in the same
// 16 bits a pixel.

#include "engine/base/message.h"
#include "engine/thermography/frame_decoder.h"

namespace bask {

enum class PlainPicture { No, Perhaps, Yes };

/// Returns whether the rows of temperatures hold a plain picture. In YUYV the low bytes are brightness and
/// the high ones colour, U and V in turn. Colours, if a tenth of the picture has them, alternate from pixel
/// to pixel as no temperature does: Yes. Grey is the number 128 in every high byte, which is a scene within
/// 256 steps of the scale as well (4 K at 240 degC with steps of 1/64 K): Yes if the rows above look like
/// temperatures, so that the halves are exchanged, or if the brightness reaches both ends of its byte with no
/// pixel beyond, as a scene does not; else Perhaps. Other cameras and big-endian numbers: No.
PlainPicture plainPicture(const CountPicture& counts, const ThermalProfile& profile);

/// Returns the warning for Perhaps: ThermalPlainDoubt.
Message plainPictureDoubt(const ThermalProfile& profile);

} // namespace bask
