#pragma once
// What the engine monitors and the limits at which it acts: the experiment's safety limits.

#include "engine/base/units.h"
#include "engine/model/experiment.h"

#include <QWidget>

class QLabel;
class QToolButton;

namespace bask {

class ParameterForm;

/// Each change is one `edited`; the fields show the last setExperiment. Object names: ParameterForm's with
/// the prefix "safety.", "safetyMore", "ownLimits".
class SafetyPanel : public QWidget {
    Q_OBJECT

public:
    explicit SafetyPanel(QWidget* parent = nullptr);

    void setExperiment(const Experiment& experiment);
    void setEditable(bool editable);
    void setTemperatureUnit(TemperatureUnit unit);

signals:
    /// `words`: what has changed.
    void edited(const bask::Experiment& experiment, const QString& words);

protected:
    void changeEvent(QEvent* event) override;

private:
    void addRows();
    void showValues();
    void retranslate();

    Experiment m_experiment;
    TemperatureUnit m_unit = TemperatureUnit::Celsius;
    QLabel *m_title, *m_own;
    QToolButton* m_more;
    ParameterForm *m_usual, *m_seldom; ///< the second one can be folded
};

} // namespace bask
