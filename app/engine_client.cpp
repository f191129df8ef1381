#include "app/engine_client.h"

#include "engine/runtime/engine_worker.h"

#include <QCoreApplication>
#include <QEvent>
#include <QThread>

#include <atomic>
#include <mutex>

namespace bask {

/// What other threads know of the worker.
struct EngineClient::Ending {
    void begin() {
        const std::lock_guard lock(mutex);
        if (worker != nullptr)
            QMetaObject::invokeMethod(worker, &EngineWorker::shutdown, Qt::QueuedConnection);
    }
    void set(EngineWorker* now) {
        const std::lock_guard lock(mutex);
        worker = now;
    }

    std::mutex mutex;
    EngineWorker* worker = nullptr;
};

EngineClient::EngineClient(QObject* parent) : QObject(parent), m_ending(std::make_shared<Ending>()) {
    m_silence.setInterval(kSilence);
    m_silence.setSingleShot(true);
    connect(&m_silence, &QTimer::timeout, this, [this] {
        m_answering = false;
        emit answeringChanged(false);
    });
}

EngineClient::~EngineClient() {
    shutDown(kEnd);
}

void EngineClient::start(const QString& alarmFile, const QString& deviceFile) {
    if (m_thread != nullptr)
        return;
    m_thread = new QThread;
    m_thread->setObjectName(QStringLiteral("engine"));
    m_worker = new EngineWorker(alarmFile.toStdString(), deviceFile.toStdString());
    m_worker->setWatch(m_watch);
    m_worker->moveToThread(m_thread);
    m_ending->set(m_worker);
    connect(m_thread, &QThread::started, m_worker, &EngineWorker::start);
    connect(m_thread, &QThread::finished, m_worker, &QObject::deleteLater);
    connect(m_worker, &EngineWorker::published, this, &EngineClient::take);
    connect(m_worker, &EngineWorker::looked, this, &EngineClient::looked);
    connect(m_worker, &EngineWorker::sawHeat, this, &EngineClient::sawHeat);
    m_thread->start();
    m_silence.start();
}

void EngineClient::send(const Command& command) {
    if (m_worker != nullptr)
        QMetaObject::invokeMethod(
            m_worker, [worker = m_worker, command] { worker->post(command); }, Qt::QueuedConnection);
}

bool EngineClient::shutDown(std::chrono::milliseconds bound) {
    if (m_thread == nullptr)
        return true;
    m_silence.stop();
    m_ending->set(nullptr);
    disconnect(m_worker, nullptr, this, nullptr);
    QThread* thread = std::exchange(m_thread, nullptr);
    const auto isHeatLeft = std::make_shared<std::atomic<bool>>(false); // the thread may outlive this
    QMetaObject::invokeMethod(
        m_worker,
        [worker = m_worker, thread, isHeatLeft] {
            worker->shutdown();
            *isHeatLeft = worker->isHeatLeft();
            thread->quit();
        },
        Qt::QueuedConnection);
    m_worker = nullptr;
    const bool ended = thread->wait(QDeadlineTimer(bound));
    m_isHeatLeft = *isHeatLeft;
    QCoreApplication::removePostedEvents(this, QEvent::MetaCall); // on the way before it was disconnected
    if (ended)
        delete thread;
    return ended;
}

std::function<void()> EngineClient::ender() const {
    return [ending = m_ending] { ending->begin(); };
}

void EngineClient::take(const Snapshot& received) {
    m_silence.start();
    if (!m_answering) {
        m_answering = true;
        emit answeringChanged(true);
    }
    emit snapshot(received);
}

} // namespace bask
