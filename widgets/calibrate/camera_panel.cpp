#include "widgets/calibrate/camera_panel.h"

#include "engine/base/message_code.h"
#include "engine/base/whole_file.h"
#include "engine/calibration/camera_file.h"
#include "widgets/calibrate/board_form.h"
#include "widgets/calibrate/camera_result.h"
#include "widgets/calibrate/coverage_view.h"
#include "widgets/calibrate/view_list.h"
#include "widgets/common/display.h"
#include "widgets/common/file_folders.h"
#include "widgets/common/floating_place.h"
#include "widgets/common/labels.h"
#include "widgets/common/message_bar.h"

#include <QCheckBox>
#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QImage>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>

namespace bask {
namespace {

constexpr int kCoefficients = 5;

QImage thumbnailOf(const GreyPicture& picture) {
    return QImage(picture.values.data(), picture.width, picture.height, picture.width,
                  QImage::Format_Grayscale8)
        .scaled(ViewList::kPictureWidth, ViewList::kPictureHeight, Qt::KeepAspectRatio,
                Qt::SmoothTransformation);
}

std::string sizeText(int width, int height) {
    return std::to_string(width) + " x " + std::to_string(height);
}

} // namespace

CameraPanel::CameraPanel(QWidget* parent)
    : QWidget(parent), m_board(new BoardForm(this)), m_start(new QPushButton(this)),
      m_automatic(new QCheckBox(this)), m_take(new QPushButton(this)), m_status(new QLabel(this)),
      m_message(new MessageBar(this)), m_coverage(new CoverageView(this)), m_list(new ViewList(this)),
      m_leaveOut(new QPushButton(this)), m_again(new QPushButton(this)), m_solve(new QPushButton(this)),
      m_progress(new QProgressBar(this)), m_cancel(new QPushButton(this)), m_result(new CameraResult(this)),
      m_boardTitle(boldLabel(this)), m_viewsTitle(boldLabel(this)), m_resultTitle(boldLabel(this)) {
    m_start->setObjectName("captureStart");
    m_start->setCheckable(true);
    m_automatic->setObjectName("captureAutomatic");
    m_automatic->setChecked(true);
    m_take->setObjectName("captureTake");
    m_status->setObjectName("captureStatus");
    m_status->setWordWrap(true);
    m_status->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_status->setMinimumHeight(2 * fontMetrics().lineSpacing()); // what is said does not move the buttons
    m_again->setObjectName("captureAgain");
    m_message->setObjectName("cameraMessage");
    m_leaveOut->setObjectName("leaveOut");
    m_solve->setObjectName("solve");
    m_progress->setObjectName("solveProgress");
    m_progress->setTextVisible(false);
    m_progress->setFixedHeight(10);
    m_cancel->setObjectName("solveCancel");
    m_list->setMinimumHeight(130);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(10);
    new FloatingPlace(*m_message, *this);
    for (QWidget* part : {buildBoard(), buildCapture(), buildViews(), buildResult()})
        layout->addWidget(part);
    layout->addStretch(1);
    connectAll();
    m_progress->hide();
    m_cancel->hide();
    m_leaveOut->hide();
    retranslate();
}

CameraPanel::~CameraPanel() = default;

QWidget* CameraPanel::buildBoard() {
    auto* part = new QWidget(this);
    auto* layout = new QVBoxLayout(part);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_boardTitle);
    layout->addWidget(m_board);
    return part;
}

QWidget* CameraPanel::buildCapture() {
    auto* part = new QWidget(this);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_start, 1);
    buttons->addWidget(m_take, 1);
    auto* layout = new QVBoxLayout(part);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_viewsTitle);
    layout->addLayout(buttons);
    layout->addWidget(m_automatic);
    layout->addWidget(m_status);
    layout->addWidget(m_coverage);
    return part;
}

QWidget* CameraPanel::buildViews() {
    auto* part = new QWidget(this);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_solve, 1);
    buttons->addWidget(m_cancel, 1);
    buttons->addWidget(m_again, 1);
    auto* layout = new QVBoxLayout(part);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_list);
    layout->addWidget(m_leaveOut);
    layout->addLayout(buttons);
    layout->addWidget(m_progress);
    return part;
}

QWidget* CameraPanel::buildResult() {
    auto* part = new QWidget(this);
    auto* layout = new QVBoxLayout(part);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_resultTitle);
    layout->addWidget(m_result);
    return part;
}

void CameraPanel::connectAll() {
    connect(m_board, &BoardForm::changed, this, &CameraPanel::changeBoard);
    connect(m_start, &QPushButton::toggled, this, &CameraPanel::capture);
    connect(m_take, &QPushButton::clicked, this, &CameraPanel::take);
    connect(m_again, &QPushButton::clicked, this, &CameraPanel::startAgain);
    connect(m_message, &MessageBar::actionClicked, this, [this] {
        if (m_other)
            setBoard(*m_other);
    });
    connect(m_coverage, &CoverageView::mapWanted, this, &CameraPanel::showViews);
    connect(m_list, &ViewList::usedChanged, this, [this](int view, bool isUsed) {
        m_collector->setUsed(static_cast<std::size_t>(view), isUsed);
        showViews();
        if (m_cameraWanted)
            solve();
    });
    connect(m_leaveOut, &QPushButton::clicked, this, &CameraPanel::leaveOut);
    connect(m_solve, &QPushButton::clicked, this, [this] {
        m_isAsked = true;
        solve();
    });
    connect(m_cancel, &QPushButton::clicked, this, &CameraPanel::cancel);
    connect(m_result, &CameraResult::useClicked, this, [this] { emit cameraChosen(*m_result->camera()); });
    connect(m_result, &CameraResult::saveClicked, this, &CameraPanel::askWhereToSave);
    connect(m_result, &CameraResult::loadClicked, this, &CameraPanel::askWhatToLoad);
}

// -- the board and its views -----------------------------------------------------------------------------

bool CameraPanel::isCapturing() const {
    return m_start->isChecked();
}

void CameraPanel::setBoard(const Board& board) {
    m_board->setBoard(board);
    changeBoard();
}

void CameraPanel::changeBoard() {
    startAgain();
    if (isCapturing())
        capture(true);
}

void CameraPanel::startAgain() {
    cancel();
    m_collector.reset();
    m_other.reset();
    m_message->clear();
    m_list->clear();
    m_outstanding.clear();
    showViews();
    retranslate();
}

void CameraPanel::changeCamera() {
    startAgain();
    m_view = {};
    m_take->setEnabled(false);
    m_result->clear();
}

void CameraPanel::capture(bool on) {
    const Result<Board> board = m_board->board();
    if (on && !board) {
        m_message->say(MessageBar::Kind::Problem, messageText(board.error().message));
        const QSignalBlocker quiet(m_start);
        m_start->setChecked(false);
    }
    if (m_collector)
        m_collector->lookedInVain();
    m_status->clear();
    emit boardWanted(isCapturing() ? std::optional(*board) : std::nullopt);
    retranslate();
}

void CameraPanel::setView(const VisionView& view) {
    if (!m_view.cameraName.empty() && view.cameraName != m_view.cameraName)
        changeCamera();
    const bool isNew = view.frame && (!m_view.frame || view.frame->number != m_view.frame->number);
    m_view = view;
    const bool answers = view.frame && view.problem.code == MessageCode::None;
    if (isCapturing() && !answers) {
        if (m_collector)
            m_collector->lookedInVain();
        sayStatus(tr("Waiting for the camera's pictures."));
    } else if (isCapturing() && isNew) {
        look();
    }
    m_take->setEnabled(isCapturing() && answers && view.board && view.board->ok());
}

// A collector for pictures of this size; false, and said, when its views have another.
bool CameraPanel::startCollector(const GreyPicture& picture) {
    if (!m_collector)
        m_collector.emplace(*m_board->board(), picture.width, picture.height);
    if (m_collector->width() == picture.width && m_collector->height() == picture.height)
        return true;
    sayStatus(messageText(
        {MessageCode::ViewSizeOther,
         {sizeText(picture.width, picture.height), sizeText(m_collector->width(), m_collector->height())}}));
    return false;
}

void CameraPanel::look() {
    const GreyPicture& picture = m_view.frame->picture;
    if (!startCollector(picture))
        return;
    if (m_view.boardSeen)
        m_collector->saw(*m_view.boardSeen);
    if (const auto other = m_collector->otherBoard(); other != m_other) {
        m_other = other;
        sayOther();
    }
    if (!m_view.board)
        return;
    if (!*m_view.board) {
        m_collector->lookedInVain();
        return sayStatus(tr("%1.").arg(sentenceText(m_view.board->error().message)));
    }
    if (!m_automatic->isChecked())
        return sayStatus(tr("The board is seen: hold it still and take the view."));
    switch (m_collector->look(**m_view.board, m_view.frame->time_s)) {
    case ViewCollector::Look::Useless:
        return sayStatus(tr("Too little of the board is seen for a view."));
    case ViewCollector::Look::Moving:
        return sayStatus(tr("Hold the board still."));
    case ViewCollector::Look::Known:
        return sayStatus(tr("There is such a view: move the board on."));
    case ViewCollector::Look::Kept:
        return added();
    }
}

void CameraPanel::take() {
    if (!startCollector(m_view.frame->picture))
        return;
    if (m_collector->keep(**m_view.board))
        added();
    else
        sayStatus(tr("Too little of the board is seen for a view."));
}

void CameraPanel::added() {
    m_list->add(thumbnailOf(m_view.frame->picture));
    showViews();
    sayStatus(tr("View %1 is taken: move the board on.").arg(m_list->count()));
    if (m_cameraWanted)
        solve();
}

void CameraPanel::showViews() {
    m_coverage->setCoverage(m_collector ? m_collector->coverage() : coverageOf({}));
    emit heatMapChanged(!m_coverage->isMapWanted() ? std::nullopt
                        : m_collector              ? std::optional(m_collector->heatMap())
                                                   : std::optional(HeatMap()));
    updateEnabled();
}

// -- the camera ------------------------------------------------------------------------------------------

void CameraPanel::solve() {
    std::vector<int> rows;
    for (int k = 0; k < m_list->count(); ++k)
        if (m_list->isUsed(k))
            rows.push_back(k);
    m_cameraWanted = true;
    const std::shared_ptr<FitProgress> progress(new FitProgress,
                                                [](QObject* object) { object->deleteLater(); });
    connect(progress.get(), &FitProgress::fitted, m_progress, [this](int done, int of) {
        m_progress->setRange(0, of);
        m_progress->setValue(done);
    });
    m_progress->setRange(0, 0);
    m_progress->show();
    m_cancel->show();
    m_solving.run(
        [views = m_collector->used(), board = m_collector->board(), width = m_collector->width(),
         height = m_collector->height(), progress](const std::stop_token& stop) {
            return calibrateCamera(views, board, width, height, kCoefficients, stop,
                                   [&](int done, int of) { emit progress->fitted(done, of); });
        },
        [this, rows](Result<CameraCalibration> result) { taken(std::move(result), rows); });
    updateEnabled();
}

void CameraPanel::cancel() {
    m_cameraWanted = false;
    m_solving.forget();
    m_progress->hide();
    m_cancel->hide();
    updateEnabled();
}

void CameraPanel::taken(Result<CameraCalibration> result, const std::vector<int>& rows) {
    m_progress->hide();
    m_cancel->hide();
    m_outstanding.clear();
    for (int k = 0; k < m_list->count(); ++k)
        m_list->setResidual(k, std::nullopt, false);
    if (!result) {
        m_message->say(MessageBar::Kind::Problem, messageText(result.error().message));
    } else {
        const std::vector<ViewResidual>& views = result->camera.views;
        for (std::size_t k = 0; k < rows.size(); ++k)
            m_list->setResidual(rows[k], views[k].rms_px, false);
        for (const std::size_t k : viewsStandingOut(views)) {
            m_outstanding.push_back(rows[k]);
            m_list->setResidual(rows[k], views[k].rms_px, true);
        }
        m_result->setCalibration(*result);
        if (std::exchange(m_isAsked, false))
            emit attentionWanted(m_result);
    }
    updateEnabled();
}

void CameraPanel::leaveOut() {
    const std::vector<int> views = std::exchange(m_outstanding, {});
    for (const int view : views)
        m_list->setUsed(view, false);
}

void CameraPanel::setDistance(double distance_m) {
    m_result->setDistance(distance_m);
}

void CameraPanel::setCamera(const std::optional<CameraModel>& camera) {
    m_result->setInUse(camera);
    if (camera && !m_result->camera())
        m_result->setCamera(*camera, {});
}

void CameraPanel::loadCamera(const QString& path) {
    m_loading.run([file = path.toStdString()] { return readCamera(file); },
                  [this, path](Result<CameraModel> camera) {
                      if (camera) {
                          m_message->clear();
                          return m_result->setCamera(*camera, QFileInfo(path).fileName());
                      }
                      m_message->say(
                          MessageBar::Kind::Problem,
                          tr("%1: %2").arg(QFileInfo(path).fileName(), messageText(camera.error().message)));
                      emit attentionWanted(m_message);
                  });
}

void CameraPanel::saveCamera(const QString& path, bool asRos) {
    const CameraModel& camera = *m_result->camera();
    m_saving.run(
        [path, text = asRos ? rosYaml(camera, "camera") : openCvYaml(camera)] {
            return writeWholeFile(path.toStdString(), text);
        },
        [this, path](Result<void> written) {
            if (written) {
                m_message->clear();
                return emit exported(tr("The camera is saved in %1.").arg(QFileInfo(path).fileName()),
                                     {path});
            }
            m_message->say(MessageBar::Kind::Problem, tr("%1: %2").arg(QFileInfo(path).fileName(),
                                                                       messageText(written.error().message)));
        });
}

void CameraPanel::askWhereToSave() {
    const QString openCv = tr("OpenCV YAML (%1)").arg("*.yml"),
                  ros = tr("ROS camera_info (%1)").arg("*.yaml");
    const bool isSizeKnown = m_result->camera()->width > 0; // which ROS wants
    QString chosen;
    const QString path = askFileToSave(this, tr("Save the camera"), QStringLiteral("camera.yml"),
                                       isSizeKnown ? openCv + QStringLiteral(";;") + ros : openCv,
                                       FileFolder::Imports, &chosen);
    if (!path.isEmpty())
        saveCamera(path, chosen == ros);
}

void CameraPanel::askWhatToLoad() {
    const QString path =
        askFileToOpen(this, tr("Load a camera"), tr("Cameras (%1);;All files (*)").arg("*.yml *.yaml"),
                      FileFolder::Imports);
    if (!path.isEmpty())
        loadCamera(path);
}

// -- words -----------------------------------------------------------------------------------------------

void CameraPanel::sayStatus(const QString& sentence) {
    if (m_status->text() != sentence)
        m_status->setText(sentence);
}

void CameraPanel::updateEnabled() {
    const std::size_t used = m_collector ? m_collector->coverage().views : 0;
    m_board->setEnabled(m_list->count() == 0);
    m_again->setEnabled(m_list->count() > 0);
    m_solve->setEnabled(used >= kMinCalibrationViews && !m_progress->isVisibleTo(this));
    m_leaveOut->setVisible(!m_outstanding.empty());
    m_take->setEnabled(m_take->isEnabled() && isCapturing());
}

void CameraPanel::retranslate() {
    m_boardTitle->setText(tr("Calibration board"));
    m_viewsTitle->setText(tr("Views"));
    m_resultTitle->setText(tr("Camera"));
    m_start->setText(isCapturing() ? tr("&Stop looking") : tr("&Start looking"));
    m_start->setToolTip(tr("Looks for the board in the live picture."));
    m_take->setText(tr("Ta&ke this view"));
    m_automatic->setText(tr("Take still, new views &automatically"));
    m_again->setText(tr("Start again"));
    m_again->setToolTip(tr("Drops all views. The board can be set again."));
    m_board->setToolTip(
        m_list->count() == 0 ? QString() : tr("The views are of this board: start again to set another."));
    m_solve->setText(tr("&Calibrate"));
    m_cancel->setText(tr("Cancel"));
    m_progress->setAccessibleName(tr("Progress of the calibration"));
    m_leaveOut->setText(tr("Leave &out the views that stand out"));
    if (!isCapturing())
        sayStatus(tr("Start looking, then show the board to the camera from near and far, at all edges of "
                     "the picture and "
                     "tilted to all sides."));
    setAccessibleName(tr("Calibration of the camera"));
    setWindowTitle(tr("Camera"));
    if (m_other)
        sayOther();
    updateEnabled();
}

void CameraPanel::sayOther() {
    if (!m_other)
        return m_message->clear();
    const Message message{MessageCode::BoardOther, {boardText(*m_other), boardText(m_collector->board())}};
    m_message->say(MessageBar::Kind::Problem, messageText(message), tr("Use the board seen"), false);
}

void CameraPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

} // namespace bask
