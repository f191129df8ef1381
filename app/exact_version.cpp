#include "app/exact_version.h"

#include "engine/base/version.h"

namespace bask {

QString exactVersion() {
    const QString revision = QStringLiteral(BASK_REVISION);
    return revision.isEmpty() ? QStringLiteral(BASK_VERSION)
                              : QStringLiteral("%1 (%2)").arg(QStringLiteral(BASK_VERSION), revision);
}

} // namespace bask
