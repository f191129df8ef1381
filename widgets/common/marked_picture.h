#pragma once
// PNG files that say what they are, so that an export replaces its own earlier files and nobody else's.

#include <QImage>
#include <QString>

namespace bask {

void markPicture(QImage& picture, const QString& mark);
/// Whether a picture was saved there with this mark.
bool isMarkedPicture(const QString& path, const QString& mark);

} // namespace bask
