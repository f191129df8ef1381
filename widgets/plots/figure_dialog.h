#pragma once
// Asks for the size of a figure on paper, and whether it has a heading.

#include "widgets/plots/figure_format.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;

namespace bask {

/// A width from a list, or typed. Object names: "figureColumns" (list), "figureWidth", "figureHeading".
class FigureDialog : public QDialog {
    Q_OBJECT

public:
    explicit FigureDialog(const FigureLayout& layout, QWidget* parent = nullptr);

    FigureLayout chosen() const;

private:
    void choose();
    void findWidth();

    QComboBox* m_columns; ///< the last entry is another width
    QDoubleSpinBox* m_width;
    QCheckBox* m_heading;
};

} // namespace bask
