#pragma once
// Zeroing of the sensors against each other: when, with which offsets, and why it is not possible now.

#include "engine/base/units.h"
#include "engine/model/experiment.h"
#include "engine/runtime/snapshot.h"

#include <QWidget>

#include <string>
#include <vector>

class QLabel;
class QPushButton;

namespace bask {

/// Object names: "zeroSensors", "zeroState", "zeroOffsets", "zeroProblem".
class ZeroPanel : public QWidget {
    Q_OBJECT

public:
    explicit ZeroPanel(QWidget* parent = nullptr);

    void setObjects(const std::vector<ObjectSpec>& objects);
    void apply(const Snapshot& snapshot);
    void setTemperatureUnit(TemperatureUnit unit);

signals:
    void zeroWanted();

protected:
    void changeEvent(QEvent* event) override;

private:
    QString offsetsText() const;
    QString problemText() const;
    void refresh();
    void retranslate();

    std::vector<std::string> m_names;
    std::optional<Zeroing> m_zeroing;
    Message m_problem;
    bool m_isHeatOn = false;
    TemperatureUnit m_unit = TemperatureUnit::Celsius;
    QLabel *m_title, *m_state, *m_offsets, *m_why;
    QPushButton* m_zero;
};

} // namespace bask
