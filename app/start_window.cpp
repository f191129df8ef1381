#include "app/start_window.h"

#include "app/end_signals.h"
#include "app/main_window.h"
#include "app/settings_store.h"
#include "engine/base/version.h"
#include "widgets/common/theme.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QLocale>

#include <clocale>
#include <cstdio>
#include <cstdlib>

namespace bask {
namespace {

/// Says how long the start took, once the first readings were painted.
void reportStart(MainWindow& window, const QElapsedTimer& sinceStart) {
    auto* connection = new QMetaObject::Connection;
    *connection =
        QObject::connect(&window, &MainWindow::snapshotApplied, [&, connection](const Snapshot& snapshot) {
            if (snapshot.latest.objects.empty())
                return;
            QObject::disconnect(*connection);
            delete connection;
            window.repaint();
            std::fprintf(stderr, "first picture: %lld ms\n", static_cast<long long>(sinceStart.elapsed()));
        });
}

/// While the QApplication is made: Qt aborts when no display answers; a sentence and exit code 1 are kinder.
void refuseDisplay(QtMsgType type, const QMessageLogContext&, const QString& text) {
    if (type != QtFatalMsg) {
        if (type == QtCriticalMsg)
            std::fprintf(stderr, "%s\n", qPrintable(text));
        return;
    }
    std::fprintf(stderr,
                 "bask: the window cannot open: no display answers (DISPLAY=%s, WAYLAND_DISPLAY=%s, "
                 "QT_QPA_PLATFORM=%s). Work without a window: bask --help\n",
                 qPrintable(qEnvironmentVariable("DISPLAY")),
                 qPrintable(qEnvironmentVariable("WAYLAND_DISPLAY")),
                 qPrintable(qEnvironmentVariable("QT_QPA_PLATFORM")));
    std::_Exit(1);
}

/// Before the QApplication is made: Qt draws everything larger by the factor, which the user's own
/// environment may have set for all programs.
void setTextSize(int percent) {
    if (percent == 100)
        return;
    bool isNumber = false;
    const double factor = qEnvironmentVariable("QT_SCALE_FACTOR").toDouble(&isNumber);
    qputenv("QT_SCALE_FACTOR", QByteArray::number((isNumber ? factor : 1.0) * percent / 100.0));
}

} // namespace

int runWindow(int& argc, char** argv, const QString& file) {
    QElapsedTimer sinceStart;
    sinceStart.start();
    QCoreApplication::setApplicationName(QStringLiteral("bask"));
    QCoreApplication::setApplicationVersion(QStringLiteral(BASK_VERSION));
    QGuiApplication::setDesktopFileName(QStringLiteral("bask"));
    setTextSize(SettingsStore().textSize_percent());
    const QtMessageHandler usual = qInstallMessageHandler(refuseDisplay);
    // A desktop's own dialogs would take no twin of the STOP button.
    QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    QApplication application(argc, argv);
    qInstallMessageHandler(usual);
    QGuiApplication::setApplicationDisplayName(QString());
    // Qt takes the user's locale: files keep the decimal point, and the window's language says what is shown.
    std::setlocale(LC_NUMERIC, "C");
    QLocale::setDefault(QLocale::c());
    applyTheme(application, SettingsStore().theme());

    EndSignals endSignals;
    MainWindow window;
    endSignals.setFirst(window.engine().ender());
    if (qEnvironmentVariableIntValue("BASK_TIMING") == 1)
        reportStart(window, sinceStart);
    window.show();
    window.begin(file);
    return QApplication::exec();
}

} // namespace bask
