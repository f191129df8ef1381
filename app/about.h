#pragma once
// Help > About.

class QWidget;

namespace bask {

void showAbout(QWidget* parent);

} // namespace bask
