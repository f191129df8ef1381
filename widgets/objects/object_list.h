#pragma once
// List of the experiment's objects: colour, name (F2 renames), and a description in a second line.

#include "engine/base/units.h"
#include "engine/model/experiment.h"

#include <QListWidget>

namespace bask {

/// Rows mirror the experiment's objects.
class ObjectList : public QListWidget {
    Q_OBJECT

public:
    explicit ObjectList(QWidget* parent = nullptr);

    /// Shows the objects and selects one, without emitting.
    void setObjects(const std::vector<ObjectSpec>& objects, int selected, TemperatureUnit unit);
    void setRenamable(bool renamable);

signals:
    void objectSelected(int index);
    void objectRenamed(int index, const QString& name);

protected:
    void changeEvent(QEvent* event) override;

private:
    QString kindText(const ObjectSpec& object) const;
    void refresh();

    std::vector<ObjectSpec> m_objects;
    TemperatureUnit m_unit = TemperatureUnit::Celsius;
    bool m_filling = false;
};

} // namespace bask
