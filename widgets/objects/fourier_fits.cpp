#include "widgets/objects/fourier_fits.h"

#include <QCoreApplication>
#include <QPointer>
#include <QtConcurrentRun>

namespace bask {

FourierFits::FourierFits(QObject* parent) : QObject(parent) {}

FourierFits::~FourierFits() {
    if (m_job)
        m_job->cancelled = true;
}

void FourierFits::setOutline(const Contour& outline) {
    if (outline == *m_outline)
        return;
    if (m_job)
        m_job->cancelled = true;
    m_job.reset();
    m_outline = std::make_shared<Contour>(outline);
    m_fits.fill(std::nullopt);
    m_done = 0;
    if (!outline.points_m.empty())
        run();
}

void FourierFits::want(int harmonics) {
    if (m_job)
        m_job->wanted = harmonics;
}

void FourierFits::run() {
    m_job = std::make_shared<Job>();
    // The job sees its own copies only; the receiver is looked at again on the GUI thread.
    const auto work = [job = m_job, outline = m_outline, self = QPointer<FourierFits>(this)] {
        std::array<bool, kMaxHarmonics + 1> done{};
        for (int next = 1; next <= kMaxHarmonics && !job->cancelled;) {
            const int wanted = job->wanted;
            const bool jump =
                wanted >= 1 && wanted <= kMaxHarmonics && !done.at(static_cast<std::size_t>(wanted));
            const int h = jump ? wanted : next;
            if (!jump)
                ++next;
            if (done.at(static_cast<std::size_t>(h)))
                continue;
            done.at(static_cast<std::size_t>(h)) = true;
            std::optional<FourierFit> fit;
            if (auto result = fitFourier(*outline, h))
                fit = std::move(result.value());
            if (job->cancelled)
                return;
            QMetaObject::invokeMethod(
                qApp,
                [self, job, h, fit = std::move(fit)]() mutable {
                    if (self)
                        self->take(job, h, std::move(fit));
                },
                Qt::QueuedConnection);
        }
    };
    (void)QtConcurrent::run(work);
}

void FourierFits::take(const std::shared_ptr<Job>& job, int harmonics, std::optional<FourierFit> fit) {
    if (job != m_job)
        return;
    m_fits.at(static_cast<std::size_t>(harmonics)) = std::move(fit);
    ++m_done;
    emit fitReady(harmonics);
}

} // namespace bask
