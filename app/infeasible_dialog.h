#pragma once
// Before a run whose targets cannot be held: why, and an explicit tick to start all the same.

#include <QDialog>
#include <QString>

namespace bask {

/// Not modal to the program: STOP stays reachable. Accepted only with the tick. Object names:
/// "infeasibleDialog", "acceptInfeasible" (tick box), "startAnyway", "cancelStart".
class InfeasibleDialog : public QDialog {
    Q_OBJECT

public:
    /// `reason` in words; may be empty.
    InfeasibleDialog(const QString& reason, QWidget* parent);
};

} // namespace bask
