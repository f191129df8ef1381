#pragma once
// Choice of the controller and its gains, staged until Apply.

#include "engine/control/controller_settings.h"

#include <QGroupBox>

#include <vector>

class QComboBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace bask {

class GainSpinBox;
struct ControllerGain;

/// Edits are staged: nothing changes until Apply; Revert restores the engine's values. Both are enabled only
/// if something differs. Object names: "controllerPanel", "controllerChoice", "gain.<group>.<name>" as in
/// files ("gain.adaptive.mu"), "gain.frequency", "gain.damping", "gainsPrediction",
/// "gainsApply", "gainsRevert", "gainsStaged". Frequency and damping are another form of the model-based D
/// and K: each follows the other.
class ControllerPanel : public QGroupBox {
    Q_OBJECT
public:
    explicit ControllerPanel(QWidget* parent = nullptr);

    /// Sets the engine's settings. Fields follow them unless a person has staged something.
    void setSettings(const ControllerSettings& settings);
    /// Sets by which factor the heat rates are wrong with which the controller begins; 1 for none.
    void setWrongRates(double factor);
    const ControllerSettings& staged() const { return m_staged; }
    bool changed() const { return !(m_staged == m_applied); }

signals:
    void controllerApplied(const bask::ControllerSettings& settings);

protected:
    void changeEvent(QEvent* event) override;

private:
    struct Gain {
        ControllerKind kind;
        const ControllerGain* gain;
        QLabel* label;
        GainSpinBox* box;
    };

    void makeRows();
    void makeNaturalRows();
    void showNatural();
    QString prediction() const;
    void retranslateUi();
    void showStaged();
    void showChanges();

    ControllerSettings m_applied;
    ControllerSettings m_staged;
    std::vector<Gain> m_gains;
    QLabel *m_frequencyLabel = nullptr, *m_dampingLabel = nullptr;
    GainSpinBox *m_frequency = nullptr, *m_damping = nullptr;
    QLabel* m_prediction = nullptr;
    double m_wrongRates = 1.0;
    bool m_showing = false;
    QComboBox* m_choice = nullptr;
    QLabel* m_choiceLabel = nullptr;
    QFormLayout* m_form = nullptr;
    QLabel* m_note = nullptr;
    QPushButton* m_apply = nullptr;
    QPushButton* m_revert = nullptr;
};

} // namespace bask
