#pragma once
// How well the views cover what a calibration needs: four bars, and the next step in words.

#include "engine/calibration/view_collector.h"

#include <QWidget>

#include <array>

class QCheckBox;
class QLabel;
class QProgressBar;

namespace bask {

/// Object names: "coverageX", "coverageY", "coverageSize", "coverageTilt" (bars), "coverageViews",
/// "coverageMissing", "coverageShown" (check box).
class CoverageView : public QWidget {
    Q_OBJECT

public:
    explicit CoverageView(QWidget* parent = nullptr);

    void setCoverage(const Coverage& coverage);
    bool isMapWanted() const;

signals:
    /// Whether to draw the heat map over the picture.
    void mapWanted(bool wanted);

protected:
    void changeEvent(QEvent* event) override;

private:
    struct Row {
        QLabel* name;
        QProgressBar* bar;
        QLabel* word;
    };
    void retranslate();

    Coverage m_coverage;
    std::array<Row, 4> m_rows{};
    QLabel* m_views;
    QLabel* m_missing;
    QCheckBox* m_map;
};

} // namespace bask
