#include "widgets/calibrate/camera_result.h"

#include "engine/calibration/camera_file.h"
#include "widgets/calibrate/pose_words.h"
#include "widgets/common/display.h"
#include "widgets/common/floating_place.h"
#include "widgets/common/labels.h"
#include "widgets/common/theme.h"

#include <QCoreApplication>
#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QTableWidget>

#include <algorithm>
#include <array>
#include <cmath>

namespace bask {
namespace {

constexpr int kResultIcon = 20;

// Digits as the deviation allows: "1000.34" and "0.21".
QString valueText(double value, double deviation, bool isLength) {
    const int digits = deviation > 0.0
                           ? std::clamp(1 - static_cast<int>(std::floor(std::log10(deviation))), 0, 6)
                           : (isLength ? 2 : 5);
    return plainNumber(value, digits);
}

// But for the residuals of its views, which an experiment does not keep.
bool isSame(CameraModel a, CameraModel b) {
    a.views.clear();
    b.views.clear();
    return openCvYaml(a) == openCvYaml(b);
}

} // namespace

QString verdictWord(Verdict verdict) {
    switch (verdict) {
    case Verdict::Good:
        return CameraResult::tr("Good");
    case Verdict::Usable:
        return CameraResult::tr("Usable");
    case Verdict::Redo:
        return CameraResult::tr("Redo");
    }
    return {};
}

CameraResult::CameraResult(QWidget* parent)
    : QWidget(parent), m_icon(new QLabel(this)), m_verdict(new QLabel(this)), m_reason(new QLabel(this)),
      m_facts(new QLabel(this)), m_numbers(new QTableWidget(this)), m_use(new QPushButton(this)),
      m_save(new QPushButton(this)), m_load(new QPushButton(this)) {
    m_verdict->setObjectName("cameraVerdict");
    m_verdict->setProperty(kKeptFree_px, kWholeWidget_px);
    m_reason->setObjectName("cameraReason");
    m_facts->setObjectName("cameraFacts");
    m_numbers->setObjectName("cameraNumbers");
    m_use->setObjectName("cameraUse");
    m_save->setObjectName("cameraSave");
    m_load->setObjectName("cameraLoad");
    makeBold(m_verdict, 1.2);
    for (QLabel* label : {m_reason, m_facts}) {
        label->setWordWrap(true);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    }
    m_numbers->setColumnCount(3);
    m_numbers->verticalHeader()->hide();
    m_numbers->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_numbers->setTabKeyNavigation(false);
    m_numbers->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    m_numbers->setShowGrid(false);

    auto* head = new QHBoxLayout;
    head->addWidget(m_icon);
    head->addWidget(m_verdict, 1);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_use, 2);
    buttons->addWidget(m_save, 1);
    buttons->addWidget(m_load, 1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(head);
    layout->addWidget(m_reason);
    layout->addWidget(m_facts);
    layout->addWidget(m_numbers);
    layout->addLayout(buttons);
    connect(m_use, &QPushButton::clicked, this, &CameraResult::useClicked);
    connect(m_save, &QPushButton::clicked, this, &CameraResult::saveClicked);
    connect(m_load, &QPushButton::clicked, this, &CameraResult::loadClicked);
    showAll();
}

void CameraResult::setCalibration(const CameraCalibration& calibration) {
    m_calibration = calibration;
    m_camera = calibration.camera;
    m_file.clear();
    showAll();
}

void CameraResult::setCamera(const CameraModel& camera, const QString& file) {
    m_calibration.reset();
    m_camera = camera;
    m_file = file;
    showAll();
}

void CameraResult::clear() {
    m_calibration.reset();
    m_camera = m_inUse;
    m_file.clear();
    showAll();
}

void CameraResult::setDistance(double distance_m) {
    m_distance_m = distance_m;
    showAll();
}

void CameraResult::setInUse(const std::optional<CameraModel>& camera) {
    m_inUse = camera;
    showAll();
}

std::optional<Verdict> CameraResult::verdict() const {
    return m_calibration ? std::optional(judged(*m_calibration, m_distance_m).verdict) : std::nullopt;
}

QString CameraResult::factsText() const {
    QStringList facts;
    if (m_calibration)
        facts << tr("%1 views").arg(m_camera->views.size());
    if (m_camera->width > 0)
        facts << tr("%1 \u00d7 %2 pixels").arg(m_camera->width).arg(m_camera->height);
    if (m_camera->rms_px)
        facts << tr("residual %1 px").arg(plainNumber(*m_camera->rms_px, 2));
    if (m_calibration && m_calibration->heldOut_px)
        facts << tr("held-out views %1 px").arg(plainNumber(*m_calibration->heldOut_px, 2));
    return facts.join(QStringLiteral(", "));
}

void CameraResult::showVerdict() {
    const bool isUsed = m_camera && m_inUse && isSame(*m_camera, *m_inUse);
    QString head, reason;
    int priority = 0;
    if (m_calibration) {
        const Judgement judgement = judged(*m_calibration, m_distance_m);
        head = verdictWord(judgement.verdict);
        reason = tr("%1.").arg(sentenceText(judgement.reason));
        priority = judgement.verdict == Verdict::Redo ? 2 : judgement.verdict == Verdict::Usable ? 3 : 0;
    } else if (m_camera) {
        head = m_file.isEmpty() ? tr("The camera in use") : m_file;
        if (!m_file.isEmpty())
            reason = tr("Read from a file: how far it holds was not checked here.");
    } else {
        head = tr("No camera yet");
        reason = tr("Calibrate it by views of a board, or load its file.");
    }
    if (isUsed && (m_calibration || !m_file.isEmpty()))
        head = tr("%1, in use").arg(head);
    m_verdict->setText(head);
    m_reason->setText(reason);
    m_reason->setVisible(!reason.isEmpty());
    m_icon->setVisible(priority > 0);
    if (priority > 0)
        m_icon->setPixmap(alarmPixmap(priority, isDark(this), kResultIcon, devicePixelRatioF()));
    const bool isUsable = m_camera && !(m_calibration && m_calibration->reasonAgainst());
    m_use->setEnabled(isUsable && !isUsed);
    m_save->setEnabled(isUsable);
}

void CameraResult::showNumbers() {
    m_numbers->setVisible(m_camera.has_value());
    m_facts->setVisible(m_camera.has_value());
    if (!m_camera)
        return;
    m_facts->setText(factsText());
    static constexpr std::array kParameters{"fx", "fy", "cx", "cy", "k1", "k2",
                                            "p1", "p2", "k3", "k4", "k5", "k6"};
    std::vector<double> values{m_camera->fx, m_camera->fy, m_camera->cx, m_camera->cy};
    values.insert(values.end(), m_camera->distortion.begin(), m_camera->distortion.end());
    m_numbers->setRowCount(static_cast<int>(values.size()));
    for (std::size_t k = 0; k < values.size(); ++k) {
        const bool isLength = k < 4;
        const double deviation = k < m_camera->deviations.size() ? m_camera->deviations[k] : 0.0;
        const QString unit = isLength ? tr("%1 px") : QStringLiteral("%1");
        const QStringList texts{QString::fromLatin1(kParameters[k]),
                                unit.arg(valueText(values[k], deviation, isLength)),
                                deviation > 0.0 ? QStringLiteral("\u00b1\u00a0") +
                                                      unit.arg(valueText(deviation, deviation, isLength))
                                                : kNoValue};
        for (int column = 0; column < 3; ++column) {
            auto* item = new QTableWidgetItem(texts[column]);
            item->setTextAlignment(column == 0 ? Qt::AlignLeft | Qt::AlignVCenter
                                               : Qt::AlignRight | Qt::AlignVCenter);
            m_numbers->setItem(static_cast<int>(k), column, item);
        }
    }
    const int row = fontMetrics().height() + 4;
    m_numbers->verticalHeader()->setDefaultSectionSize(row);
    m_numbers->setFixedHeight(m_numbers->horizontalHeader()->sizeHint().height() +
                              row * static_cast<int>(values.size()) + 2 * m_numbers->frameWidth());
}

void CameraResult::showAll() {
    m_numbers->setHorizontalHeaderLabels({tr("Parameter"), tr("Value"), tr("Standard deviation")});
    m_numbers->setAccessibleName(tr("Parameters of the camera"));
    m_use->setText(tr("&Use this camera"));
    m_use->setToolTip(tr("Poses of markers are computed by it from now on."));
    m_save->setText(tr("Save\u2026"));
    m_save->setAccessibleName(tr("Save the camera in a file"));
    m_load->setText(tr("Load\u2026"));
    m_load->setAccessibleName(tr("Load a camera from a file"));
    showVerdict();
    showNumbers();
}

void CameraResult::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
        showAll();
    QWidget::changeEvent(event);
}

} // namespace bask
