#include "widgets/plots/plot_window.h"

#include "widgets/common/elided_label.h"
#include "widgets/plots/trace_plot.h"

#include <QCloseEvent>
#include <QKeyEvent>
#include <QVBoxLayout>

namespace bask {

PlotWindow::PlotWindow(TracePlot& plot) : QWidget(nullptr, Qt::Window), m_title(new ElidedLabel(this)) {
    setObjectName(QStringLiteral("plotWindow.") + plot.objectName());
    setAttribute(Qt::WA_QuitOnClose, false);
    m_title->setObjectName(QStringLiteral("plotWindowTitle"));
    m_title->setTextFormat(Qt::PlainText);
    m_title->hide();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 6, 6, 6);
    layout->addWidget(m_title);
    layout->addWidget(&plot, 1);
    plot.show();
    setMinimumSize(320, 200);
    resize(900, 520);
}

void PlotWindow::setTitle(const QString& title) {
    setWindowTitle(title);
    m_title->setText(title);
}

void PlotWindow::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::WindowStateChange)
        m_title->setVisible(isFullScreen());
}

void PlotWindow::closeEvent(QCloseEvent* event) {
    event->accept();
    emit closed();
}

/// What the plot does not want: its Esc ends a cursor first.
void PlotWindow::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_F11)
        setWindowState(windowState() ^ Qt::WindowFullScreen);
    else if (event->key() == Qt::Key_Escape && isFullScreen())
        setWindowState(windowState() & ~Qt::WindowFullScreen);
    else if (event->key() == Qt::Key_Escape && !event->isAutoRepeat()) // one that is held has done its work
        close();
    else
        QWidget::keyPressEvent(event);
}

} // namespace bask
