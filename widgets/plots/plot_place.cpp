#include "widgets/plots/plot_place.h"

#include "widgets/common/display.h"
#include "widgets/plots/plot_window.h"
#include "widgets/plots/quantity_words.h"
#include "widgets/plots/trace_plot.h"

#include <QAction>
#include <QActionGroup>
#include <QEvent>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QVBoxLayout>

namespace bask {
namespace {

constexpr Qt::Key kMeasureKey = Qt::Key_M;

} // namespace

PlotPlace::PlotPlace(TracePlot* plot, QWidget* parent)
    : QWidget(parent), m_plot(plot), m_layout(new QVBoxLayout(this)), m_note(new QWidget(this)),
      m_noteText(new QLabel(m_note)), m_putBack(new QPushButton(m_note)), m_ownWindow(new QAction(this)) {
    m_putBack->setObjectName(QStringLiteral("plotPutBack"));
    m_noteText->setAlignment(Qt::AlignCenter);
    m_noteText->setWordWrap(true);
    auto* note = new QVBoxLayout(m_note);
    note->addStretch(1);
    note->addWidget(m_noteText);
    note->addWidget(m_putBack, 0, Qt::AlignHCenter);
    note->addStretch(1);
    m_note->hide();
    m_layout->setContentsMargins(0, 0, 0, 0);
    m_layout->addWidget(m_note);
    m_layout->addWidget(m_plot);

    m_ownWindow->setObjectName(QStringLiteral("plotOwnWindow"));
    m_ownWindow->setShortcut(Qt::Key_W);
    m_ownWindow->setShortcutContext(Qt::WidgetShortcut); // in a field W is a letter
    m_ownWindow->setAutoRepeat(false);                   // a key that is held would take it out and back
    m_plot->addAction(m_ownWindow);
    auto* measure = new QAction(this);
    measure->setShortcut(kMeasureKey);
    measure->setShortcutContext(Qt::WidgetShortcut);
    m_plot->addAction(measure);
    connect(measure, &QAction::triggered, m_plot, [this] { m_plot->measureFrom(); });
    m_plot->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(m_ownWindow, &QAction::triggered, this, [this] { isOut() ? putBack() : takeOut(); });
    connect(m_plot, &QWidget::customContextMenuRequested, this, &PlotPlace::openMenu);
    connect(m_putBack, &QPushButton::clicked, this, &PlotPlace::putBack);
    retranslate();
}

PlotPlace::~PlotPlace() = default;

void PlotPlace::takeOut() {
    if (isOut())
        return;
    m_plotWindow = std::make_unique<PlotWindow>(*m_plot);
    m_plotWindow->setWindowIcon(window()->windowIcon());
    connect(m_plotWindow.get(), &PlotWindow::closed, this, &PlotPlace::takeBack);
    m_note->show();
    retranslate();
    emit takenOut(m_plotWindow.get());
    m_plotWindow->show();
    m_plotWindow->activateWindow();
    m_plot->setFocus();
}

void PlotPlace::putBack() {
    if (isOut())
        m_plotWindow->close();
}

void PlotPlace::takeBack() {
    if (!isOut())
        return;
    const bool hadFocus = m_putBack->hasFocus() || m_plotWindow->isActiveWindow();
    m_layout->addWidget(m_plot);
    m_plot->show();
    m_note->hide();
    setTabOrder(m_putBack, m_plot); // it came to the end of the page's
    if (hadFocus) {
        window()->activateWindow();
        m_plot->setFocus();
    }
    m_plotWindow.release()->deleteLater(); // it is closing
    retranslate();
}

void PlotPlace::setRun(const QString& words) {
    m_run = words;
    showTitle();
}

void PlotPlace::setState(const QString& words) {
    if (m_state == words)
        return;
    m_state = words;
    showTitle();
}

QString PlotPlace::words() const {
    QStringList words{m_state, m_run};
    words.removeAll(QString());
    return words.join(listSeparator());
}

/// The state first: a narrow title loses its end.
void PlotPlace::showTitle() {
    if (!isOut())
        return;
    QString quantities = quantityTitle(m_plot->quantity());
    if (const auto right = m_plot->rightQuantity())
        quantities += QStringLiteral(", ") + quantityTitle(*right);
    QStringList words{m_state, quantities, m_run};
    words.removeAll(QString());
    m_plotWindow->setTitle(words.join(QStringLiteral(" \u2014 ")));
}

void PlotPlace::openMenu(const QPoint& at) {
    auto* menu = new QMenu(m_plot);
    menu->setObjectName(QStringLiteral("plotMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(m_ownWindow);
    QAction* measure =
        menu->addAction(tr("Measure from here"), m_plot, [this, at] { m_plot->measureFrom(at); });
    measure->setObjectName(QStringLiteral("plotMeasure"));
    measure->setText(measure->text() + u'\t' + QKeySequence(kMeasureKey).toString(QKeySequence::NativeText));
    measure->setEnabled(!m_plot->isEmpty());
    QAction* away = menu->addAction(tr("Take the cursor away"), m_plot, &TracePlot::takeCursorAway);
    away->setObjectName(QStringLiteral("plotCursorAway"));
    away->setEnabled(m_plot->cursor_s().has_value());
    addRightMenu(*menu);
    QMenu* exports = menu->addMenu(tr("Export what is shown"));
    exports->setObjectName(QStringLiteral("plotExportMenu"));
    exports->setEnabled(!m_plot->isEmpty());
    addExports(*exports);
    menu->popup(m_plot->mapToGlobal(at));
}

void PlotPlace::addRightMenu(QMenu& menu) {
    QMenu* choices = menu.addMenu(tr("On the right axis"));
    choices->setObjectName(QStringLiteral("plotRightMenu"));
    auto* group = new QActionGroup(choices);
    const auto add = [&](const QString& text, const QString& name, std::optional<Quantity> quantity) {
        QAction* action = choices->addAction(text, this, [this, quantity] {
            m_plot->setRightQuantity(quantity);
            showTitle();
        });
        action->setObjectName(QStringLiteral("plotRight.") + name);
        action->setCheckable(true);
        action->setChecked(m_plot->rightQuantity() == quantity);
        group->addAction(action);
    };
    add(tr("None"), QStringLiteral("none"), std::nullopt);
    std::vector<Quantity> quantities = furtherQuantities();
    quantities.insert(quantities.begin(), Quantity::Temperature);
    for (const Quantity quantity : quantities)
        if (quantity != m_plot->quantity())
            add(quantityTitle(quantity), quantityKey(quantity), quantity);
}

void PlotPlace::addExports(QMenu& menu) {
    const auto add = [&](const QString& text, const char* name, PlotForm form) {
        menu.addAction(text, this, [this, form] { emit exportRequested(form); })
            ->setObjectName(QStringLiteral("plotExport.") + QLatin1String(name));
    };
    add(tr("Figure (PDF)\u2026"), "pdf", PlotForm::Pdf);
    add(tr("Figure (SVG)\u2026"), "svg", PlotForm::Svg);
    add(tr("Figure (PNG)\u2026"), "png", PlotForm::Png);
    add(tr("Table (CSV)\u2026"), "csv", PlotForm::Csv);
}

void PlotPlace::retranslate() {
    m_ownWindow->setText(isOut() ? tr("Put back into the page") : tr("Own window"));
    m_noteText->setText(tr("This plot is in a window of its own."));
    m_putBack->setText(tr("Put back"));
    m_putBack->setAccessibleName(tr("Put the plot back: %1").arg(quantityTitle(m_plot->quantity())));
    showTitle();
}

void PlotPlace::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

} // namespace bask
