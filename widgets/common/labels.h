#pragma once
// Labels that head a part of a page.

class QLabel;
class QWidget;

namespace bask {

/// In semi-bold, `scale` times as large.
void makeBold(QLabel* label, double scale = 1.0);
QLabel* boldLabel(QWidget* parent, double scale = 1.0);

} // namespace bask
