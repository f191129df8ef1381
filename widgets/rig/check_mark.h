#pragma once
// Marks before a line of text: done, wrong, in progress, none. They differ by shape, not only by colour.

#include <QPixmap>

namespace bask {

enum class CheckMark { Tick, Cross, Waiting, None };

QPixmap checkMarkPixmap(CheckMark mark, bool dark, int size, double devicePixelRatio);

} // namespace bask
