#include "widgets/objects/fourier_fits.h"

#include "engine/model/experiment.h"

#include <QCoreApplication>
#include <QPointer>
#include <QtConcurrentRun>

#include <utility>

namespace bask {
namespace {

constexpr double kPointsPerOutline = 1000.0; // at least, however few its corners are

} // namespace

/// What one job does on a thread of the pool. It sees its own copies only; the receiver is looked at again on
/// the GUI thread.
struct FourierFits::Work {
    std::shared_ptr<Job> job;
    std::shared_ptr<const Contour> outline;
    QPointer<FourierFits> receiver;

    void operator()() const {
        const auto points =
            std::make_shared<Points>(pointsAlong(*outline, contourPerimeter(*outline) / kPointsPerOutline));
        const auto polygon = std::make_shared<Contour>(simplifiedTo(*outline, kMaxCorners));
        tell([points, polygon](FourierFits& fits) {
            fits.m_points = points;
            fits.m_polygon = polygon;
        });
        std::array<bool, kMaxHarmonics + 1> done{};
        for (int next = 1; next <= kMaxHarmonics && !job->cancelled;) {
            const int wanted = job->wanted;
            const bool jump =
                wanted >= 1 && wanted <= kMaxHarmonics && !done.at(static_cast<std::size_t>(wanted));
            const int h = jump ? wanted : next;
            if (!jump)
                ++next;
            if (std::exchange(done.at(static_cast<std::size_t>(h)), true))
                continue;
            std::optional<OutlineFit> fit;
            if (auto result = fitFourier(*outline, h))
                fit = OutlineFit{*result, distancesTo(*result, *points)};
            tell([h, fit = std::move(fit)](FourierFits& fits) mutable {
                fits.m_fits.at(static_cast<std::size_t>(h)) = std::move(fit);
                ++fits.m_done;
                emit fits.fitReady(h);
            });
        }
    }

    template <class Answer> void tell(Answer answer) const {
        QMetaObject::invokeMethod(
            qApp,
            [self = receiver, sender = job, answer = std::move(answer)]() mutable {
                if (self && self->m_job == sender)
                    answer(*self);
            },
            Qt::QueuedConnection);
    }
};

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
    m_points = std::make_shared<Points>();
    m_polygon = std::make_shared<Contour>();
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
    (void)QtConcurrent::run(Work{m_job, m_outline, this});
}

} // namespace bask
