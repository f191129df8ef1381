#include "widgets/targets/picture_dialog.h"

#include "widgets/common/dialog_frame.h"
#include "widgets/common/file_folders.h"
#include "widgets/common/number_field.h"

#include <QComboBox>
#include <QFormLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>

namespace bask {
namespace {

constexpr int kMaxFrame_px = 2000; // nine of them are in memory, and make one sheet

} // namespace

PictureDialog::PictureDialog(const QString& title, QSize size, int max, QWidget* parent)
    : QDialog(parent), m_sizes(new QComboBox(this)), m_width(new WholeNumberField(this)),
      m_height(new WholeNumberField(this)) {
    setWindowTitle(title);
    m_sizes->setObjectName("pictureSize");
    m_width->setObjectName("pictureWidth");
    m_height->setObjectName("pictureHeight");
    for (WholeNumberField* side : {m_width, m_height}) {
        side->setRange(kMin_px, max);
        side->setSingleStep(10);
        side->setSuffix(tr(" px"));
        connect(side, &QDoubleSpinBox::valueChanged, this, &PictureDialog::findSize);
    }
    const QSize min(kMin_px, kMin_px);
    const QSize view = size.boundedTo({max, max}).expandedTo(min);
    const auto add = [this, max](const QString& name, QSize offered) {
        if (std::max(offered.width(), offered.height()) <= max)
            m_sizes->addItem(name.arg(offered.width()).arg(offered.height()), offered);
    };
    add(tr("As the view: %1 × %2"), view);
    add(tr("Twice the view: %1 × %2"), 2 * view);
    add(tr("Screen: %1 × %2"), {1920, 1080});
    add(tr("A4 across at 300 dpi: %1 × %2"), {3508, 2480});
    add(tr("A4 upright at 300 dpi: %1 × %2"), {2480, 3508});
    m_sizes->addItem(tr("Another"), QSize());
    connect(m_sizes, &QComboBox::activated, this, &PictureDialog::choose);
    choose();

    auto* form = new QFormLayout;
    form->addRow(tr("&Size"), m_sizes);
    form->addRow(tr("&Width"), m_width);
    form->addRow(tr("&Height"), m_height);
    dialogColumn(*this)->addLayout(form);
    addDialogButtons(*this, tr("Choose the place\u2026"));
}

QSize PictureDialog::size_px() const {
    return {m_width->whole(), m_height->whole()};
}

std::optional<PictureDialog::Order> PictureDialog::askPicture(QSize size, QWidget* parent) {
    PictureDialog dialog(tr("Save the picture"), size, kMax_px, parent);
    if (dialog.exec() != QDialog::Accepted)
        return std::nullopt;
    const QString path = askFileToSave(parent, tr("Save the picture"), QStringLiteral("targets.png"),
                                       QStringLiteral("*.png"), FileFolder::Exports);
    return path.isEmpty() ? std::nullopt : std::optional(Order{path, dialog.size_px()});
}

std::optional<PictureDialog::Order> PictureDialog::askAnimation(QSize size, QWidget* parent) {
    PictureDialog dialog(tr("Save the animation"), size, kMaxFrame_px, parent);
    if (dialog.exec() != QDialog::Accepted)
        return std::nullopt;
    const QString path = askFolder(parent, tr("Folder for the pictures"), FileFolder::Exports);
    return path.isEmpty() ? std::nullopt : std::optional(Order{path, dialog.size_px()});
}

void PictureDialog::choose() {
    const QSize chosen = m_sizes->currentData().toSize();
    if (chosen.isEmpty())
        return m_width->setFocus();
    const QSignalBlocker quietWidth(m_width), quietHeight(m_height);
    m_width->setValue(chosen.width());
    m_height->setValue(chosen.height());
}

/// Shows in the list what is typed.
void PictureDialog::findSize() {
    const int known = m_sizes->findData(size_px());
    m_sizes->setCurrentIndex(known < 0 ? m_sizes->count() - 1 : known);
}

} // namespace bask
