#pragma once
// The window's side of the library of materials: its file, what is added to it, and its dialogs.

#include "engine/model/material_library.h"

#include <QObject>
#include <QString>

#include <functional>
#include <optional>

class QWidget;

namespace bask {

class MaterialsDialog;
class ObjectsPage;
class SessionActions;

/// The file is read again before each change, so that nothing is lost of what another Bask wrote; one that
/// cannot be read is left as it is.
class MaterialControl : public QObject {
    Q_OBJECT

public:
    MaterialControl(const QString& file, SessionActions& files, ObjectsPage& page, QWidget* window);

    /// Reads the library and shows it on the page.
    void begin();

signals:
    void problem(const QString& sentence);
    void exported(const QString& sentence, const QStringList& files);

private:
    /// Empty: it cannot be read, which was told.
    std::optional<MaterialLibrary> library();
    void show(const MaterialLibrary& library);
    /// Returns whether the library was written.
    bool change(const std::function<void(MaterialLibrary&)>& edit);
    /// In the dialog if it is open.
    void tell(const QString& sentence);
    MaterialsDialog* dialog() const;
    void askSave(const Material& material);
    void showMaterials();
    void rename(const QString& from, const QString& to);
    void remove(const QString& name);
    void putBack();
    void importFile();
    void exportFile();

    QString m_file;
    SessionActions& m_files;
    ObjectsPage& m_page;
    QWidget* m_window;
    std::optional<Material> m_removed; ///< the last one
    std::size_t m_removedFrom = 0;     ///< its place
};

} // namespace bask
