#pragma once
// The gravest alarm on the state bar: its mark, what it is, how many others there are. Without alarms it is
// not there.

#include "engine/base/units.h"
#include "engine/session/alarm.h"

#include <QAbstractButton>

#include <vector>

namespace bask {

/// Object name: "alarmButton". Takes what room there is; its mark and the number of others are never cut.
class AlarmButton : public QAbstractButton {
    Q_OBJECT

public:
    explicit AlarmButton(QWidget* parent = nullptr);

    /// As the engine sorts them: the first is shown.
    void setAlarms(const std::vector<Alarm>& alarms);
    void setTemperatureUnit(TemperatureUnit unit);
    /// The engine does not answer: what is shown may be old.
    void setStale(bool isStale);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    void alarmChosen(quint64 id);

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    QString othersText() const; ///< "+2"
    QFont textFont() const;
    int widthBesideText() const;
    void retranslateUi();

    std::vector<Alarm> m_alarms;
    TemperatureUnit m_unit = TemperatureUnit::Celsius;
    bool m_isStale = false;
};

} // namespace bask
