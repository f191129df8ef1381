#pragma once
// Before a run whose targets cannot all be reached: which, and an explicit tick to start all the same.

#include <QDialog>
#include <QStringList>

namespace bask {

/// Not modal to the program: STOP stays reachable. Accepted only with the tick. Object names:
/// "infeasibleDialog", "acceptInfeasible" (tick box), "startAnyway", "cancelStart".
class InfeasibleDialog : public QDialog {
    Q_OBJECT

public:
    InfeasibleDialog(const QStringList& objects, QWidget* parent);
};

} // namespace bask
