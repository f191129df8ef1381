#pragma once
// Waiting in tests: events are handled until a condition holds; no blind sleeps.

#include <QCoreApplication>
#include <QDeadlineTimer>
#include <QThread>

namespace bask::test {

/// True as soon as `condition` holds; false after `limit_ms`.
template <class Condition> bool waitFor(Condition condition, int limit_ms = 120000) {
    const QDeadlineTimer deadline(limit_ms);
    while (!condition()) {
        if (deadline.hasExpired())
            return false;
        QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
        QThread::msleep(1); // or two tests that wait take the machine from what they wait for
    }
    return true;
}

} // namespace bask::test
