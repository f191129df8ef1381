// The window as a process of its own that runs the experiment which it is given, as a person would: take its
// limits, confirm the robot's place, reset, arm, start. It goes on until it is ended.

#include "app/main_window.h"
#include "widgets/common/theme.h"

#include <QAbstractButton>
#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QLocale>
#include <QMessageBox>
#include <QTimer>

namespace {

constexpr int kBetween_ms = 1000; ///< two verbs: readings are fresh again, devices have answered

} // namespace

int main(int argc, char** argv) {
    QCoreApplication::setApplicationName(QStringLiteral("bask"));
    QApplication application(argc, argv);
    QLocale::setDefault(QLocale::c());
    bask::SettingsStore().setCoachAnswered();
    bask::applyTheme(application, bask::Theme::Light);
    bask::MainWindow window;
    QElapsedTimer said;
    said.start();
    QObject::connect(&window, &bask::MainWindow::snapshotApplied, &window,
                     [&](const bask::Snapshot& snapshot) {
                         if (snapshot.simulated || said.elapsed() < kBetween_ms)
                             return;
                         const auto say = [&](const bask::Command& command) {
                             said.restart();
                             window.engine().send(command);
                         };
                         if (!snapshot.isPlaceSure)
                             say(bask::ClearRobotAlarm{});
                         else if (snapshot.state == bask::RunState::Fault && snapshot.runId == 0)
                             say(bask::Reset{});
                         else if (snapshot.state == bask::RunState::Ready)
                             say(bask::Arm{{}});
                         else if (snapshot.state == bask::RunState::Armed)
                             say(bask::Start{true});
                     });
    QTimer answering; // the file allows the rig more than Bask does by itself
    QObject::connect(&answering, &QTimer::timeout, &window, [&] {
        for (auto* box : window.findChildren<QMessageBox*>(QStringLiteral("limitsOfFile")))
            for (QAbstractButton* button : box->buttons())
                if (box->isVisible() && box->buttonRole(button) == QMessageBox::AcceptRole)
                    button->click();
    });
    answering.start(kBetween_ms);
    window.show();
    window.begin(QString::fromLocal8Bit(argv[1]));
    return QApplication::exec();
}
