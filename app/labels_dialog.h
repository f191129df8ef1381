#pragma once
// Asks who operates, and what is heated: at any time, and before a run if that is wanted.

#include "engine/model/run_labels.h"

#include <QDialog>
#include <QStringList>

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace bask {

/// Not modal, so that STOP stays reachable. Object names: "labelsDialog", "operatorName", "sampleName",
/// "batchName", "askLabels" (tick box), "labelsProblem", "takeLabels".
class LabelsDialog : public QDialog {
    Q_OBJECT

public:
    struct Content {
        RunLabels labels;
        QStringList operators;      ///< names that were used before
        bool isAskedAlways = false; ///< before each run
        bool isBeforeArm = false;   ///< its answer arms the run
        bool isRunOn = false;       ///< sample and batch are those of the run
    };
    LabelsDialog(const Content& content, QWidget* parent);

    RunLabels labels() const;
    bool isAskedAlways() const;

private:
    void check();

    QComboBox* m_operator;
    QLineEdit *m_sample, *m_batch;
    QCheckBox* m_ask;
    QLabel* m_problem;
    QPushButton* m_take;
};

} // namespace bask
