#include "widgets/calibrate/rig_panel.h"

#include "engine/base/units.h"
#include "engine/model/experiment_rig.h"
#include "widgets/calibrate/calibration_age.h"
#include "widgets/calibrate/camera_result.h"
#include "widgets/calibrate/marker_editor.h"
#include "widgets/common/display.h"
#include "widgets/common/labels.h"
#include "widgets/common/theme.h"

#include <QCheckBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>

#include <cmath>

namespace bask {
namespace {

constexpr int kIcon = 20;

QLabel* wrapped(QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

/// With a true minus sign, and none before a zero.
QString number(double value, int decimals) {
    return formatSigned(value, decimals).remove(QLatin1Char('+'));
}

QString mm(double length_m, int decimals = 1) {
    return RigPanel::tr("%1 mm").arg(number(1000.0 * length_m, decimals));
}

QString degrees(double angle_rad, int decimals = 2) {
    return RigPanel::tr("%1\u00b0").arg(number(degFromRad(angle_rad), decimals));
}

/// "x 1.2 mm, y ..., turned ... about x, y, z".
QString poseWords(const Pose& X) {
    const Vector6d q = coordinatesFromPose(X);
    return RigPanel::tr("x %1, y %2, z %3; turned by %4, %5, %6 about x, y, z")
        .arg(mm(q[kX]), mm(q[kY]), mm(q[kZ]), degrees(q[kThetaX]), degrees(q[kThetaY]), degrees(q[kThetaZ]));
}

int priorityOf(Verdict verdict) {
    return verdict == Verdict::Redo ? 2 : verdict == Verdict::Usable ? 3 : 0;
}

} // namespace

RigPanel::RigPanel(QWidget* parent)
    : QWidget(parent), m_markers(new MarkerEditor(this)), m_markersTitle(boldLabel(this)),
      m_placeTitle(boldLabel(this)), m_sourceTitle(boldLabel(this)), m_placeHint(wrapped(this)),
      m_sourceHint(wrapped(this)), m_here(new QPushButton(this)), m_tour(new QPushButton(this)),
      m_checkButton(new QPushButton(this)), m_usePlace(new QPushButton(this)), m_placeIcon(new QLabel(this)),
      m_placeVerdict(boldLabel(this)), m_placeText(wrapped(this)), m_measure(new QPushButton(this)),
      m_useSource(new QPushButton(this)), m_follow(new QCheckBox(this)), m_sourceIcon(new QLabel(this)),
      m_sourceVerdict(boldLabel(this)), m_sourceText(wrapped(this)), m_status(wrapped(this)),
      m_progress(new QProgressBar(this)), m_cancel(new QPushButton(this)) {
    m_here->setObjectName("placeHere");
    m_tour->setObjectName("placeTour");
    m_checkButton->setObjectName("placeCheck");
    m_usePlace->setObjectName("placeUse");
    m_placeVerdict->setObjectName("placeVerdict");
    m_placeText->setObjectName("placeText");
    m_measure->setObjectName("sourceMeasure");
    m_useSource->setObjectName("sourceUse");
    m_sourceVerdict->setObjectName("sourceVerdict");
    m_follow->setObjectName("sourceFollow");
    m_sourceText->setObjectName("sourceText");
    m_status->setObjectName("rigStatus");
    m_progress->setObjectName("surveyProgress");
    m_progress->setTextVisible(false);
    m_progress->setFixedHeight(10);
    m_cancel->setObjectName("surveyCancel");

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    layout->addWidget(m_markersTitle);
    layout->addWidget(m_markers);
    layout->addSpacing(8);
    layout->addWidget(buildPlace());
    layout->addSpacing(8);
    layout->addWidget(buildBusy()); // between what it belongs to
    layout->addSpacing(8);
    layout->addWidget(buildSource());
    layout->addStretch(1);

    connect(m_markers, &MarkerEditor::visionEdited, this, &RigPanel::visionEdited);
    connect(m_here, &QPushButton::clicked, this, [this] { begin(Task::PlaceHere); });
    connect(m_tour, &QPushButton::clicked, this, [this] { begin(Task::PlaceTour); });
    connect(m_checkButton, &QPushButton::clicked, this, [this] { begin(Task::PlaceCheck); });
    connect(m_measure, &QPushButton::clicked, this, [this] { begin(Task::Source); });
    connect(m_usePlace, &QPushButton::clicked, this, &RigPanel::usePlace);
    connect(m_useSource, &QPushButton::clicked, this, &RigPanel::useSource);
    connect(m_follow, &QCheckBox::clicked, this, &RigPanel::followWanted);
    connect(m_cancel, &QPushButton::clicked, this, &RigPanel::cancel);
    retranslate();
}

RigPanel::~RigPanel() = default;

QWidget* RigPanel::buildPlace() {
    auto* part = new QWidget(this);
    auto* buttons = new QHBoxLayout;
    for (QPushButton* button : {m_here, m_tour, m_checkButton})
        buttons->addWidget(button);
    auto* head = new QHBoxLayout;
    head->addWidget(m_placeIcon);
    head->addWidget(m_placeVerdict, 1);
    head->addWidget(m_usePlace);
    auto* layout = new QVBoxLayout(part);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_placeTitle);
    layout->addWidget(m_placeHint);
    layout->addLayout(buttons);
    layout->addLayout(head);
    layout->addWidget(m_placeText);
    return part;
}

QWidget* RigPanel::buildBusy() {
    auto* part = new QWidget(this);
    auto* busy = new QHBoxLayout;
    busy->addWidget(m_progress, 1);
    busy->addWidget(m_cancel);
    auto* layout = new QVBoxLayout(part);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_status);
    layout->addLayout(busy);
    return part;
}

QWidget* RigPanel::buildSource() {
    auto* part = new QWidget(this);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_measure);
    buttons->addStretch(1);
    auto* head = new QHBoxLayout;
    head->addWidget(m_sourceIcon);
    head->addWidget(m_sourceVerdict, 1);
    head->addWidget(m_useSource);
    auto* layout = new QVBoxLayout(part);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_sourceTitle);
    layout->addWidget(m_sourceHint);
    layout->addLayout(buttons);
    layout->addLayout(head);
    layout->addWidget(m_sourceText);
    layout->addWidget(m_follow);
    return part;
}

void RigPanel::setExperiment(const Experiment& experiment) {
    const bool isSameRig = m_experiment.vision.camera == experiment.vision.camera &&
                           m_experiment.vision.markers == experiment.vision.markers &&
                           m_experiment.vision.dictionary == experiment.vision.dictionary;
    m_experiment = experiment;
    if (!isSameRig)
        forget();
    m_markers->setVision(experiment.vision);
    showPlace();
    showSource();
    showEnabled();
}

void RigPanel::forget() {
    if (m_task != Task::None)
        cancel();
    m_place.reset();
    m_check.reset();
    m_source.reset();
    showPlace();
    showSource();
}

void RigPanel::setView(const VisionView& view) {
    m_markers->setView(view);
    if (view.cameraName != m_cameraName)
        forget();
    m_cameraName = view.cameraName;
    const bool isNew = view.frame && (!m_hasFrame || view.frame->number != m_frame);
    m_hasFrame = view.frame != nullptr;
    m_problem = view.problem;
    if (m_hasFrame && m_problem.code == MessageCode::None && m_experiment.vision.camera) {
        const GreyPicture& picture = view.frame->picture;
        if (const auto fits = checkSize(*m_experiment.vision.camera, picture.width, picture.height); !fits)
            m_problem = fits.error().message;
    }
    if (isNew && m_problem.code == MessageCode::None) {
        m_frame = view.frame->number;
        MarkerFrame frame;
        for (const ViewedMarker& marker : view.markers)
            frame.push_back(marker.marker);
        m_survey.addFrame(view.frame->time_s, frame);
        advance();
    }
    showEnabled();
}

void RigPanel::setRobot(const Vector6d& coordinates, bool isMoving, bool mayMove) {
    m_robot = coordinates;
    m_mayMove = mayMove;
    m_survey.setRobot(coordinates, isMoving);
    const bool isHeld = m_survey.state() == RigSurvey::State::Idle && !m_solving.busy();
    if (m_task != Task::None && (!mayMove || isHeld)) {
        m_survey.cancel(); // the run has the robot: no Hold, which would be the run's
        cancel();
    }
    showEnabled();
}

void RigPanel::begin(Task task) {
    m_task = task;
    m_status->clear();
    if (task == Task::PlaceTour) {
        m_survey.begin(surveyPoses(*rigGeometry(m_experiment), m_robot), kFramesOnTour);
    } else if (task == Task::PlaceCheck) {
        // Neither a pose of the tour nor the one where it is.
        const Vector6d first = surveyPoses(*rigGeometry(m_experiment), m_robot).front();
        m_survey.begin({0.6 * first + 0.4 * m_robot}, kFramesHere);
    } else {
        m_survey.begin({}, kFramesHere);
    }
    advance();
    emit attentionWanted(m_cancel);
}

void RigPanel::cancel() {
    const bool travels = m_survey.state() == RigSurvey::State::Travelling;
    m_survey.cancel();
    m_solving.forget();
    m_task = Task::None;
    m_status->clear();
    if (travels)
        emit holdWanted();
    showProgress();
    showEnabled();
}

void RigPanel::advance() {
    if (const auto goal = m_survey.takeGoal())
        emit moveWanted(*goal);
    if (m_task != Task::None && m_survey.state() == RigSurvey::State::Done && !m_solving.busy())
        solve();
    showProgress();
}

void RigPanel::solve() {
    const Task task = m_task;
    if (task == Task::PlaceCheck && !m_survey.hasMoved()) {
        cancel();
        m_status->setText(tr("The robot did not move: nothing was checked."));
        return;
    }
    const auto work = [task, views = m_survey.views(), layout = markerLayout(m_experiment.vision),
                       camera = *m_experiment.vision.camera, place = m_place,
                       p_RS = Eigen::Vector3d(m_experiment.source.pose.head<3>())]() {
        Outcome outcome;
        const auto keep = [&outcome](auto&& result, auto& into) {
            if (result)
                into = *result;
            else
                outcome.trouble = result.error().message;
        };
        if (task == Task::Source) {
            const HandEyeView& view = views.front();
            keep(relativePose(view.frames, layout, Part::Source, Part::EndEffector, camera), outcome.source);
            if (outcome.source)
                outcome.X_RS = view.X_RE * outcome.source->X_AB.inverse();
        } else if (task == Task::PlaceCheck) {
            keep(checkHandEye(*place, views.front(), layout, camera), outcome.check);
        } else {
            keep(calibrateHandEye(views, layout, camera, Mounting::Known), outcome.place);
            if (outcome.place)
                outcome.spread = spreadAt(*outcome.place, p_RS, layout, camera, views.front().X_RE);
        }
        return outcome;
    };
    m_survey.cancel();
    m_solving.run(work, [this, task](Outcome outcome) { take(task, std::move(outcome)); });
}

void RigPanel::take(Task task, Outcome outcome) {
    m_task = Task::None;
    m_status->setText(outcome.trouble.code == MessageCode::None ? QString() : sentenceText(outcome.trouble));
    if (outcome.place) {
        m_place = std::move(outcome.place);
        m_placeSpread = outcome.spread;
        m_check.reset();
    }
    if (outcome.check)
        m_check = outcome.check;
    if (outcome.source) {
        m_source = std::move(outcome.source);
        m_X_RS = outcome.X_RS;
    }
    if (task == Task::PlaceCheck)
        emit moveWanted(m_survey.start());
    showPlace();
    showSource();
    showProgress();
    showEnabled();
    emit attentionWanted(!m_status->text().isEmpty() ? m_status
                         : task == Task::Source      ? m_sourceText
                                                     : m_placeText);
}

void RigPanel::usePlace() {
    VisionSpec vision = m_experiment.vision;
    vision.cameraPose = coordinatesFromPose(m_place->X_RC);
    vision.cameraPoseDate = calibrationDate();
    emit visionEdited(vision);
}

void RigPanel::useSource() {
    VisionSpec vision = m_experiment.vision;
    vision.sourcePoseDate = calibrationDate();
    emit sourceMeasured(vision, coordinatesFromPose(m_X_RS));
}

bool RigPanel::isPlaceUsed() const {
    return m_experiment.vision.cameraPose == coordinatesFromPose(m_place->X_RC);
}

bool RigPanel::isSourceUsed() const {
    return m_experiment.source.pose == coordinatesFromPose(m_X_RS);
}

void RigPanel::showProgress() {
    const bool isBusy = m_task != Task::None;
    m_progress->setVisible(isBusy);
    m_cancel->setVisible(isBusy);
    if (!isBusy)
        return;
    m_progress->setRange(0, m_solving.busy() ? 0 : m_survey.framesWanted());
    m_progress->setValue(m_survey.framesTaken());
    if (m_solving.busy())
        m_status->setText(tr("Computing\u2026"));
    else if (m_survey.state() == RigSurvey::State::Travelling)
        m_status->setText(
            tr("The robot moves to pose %1 of %2.").arg(m_survey.views().size() + 1).arg(m_survey.poses()));
    else
        m_status->setText(tr("Looking, picture %1 of %2. Nothing may move.")
                              .arg(m_survey.framesTaken())
                              .arg(m_survey.framesWanted()));
}

void RigPanel::showPlace() {
    const VisionSpec& vision = m_experiment.vision;
    if (!m_place) {
        m_placeIcon->hide();
        m_placeVerdict->setText(vision.cameraPose ? tr("In use") : tr("Not measured"));
        m_placeText->setText(vision.cameraPose ? tr("The camera stands at %1, measured %2.")
                                                     .arg(poseWords(poseFromCoordinates(*vision.cameraPose)),
                                                          ageText(vision.cameraPoseDate))
                                               : QString());
        m_placeText->setVisible(vision.cameraPose.has_value());
        return;
    }
    const PoseSpread& spread = m_placeSpread;
    const Verdict verdict = verdictOn(spread);
    const bool isUsed = isPlaceUsed();
    m_placeVerdict->setText(isUsed ? tr("%1, in use").arg(verdictWord(verdict)) : verdictWord(verdict));
    const int priority = priorityOf(verdict);
    m_placeIcon->setVisible(priority > 0);
    if (priority > 0)
        m_placeIcon->setPixmap(alarmPixmap(priority, isDark(this), kIcon, devicePixelRatio()));
    int used = 0;
    for (const HandEyeResidual& view : m_place->views)
        used += view.isUsed ? 1 : 0;
    QStringList lines{
        tr("The camera stands at %1.").arg(poseWords(m_place->X_RC)),
        tr("What it sees at the source is known to \u00b1%1 and \u00b1%2 (two standard deviations), by %3 "
           "pose(s) of the robot; residual %4 px.")
            .arg(mm(spread.position_m, 2), degrees(spread.angle_rad))
            .arg(used)
            .arg(number(m_place->rms_px, 2))};
    if (m_place->views.size() > 1)
        lines << tr("The robot says where it is to %1 and %2 (one standard deviation).")
                     .arg(mm(m_place->robot_m, 2), degrees(m_place->robot_rad));
    for (const Message& remark : m_place->remarks)
        lines << sentenceText(remark);
    if (m_check)
        lines << tr("Checked at another pose: %1 and %2 off; up to %3 and %4 was to be expected.")
                     .arg(mm(m_check->difference.distance_m, 2), degrees(m_check->difference.angle_rad),
                          mm(m_check->expected.position_m, 2), degrees(m_check->expected.angle_rad));
    m_placeText->setText(lines.join(QLatin1Char('\n')));
    m_placeText->show();
}

void RigPanel::showSource() {
    m_sourceIcon->hide();
    const Pose configured = poseFromCoordinates(m_experiment.source.pose);
    if (!m_source) {
        const std::string& date = m_experiment.vision.sourcePoseDate;
        m_sourceVerdict->setText(date.empty() ? tr("As typed") : tr("In use"));
        m_sourceText->setText(
            date.empty()
                ? tr("The source lies at %1.").arg(poseWords(configured))
                : tr("The source lies at %1, measured %2.").arg(poseWords(configured), ageText(date)));
        return;
    }
    const Judgement judgement = judged(*m_source);
    const bool isUsed = isSourceUsed();
    m_sourceVerdict->setText(isUsed ? tr("%1, in use").arg(verdictWord(judgement.verdict))
                                    : verdictWord(judgement.verdict));
    const int priority = priorityOf(judgement.verdict);
    m_sourceIcon->setVisible(priority > 0);
    if (priority > 0)
        m_sourceIcon->setPixmap(alarmPixmap(priority, isDark(this), kIcon, devicePixelRatio()));
    const PoseDifference off = differenceBetween(configured, m_X_RS);
    QStringList lines{sentenceText(judgement.reason),
                      tr("The end-effector in the source: %1.").arg(poseWords(m_source->X_AB)),
                      tr("The source in the robot's base: %1.").arg(poseWords(m_X_RS))};
    if (!isUsed)
        lines << tr("That is %1 and %2 from where the experiment has it.")
                     .arg(mm(off.distance_m), degrees(off.angle_rad));
    for (const PartPose* part : {&m_source->a, &m_source->b})
        for (const Message& remark : part->remarks)
            lines << sentenceText(remark);
    m_sourceText->setText(lines.join(QLatin1Char('\n')));
}

QString RigPanel::whyNot() const {
    if (!m_experiment.vision.camera)
        return tr("Calibrate the camera first.");
    if (!m_experiment.vision.marks(Part::EndEffector))
        return tr("List the markers on the end-effector first.");
    if (m_problem.code != MessageCode::None)
        return sentenceText(m_problem);
    if (!m_hasFrame)
        return tr("No picture from the camera.");
    if (!m_mayMove)
        return tr("A run is armed or on, or a stop is not reset. Measure after that.");
    return {};
}

void RigPanel::showEnabled() {
    const QString reason = whyNot();
    const bool isFree = reason.isEmpty() && m_task == Task::None;
    for (QPushButton* button : {m_here, m_tour})
        button->setEnabled(isFree);
    m_checkButton->setEnabled(isFree && m_place);
    m_follow->setChecked(m_experiment.source.tracked);
    m_follow->setEnabled(m_mayMove && (m_experiment.source.tracked || m_experiment.vision.followsSource()));
    m_measure->setEnabled(isFree && m_experiment.vision.marks(Part::Source));
    m_usePlace->setEnabled(m_place && m_mayMove && !isPlaceUsed());
    m_useSource->setEnabled(m_source && m_mayMove && !isSourceUsed());
    if (m_task == Task::None && !reason.isEmpty() && m_status->text() != reason) {
        m_status->setText(reason);
        m_isReason = true;
    } else if (reason.isEmpty() && m_isReason) {
        m_status->clear();
        m_isReason = false;
    }
}

void RigPanel::retranslate() {
    setWindowTitle(tr("Rig"));
    m_markersTitle->setText(tr("Markers on the rig"));
    m_placeTitle->setText(tr("Where the camera stands"));
    m_placeHint->setText(tr("By the end-effector's markers, in the robot's base. Several poses of the robot "
                            "are surer than one."));
    m_here->setText(tr("Fr&om here"));
    m_here->setToolTip(tr("The robot stays where it is."));
    m_tour->setText(tr("&Several poses"));
    m_tour->setToolTip(tr("The robot moves to some poses within its workspace, never nearer to the source, "
                          "and back. Stand clear."));
    m_checkButton->setText(tr("Chec&k"));
    m_checkButton->setToolTip(
        tr("Moves the robot to a pose that was not measured, compares where the markers "
           "are with where they should be, and moves back."));
    m_usePlace->setText(tr("Use this p&lace"));
    m_sourceTitle->setText(tr("Where the source is"));
    m_sourceHint->setText(tr("By the markers on the source and on the end-effector, seen in the same "
                             "pictures."));
    m_measure->setText(tr("&Measure"));
    m_useSource->setText(tr("&Use this pose"));
    m_follow->setText(tr("Follow the source &during runs"));
    m_follow->setToolTip(
        tr("The camera tells the controllers where the source is. Takes markers on the source, "
           "a calibrated camera and its place."));
    m_cancel->setText(tr("Cancel"));
    m_progress->setAccessibleName(tr("Pictures looked at"));
    showPlace();
    showSource();
    showProgress();
    showEnabled();
}

void RigPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    else if (event->type() == QEvent::PaletteChange) {
        showPlace();
        showSource();
    }
}

} // namespace bask
