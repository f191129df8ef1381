#include "widgets/calibrate/rig_panel.h"

#include "engine/model/experiment_rig.h"
#include "widgets/calibrate/calibration_age.h"
#include "widgets/calibrate/marker_editor.h"
#include "widgets/calibrate/pose_words.h"
#include "widgets/calibrate/survey_bar.h"
#include "widgets/calibrate/verdict_box.h"
#include "widgets/common/display.h"
#include "widgets/common/labels.h"

#include <QCheckBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

namespace bask {
namespace {

QLabel* wrapped(QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

} // namespace

RigPanel::RigPanel(QWidget* parent)
    : QWidget(parent), m_markers(new MarkerEditor(this)), m_markersTitle(boldLabel(this)),
      m_placeTitle(boldLabel(this)), m_sourceTitle(boldLabel(this)), m_placeHint(wrapped(this)),
      m_sourceHint(wrapped(this)), m_here(new QPushButton(this)), m_tour(new QPushButton(this)),
      m_checkButton(new QPushButton(this)), m_placeBox(new VerdictBox(QStringLiteral("place"), this)),
      m_measure(new QPushButton(this)), m_sourceBox(new VerdictBox(QStringLiteral("source"), this)),
      m_follow(new QCheckBox(this)), m_bar(new SurveyBar(this)) {
    m_here->setObjectName("placeHere");
    m_tour->setObjectName("placeTour");
    m_checkButton->setObjectName("placeCheck");
    m_measure->setObjectName("sourceMeasure");
    m_follow->setObjectName("sourceFollow");

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    layout->addWidget(m_markersTitle);
    layout->addWidget(m_markers);
    layout->addSpacing(8);
    layout->addWidget(buildPlace());
    layout->addSpacing(8);
    layout->addWidget(m_bar); // between what it belongs to
    layout->addSpacing(8);
    layout->addWidget(buildSource());
    layout->addStretch(1);

    connect(m_markers, &MarkerEditor::visionEdited, this, &RigPanel::visionEdited);
    connect(m_here, &QPushButton::clicked, this, [this] { begin(Task::PlaceHere); });
    connect(m_tour, &QPushButton::clicked, this, [this] { begin(Task::PlaceTour); });
    connect(m_checkButton, &QPushButton::clicked, this, [this] { begin(Task::PlaceCheck); });
    connect(m_measure, &QPushButton::clicked, this, [this] { begin(Task::Source); });
    connect(m_placeBox->useButton(), &QPushButton::clicked, this, &RigPanel::usePlace);
    connect(m_sourceBox->useButton(), &QPushButton::clicked, this, &RigPanel::useSource);
    connect(m_follow, &QCheckBox::clicked, this, &RigPanel::followWanted);
    connect(m_bar, &SurveyBar::moveWanted, this, &RigPanel::moveWanted);
    connect(m_bar, &SurveyBar::holdWanted, this, &RigPanel::holdWanted);
    connect(m_bar, &SurveyBar::finished, this, &RigPanel::solve);
    connect(m_bar, &SurveyBar::cancelled, this, [this] {
        m_solving.forget();
        m_task = Task::None;
        showEnabled();
    });
    retranslate();
}

RigPanel::~RigPanel() = default;

QWidget* RigPanel::buildPlace() {
    auto* part = new QWidget(this);
    auto* buttons = new QHBoxLayout;
    for (QPushButton* button : {m_here, m_tour, m_checkButton})
        buttons->addWidget(button);
    auto* layout = new QVBoxLayout(part);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_placeTitle);
    layout->addWidget(m_placeHint);
    layout->addLayout(buttons);
    layout->addWidget(m_placeBox);
    return part;
}

QWidget* RigPanel::buildSource() {
    auto* part = new QWidget(this);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_measure);
    buttons->addStretch(1);
    auto* layout = new QVBoxLayout(part);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_sourceTitle);
    layout->addWidget(m_sourceHint);
    layout->addLayout(buttons);
    layout->addWidget(m_sourceBox);
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
    if (m_bar->isBusy())
        m_bar->cancel();
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
        m_bar->addFrame(view.frame->time_s, frame);
    }
    showEnabled();
}

void RigPanel::setRobot(const Vector6d& coordinates, bool isMoving, bool mayMove) {
    m_robot = coordinates;
    m_mayMove = mayMove;
    m_bar->setRobot(coordinates, isMoving, mayMove);
    showEnabled();
}

void RigPanel::begin(Task task) {
    m_task = task;
    if (task == Task::PlaceTour) {
        m_bar->begin(surveyPoses(*rigGeometry(m_experiment), m_robot), kFramesOnTour);
    } else if (task == Task::PlaceCheck) {
        // Neither a pose of the tour nor the one where it is.
        const Vector6d first = surveyPoses(*rigGeometry(m_experiment), m_robot).front();
        m_bar->begin({0.6 * first + 0.4 * m_robot}, kFramesHere);
    } else {
        m_bar->begin({}, kFramesHere);
    }
    showEnabled();
    emit attentionWanted(m_bar->cancelButton());
}

void RigPanel::solve() {
    const Task task = m_task;
    if (task == Task::PlaceCheck && !m_bar->survey().hasMoved()) {
        m_bar->cancel();
        return m_bar->say(tr("The robot did not move: nothing was checked."));
    }
    const auto work = [task, views = m_bar->survey().views(), layout = markerLayout(m_experiment.vision),
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
    m_solving.run(work, [this, task](Outcome outcome) { take(task, std::move(outcome)); });
}

void RigPanel::take(Task task, Outcome outcome) {
    m_task = Task::None;
    m_bar->end(outcome.trouble.code == MessageCode::None ? QString() : sentenceText(outcome.trouble));
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
        emit moveWanted(m_bar->survey().start());
    showPlace();
    showSource();
    showEnabled();
    emit attentionWanted(!m_bar->sentence().isEmpty() ? m_bar->statusLabel()
                         : task == Task::Source       ? m_sourceBox->textLabel()
                                                      : m_placeBox->textLabel());
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

void RigPanel::showPlace() {
    const VisionSpec& vision = m_experiment.vision;
    if (!m_place) {
        m_placeBox->showState(vision.cameraPose ? tr("In use") : tr("Not measured"),
                              vision.cameraPose ? tr("The camera stands at %1, measured %2.")
                                                      .arg(poseWords(poseFromCoordinates(*vision.cameraPose)),
                                                           ageText(vision.cameraPoseDate))
                                                : QString());
        return;
    }
    const PoseSpread& spread = m_placeSpread;
    int used = 0;
    for (const HandEyeResidual& view : m_place->views)
        used += view.isUsed ? 1 : 0;
    QStringList lines{
        tr("The camera stands at %1.").arg(poseWords(m_place->X_RC)),
        tr("What it sees at the source is known to \u00b1%1 and \u00b1%2 (two standard deviations), by %3 "
           "pose(s) of the robot; residual %4 px.")
            .arg(millimetres(spread.position_m, 2), degrees(spread.angle_rad))
            .arg(used)
            .arg(plainNumber(m_place->rms_px, 2))};
    if (m_place->views.size() > 1)
        lines << tr("The robot says where it is to %1 and %2 (one standard deviation).")
                     .arg(millimetres(m_place->robot_m, 2), degrees(m_place->robot_rad));
    for (const Message& remark : m_place->remarks)
        lines << sentenceText(remark);
    if (m_check)
        lines << tr("Checked at another pose: %1 and %2 off; up to %3 and %4 was to be expected.")
                     .arg(millimetres(m_check->difference.distance_m, 2),
                          degrees(m_check->difference.angle_rad),
                          millimetres(m_check->expected.position_m, 2), degrees(m_check->expected.angle_rad));
    m_placeBox->showVerdict(verdictOn(spread), isPlaceUsed(), lines);
}

void RigPanel::showSource() {
    const Pose configured = poseFromCoordinates(m_experiment.source.pose);
    if (!m_source) {
        const std::string& date = m_experiment.vision.sourcePoseDate;
        m_sourceBox->showState(
            date.empty() ? tr("As typed") : tr("In use"),
            date.empty()
                ? tr("The source lies at %1.").arg(poseWords(configured))
                : tr("The source lies at %1, measured %2.").arg(poseWords(configured), ageText(date)));
        return;
    }
    const Judgement judgement = judged(*m_source);
    const bool isUsed = isSourceUsed();
    const PoseDifference off = differenceBetween(configured, m_X_RS);
    QStringList lines{sentenceText(judgement.reason),
                      tr("The end-effector in the source: %1.").arg(poseWords(m_source->X_AB)),
                      tr("The source in the robot's base: %1.").arg(poseWords(m_X_RS))};
    if (!isUsed)
        lines << tr("That is %1 and %2 from where the experiment has it.")
                     .arg(millimetres(off.distance_m), degrees(off.angle_rad));
    for (const PartPose* part : {&m_source->a, &m_source->b})
        for (const Message& remark : part->remarks)
            lines << sentenceText(remark);
    m_sourceBox->showVerdict(judgement.verdict, isUsed, lines);
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
    m_placeBox->useButton()->setEnabled(m_place && m_mayMove && !isPlaceUsed());
    m_sourceBox->useButton()->setEnabled(m_source && m_mayMove && !isSourceUsed());
    m_bar->sayReason(reason);
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
    m_placeBox->useButton()->setText(tr("Use this p&lace"));
    m_sourceTitle->setText(tr("Where the source is"));
    m_sourceHint->setText(tr("By the markers on the source and on the end-effector, seen in the same "
                             "pictures."));
    m_measure->setText(tr("&Measure"));
    m_sourceBox->useButton()->setText(tr("&Use this pose"));
    m_follow->setText(tr("Follow the source &during runs"));
    m_follow->setToolTip(
        tr("The camera tells the controllers where the source is. Takes markers on the source, "
           "a calibrated camera and its place."));
    showPlace();
    showSource();
    showEnabled();
}

void RigPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

} // namespace bask
