#include "app/close_question.h"

#include <QCoreApplication>
#include <QMessageBox>
#include <QPushButton>

namespace bask {
namespace {

struct ClosingText {
    Q_DECLARE_TR_FUNCTIONS(CloseQuestion)
};

void addStay(QMessageBox& box) {
    QPushButton* stay = box.addButton(ClosingText::tr("Stay"), QMessageBox::RejectRole);
    box.setDefaultButton(stay);
    box.setEscapeButton(stay);
}

QPushButton* addClose(QMessageBox& box, const QString& words, const char* name) {
    QPushButton* button = box.addButton(words, QMessageBox::DestructiveRole);
    button->setObjectName(QLatin1String(name));
    return button;
}

/// Asks, with one button that closes and one that does not.
bool isCloseChosen(QMessageBox& box, const QString& words, const char* name) {
    const QPushButton* close = addClose(box, words, name);
    addStay(box);
    box.exec();
    return box.clickedButton() == close;
}

} // namespace

Closing askToClose(QWidget* window, bool isRunOn, bool isRecipeOn) {
    QString text =
        isRunOn
            ? ClosingText::tr("\"Stop, then close\" switches the heat off, takes the objects away from "
                              "the source, and closes when they are there. \"Close now\" switches the heat "
                              "off and leaves the objects where they are, perhaps close to a hot source. "
                              "What is recorded stays.")
            : ClosingText::tr("A recipe is on, with nothing heated or moved just now.");
    if (isRecipeOn)
        text += u' ' + ClosingText::tr("The recipe ends, and its other steps are not run.");
    QMessageBox box(QMessageBox::Warning,
                    isRunOn ? ClosingText::tr("A run is on") : ClosingText::tr("A recipe is on"), text,
                    QMessageBox::NoButton, window);
    box.setObjectName(QStringLiteral("closeQuestion"));
    const QPushButton* stop = nullptr;
    if (isRunOn) {
        QPushButton* button = box.addButton(ClosingText::tr("Stop, then close"), QMessageBox::AcceptRole);
        button->setObjectName(QStringLiteral("closeStop"));
        stop = button;
    }
    const QPushButton* now =
        addClose(box, isRunOn ? ClosingText::tr("Close now") : ClosingText::tr("End the recipe and close"),
                 "closeNow");
    addStay(box);
    box.exec();
    if (stop != nullptr && box.clickedButton() == stop)
        return Closing::Stop;
    return box.clickedButton() == now ? Closing::Now : Closing::Keep;
}

bool askToEndRecording(QWidget* window, const QString& why) {
    QMessageBox box(QMessageBox::Warning, ClosingText::tr("The recording is on"),
                    why + u' ' +
                        ClosingText::tr("If Bask is closed now, the recording ends. What is recorded stays."),
                    QMessageBox::NoButton, window);
    box.setObjectName(QStringLiteral("recordingQuestion"));
    return isCloseChosen(box, ClosingText::tr("Close now"), "closeNow");
}

bool askToLeaveExports(QWidget* window, const QStringList& places) {
    QMessageBox box(QMessageBox::Warning, ClosingText::tr("An export is being written"),
                    ClosingText::tr("Bask is still writing what is named below. If it closes now, some of it "
                                    "may be missing; no file is left half written.") +
                        QStringLiteral("\n\n") + places.join(u'\n'),
                    QMessageBox::NoButton, window);
    box.setObjectName(QStringLiteral("exportQuestion"));
    box.setTextFormat(Qt::PlainText); // names are as they are
    return isCloseChosen(box, ClosingText::tr("Close anyway"), "closeAnyway");
}

void tellHeatLeft(QWidget* window) {
    QMessageBox box(
        QMessageBox::Critical, ClosingText::tr("The heat is not known to be off"),
        ClosingText::tr("The heat source was told to switch off and has not said that it is off. Look "
                        "at the plate, and switch it off at its mains."),
        QMessageBox::NoButton, window);
    box.setInformativeText(
        ClosingText::tr("A guard process goes on switching off a heater on a serial port after Bask has "
                        "closed. The alarm is there again at the next start."));
    box.setObjectName(QStringLiteral("heatLeft"));
    // Not Qt's own, which is English where the distribution's words for Qt are not installed.
    box.addButton(QCoreApplication::translate("About", "Close"), QMessageBox::RejectRole);
    box.exec();
}

} // namespace bask
