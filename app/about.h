#pragma once
// Help > About: the exact version, so that a report can name it.

#include <QString>

class QWidget;

namespace bask {

/// "0.1.0 (a1b2c3d)"; the revision is missing when the source was no checkout.
QString exactVersion();

void showAbout(QWidget* parent);

} // namespace bask
