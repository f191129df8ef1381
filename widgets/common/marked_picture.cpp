#include "widgets/common/marked_picture.h"

#include <QImageReader>

namespace bask {
namespace {
const QString kKey = QStringLiteral("Description"); // of PNG's own
} // namespace

void markPicture(QImage& picture, const QString& mark) {
    picture.setText(kKey, mark);
}

bool isMarkedPicture(const QString& path, const QString& mark) {
    return QImageReader(path).text(kKey) == mark;
}

} // namespace bask
