#pragma once
// Sheets to be printed, with a board or markers, and the length of their ruler measured on the print.

#include "widgets/calibrate/board_sheet.h"

#include <QWidget>

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace bask {

class BoardForm;
class SheetPreview;

/// Object names: "sheetKind", "sheetDictionary", "sheetIds", "sheetSide", "sheetPaper", "sheetPreview",
/// "sheetPages", "sheetProblem", "sheetSave", "sheetMeasured", "sheetTrue", "sheetUse" and those of
/// BoardForm.
class SheetPanel : public QWidget {
    Q_OBJECT

public:
    explicit SheetPanel(QWidget* parent = nullptr);

    /// Sets the board that is offered to be printed.
    void setBoard(const Board& board);
    void setMarkers(const std::string& dictionary, const std::vector<int>& ids, double side_m);
    /// Writes the PDF; the panel shows the result.
    void saveTo(const QString& path);

signals:
    /// The board with its size corrected by the ruler on the print.
    void boardMeasured(const bask::Board& board);
    void markersMeasured(const std::string& dictionary, const std::vector<int>& ids, double side_m);
    void exported(const QString& sentence, const QStringList& files);

protected:
    void changeEvent(QEvent* event) override;

private:
    QWidget* buildForm();
    void connectAll();
    bool isMarkers() const;
    double scale() const;        ///< scale of the print; 0 if it was not measured
    std::string ids() const;     ///< the typed ids
    std::string setting() const; ///< setting of the markers
    void refresh();
    void showTrueLength();
    void say(const QString& sentence, bool isProblem);
    void use();
    void retranslate();

    std::vector<BoardSheet> m_sheets; ///< empty if the setting cannot be printed

    SheetPreview* m_preview;
    QLabel* m_pages;
    QFormLayout* m_form;
    QComboBox* m_kind;
    BoardForm* m_board;
    QComboBox* m_dictionary;
    QLineEdit* m_ids;
    QDoubleSpinBox* m_side;
    QComboBox* m_paper;
    QLabel* m_problem;
    QPushButton* m_save;
    QDoubleSpinBox* m_measured;
    QLabel* m_true;
    QPushButton* m_use;
};

} // namespace bask
