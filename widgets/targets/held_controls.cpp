#include "widgets/targets/held_controls.h"

#include "widgets/common/verdict_words.h"
#include "widgets/targets/coordinate_slider.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>

#include <algorithm>

namespace bask {

HeldControls::HeldControls(QWidget* parent)
    : QWidget(parent), m_play(new QToolButton(this)), m_atPose(new QPushButton(this)) {
    static constexpr std::array<const char*, 6> kNames{"X", "Y", "Z", "ThetaX", "ThetaY", "ThetaZ"};
    m_play->setObjectName("playSweep");
    m_play->setCheckable(true);
    m_play->setArrowType(Qt::RightArrow);
    m_play->setFocusPolicy(Qt::StrongFocus);
    m_atPose->setObjectName("heldAtPose");
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_play);
    for (int k = 0; k < 6; ++k) {
        const QString name = QString::fromLatin1(kNames.at(static_cast<std::size_t>(k)));
        Cell cell{new QBoxLayout(QBoxLayout::LeftToRight), new QLabel(this), new CoordinateSlider(this)};
        cell.word->setObjectName(QStringLiteral("heldWord") + name);
        cell.word->setBuddy(cell.slider);
        cell.slider->setObjectName(QStringLiteral("held") + name);
        cell.layout->setSpacing(4);
        cell.layout->addWidget(cell.word);
        cell.layout->addWidget(cell.slider, 1);
        row->addLayout(cell.layout);
        connect(cell.slider, &QSlider::valueChanged, this, [this, k, slider = cell.slider] {
            showWord(k, slider->place());
            emit fixedManually(k, slider->place());
        });
        m_cells.at(static_cast<std::size_t>(k)) = cell;
    }
    row->addWidget(m_atPose);
    connect(m_play, &QToolButton::toggled, this, &HeldControls::playWanted);
    connect(m_atPose, &QPushButton::clicked, this, &HeldControls::poseWanted);
    setCoordinates({}, {});
    retranslate();
}

void HeldControls::setCoordinates(const std::vector<Coordinate>& coordinates, const RobotLimits& robot) {
    for (int k = 0; k < 6; ++k) {
        const Cell& cell = m_cells.at(static_cast<std::size_t>(k));
        const bool is = std::ranges::find(coordinates, k) != coordinates.end();
        static_cast<QBoxLayout*>(layout())->setStretchFactor(cell.layout, is ? 1 : 0);
        cell.word->setVisible(is);
        cell.slider->setVisible(is);
        // Of several, each has its word above it.
        cell.layout->setDirection(coordinates.size() > 1 ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
        const QSignalBlocker quiet(cell.slider);
        cell.slider->setCoordinate(k, robot.lower[k], robot.upper[k]);
    }
    setVisible(!coordinates.empty());
}

void HeldControls::setFixed(const Vector6d& fixed, bool isManual) {
    for (int k = 0; k < 6; ++k) {
        CoordinateSlider* slider = m_cells.at(static_cast<std::size_t>(k)).slider;
        const QSignalBlocker quiet(slider);
        slider->setPlace(fixed[k]);
        showWord(k, fixed[k]);
    }
    m_atPose->setEnabled(isManual);
}

void HeldControls::setPlaying(bool playing) {
    const QSignalBlocker quiet(m_play);
    m_play->setChecked(playing);
}

void HeldControls::showWord(int coordinate, double value) {
    QLabel* word = m_cells.at(static_cast<std::size_t>(coordinate)).word;
    word->setText(coordinateText(coordinate, value));
    // As wide as its widest, so that the slider does not move under the pointer.
    const QFontMetrics metrics(word->font());
    word->setMinimumWidth(
        metrics.horizontalAdvance(coordinateText(coordinate, coordinate < kThetaX ? -0.288 : -1.5)));
}

void HeldControls::retranslate() {
    m_play->setAccessibleName(tr("Play"));
    m_play->setToolTip(tr("Play the surfaces through the robot's range of the value held, in nine steps."));
    m_atPose->setText(tr("As at the pose"));
    m_atPose->setToolTip(tr("Draw the surfaces at the values of the pose that was found."));
    for (int k = 0; k < 6; ++k)
        m_cells.at(static_cast<std::size_t>(k))
            .slider->setAccessibleName(
                k < kThetaX ? tr("Position at which the surfaces are drawn: %1").arg(axisName(k))
                            : tr("Angle at which the surfaces are drawn: %1").arg(axisName(k)));
}

void HeldControls::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

} // namespace bask
