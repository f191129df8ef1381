#include "app/infeasible_dialog.h"

#include "widgets/common/dialog_frame.h"

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace bask {

InfeasibleDialog::InfeasibleDialog(const QString& reason, QWidget* parent) : QDialog(parent) {
    setObjectName(QStringLiteral("infeasibleDialog"));
    setWindowTitle(tr("Targets out of reach"));
    setWindowModality(Qt::WindowModal);
    setAttribute(Qt::WA_DeleteOnClose);

    auto* title = new QLabel(windowTitle(), this);
    QFont bold = font();
    bold.setBold(true);
    title->setFont(bold);
    auto* text =
        new QLabel((reason.isEmpty() ? QString() : reason + QStringLiteral(".\n")) +
                       tr("The run would end at the best compromise it finds.\n"
                          "The Targets page says more and offers the nearest targets that can be held."),
                   this);
    text->setWordWrap(true);
    text->setMinimumWidth(420);
    auto* tick = new QCheckBox(tr("Start all the same; the recording says so"), this);
    tick->setObjectName(QStringLiteral("acceptInfeasible"));

    QVBoxLayout* column = dialogColumn(*this);
    column->addWidget(title);
    column->addWidget(text);
    column->addWidget(tick);
    const DialogButtons buttons = addDialogButtons(*this, tr("Start"));
    buttons.take->setObjectName(QStringLiteral("startAnyway"));
    buttons.cancel->setObjectName(QStringLiteral("cancelStart"));
    buttons.take->setEnabled(false);
    buttons.take->setAutoDefault(false);
    buttons.cancel->setDefault(true);
    connect(tick, &QCheckBox::toggled, buttons.take, &QPushButton::setEnabled);
}

} // namespace bask
