#pragma once
// The library of materials as a list: what each is, with buttons to rename, remove, import and export.

#include "engine/model/material_library.h"

#include <QDialog>

class QLabel;
class QListWidget;
class QPushButton;

namespace bask {

class MessageBar;

/// Changes nothing by itself: it tells what a person wants, and shows the library that it is given. Not
/// modal, so that STOP stays reachable. Object names: "materialsDialog", "materialList", "materialValues",
/// "renameMaterial", "removeMaterial", "importMaterials", "exportMaterials", "materialsMessage" (MessageBar).
class MaterialsDialog : public QDialog {
    Q_OBJECT

public:
    explicit MaterialsDialog(QWidget* parent);

    void setLibrary(const MaterialLibrary& library);
    void showProblem(const QString& sentence);
    void showNote(const QString& sentence);
    /// Offers to undo it.
    void showRemoved(const QString& name);

signals:
    void renameWanted(const QString& from, const QString& to);
    void removeWanted(const QString& name);
    void undoWanted(); ///< of the last removal
    void importWanted();
    void exportWanted();

private:
    QPushButton* button(const char* name, const QString& text);
    void showCurrent();

    MaterialLibrary m_library;
    QListWidget* m_list;
    QLabel* m_values;
    MessageBar* m_message;
    QPushButton *m_rename, *m_remove, *m_import, *m_export;
};

} // namespace bask
