#pragma once
// Asks what an object's material is called in the library, where its values are from and how good they are.

#include "engine/model/experiment_parameters.h"
#include "engine/model/material_library.h"

#include <QDialog>
#include <QString>

#include <utility>
#include <vector>

class QDate;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace bask {

/// Not modal, so that STOP stays reachable. Object names: "saveMaterialDialog", "materialName",
/// "materialSource", "uncertainty_" with parameterObjectName(), "materialProblem", "takeMaterial".
class SaveMaterialDialog : public QDialog {
    Q_OBJECT

public:
    SaveMaterialDialog(const Material& values, const MaterialLibrary& library, const QDate& today,
                       QWidget* parent);

    Material material() const;

private:
    QWidget* uncertaintyRow(const Parameter<Material>& value);
    void check();

    Material m_values;
    MaterialLibrary m_library;
    QLineEdit *m_name, *m_source;
    std::vector<std::pair<const Parameter<Material>*, QDoubleSpinBox*>> m_uncertainties;
    QLabel* m_problem;
    QPushButton* m_take;
};

} // namespace bask
