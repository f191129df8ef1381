#include "widgets/calibrate/thermal_panel.h"

#include "engine/base/message_code.h"
#include "engine/calibration/hand_eye.h"
#include "engine/model/experiment_rig.h"
#include "widgets/calibrate/calibration_age.h"
#include "widgets/calibrate/pose_words.h"
#include "widgets/calibrate/survey_bar.h"
#include "widgets/calibrate/verdict_box.h"
#include "widgets/common/display.h"
#include "widgets/common/labels.h"

#include <QEvent>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace bask {
namespace {

std::optional<PlacedThermalCamera> thermalCameraOf(const Experiment& experiment) {
    return believedThermalCamera(experiment, !experiment.rig);
}

std::optional<RigSpec> uncalibrated(std::optional<RigSpec> rig) {
    if (rig && rig->thermalCamera)
        rig->thermalCamera->calibration = {};
    return rig;
}

/// Whether a pose that was found for one is right for the other.
bool hasSameSilhouettes(const Experiment& a, const Experiment& b) {
    const auto one = thermalCameraOf(a), other = thermalCameraOf(b);
    if (!one || !other || !one->X_RC || !other->X_RC || one->lens != other->lens ||
        uncalibrated(a.rig) != uncalibrated(b.rig))
        return false;
    return a.source.shape == b.source.shape && a.source.pose == b.source.pose && a.shields == b.shields &&
           a.fixtures == b.fixtures && a.source.uneven == b.source.uneven &&
           std::ranges::equal(a.objects, b.objects, [](const ObjectSpec& x, const ObjectSpec& y) {
               return x.shape == y.shape && x.mounting == y.mounting;
           });
}

} // namespace

ThermalPanel::ThermalPanel(QWidget* parent)
    : QWidget(parent), m_title(boldLabel(this)), m_hint(new QLabel(this)), m_tour(new QPushButton(this)),
      m_bar(new SurveyBar(this)), m_box(new VerdictBox(QStringLiteral("thermal"), this)) {
    m_tour->setObjectName("thermalTour");
    m_hint->setWordWrap(true);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    layout->addWidget(m_title);
    layout->addWidget(m_hint);
    layout->addWidget(m_tour, 0, Qt::AlignLeft);
    layout->addWidget(m_bar);
    layout->addWidget(m_box);
    layout->addStretch(1);
    connect(m_tour, &QPushButton::clicked, this, &ThermalPanel::begin);
    connect(m_bar, &SurveyBar::moveWanted, this, &ThermalPanel::moveWanted);
    connect(m_bar, &SurveyBar::holdWanted, this, &ThermalPanel::holdWanted);
    connect(m_bar, &SurveyBar::frameTaken, this, [this] {
        m_views.push_back({*m_view.picture, m_bar->survey().views().back().X_RE});
    });
    connect(m_bar, &SurveyBar::finished, this, &ThermalPanel::solve);
    connect(m_bar, &SurveyBar::cancelled, this, [this] {
        m_solving.forget();
        showEnabled();
    });
    connect(m_box->useButton(), &QPushButton::clicked, this, &ThermalPanel::use);
    retranslate();
}

ThermalPanel::~ThermalPanel() = default;

ThermalCalibration ThermalPanel::calibration() const {
    return thermalCalibration(m_experiment, !m_experiment.rig);
}

void ThermalPanel::setExperiment(const Experiment& experiment) {
    if (!hasSameSilhouettes(m_experiment, experiment)) {
        if (m_bar->isBusy())
            m_bar->cancel();
        m_found.reset();
    }
    m_experiment = experiment;
    showPose();
    showEnabled();
}

void ThermalPanel::setView(const ThermalView& view) {
    const bool isNew = view.picture && view.problem.code == MessageCode::None &&
                       (!m_view.picture || view.time_s > m_view.time_s) && !isConstant(*view.picture);
    m_view = view;
    if (isNew)
        m_bar->addFrame(view.time_s, {});
    else if (view.problem.code != MessageCode::None && m_bar->survey().isOn())
        m_bar->cancel(); // the reason follows
    showEnabled();
}

void ThermalPanel::setRobot(const Vector6d& coordinates, bool isMoving, bool mayMove) {
    m_robot = coordinates;
    m_mayMove = mayMove;
    m_bar->setRobot(coordinates, isMoving, mayMove);
    showEnabled();
}

void ThermalPanel::setBoardWanted(bool isWanted) {
    m_isBoardWanted = isWanted;
    showEnabled();
}

void ThermalPanel::begin() {
    m_views.clear();
    m_bar->begin(surveyPoses(*rigGeometry(m_experiment), m_robot), 1);
    showEnabled();
    emit attentionWanted(m_bar->cancelButton());
}

void ThermalPanel::solve() {
    const auto camera = thermalCameraOf(m_experiment); // has a pose, else the survey had been cancelled
    m_solving.run(
        [lens = camera->lens, start = *camera->X_RC, views = std::move(m_views),
         scene = silhouetteScene(m_experiment)] { return silhouettePose(lens, views, scene, start); },
        [this](Result<SilhouettePose> result) { take(std::move(result)); });
}

void ThermalPanel::take(Result<SilhouettePose> result) {
    m_bar->end(result ? QString() : sentenceText(result.error().message));
    if (result)
        m_found = std::move(*result);
    showPose();
    showEnabled();
    emit attentionWanted(result ? m_box->textLabel() : m_bar->statusLabel());
}

void ThermalPanel::use() {
    ThermalCalibration changed = calibration();
    changed.pose = coordinatesFromPose(m_found->X_RC);
    changed.poseDate = calibrationDate();
    changed.poseUncertainty_m = 0.5 * m_found->across_m;
    emit calibrated(changed);
}

void ThermalPanel::showPose() {
    const auto camera = thermalCameraOf(m_experiment);
    if (!m_found) {
        const ThermalCalibration believed = calibration();
        const std::string& date = believed.poseDate;
        const QString place = camera && camera->X_RC ? poseWords(*camera->X_RC) : QString();
        return m_box->showState(
            place.isEmpty()               ? tr("Not measured")
            : !believed.pose              ? tr("As simulated")
            : date.empty()                ? tr("As typed")
            : !believed.poseUncertainty_m ? tr("Measured by an earlier version: measure it again")
                                          : tr("In use"),
            place.isEmpty() ? QString()
            : date.empty()  ? tr("The camera is at %1.").arg(place)
                            : tr("The camera is at %1, measured %2.").arg(place, ageText(date)));
    }
    const Judgement judgement = judged(*m_found);
    const bool isUsed = calibration().pose == coordinatesFromPose(m_found->X_RC);
    QStringList lines{sentenceText(judgement.reason),
                      tr("The camera is at %1.").arg(poseWords(m_found->X_RC))};
    if (!isUsed && camera && camera->X_RC) {
        const PoseDifference off = differenceBetween(*camera->X_RC, m_found->X_RC);
        lines << tr("That is %1 and %2 from where the experiment has it.")
                     .arg(millimetres(off.distance_m), degrees(off.angle_rad));
    }
    lines << tr("Of the outlines %1 % were found, %2 px from where they should be.")
                 .arg(plainNumber(100.0 * m_found->foundShare, 0), plainNumber(m_found->rms_px, 2));
    for (const Message& remark : m_found->remarks)
        lines << sentenceText(remark);
    m_box->showVerdict(judgement.verdict, isUsed, lines);
}

QString ThermalPanel::whyNot() const {
    const auto camera = thermalCameraOf(m_experiment);
    if (camera && !camera->X_RC)
        return tr("Say on the Rig page where the thermal camera is, to 5 cm and 5 degrees.");
    if (m_view.problem.code != MessageCode::None)
        return sentenceText(m_view.problem);
    if (!m_view.picture)
        return tr("No picture from the thermal camera.");
    if (m_isBoardWanted)
        return tr("A calibration board is looked for. Stop looking first.");
    if (!m_mayMove)
        return tr("A run is armed or on, or a stop is not reset. Measure after that.");
    return {};
}

void ThermalPanel::showEnabled() {
    const QString reason = whyNot();
    m_tour->setEnabled(reason.isEmpty() && !m_bar->isBusy());
    m_box->useButton()->setEnabled(m_found && m_mayMove && !m_bar->isBusy() &&
                                   calibration().pose != coordinatesFromPose(m_found->X_RC));
    m_bar->sayReason(reason);
}

void ThermalPanel::retranslate() {
    setWindowTitle(tr("Place"));
    m_title->setText(tr("Where the thermal camera is"));
    m_hint->setText(tr("By the outlines of the objects at several poses of the robot. The camera has to see "
                       "them, and they have to be 5 K or more warmer or colder than what is behind them."));
    m_tour->setText(tr("&Several poses"));
    m_tour->setToolTip(tr("The robot moves to some poses within its workspace, never nearer to the source, "
                          "and back. Stand clear."));
    m_box->useButton()->setText(tr("Use this p&lace"));
    showPose();
    showEnabled();
}

void ThermalPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

} // namespace bask
