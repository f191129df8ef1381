#include "engine/drivers/link_thread.h"

#include <utility>

namespace bask {

LinkThread::LinkThread(std::function<void()> turn) : m_timer(new QTimer) {
    m_timer->setTimerType(Qt::PreciseTimer);
    m_timer->setInterval(kTurn_ms);
    QObject::connect(m_timer, &QTimer::timeout, m_timer, std::move(turn));
    m_timer->moveToThread(&m_thread);
    m_thread.start();
}

LinkThread::~LinkThread() {
    m_timer->deleteLater();
    m_thread.quit();
    m_thread.wait();
}

void LinkThread::post(std::function<void()> task) {
    QMetaObject::invokeMethod(m_timer, std::move(task), Qt::QueuedConnection);
}

void LinkThread::start() {
    m_timer->start();
}

void LinkThread::stop() {
    m_timer->stop();
}

void LinkThread::finish(const std::function<void()>& last) {
    QMetaObject::invokeMethod(m_timer, last, Qt::BlockingQueuedConnection);
}

} // namespace bask
