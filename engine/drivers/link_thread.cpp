#include "engine/drivers/link_thread.h"

#include <QThread>
#include <QTimer>

#include <utility>

namespace bask {
namespace {

constexpr int kTurn_ms = 4;

} // namespace

struct LinkThread::Parts {
    QThread thread;
    QTimer* timer = new QTimer; // lives on that thread, and ends there
};

LinkThread::LinkThread(std::function<void()> turn) : m_parts(std::make_unique<Parts>()) {
    QTimer* timer = m_parts->timer;
    timer->setTimerType(Qt::PreciseTimer);
    timer->setInterval(kTurn_ms);
    QObject::connect(timer, &QTimer::timeout, timer, std::move(turn));
    timer->moveToThread(&m_parts->thread);
    m_parts->thread.start();
}

LinkThread::~LinkThread() {
    m_parts->timer->deleteLater();
    m_parts->thread.quit();
    m_parts->thread.wait();
}

void LinkThread::post(std::function<void()> task) {
    QMetaObject::invokeMethod(m_parts->timer, std::move(task), Qt::QueuedConnection);
}

void LinkThread::start() {
    m_parts->timer->start();
}

void LinkThread::stop() {
    m_parts->timer->stop();
}

void LinkThread::finish(const std::function<void()>& last) {
    QMetaObject::invokeMethod(m_parts->timer, last, Qt::BlockingQueuedConnection);
}

} // namespace bask
