#pragma once
// Waiting in tests: events are handled until a condition holds; no blind sleeps.

#include <QCoreApplication>
#include <QDeadlineTimer>

namespace bask::test {

/// True as soon as `condition` holds; false after `limit_ms`.
template <class Condition> bool waitFor(Condition condition, int limit_ms = 20000) {
    const QDeadlineTimer deadline(limit_ms);
    while (!condition()) {
        if (deadline.hasExpired())
            return false;
        QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
    }
    return true;
}

} // namespace bask::test
