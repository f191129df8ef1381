#pragma once
// Marks English texts of the engine for lupdate, without Qt; whoever shows one translates it. As Qt defines
// it.

#ifndef QT_TRANSLATE_NOOP
#define QT_TRANSLATE_NOOP(scope, x) x
#endif
