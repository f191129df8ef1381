#include "engine/model/run_labels.h"

#include "engine/model/checker.h"

namespace bask {

Result<void> validate(const RunLabels& labels) {
    Checker check;
    check.line("operator", labels.operatorName, Checker::kMaxNameLength);
    check.name("sample", labels.sample);
    check.name("batch", labels.batch);
    return check.result();
}

} // namespace bask
