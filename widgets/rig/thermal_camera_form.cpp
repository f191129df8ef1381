#include "widgets/rig/thermal_camera_form.h"

#include "engine/model/coordinate_range.h"
#include "engine/thermography/usual_thermal_camera.h"
#include "widgets/common/coordinate_field.h"
#include "widgets/common/display.h"
#include "widgets/common/file_folders.h"
#include "widgets/common/labels.h"
#include "widgets/common/number_field.h"
#include "widgets/rig/coordinate_words.h"
#include "widgets/rig/profile_choice.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include <algorithm>
#include <cmath>

namespace bask {
namespace {} // namespace

ThermalCameraForm::ThermalCameraForm(QWidget* parent)
    : QWidget(parent), m_profile(new QComboBox(this)), m_file(new QPushButton(this)),
      m_isPoseKnown(new QCheckBox(this)), m_profileLabel(new QLabel(this)), m_hint(new QLabel(this)) {
    m_profile->setObjectName("thermalProfile");
    m_file->setObjectName("thermalProfileFile");
    m_file->setAutoDefault(false);
    m_isPoseKnown->setObjectName("poseKnown");
    m_hint->setWordWrap(true);
    auto* profile = new QHBoxLayout;
    profile->addWidget(m_profileLabel);
    profile->addWidget(m_profile, 1);
    profile->addWidget(m_file);
    auto* pose = new QGridLayout;
    for (int k = 0; k < 6; ++k) {
        const auto index = static_cast<std::size_t>(k);
        auto* field = new NumberField(this);
        field->setObjectName(coordinateObjectName("thermalPose", k));
        field->setDecimals(1);
        setCoordinateRange(*field, k, coordinateRange(k, kMaxPlace_cm, false));
        field->setSuffix(coordinateSymbol(k));
        m_names[index] = new QLabel(coordinateWord(k), this);
        m_pose[index] = field;
        const int column = 2 * (k % 3);
        pose->addWidget(m_names[index], k / 3, column, Qt::AlignRight);
        pose->addWidget(field, k / 3, column + 1);
        pose->setColumnStretch(column + 1, 1);
    }
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(profile);
    layout->addWidget(m_isPoseKnown);
    layout->addLayout(pose);
    layout->addWidget(m_hint);
    connect(m_file, &QPushButton::clicked, this, [this] {
        const QString path = askFileToOpen(this, tr("Take a profile from a file"), tr("Profiles (*.json)"),
                                           FileFolder::Imports);
        if (path.isEmpty())
            return;
        if (const QString problem = useProfileFile(path); !problem.isEmpty())
            emit failed(problem);
    });
    connect(m_isPoseKnown, &QCheckBox::toggled, this, [this](bool isKnown) {
        for (QDoubleSpinBox* field : m_pose)
            field->setEnabled(isKnown);
    });
    for (const ThermalProfile& each : shippedThermalProfiles())
        listAndChoose(*m_profile, m_profiles, each);
    ThermalCameraSpec usual;
    usual.profile = findThermalProfile("lepton-3.5").value();
    setCamera(usual);
    retranslate();
}

void ThermalCameraForm::setCamera(const ThermalCameraSpec& camera) {
    m_camera = camera;
    listAndChoose(*m_profile, m_profiles, camera.profile);
    const auto& known = camera.calibration.pose;
    m_isPoseKnown->setChecked(known.has_value());
    const Vector6d pose = known.value_or(coordinatesFromPose(usualThermalPose()));
    for (int k = 0; k < 6; ++k) {
        QDoubleSpinBox* field = m_pose[static_cast<std::size_t>(k)];
        field->setValue(shownCoordinate(k, pose[k]));
        field->setEnabled(known.has_value());
    }
}

ThermalCameraSpec ThermalCameraForm::camera() const {
    ThermalCameraSpec out = m_camera;
    out.profile = m_profiles.at(static_cast<std::size_t>(m_profile->currentIndex()));
    auto& [lens, lensDate, pose, poseDate, poseUncertainty_m] = out.calibration;
    const auto before = pose;
    if (out.profile != m_camera.profile) {
        lens.reset();
        lensDate.clear();
        poseDate.clear();
        poseUncertainty_m.reset();
    }
    pose.reset();
    if (m_isPoseKnown->isChecked()) {
        pose = before.value_or(Vector6d::Zero());
        for (int k = 0; k < 6; ++k) // what nobody changed keeps its digits
            if (const double shown = m_pose[static_cast<std::size_t>(k)]->value();
                !before || std::abs(shown - shownCoordinate(k, (*pose)[k])) > 0.051)
                (*pose)[k] = coordinateFromShown(k, shown);
    }
    if (pose != before) { // typed, not measured
        poseDate.clear();
        poseUncertainty_m.reset();
    }
    return out;
}

QString ThermalCameraForm::useProfileFile(const QString& path) {
    const auto profile = findThermalProfile(path.toStdString());
    if (!profile)
        return path + QStringLiteral(": ") + messageText(profile.error().message);
    listAndChoose(*m_profile, m_profiles, *profile);
    return {};
}

void ThermalCameraForm::retranslate() {
    m_profileLabel->setText(tr("Camera"));
    nameChoice(m_profile, tr("Kind of thermal camera"));
    m_file->setText(tr("From file…"));
    m_file->setToolTip(tr("Take what the camera's numbers mean from a file"));
    m_isPoseKnown->setText(tr("Its pose in the robot's base is known"));
    m_hint->setText(
        tr("The camera's axes: x right, y down, z along its view. Without its pose it shows pictures "
           "and reads no object."));
    for (int k = 0; k < 6; ++k)
        m_pose[static_cast<std::size_t>(k)]->setAccessibleName(
            tr("Pose of the camera, %1").arg(coordinateWord(k)));
}

void ThermalCameraForm::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

} // namespace bask
