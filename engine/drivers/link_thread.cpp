#include "engine/drivers/link_thread.h"

#include <QTimer>

#include <utility>

namespace bask {

LinkThread::LinkThread() : m_there(new QObject) {
    m_there->moveToThread(&m_thread);
    m_thread.start();
}

LinkThread::~LinkThread() {
    m_there->deleteLater();
    m_thread.quit();
    m_thread.wait();
}

void LinkThread::post(std::function<void()> task) {
    QMetaObject::invokeMethod(m_there, std::move(task), Qt::QueuedConnection);
}

void LinkThread::repeat(std::function<void()> turn) {
    for (QObject* timer : m_there->children())
        timer->deleteLater();
    if (!turn)
        return;
    auto* timer = new QTimer(m_there);
    timer->setTimerType(Qt::PreciseTimer);
    QObject::connect(timer, &QTimer::timeout, m_there, std::move(turn));
    timer->start(kTurn_ms);
}

void LinkThread::finish(const std::function<void()>& last) {
    QMetaObject::invokeMethod(m_there, last, Qt::BlockingQueuedConnection);
}

} // namespace bask
