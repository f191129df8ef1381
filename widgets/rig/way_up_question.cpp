#include "widgets/rig/way_up_question.h"

#include <QCoreApplication>
#include <QMessageBox>
#include <QPushButton>

namespace bask {
namespace {

struct QuestionText {
    Q_DECLARE_TR_FUNCTIONS(bask::Question)
};

} // namespace

void dropQuestion(QWidget* parent, const QString& name) {
    auto* box = parent->findChild<QMessageBox*>(name);
    if (box == nullptr)
        return;
    box->setObjectName({});
    box->hide();
    box->deleteLater(); // it may be asking just now
}

void askOnTheWayUp(QWidget* parent, const QString& name, const QString& title, const QString& text,
                   const QString& yes, const std::function<void()>& then) {
    dropQuestion(parent, name);
    auto* box = new QMessageBox(QMessageBox::Warning, title, text, QMessageBox::NoButton, parent);
    box->setObjectName(name);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setTextFormat(Qt::PlainText); // names and commands from files are in it
    const QPushButton* go = box->addButton(yes, QMessageBox::AcceptRole);
    QPushButton* leave = box->addButton(QuestionText::tr("Cancel"), QMessageBox::RejectRole);
    box->setDefaultButton(leave);
    box->setEscapeButton(leave);
    QObject::connect(go, &QPushButton::clicked, parent, then);
    box->setModal(false);
    box->show();
}

} // namespace bask
