#pragma once
// PNG files with a mark, so that an export replaces only its own earlier files.

#include <QImage>
#include <QString>

namespace bask {

void markPicture(QImage& picture, const QString& mark);
/// Returns whether the file is a picture with this mark.
bool isMarkedPicture(const QString& path, const QString& mark);

} // namespace bask
