#pragma once
// The settings of the calibration board that is shown to the camera.

#include "engine/calibration/board.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;

namespace bask {

class WholeNumberField;

/// Object names: "boardKind", "boardColumns", "boardRows", "boardSquare", "boardMarker", "boardDictionary",
/// "boardLegacy".
class BoardForm : public QWidget {
    Q_OBJECT

public:
    explicit BoardForm(QWidget* parent = nullptr);

    /// Returns the entered board. Errors: those of parseBoard.
    Result<Board> board() const;
    /// Sets the board without emitting changed().
    void setBoard(const Board& board);

signals:
    void changed();

protected:
    void changeEvent(QEvent* event) override;

private:
    bool isCharuco() const;
    void showKind();
    void retranslate();

    QLabel* m_kindLabel;
    QComboBox* m_kind;
    QLabel* m_countsLabel;
    WholeNumberField* m_columns;
    WholeNumberField* m_rows;
    QLabel* m_squareLabel;
    QDoubleSpinBox* m_square;
    QLabel* m_markerLabel;
    QDoubleSpinBox* m_marker;
    QLabel* m_dictionaryLabel;
    QComboBox* m_dictionary;
    QCheckBox* m_legacy;
};

} // namespace bask
