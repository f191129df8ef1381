#include "app/large_numbers_control.h"

#include "widgets/run/large_numbers.h"
#include "widgets/run/run_page.h"

#include <QEvent>

namespace bask {

LargeNumbersControl::LargeNumbersControl(RunPage& run, QWidget* window)
    : QObject(window), m_run(run), m_window(window) {
    window->installEventFilter(this);
    connect(&run, &RunPage::applied, this, [this](const Snapshot& snapshot) {
        if (m_view)
            m_view->apply(snapshot, m_run.shownObjects(), m_run.temperatureUnit());
    });
}

LargeNumbersControl::~LargeNumbersControl() = default;

/// Without a parent: a child would stay above the main window, and be minimised with it.
void LargeNumbersControl::make() {
    m_view = std::make_unique<LargeNumbers>();
    m_view->setAttribute(Qt::WA_QuitOnClose, false);
    m_view->setWindowIcon(m_window->windowIcon());
    m_view->setAnswering(m_isAnswering);
    m_view->restoreGeometry(m_settings.largeNumbersGeometry());
    m_view->installEventFilter(this);
    connect(m_view.get(), &LargeNumbers::stopRequested, this, &LargeNumbersControl::stopRequested);
}

void LargeNumbersControl::setOpen(bool isOpen) {
    const bool isUnseen = m_view && m_view->isVisible() && m_view->isMinimized();
    if (!isOpen && !isUnseen) {
        if (m_view)
            m_view->close();
        return;
    }
    if (!m_view)
        make();
    m_view->setWindowState(m_view->windowState() & ~Qt::WindowMinimized);
    m_view->show();
    m_view->raise();
    m_view->activateWindow();
    emit openChanged(true);
}

void LargeNumbersControl::setAnswering(bool answering) {
    m_isAnswering = answering;
    if (m_view)
        m_view->setAnswering(answering);
}

bool LargeNumbersControl::eventFilter(QObject* watched, QEvent* event) {
    if (m_view && watched == m_view.get() && event->type() == QEvent::Close)
        m_settings.setLargeNumbersGeometry(m_view->saveGeometry());
    else if (m_view && watched == m_view.get() && event->type() == QEvent::Hide && !event->spontaneous())
        emit openChanged(false);
    else if (m_view && watched == m_window && event->type() == QEvent::Hide && !event->spontaneous())
        m_view->close();
    return QObject::eventFilter(watched, event);
}

} // namespace bask
