#pragma once
// The Objects page: list, import, outlines, harmonics, material, mounting.

#include "engine/base/units.h"
#include "engine/model/material_library.h"
#include "engine/model/mounting_check.h"
#include "engine/shape/contour_import.h"
#include "widgets/common/latest_job.h"

#include <QWidget>

#include <functional>

class QAction;
class QLabel;
class QPushButton;
class QScrollArea;
class QStackedWidget;
class QTabBar;

namespace bask {

class AirForm;
class HarmonicsPanel;
class ImportPanel;
class MessageBar;
class MountingViews;
class ObjectList;
class ObjectProperties;
class OutlinePreview;

/// Setters in, signals out. Every committed edit is one experimentEdited with the whole value, shown as if it
/// were taken; the receiver answers a refused one with setExperiment(the value before) and showError. Files
/// are read, and the shade of objects on one another is found, off the GUI thread.
///
/// Object names for tests: "objectList", "objectCount", "addDisk", "importOutline", "sampleShapes",
/// "duplicateObject", "removeObject", "undo", "redo", "objectTabs", "outlinePreview", "mountingRemarks",
/// "pageMessage" (MessageBar), "editNote" (MessageBar), "importPanel", and those of AirForm, HarmonicsPanel,
/// MountingViews, ObjectProperties, ImportPanel and MessageBar.
class ObjectsPage : public QWidget {
    Q_OBJECT

public:
    explicit ObjectsPage(QWidget* parent = nullptr);
    ~ObjectsPage() override;

    void setExperiment(const Experiment& experiment);
    const Experiment& experiment() const { return m_experiment; }
    /// Sets the materials of one's own that the form offers.
    void setMaterialLibrary(const MaterialLibrary& library);
    /// Gives name, source and date to the selected object's material, if that still has these values.
    void nameMaterial(const Material& saved);
    /// False while a run is on; `why` is shown above the page.
    void setEditable(bool editable, const QString& why);
    void setTemperatureUnit(TemperatureUnit unit);
    /// Sets the actions of the buttons, which show whether they are possible and what they do.
    void setUndoActions(QAction* undo, QAction* redo);
    /// Returns whether the file is of a kind that can be imported.
    static bool isReadable(const QString& path);

    int selectedObject() const { return m_selected; }
    void selectObject(int index);

public slots:
    /// Shows why an edit was refused, until the next edit.
    void showError(const QString& sentence);
    /// Imports a file, as after a drop: adds an object named after it, after asking for missing information.
    void offerFile(const QString& path);
    /// Opens a file dialog, then calls offerFile.
    void chooseFile();

signals:
    void experimentEdited(const bask::Experiment& experiment);
    /// The selected object's material is to be kept in the library.
    void saveMaterialWanted(const bask::Material& material);
    void materialsWanted();

protected:
    void changeEvent(QEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    QWidget* buildLeft();
    QWidget* buildCentre();
    QWidget* buildRight();
    void connectAll();
    /// Shows and emits one edit. `select` -1: the selection stays.
    void commit(std::vector<ObjectSpec> objects, int select = -1);
    /// Shows and emits the experiment, edited.
    void emitEdited();
    void editSelected(const std::function<void(ObjectSpec&)>& change);
    void addObject(ObjectSpec object);
    void addImported(const QString& path, const PickedOutline& picked);
    void showPanel(bool shown);
    void sayReading(const QString& path);
    void endImport();
    void focusImported();
    void addDisk();
    void duplicateSelected();
    void removeSelected();
    void previewFit(const FourierFit& fit);
    void commitFit(const FourierFit& fit);
    void commitOutline(const Contour& polygon);
    void showAll();
    void showSelected();
    void showMounting();
    /// Shows an object where it is dragged, without an edit.
    void showDragged(int index, const Vector6d& mounting);
    void findRemarks(const Experiment& experiment);
    void showRemarks();
    void updateEnabled();
    void refreshTexts();
    bool hasSelection() const;
    const ObjectSpec& selected() const { return m_experiment.objects[static_cast<std::size_t>(m_selected)]; }
    std::string uniqueName(const QString& wish) const;
    Eigen::Vector2d freePlace(const Shape& shape) const;

    Experiment m_experiment;
    int m_selected = -1;
    bool m_editable = true;
    bool m_importing = false;  ///< a file is being read or fitted in the background, as the message says
    bool m_committing = false; ///< the next experiment is the answer to an edit
    QString m_why;
    TemperatureUnit m_unit = TemperatureUnit::Celsius;

    MessageBar* m_note;
    MessageBar* m_message;
    QStackedWidget* m_stack; ///< the page, or the import panel
    ImportPanel* m_importPanel;
    LatestJob<Result<OriginalShape>> m_fitting; ///< fits the imported outline
    std::vector<MountingRemark> m_mountingRemarks;
    std::vector<MountingRemark> m_shade; ///< who shades whom at the start pose
    LatestJob<std::vector<MountingRemark>> m_shading;
    ObjectList* m_list;
    QLabel* m_listTitle;
    QLabel* m_count;
    QLabel* m_remarks; ///< remarks on the mounting
    QPushButton* m_addDisk;
    QPushButton* m_import;
    QPushButton* m_samples;
    QPushButton* m_duplicate;
    QPushButton* m_remove;
    QPushButton* m_undoButton;
    QPushButton* m_redoButton;
    QTabBar* m_tabs; ///< of the outline and the mounting
    QStackedWidget* m_centre;
    OutlinePreview* m_preview;
    HarmonicsPanel* m_harmonics;
    MountingViews* m_mounting;
    QScrollArea* m_form;
    ObjectProperties* m_properties;
    AirForm* m_air;
};

/// Returns the outline from which an object can be fitted again: the imported one, or its own polygon; empty
/// if there is none.
Contour rawOutline(const ObjectSpec& object);

} // namespace bask
