#include "app/commands/recipe_live.h"

#include "app/commands/cooling_watch.h"
#include "app/commands/engine_thread.h"
#include "engine/base/clock.h"
#include "engine/monitor/monitor.h"

#include <QCoreApplication>
#include <QTimer>

#include <algorithm>
#include <utility>

namespace bask {
namespace {

constexpr double kRoom_K = 295.0; // roughly; a recipe has several experiments

} // namespace

void runLive(RecipeRunner& runner, const RecipeWatch& watch, const LiveStart& start,
             const RunLabels& labels) {
    PlaceOrders placeOrders(start.place);
    const SignalCount signalCount;
    Monitor monitor; // the engine's last words, too, are told
    monitor.use(start.monitor);
    EngineThread engine;
    engine.worker.setWatch(monitor.inlet());
    QObject here; // of this thread, which takes the snapshots
    const auto post = [&](const std::vector<Command>& commands) {
        for (const Command& command : commands)
            engine.post(command);
    };
    SteadyClock clock;
    CoolingWatch cooling(kRoom_K);
    double reset_s = clock.now_s();
    QObject::connect(&engine.worker, &EngineWorker::published, &here, [&](const Snapshot& snapshot) {
        if (const auto order = placeOrders.next(snapshot))
            post({*order});
        post(runner.take(snapshot));
        // Whoever started it stands for the rig that was connected just now; for no fault after that.
        const bool isFirst = runner.step() == 0 && runner.phase() == RecipeRunner::Phase::Load;
        if (isFirst && snapshot.state == RunState::Fault && clock.now_s() - reset_s > kBetweenResets_s &&
            std::ranges::all_of(snapshot.reasons,
                                [](const Message& reason) { return isNotThereYet(reason.code); })) {
            reset_s = clock.now_s();
            engine.post(Reset{});
        }
        watch(runner, snapshot);
        if (runner.isOver() && cooling.isOver(snapshot))
            QCoreApplication::exit();
    });
    int seen = 0;
    QTimer look;
    QObject::connect(&look, &QTimer::timeout, &here, [&] {
        const int before = std::exchange(seen, signalCount.now());
        if (seen == before)
            return;
        const bool wasOver = runner.isOver();
        if (seen == 1) {
            post(runner.stopNow());
        } else {
            runner.takeOver(); // by what the engine told before, it would go on
            engine.post(EmergencyStop{});
        }
        if (runner.isOver() && (wasOver || seen > 1)) // a person looks after the source
            QCoreApplication::exit();
    });
    look.start(SignalCount::kLook_ms);
    engine.ask([&] { engine.worker.start(); });
    post(start.allowed);
    post({SetLabels{labels}});
    post(runner.begin({}));
    QCoreApplication::exec();
    look.stop();
}

} // namespace bask
