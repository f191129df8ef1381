#include "app/material_control.h"

#include "app/error_text.h"
#include "app/materials_dialog.h"
#include "app/save_material_dialog.h"
#include "app/session_actions.h"
#include "engine/base/message_code.h"
#include "engine/experiment/material_file.h"
#include "widgets/common/display.h"
#include "widgets/objects/objects_page.h"

#include <QDate>
#include <QDir>
#include <QFileInfo>

#include <algorithm>

namespace bask {

MaterialControl::MaterialControl(const QString& file, SessionActions& files, ObjectsPage& page,
                                 QWidget* window)
    : QObject(window), m_file(file), m_files(files), m_page(page), m_window(window) {
    connect(&page, &ObjectsPage::saveMaterialWanted, this, &MaterialControl::askSave);
    connect(&page, &ObjectsPage::materialsWanted, this, &MaterialControl::showMaterials);
}

void MaterialControl::begin() {
    if (const auto read = library())
        show(*read);
}

std::optional<MaterialLibrary> MaterialControl::library() {
    const auto read = readMaterialLibrary(m_file.toStdString());
    if (read)
        return *read;
    if (read.error().code() == MessageCode::FileNotFound)
        return MaterialLibrary();
    tell(tr("Your library of materials cannot be used and is left as it is: %1. Mend the file or move it "
            "elsewhere.")
             .arg(sentence(read.error())));
    return std::nullopt;
}

void MaterialControl::show(const MaterialLibrary& library) {
    m_page.setMaterialLibrary(library);
    if (MaterialsDialog* open = dialog())
        open->setLibrary(library);
}

bool MaterialControl::change(const std::function<void(MaterialLibrary&)>& edit) {
    auto changed = library();
    if (!changed)
        return false;
    const MaterialLibrary before = *changed;
    edit(*changed);
    const auto written = writeMaterialLibrary(*changed, m_file.toStdString());
    show(written ? *changed : before);
    if (!written)
        tell(asSentence(sentence(written.error())));
    return written.ok();
}

void MaterialControl::tell(const QString& sentence) {
    if (MaterialsDialog* open = dialog())
        open->showProblem(sentence);
    else
        emit problem(sentence);
}

MaterialsDialog* MaterialControl::dialog() const {
    return m_window->findChild<MaterialsDialog*>();
}

void MaterialControl::askSave(const Material& material) {
    const auto known = library();
    if (!known)
        return;
    delete m_window->findChild<SaveMaterialDialog*>();
    auto* ask = new SaveMaterialDialog(material, *known, QDate::currentDate(), m_window);
    connect(ask, &QDialog::accepted, this, [this, ask] {
        const Material saved = ask->material();
        if (change([&saved](MaterialLibrary& library) { putMaterial(library, saved); }))
            m_page.nameMaterial(saved);
    });
    ask->show();
}

void MaterialControl::showMaterials() {
    const auto known = library();
    if (!known)
        return;
    delete dialog();
    auto* made = new MaterialsDialog(m_window);
    connect(made, &MaterialsDialog::renameWanted, this, &MaterialControl::rename);
    connect(made, &MaterialsDialog::removeWanted, this, &MaterialControl::remove);
    connect(made, &MaterialsDialog::undoWanted, this, &MaterialControl::putBack);
    connect(made, &MaterialsDialog::importWanted, this, &MaterialControl::importFile);
    connect(made, &MaterialsDialog::exportWanted, this, &MaterialControl::exportFile);
    m_removed.reset();
    show(*known);
    made->show();
}

void MaterialControl::rename(const QString& from, const QString& to) {
    change([&](MaterialLibrary& library) {
        for (Material& material : library)
            if (material.name == from.toStdString()) {
                material.name = to.toStdString();
                return;
            }
    });
}

void MaterialControl::remove(const QString& name) {
    m_removed.reset();
    const bool isWritten = change([&](MaterialLibrary& library) {
        const auto found =
            std::ranges::find_if(library, [&](const Material& m) { return m.name == name.toStdString(); });
        if (found == library.end())
            return;
        m_removed = *found;
        m_removedFrom = static_cast<std::size_t>(found - library.begin());
        library.erase(found);
    });
    if (isWritten && m_removed)
        dialog()->showRemoved(name);
}

void MaterialControl::putBack() {
    if (!m_removed)
        return;
    const bool isWritten = change([this](MaterialLibrary& library) {
        const auto place = static_cast<std::ptrdiff_t>(std::min(m_removedFrom, library.size()));
        library.insert(library.begin() + place, *m_removed);
    });
    if (isWritten)
        m_removed.reset();
}

void MaterialControl::importFile() {
    const QString path = m_files.ask({FileQuestion::Kind::OpenFile,
                                      tr("Import materials"),
                                      m_files.lastFolder(FileFolder::Experiments),
                                      tr("Materials (*.json);;All files (*)"),
                                      {}});
    if (path.isEmpty())
        return;
    const auto other = readMaterialLibrary(path.toStdString());
    if (!other)
        return tell(asSentence(sentence(other.error())));
    MergedMaterials both;
    const bool isWritten = change([&](MaterialLibrary& library) {
        both = merged(library, *other);
        library = both.library;
    });
    if (isWritten && dialog() != nullptr)
        dialog()->showNote(tr("%1: %2 added, %3 of them under another name, since theirs was taken; %4 were "
                              "there already.")
                               .arg(QFileInfo(path).fileName())
                               .arg(both.added)
                               .arg(both.renamed)
                               .arg(both.known));
}

void MaterialControl::exportFile() {
    const auto known = library();
    if (!known)
        return;
    const QString proposed =
        QDir(m_files.lastFolder(FileFolder::Exports)).filePath(QStringLiteral("materials.json"));
    const QString path =
        m_files.ask({FileQuestion::Kind::SaveFile, tr("Export the library of materials"), proposed,
                     tr("Materials (*.json)"), QStringLiteral("json"), FileFolder::Exports});
    if (path.isEmpty())
        return;
    if (const auto written = writeMaterialLibrary(*known, path.toStdString()); !written)
        return tell(asSentence(sentence(written.error())));
    const QString sentence = tr("%1 was written.").arg(QFileInfo(path).fileName());
    if (dialog() != nullptr)
        dialog()->showNote(sentence);
    emit exported(sentence, {path});
}

} // namespace bask
