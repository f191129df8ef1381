#pragma once
// Table of the heat rates that a record gives, beside the controller's last estimate and the material's.

#include <QTableWidget>

#include <limits>
#include <vector>

namespace bask {

/// Rates of one object; NaN where nothing is known.
struct IdentifiedRow {
    struct Value {
        double value = std::numeric_limits<double>::quiet_NaN();
        double standardError = std::numeric_limits<double>::quiet_NaN();
    };
    QString name;
    Value lambda1;                                                ///< K/s
    Value lambda2;                                                ///< 1/(K3 s)
    Value lambda3;                                                ///< K/s
    double controller = std::numeric_limits<double>::quiet_NaN(); ///< its lambda1 at the end, K/s
    double material = std::numeric_limits<double>::quiet_NaN();   ///< lambda1, K/s
    QString unusable; ///< why the rates cannot be used, a sentence; empty: they can
};

/// One row an object, read-only: lambda1 in the cells, the other rates in the tool-tips.
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
