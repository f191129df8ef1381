#pragma once
// How good a calibration's result is, for the operator.

#include "engine/base/message.h"

namespace bask {

enum class Verdict { Good, Usable, Redo };

struct Judgement {
    Verdict verdict = Verdict::Redo;
    Message reason;
};

} // namespace bask
