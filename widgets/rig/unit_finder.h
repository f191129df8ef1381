#pragma once
// Finds the Modbus units at a port: a button, how far the search is, and what was found to choose from.

#include "engine/base/units.h"
#include "engine/drivers/found_units.h"

#include <QWidget>

class QLabel;
class QListWidget;
class QListWidgetItem;
class QPushButton;

namespace bask {

/// Object names: "findUnits", "findProgress", "foundUnits".
class UnitFinder : public QWidget {
    Q_OBJECT

public:
    explicit UnitFinder(QWidget* parent = nullptr);

    /// Sets the names and titles of the profiles that may be chosen; those of other roles are not shown.
    void setProfiles(const std::vector<std::pair<std::string, std::string>>& profiles);
    void setTemperatureUnit(TemperatureUnit unit) { m_unit = unit; }
    /// Returns whether its size has changed.
    bool setState(const ModbusSearchState& state);
    /// Forgets the search.
    void reset();

signals:
    void findWanted();
    void stopWanted();
    void chosen(int unit, const QString& profile, const bask::SerialSettings& line);

protected:
    void changeEvent(QEvent* event) override;

private:
    void list();
    void choose(const QListWidgetItem* item);
    void retranslate();
    bool isOn() const { return m_isAsked && !m_state.isOver; }

    std::vector<std::pair<std::string, std::string>> m_profiles;
    TemperatureUnit m_unit = TemperatureUnit::Celsius;
    ModbusSearchState m_state;
    bool m_isAsked = false; ///< a search was begun
    QPushButton* m_find;
    QLabel* m_progress;
    QListWidget* m_found;
};

} // namespace bask
