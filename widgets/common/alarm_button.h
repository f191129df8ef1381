#pragma once
// The most serious alarm on the state bar: its mark, its text, and the number of other causes. Hidden without
// alarms, or if all are shelved.

#include "engine/base/units.h"
#include "widgets/common/alarm_groups.h"

#include <QAbstractButton>

#include <vector>

namespace bask {

/// Object name: "alarmButton". Uses the available width; its mark and the number of others are never cut.
class AlarmButton : public QAbstractButton {
    Q_OBJECT

public:
    explicit AlarmButton(QWidget* parent = nullptr);

    /// The gravest is shown; it calls as long as any does.
    void setAlarms(const std::vector<Alarm>& alarms);
    void setTemperatureUnit(TemperatureUnit unit);
    /// Marks the alarms as possibly old because the engine does not answer.
    void setStale(bool isStale);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;
    /// Its width with only the mark and a large number of others, whatever is shown now.
    int widthWithoutText() const;

signals:
    void alarmChosen(quint64 id);

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    std::size_t others() const;
    bool isCalling() const;
    QString othersText() const; ///< "+2"
    QFont textFont() const;
    QFont smallFont() const;
    void paintText(QPainter& painter, const QRect& room) const;
    int widthBesideText() const;
    void retranslateUi();

    AlarmGroups m_groups;
    const AlarmGroup* m_shown = nullptr; ///< of them; null without alarms
    TemperatureUnit m_unit = TemperatureUnit::Celsius;
    bool m_isStale = false;
};

} // namespace bask
