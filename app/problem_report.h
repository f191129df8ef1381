#pragma once
// Help > Report a problem: what a developer needs, in one text that a person reads before it is saved.
// Nothing is ever sent.

#include "engine/model/experiment.h"
#include "engine/runtime/snapshot.h"

#include <QDialog>

class QPlainTextEdit;

namespace bask {

/// In English: who reads it may not know the window's language. Paths outside of the experiment are not in
/// it, but those of the rig's ports are.
QString problemReport(const Snapshot& snapshot, const std::vector<TraceEvent>& events,
                      const Experiment& experiment);

/// The text, to be read, added to and shortened. Not modal. Object names: "problemDialog", "problemText",
/// "problemSave", "problemClose".
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
