#include "app/infeasible_dialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
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
    auto* buttons = new QDialogButtonBox(this);
    QPushButton* start = buttons->addButton(tr("Start"), QDialogButtonBox::AcceptRole);
    QPushButton* cancel = buttons->addButton(tr("Cancel"), QDialogButtonBox::RejectRole);
    start->setObjectName(QStringLiteral("startAnyway"));
    cancel->setObjectName(QStringLiteral("cancelStart"));
    start->setEnabled(false);
    start->setAutoDefault(false);
    cancel->setDefault(true);

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 16);
    column->setSpacing(12);
    column->addWidget(title);
    column->addWidget(text);
    column->addWidget(tick);
    column->addWidget(buttons);
    connect(tick, &QCheckBox::toggled, start, &QPushButton::setEnabled);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

} // namespace bask
