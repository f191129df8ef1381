#pragma once
// Form of one object: name and shape, material, mounting on the end-effector, target. Display units are used
// only in the fields.

#include "engine/base/units.h"
#include "engine/model/experiment_parameters.h"
#include "engine/model/material_library.h"

#include <QWidget>

#include <functional>

class QComboBox;
class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace bask {

class QuantitySpinBox;

/// Emits a whole new value per committed edit; only the edited field differs from what was set.
/// Object names: "objectName", "radius", "materialPreset", "emittance", "absorptance", "specificHeat",
/// "density", "thickness", "infill", "mountX", "mountY", "mountZ", "mountRotation", "mountTiltX",
/// "mountTiltY", "target", "area", "perimeter", "presetSource", "saveMaterial", "materials", "heatCapacity",
/// "timeConstant", "lambda1", "lambda2", "lambda3".
class ObjectProperties : public QWidget {
    Q_OBJECT

public:
    explicit ObjectProperties(QWidget* parent = nullptr);

    void setObject(const ObjectSpec& object);
    /// Sets the materials that are listed after the presets.
    void setMaterialLibrary(const MaterialLibrary& library);
    /// Sets what the rates are computed with.
    void setSurroundings(const Surroundings& surroundings);
    void setTemperatureUnit(TemperatureUnit unit);
    void setReadOnly(bool readOnly);
    /// Gives the keyboard to the name, which is selected.
    void focusName();

signals:
    void objectEdited(const bask::ObjectSpec& object);
    void saveMaterialWanted(const bask::Material& material);
    void materialsWanted();

protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void build();
    QLabel* heading(QGridLayout* layout, int row);
    QDoubleSpinBox* number(const char* name, double min, double max, int decimals, double step,
                           std::function<void(ObjectSpec&, double)> apply);
    QDoubleSpinBox* angle(const char* name, Coordinate coordinate);
    QDoubleSpinBox* materialField(const Parameter<Material>& parameter);
    void edit(const std::function<void(ObjectSpec&)>& change);
    void showObject();
    void showDerived();
    void addMaterialRows(QGridLayout* layout, int row);
    void showPresets();
    void refreshTexts();

    ObjectSpec m_object;
    MaterialLibrary m_library;
    Surroundings m_surroundings;
    bool m_showing = false;
    QLabel* m_headings[3]{};
    QLineEdit* m_name;
    QLabel* m_kind;
    QDoubleSpinBox* m_radius;
    QLabel* m_area;
    QLabel* m_perimeter;
    QComboBox* m_preset;
    std::vector<std::pair<const Parameter<Material>*, QDoubleSpinBox*>> m_material; ///< in the table's order
    QLabel* m_presetSource;
    QPushButton *m_saveMaterial, *m_materials;
    QLabel* m_heatCapacity;
    QLabel* m_timeConstant;
    QLabel* m_lambda1;
    QLabel* m_lambda2;
    QLabel* m_lambda3;
    QDoubleSpinBox* m_mountX;
    QDoubleSpinBox* m_mountY;
    QDoubleSpinBox* m_mountZ;
    QDoubleSpinBox* m_mountRotation;
    QDoubleSpinBox* m_mountTiltX;
    QDoubleSpinBox* m_mountTiltY;
    QuantitySpinBox* m_target;
    /// Caption above each field, with its buddy.
    struct Caption {
        QLabel* label;
        QWidget* field;
    };
    std::vector<Caption> m_captions;
};

} // namespace bask
