#pragma once
// What a thermal camera reads of each object, or why it cannot; the one that is chosen.

#include "engine/base/units.h"
#include "widgets/thermal/thermal_range.h"

#include <QTableWidget>

#include <optional>
#include <vector>

namespace bask {

/// The first row is the whole picture.
class ThermalObjectList : public QTableWidget {
    Q_OBJECT
public:
    explicit ThermalObjectList(QWidget* parent = nullptr);

    /// Shows the readings of a view, and the range of its whole picture. If they are not current, dashes are
    /// shown.
    void showView(const ThermalView& view, const std::optional<ThermalRange>& range, bool isCurrent,
                  TemperatureUnit unit);
    void setNames(const std::vector<QString>& names);
    /// Returns the chosen object; empty is the whole picture.
    std::optional<std::size_t> chosen() const;
    QString chosenName() const; ///< or the words for the whole picture

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {270, 60}; }

signals:
    void chosenChanged();

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void setRows();
    void setCell(int row, int column, const QString& text, const QString& toolTip = {});
    void fitColumns();
    void fitRow(int row);
    void showReason(int row, const QString& reason);
    void showReading(int row, const ThermalObjectView& object, bool isCurrent, TemperatureUnit unit);

    std::vector<QString> m_names;
};

} // namespace bask
