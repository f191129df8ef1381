#include "widgets/common/dialog_frame.h"

#include "widgets/common/number_field.h"

#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace bask {
namespace {

struct DialogFrameWords {
    Q_DECLARE_TR_FUNCTIONS(bask::DialogFrame)
};

} // namespace

QVBoxLayout* dialogColumn(QDialog& dialog) {
    auto* column = new QVBoxLayout(&dialog);
    column->setContentsMargins(16, 16, 16, 16);
    column->setSpacing(12);
    return column;
}

bool takeRefusalBy(const QWidget* button, const QDialog& dialog) {
    return std::ranges::any_of(dialog.findChildren<NumberField*>(),
                               [button](NumberField* each) { return each->takeRefusalBy(button); });
}

DialogButtons addDialogButtons(QDialog& dialog, const QString& take) {
    auto* box = new QDialogButtonBox(&dialog);
    const DialogButtons buttons{box, box->addButton(take, QDialogButtonBox::AcceptRole),
                                box->addButton(DialogFrameWords::tr("Cancel"), QDialogButtonBox::RejectRole)};
    buttons.take->setDefault(true);
    QObject::connect(box, &QDialogButtonBox::accepted, &dialog, [&dialog, take = buttons.take] {
        if (!takeRefusalBy(take, dialog))
            dialog.accept();
    });
    QObject::connect(box, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    dialog.layout()->addWidget(box);
    return buttons;
}

} // namespace bask
