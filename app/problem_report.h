#pragma once
// Help > Report a problem: what a developer needs, in one text that a person reads before it is saved.
// Nothing is ever sent.

#include "engine/model/experiment.h"
#include "engine/runtime/snapshot.h"

#include <QDialog>

class QPlainTextEdit;

namespace bask {

/// Returns the report in English, since its reader may not know the window's language. It contains the paths
/// of the rig's ports, but no other paths outside of the experiment.
QString problemReport(const Snapshot& snapshot, const std::vector<TraceEvent>& events,
                      const Experiment& experiment);

/// Shows the text, to be read, extended or shortened. Not modal. Object names: "problemDialog",
/// "problemText", "problemSave", "problemClose".
class ProblemDialog : public QDialog {
    Q_OBJECT

public:
    ProblemDialog(const QString& report, QWidget* parent);

signals:
    void saveWanted(const QString& text);

private:
    QPlainTextEdit* m_text;
};

} // namespace bask
