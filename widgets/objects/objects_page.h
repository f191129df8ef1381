#pragma once
// The Objects page: list, import, outline over outline, harmonics, material, mounting; with undo.

#include "engine/base/units.h"
#include "engine/session/experiment.h"
#include "engine/shape/contour_import.h"

#include <QWidget>

#include <functional>

class QLabel;
class QPushButton;
class QUndoStack;

namespace bask {

class HarmonicsPanel;
class ImportBar;
class MessageBar;
class MountingPlan;
class ObjectList;
class ObjectProperties;
class OutlinePreview;

/// Setters in, signals out. Every committed edit is one experimentEdited with the whole value; the receiver
/// answers a refused one with setExperiment(the value before) and showError, which also takes the edit off
/// the undo stack. Reading a file is the receiver's work, off the GUI thread: importRequested is answered by
/// showImported or showImportError.
///
/// Object names for tests: "objectList", "objectCount", "addDisk", "importOutline", "duplicateObject",
/// "removeObject", "undo", "redo", "outlinePreview", "mountingPlan", "mountingRemarks", "pageMessage"
/// (MessageBar), "editNote" (MessageBar), "importBar", and those of HarmonicsPanel, ObjectProperties,
/// ImportBar and MessageBar.
class ObjectsPage : public QWidget {
    Q_OBJECT

public:
    explicit ObjectsPage(QWidget* parent = nullptr);
    ~ObjectsPage() override;

    void setExperiment(const Experiment& experiment);
    const Experiment& experiment() const { return m_experiment; }
    /// False while a run is on; `why` is shown above the page.
    void setEditable(bool editable, const QString& why);
    void setTemperatureUnit(TemperatureUnit unit);
    QUndoStack* undoStack() const { return m_undo; }

    int selectedObject() const { return m_selected; }
    void selectObject(int index);

public slots:
    /// The outline of a file asked for with importRequested: adds an object with 5 harmonics, named after the
    /// file.
    void showImported(const QString& path, const bask::Contour& outline);
    void showImportError(const QString& sentence);
    /// An edit was refused: the sentence, until the next edit.
    void showError(const QString& sentence);
    /// Asks for the unit or scale of a list or picture, as after a drop; a drawing is read at once; other
    /// kinds of file are refused here.
    void offerFile(const QString& path);
    /// File dialog, then offerFile.
    void chooseFile();

signals:
    void experimentEdited(const bask::Experiment& experiment);
    void importRequested(const QString& path, const bask::ContourImportOptions& options);

protected:
    void changeEvent(QEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    class Edit;

    QWidget* buildLeft();
    QWidget* buildCentre();
    QWidget* buildRight();
    void connectAll();
    /// One edit: pushed on the undo stack, shown and emitted. `mergeKey`: edits of the same key in a row
    /// become one.
    void commit(std::vector<ObjectSpec> objects, const QString& text, const QString& mergeKey = {},
                int select = -1);
    void applyObjects(const std::vector<ObjectSpec>& objects, int select);
    void tellApplied();
    void editSelected(const QString& text, const QString& mergeKey,
                      const std::function<void(ObjectSpec&)>& change);
    void addObject(ObjectSpec object, const QString& text);
    void startImport(const QString& path, const ContourImportOptions& options);
    void addDisk();
    void duplicateSelected();
    void removeSelected();
    void previewFit(const FourierFit& fit);
    void commitFit(const FourierFit& fit);
    void commitOutline(const Contour& polygon);
    void showAll();
    void showSelected();
    void showMounting();
    void updateEnabled();
    void refreshTexts();
    bool hasSelection() const;
    const ObjectSpec& selected() const { return m_experiment.objects[static_cast<std::size_t>(m_selected)]; }
    std::string uniqueName(const QString& wish) const;
    Vector6d freeMounting(const Shape& shape) const;

    Experiment m_experiment;
    int m_selected = -1;
    bool m_editable = true;
    bool m_applied = false; ///< the undo stack changed the objects and it was not told yet
    QString m_why;
    TemperatureUnit m_unit = TemperatureUnit::Celsius;
    QUndoStack* m_undo;
    Edit* m_lastEdit = nullptr; ///< compared with the stack's last only

    MessageBar* m_note;
    MessageBar* m_message;
    ImportBar* m_importBar;
    ObjectList* m_list;
    QLabel* m_listTitle;
    QLabel* m_count;
    QLabel* m_remarks; ///< on the mounting
    QPushButton* m_addDisk;
    QPushButton* m_import;
    QPushButton* m_duplicate;
    QPushButton* m_remove;
    QPushButton* m_undoButton;
    QPushButton* m_redoButton;
    OutlinePreview* m_preview;
    HarmonicsPanel* m_harmonics;
    MountingPlan* m_plan;
    ObjectProperties* m_properties;
};

/// Outline an object can be fitted again from: the one imported, or its own polygon. Empty: none.
Contour rawOutline(const ObjectSpec& object);

} // namespace bask
