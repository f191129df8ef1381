#include "app/materials_dialog.h"

#include "engine/model/experiment_parameters.h"
#include "widgets/common/message_bar.h"
#include "widgets/common/parameter_form.h"
#include "widgets/objects/material_presets.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>

namespace bask {
namespace {

constexpr int kListWidth = 420;
constexpr int kValueLines = 9;

/// One line a value, then where they are from.
QString materialWords(const Material& material) {
    QStringList lines;
    for (const Parameter<Material>& value : materialParameters())
        lines << parameterLabel(value) + u' ' + parameterText(value, value.get(material).value(), 6);
    for (const QString& line : {QString::fromStdString(originText(material)), uncertaintyText(material)})
        if (!line.isEmpty())
            lines << line;
    return lines.join(u'\n');
}

} // namespace

MaterialsDialog::MaterialsDialog(QWidget* parent)
    : QDialog(parent), m_list(new QListWidget(this)), m_values(new QLabel(this)),
      m_message(new MessageBar(this)), m_rename(button("renameMaterial", tr("Rename"))),
      m_remove(button("removeMaterial", tr("Remove"))),
      m_import(button("importMaterials", tr("Import\u2026"))),
      m_export(button("exportMaterials", tr("Export\u2026"))) {
    setObjectName(QStringLiteral("materialsDialog"));
    setWindowTitle(tr("Materials"));
    setAttribute(Qt::WA_DeleteOnClose);
    m_list->setObjectName(QStringLiteral("materialList"));
    m_list->setAccessibleName(tr("Materials"));
    m_list->setMinimumWidth(kListWidth);
    m_values->setObjectName(QStringLiteral("materialValues"));
    m_values->setWordWrap(true);
    m_values->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_values->setMinimumHeight(kValueLines * fontMetrics().lineSpacing());
    m_values->setTextFormat(Qt::PlainText);
    m_values->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_message->setObjectName(QStringLiteral("materialsMessage"));

    auto* close = button("closeMaterials", tr("Close"));
    auto* buttons = new QHBoxLayout;
    for (QPushButton* each : {m_rename, m_remove, m_import, m_export})
        buttons->addWidget(each);
    buttons->addStretch(1);
    buttons->addWidget(close);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 16);
    column->setSpacing(12);
    column->addWidget(m_list, 1);
    column->addWidget(m_message); // the rows stay where they are
    column->addWidget(m_values);
    column->addLayout(buttons);

    connect(close, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_list, &QListWidget::currentRowChanged, this, &MaterialsDialog::showCurrent);
    connect(m_rename, &QPushButton::clicked, this, [this] { m_list->editItem(m_list->currentItem()); });
    connect(m_remove, &QPushButton::clicked, this,
            [this] { emit removeWanted(m_list->currentItem()->data(Qt::UserRole).toString()); });
    connect(m_import, &QPushButton::clicked, this, &MaterialsDialog::importWanted);
    connect(m_export, &QPushButton::clicked, this, &MaterialsDialog::exportWanted);
    connect(m_message, &MessageBar::actionClicked, this, [this] {
        m_message->clear();
        emit undoWanted();
    });
    connect(m_list, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
        const QString from = item->data(Qt::UserRole).toString(), to = item->text().trimmed();
        m_message->clear();
        const QSignalBlocker quiet(m_list);
        item->setText(from); // until it is done
        // The answer fills the list again, which the editor that is being closed would not survive.
        QTimer::singleShot(0, this, [this, from, to] { emit renameWanted(from, to); });
    });
}

QPushButton* MaterialsDialog::button(const char* name, const QString& text) {
    auto* made = new QPushButton(text, this);
    made->setObjectName(QLatin1String(name));
    made->setAutoDefault(false); // Enter ends a name that is typed
    return made;
}

void MaterialsDialog::setLibrary(const MaterialLibrary& library) {
    m_library = library;
    const int row = m_list->currentRow();
    const QSignalBlocker quiet(m_list);
    m_list->clear();
    for (const Material& material : library) {
        const QString name = QString::fromStdString(material.name);
        auto* item = new QListWidgetItem(name, m_list);
        item->setData(Qt::UserRole, name);
        item->setFlags(item->flags() | Qt::ItemIsEditable);
    }
    m_list->setCurrentRow(std::clamp(row, library.empty() ? -1 : 0, m_list->count() - 1));
    showCurrent();
}

void MaterialsDialog::showCurrent() {
    const auto row = static_cast<std::size_t>(std::max(m_list->currentRow(), 0));
    const bool isOne = row < m_library.size();
    m_values->setText(isOne
                          ? materialWords(m_library[row])
                          : tr("The library is empty. \u201cSave as material\u201d on the Objects page adds "
                               "an object's material, Import those of a file."));
    m_rename->setEnabled(isOne);
    m_remove->setEnabled(isOne);
    m_export->setEnabled(isOne);
}

void MaterialsDialog::showProblem(const QString& sentence) {
    m_message->say(MessageBar::Kind::Problem, sentence);
}

void MaterialsDialog::showNote(const QString& sentence) {
    m_message->say(MessageBar::Kind::Note, sentence);
}

void MaterialsDialog::showRemoved(const QString& name) {
    m_message->say(MessageBar::Kind::Note, tr("\u201c%1\u201d was removed.").arg(name), tr("Undo"));
}

} // namespace bask
