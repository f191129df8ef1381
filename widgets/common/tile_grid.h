#pragma once
// The tiles of a run's objects, in as few rows as the width allows.

#include "engine/base/units.h"

#include <QStringList>
#include <QWidget>

#include <vector>

class QGridLayout;

namespace bask {

class ObjectTile;
struct Experiment;

/// Prefers one row for up to four objects, and two for more; a narrow window needs more rows.
class TileGrid : public QWidget {
    Q_OBJECT
public:
    explicit TileGrid(QWidget* parent = nullptr);

    /// Creates new tiles; their object names are `objectName` and a number.
    void setObjects(const QString& objectName, const QStringList& names);
    /// Of the objects, in their order.
    void setLimits(const Experiment& experiment);
    void setTemperatureUnit(TemperatureUnit unit);
    const std::vector<ObjectTile*>& tiles() const { return m_tiles; }

    QSize minimumSizeHint() const override;

protected:
    bool event(QEvent* event) override;

private:
    int widest() const;
    void arrange();

    QGridLayout* m_layout;
    std::vector<ObjectTile*> m_tiles;
    int m_perRow = 0;
    TemperatureUnit m_unit = TemperatureUnit::Celsius;
};

} // namespace bask
