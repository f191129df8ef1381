#pragma once
// What the engine watches and from where on it acts: the experiment's safety limits.

#include "engine/base/units.h"
#include "engine/session/experiment.h"

#include <QWidget>

#include <functional>
#include <vector>

class QCheckBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QToolButton;

namespace bask {

class QuantitySpinBox;

/// Each change is one `edited`; fields show what setExperiment gave last. Object names: "safety.warning",
/// "safety.trip", "safety.sourceTrip", "safety.sourceTripAutomatic", "safety.heldLimit",
/// "safety.stalePeriods", "safetyMore", "safety.largestRate", "safety.largestRateAutomatic", "safety.jumps",
/// "safety.frozen", "safety.warming", "safety.crossCheck", "safety.sourceHeating", "safety.sourceBand",
/// "safety.sourceUnasked", "safety.leastDisk", "ownLimits".
class SafetyPanel : public QWidget {
    Q_OBJECT

public:
    explicit SafetyPanel(QWidget* parent = nullptr);

    void setExperiment(const Experiment& experiment);
    void setEditable(bool editable);
    void setTemperatureUnit(TemperatureUnit unit);

signals:
    /// `words`: what of it is new.
    void edited(const bask::Experiment& experiment, const QString& words);

protected:
    void changeEvent(QEvent* event) override;

private:
    using Apply = std::function<void(SafetySpec&)>;
    struct Row {
        QLabel* label;
        QWidget* field;
        const char* text;
        const char* tip;
    };
    struct Number {
        QDoubleSpinBox* field;
        double SafetySpec::*limit;
    };

    void build();
    QWidget* withAutomatic(QWidget* field, QCheckBox* box);
    QuantitySpinBox* temperature(const QString& name);
    void addRow(QFormLayout* form, QWidget* row, QWidget* field, const char* text, const char* tip);
    void addNumber(QFormLayout* form, const QString& name, double SafetySpec::*limit, double least,
                   double most, int decimals, const QString& suffix, const char* text, const char* tip);
    void edit(QDoubleSpinBox* field, const QString& wanted, const Apply& apply);
    void showValues();
    void showEditable();
    void retranslate();

    Experiment m_experiment;
    TemperatureUnit m_unit = TemperatureUnit::Celsius;
    bool m_editable = true;
    QLabel *m_title, *m_own;
    QuantitySpinBox *m_warning, *m_trip, *m_sourceTrip;
    QDoubleSpinBox *m_largestRate, *m_jumps;
    QCheckBox *m_sourceAutomatic, *m_rateAutomatic;
    QToolButton* m_more;
    QWidget* m_morePart;
    std::vector<Row> m_rows;
    std::vector<Number> m_numbers;
};

} // namespace bask
