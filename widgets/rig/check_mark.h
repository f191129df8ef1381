#pragma once
// Marks before a line of text: done, wrong, under way, none. Told apart by their shape, not their colour.

#include <QPixmap>

namespace bask {

enum class CheckMark { Tick, Cross, Waiting, None };

QPixmap checkMarkPixmap(CheckMark mark, bool dark, int size, double devicePixelRatio);

} // namespace bask
