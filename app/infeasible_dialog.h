#pragma once
// The dialog before a run whose targets cannot be held: the reason, and a tick box to start anyway.

#include <QDialog>
#include <QString>

namespace bask {

/// Not modal to the program, so that STOP stays reachable. Accepted only if ticked. Object names:
/// "infeasibleDialog", "acceptInfeasible" (tick box), "startAnyway", "cancelStart".
class InfeasibleDialog : public QDialog {
    Q_OBJECT

public:
    /// `reason` in words; may be empty.
    InfeasibleDialog(const QString& reason, QWidget* parent);
};

} // namespace bask
