#pragma once
// The gravest alarm on the state bar: its mark, what it is, how many other causes there are. Without alarms,
// or with shelved ones alone, it is not there.

#include "engine/base/units.h"
#include "widgets/common/alarm_groups.h"

#include <QAbstractButton>

#include <vector>

namespace bask {

/// Object name: "alarmButton". Takes what room there is; its mark and the number of others are never cut.
class AlarmButton : public QAbstractButton {
    Q_OBJECT

public:
    explicit AlarmButton(QWidget* parent = nullptr);

    /// As the engine sorts them: the first that is active is shown.
    void setAlarms(const std::vector<Alarm>& alarms);
    void setTemperatureUnit(TemperatureUnit unit);
    /// The engine does not answer: what is shown may be old.
    void setStale(bool isStale);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;
    /// Its width with the mark and the number of many others alone, whatever is shown now.
    int widthWithoutText() const;

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

    std::vector<AlarmGroup> m_alarms;
    TemperatureUnit m_unit = TemperatureUnit::Celsius;
    bool m_isStale = false;
};

} // namespace bask
