#pragma once
// What a calibration's outcome is worth to the operator.

#include "engine/base/message.h"

namespace bask {

enum class Verdict { Good, Usable, Redo };

struct Judgement {
    Verdict verdict = Verdict::Redo;
    Message reason;
};

} // namespace bask
