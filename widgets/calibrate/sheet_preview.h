#pragma once
// The first sheet to be printed, drawn to scale.

#include "widgets/calibrate/board_sheet.h"

#include <QPixmap>
#include <QWidget>

#include <optional>

namespace bask {

class SheetPreview : public QWidget {
    Q_OBJECT

public:
    explicit SheetPreview(QWidget* parent = nullptr);

    void setSheet(const std::optional<BoardSheet>& sheet);
    QSize sizeHint() const override { return {360, 460}; }
    QSize minimumSizeHint() const override { return {180, 260}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    std::optional<BoardSheet> m_sheet;
    QPixmap m_picture; ///< picture of the sheet at this size; null if it must be painted
};

} // namespace bask
