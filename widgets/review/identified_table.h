#pragma once
// Table of the heat rates identified from a record, beside the controller's last estimate and the material's
// values.

#include <QTableWidget>

#include <limits>
#include <vector>

namespace bask {

/// Rates of one object; NaN if unknown.
struct IdentifiedRow {
    struct Value {
        double value = std::numeric_limits<double>::quiet_NaN();
        double standardError = std::numeric_limits<double>::quiet_NaN();
    };
    QString name;
    Value lambda1; ///< K/s
    Value lambda2; ///< 1/(K3 s)
    Value lambda3; ///< K/s
    /// the controller's lambda1 at the end, K/s
    double controller = std::numeric_limits<double>::quiet_NaN();
    double material = std::numeric_limits<double>::quiet_NaN(); ///< lambda1 of the material, K/s
    QString unusable; ///< why the rates cannot be used, in a sentence; empty if they can
};

/// One row for each object, read-only: lambda1 in the cells, the other rates in the tool tips.
class IdentifiedTable : public QTableWidget {
    Q_OBJECT

public:
    explicit IdentifiedTable(QWidget* parent = nullptr);

    void setRows(std::vector<IdentifiedRow> rows);

protected:
    void changeEvent(QEvent* event) override;

private:
    void refresh();

    std::vector<IdentifiedRow> m_rows;
};

} // namespace bask
