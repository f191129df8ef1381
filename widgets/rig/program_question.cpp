#include "widgets/rig/program_question.h"

#include "engine/drivers/program_files.h"
#include "widgets/common/display.h"
#include "widgets/rig/way_up_question.h"

#include <QCoreApplication>
#include <QMessageBox>

namespace bask {
namespace {

struct ProgramText {
    Q_DECLARE_TR_FUNCTIONS(bask::ProgramQuestion)
};

/// Without the characters that are not seen, or change the order of others.
QString shown(const std::string& text) {
    QString out = QString::fromStdString(text);
    for (QChar& c : out)
        if (!c.isPrint() || c.category() == QChar::Other_Format)
            c = QChar::ReplacementCharacter;
    return out;
}

} // namespace

void askForProgram(QWidget* parent, const std::string& command,
                   const std::function<void(const ConfirmProgram&)>& confirm) {
    const QString title = ProgramText::tr("Program of a device");
    const auto files = programFiles(command);
    if (!files) {
        auto* box = new QMessageBox(QMessageBox::Warning, title, messageText(files.error().message),
                                    QMessageBox::Close, parent);
        box->setTextFormat(Qt::PlainText);
        box->setAttribute(Qt::WA_DeleteOnClose);
        box->setModal(false);
        return box->show();
    }
    QStringList paths;
    for (const std::string& path : files->files)
        paths << shown(path);
    const QString text =
        ProgramText::tr("May Bask start this program on this computer?") + QStringLiteral("\n\n") +
        shown(command) + QStringLiteral("\n\n") + ProgramText::tr("It starts these files:") +
        QStringLiteral("\n") + paths.join(u'\n') + QStringLiteral("\n\n") +
        ProgramText::tr("It can do whatever you can do on this computer, and it moves or heats the device. "
                        "Confirm only what you know. You are asked again when one of these files changes.");
    askOnTheWayUp(parent, QStringLiteral("programQuestion"), title, text, ProgramText::tr("Allow it"),
                  [confirm, command, hash = files->hash] {
                      confirm(ConfirmProgram{command, hash});
                  });
}

} // namespace bask
