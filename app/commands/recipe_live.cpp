#include "app/commands/recipe_live.h"

#include "app/commands/engine_thread.h"

#include <QCoreApplication>
#include <QTimer>

#include <utility>

namespace bask {
namespace {

constexpr int kLook_ms = 20;

} // namespace

void runLive(RecipeRunner& runner, const RecipeWatch& watch) {
    const SignalCount signalCount;
    EngineThread engine;
    QObject here; // of this thread, which takes the snapshots
    const auto post = [&](const std::vector<Command>& commands) {
        for (const Command& command : commands)
            engine.post(command);
    };
    QObject::connect(&engine.worker, &EngineWorker::published, &here, [&](const Snapshot& snapshot) {
        post(runner.take(snapshot));
        watch(runner, snapshot);
        if (runner.isOver())
            QCoreApplication::exit();
    });
    int seen = 0;
    QTimer look;
    QObject::connect(&look, &QTimer::timeout, &here, [&] {
        const int before = std::exchange(seen, signalCount.now());
        if (seen == before)
            return;
        if (seen == 1) {
            post(runner.stopNow());
        } else {
            runner.takeOver(); // by what the engine told before, it would go on
            engine.post(EmergencyStop{});
        }
        if (runner.isOver())
            QCoreApplication::exit();
    });
    look.start(kLook_ms);
    engine.ask([&] { engine.worker.start(); });
    post(runner.begin({}));
    QCoreApplication::exec();
    look.stop();
}

} // namespace bask
