#include "engine/experiment/text_file.h"

#include "engine/base/message_code.h"

#include <QSaveFile>
#include <QString>

namespace bask {

Result<void> writeTextFile(const std::string& path, const std::string& text) {
    QSaveFile file(QString::fromStdString(path));
    const auto size = static_cast<qint64>(text.size());
    if (!file.open(QIODevice::WriteOnly) || file.write(text.data(), size) != size || !file.commit())
        return Error(MessageCode::FileUnwritable, path, {file.errorString().toStdString()});
    return {};
}

} // namespace bask
