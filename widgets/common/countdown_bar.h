#pragma once
// The next action that the engine takes by itself, with countdown and reason: above every page as long as it
// is pending.

#include "engine/base/units.h"
#include "engine/runtime/snapshot.h"

#include <QFrame>

#include <optional>

class QLabel;

namespace bask {

/// Hidden while nothing is pending. Object names: "countdownBar", "countdown", "countdownCause".
class CountdownBar : public QFrame {
    Q_OBJECT

public:
    explicit CountdownBar(QWidget* parent = nullptr);

    void setPending(const std::optional<PendingAction>& pending);
    void setTemperatureUnit(TemperatureUnit unit);

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void refresh();
    int priority() const; ///< priority of the cause as an alarm

    std::optional<PendingAction> m_pending;
    double m_from_s = 0.0; ///< when it was first pending
    TemperatureUnit m_unit = TemperatureUnit::Celsius;
    QLabel *m_mark, *m_text, *m_cause;
};

} // namespace bask
