#pragma once
// Table of the heat rates identified from a record, beside the controller's last estimate and the material's
// values.

#include "engine/base/units.h"

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
    /// the controller's lambda1 at the first sample and at the end, K/s
    double begun = std::numeric_limits<double>::quiet_NaN();
    double controller = std::numeric_limits<double>::quiet_NaN();
    double material = std::numeric_limits<double>::quiet_NaN(); ///< lambda1 of the material, K/s
    QString unusable; ///< why the rates cannot be used, in a sentence; empty if they can
    /// at which the next two are given
    double working_K = std::numeric_limits<double>::quiet_NaN();
    Value loss;             ///< of radiation and air together, K/s
    Value lossSlope;        ///< 1/s
    Value convection;       ///< h, W/(m2 K)
    QString hUntold;        ///< why the record does not tell h, in a sentence
    bool isAirApart = true; ///< whether the rates tell radiation from an air that is not stated
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

/// One row for each object, read-only: what the record tells of the loss, whether it is radiated or taken by
/// the air, and of the air's h.
class IdentifiedLosses : public QTableWidget {
    Q_OBJECT

public:
    explicit IdentifiedLosses(QWidget* parent = nullptr);

    void setRows(std::vector<IdentifiedRow> rows);
    void setTemperatureUnit(TemperatureUnit unit);

protected:
    void changeEvent(QEvent* event) override;

private:
    void refresh();

    std::vector<IdentifiedRow> m_rows;
    TemperatureUnit m_unit = TemperatureUnit::Celsius;
};

} // namespace bask
