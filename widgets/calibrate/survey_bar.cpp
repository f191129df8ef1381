#include "widgets/calibrate/survey_bar.h"

#include <QHBoxLayout>
#include <QHideEvent>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

namespace bask {

SurveyBar::SurveyBar(QWidget* parent)
    : QWidget(parent), m_status(new QLabel(this)), m_progress(new QProgressBar(this)),
      m_cancel(new QPushButton(this)) {
    m_status->setObjectName("surveyStatus");
    m_status->setWordWrap(true);
    m_status->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_progress->setObjectName("surveyProgress");
    m_progress->setTextVisible(false);
    m_progress->setFixedHeight(10);
    m_cancel->setObjectName("surveyCancel");
    auto* busy = new QHBoxLayout;
    busy->addWidget(m_progress, 1);
    busy->addWidget(m_cancel);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_status);
    layout->addLayout(busy);
    connect(m_cancel, &QPushButton::clicked, this, &SurveyBar::cancel);
    setBusy(false);
    retranslate();
}

void SurveyBar::setBusy(bool isBusy) {
    m_isBusy = isBusy;
    m_progress->setVisible(isBusy);
    m_cancel->setVisible(isBusy);
}

void SurveyBar::begin(std::vector<Vector6d> goals, int frames) {
    m_survey.begin(std::move(goals), frames);
    setBusy(true);
    advance();
}

void SurveyBar::setRobot(const Vector6d& coordinates, bool isMoving, bool mayMove) {
    const bool wasOn = m_survey.isOn();
    m_survey.setRobot(coordinates, isMoving);
    if (!mayMove)
        m_survey.cancel();
    if (m_isBusy && (!mayMove || (wasOn && !m_survey.isOn())))
        cancel();
}

void SurveyBar::addFrame(double time_s, const MarkerFrame& frame) {
    if (m_survey.addFrame(time_s, frame))
        emit frameTaken();
    advance();
}

void SurveyBar::advance() {
    if (const auto goal = m_survey.takeGoal())
        emit moveWanted(*goal);
    const bool isDone = m_survey.state() == RigSurvey::State::Done;
    if (isDone)
        m_survey.cancel(); // no later frame is taken; its views stay
    if (m_isBusy)
        showSurvey();
    if (isDone)
        emit finished();
}

void SurveyBar::showSurvey() {
    m_progress->setRange(0, m_survey.isOn() ? m_survey.framesWanted() : 0);
    m_progress->setValue(m_survey.framesTaken());
    m_status->setText(
        !m_survey.isOn() ? tr("Computing\u2026")
        : m_survey.state() == RigSurvey::State::Travelling
            ? tr("The robot moves to pose %1 of %2.").arg(m_survey.views().size() + 1).arg(m_survey.poses())
            : tr("Looking, picture %1 of %2. Nothing may move.")
                  .arg(m_survey.framesTaken())
                  .arg(m_survey.framesWanted()));
}

void SurveyBar::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    if (!event->spontaneous() && m_isBusy && m_survey.isOn())
        cancel();
}

void SurveyBar::cancel() {
    const bool travels = m_survey.state() == RigSurvey::State::Travelling;
    m_survey.cancel();
    end({});
    if (travels)
        emit holdWanted();
    emit cancelled();
}

void SurveyBar::end(const QString& sentence) {
    setBusy(false);
    say(sentence);
}

void SurveyBar::sayReason(const QString& reason) {
    if (m_isBusy || (reason.isEmpty() && !m_isReason))
        return;
    say(reason);
    m_isReason = !reason.isEmpty();
}

void SurveyBar::say(const QString& sentence) {
    m_isReason = false;
    if (m_status->text() != sentence)
        m_status->setText(sentence);
}

QString SurveyBar::sentence() const {
    return m_status->text();
}

void SurveyBar::retranslate() {
    m_cancel->setText(tr("Cancel"));
    m_progress->setAccessibleName(tr("Pictures looked at"));
    if (m_isBusy)
        showSurvey();
}

void SurveyBar::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

} // namespace bask
