#include "app/error_text.h"

#include "widgets/common/display.h"

namespace bask {

QString sentence(const Message& message) {
    return messageText(message);
}

QString sentence(const Error& error) {
    const QString text = sentence(error.message);
    return error.where.empty() ? text : QString::fromStdString(error.where) + QStringLiteral(": ") + text;
}

} // namespace bask
