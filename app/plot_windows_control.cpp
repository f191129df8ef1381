#include "app/plot_windows_control.h"

#include "widgets/common/device_words.h"
#include "widgets/common/display.h"
#include "widgets/common/run_state_chip.h"
#include "widgets/plots/plot_place.h"
#include "widgets/plots/plot_window.h"
#include "widgets/plots/trace_plot.h"

#include <QEvent>

#include <utility>

namespace bask {

PlotWindowsControl::PlotWindowsControl(QWidget* window)
    : QObject(window), m_window(window), m_places(window->findChildren<PlotPlace*>()) {
    window->installEventFilter(this);
    for (const PlotPlace* place : std::as_const(m_places))
        connect(place, &PlotPlace::takenOut, this, [this, place](PlotWindow* plotWindow) {
            plotWindow->restoreGeometry(m_settings.plotWindowGeometry(place->plot()->objectName()));
            plotWindow->setWindowState(plotWindow->windowState() & ~Qt::WindowFullScreen);
            plotWindow->installEventFilter(this);
        });
}

void PlotWindowsControl::apply(const Snapshot& snapshot) {
    m_isTold = true;
    m_isSimulated = snapshot.simulated;
    m_state = snapshot.state;
    tell();
}

void PlotWindowsControl::setAnswering(bool answering) {
    m_isAnswering = answering;
    tell();
}

void PlotWindowsControl::tell() {
    if (!m_isTold)
        return;
    const QString words =
        tr("Rig %1: %2", "SIMULATED or LIVE, and the state of the run")
            .arg(rigWord(m_isSimulated), m_isAnswering ? runStateWord(m_state) : RunStateChip::unknownWord());
    for (PlotPlace* place : std::as_const(m_places))
        place->setState(words);
}

bool PlotWindowsControl::eventFilter(QObject* watched, QEvent* event) {
    if (watched != m_window) {
        if (event->type() == QEvent::Close)
            for (const PlotPlace* place : std::as_const(m_places))
                if (place->isOut() && place->plot()->window() == watched)
                    m_settings.setPlotWindowGeometry(place->plot()->objectName(),
                                                     place->plot()->window()->saveGeometry());
    } else if (event->type() == QEvent::Hide && !event->spontaneous()) {
        for (PlotPlace* place : std::as_const(m_places))
            place->putBack();
    } else if (event->type() == QEvent::LanguageChange) {
        tell();
    }
    return QObject::eventFilter(watched, event);
}

} // namespace bask
