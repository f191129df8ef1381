#include "app/resources.h"

#include <QDir>

// Q_INIT_RESOURCE declares a function and must stand outside any namespace.
static void init() {
    Q_INIT_RESOURCE(bask);
    Q_INIT_RESOURCE(i18n);
}

namespace bask {

void initResources() {
    init();
}

} // namespace bask
