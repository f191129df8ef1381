#pragma once
// Marks English texts of the engine for lupdate without using Qt, with the same definition as in Qt. The code
// that shows a text translates it.

#ifndef QT_TRANSLATE_NOOP
#define QT_TRANSLATE_NOOP(scope, x) x
#endif
