#include "engine/experiment/text_file.h"

#include "engine/base/message_code.h"
#include "engine/base/unfinished.h"

#include <QSaveFile>
#include <QString>

#include <cerrno>
#include <cstring>

namespace bask {

Result<void> writeTextFile(const std::string& path, const std::string& text) {
    const Uninterrupted whole;
    QSaveFile file(QString::fromStdString(path));
    const auto size = static_cast<qint64>(text.size());
    errno = 0;
    // Qt 6.4's commit() does not see that its last bytes found no room, and its flush() has no words for it.
    if (!file.open(QIODevice::WriteOnly) || file.write(text.data(), size) != size || !file.flush() ||
        !file.commit())
        return Error(MessageCode::FileUnwritable, path,
                     {errno == ENOSPC || errno == EDQUOT || errno == EFBIG
                          ? std::strerror(errno)
                          : file.errorString().toStdString()});
    return {};
}

} // namespace bask
