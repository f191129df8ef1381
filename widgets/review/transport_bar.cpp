#include "widgets/review/transport_bar.h"

#include "widgets/common/display.h"
#include "widgets/common/labels.h"
#include "widgets/common/theme.h"

#include <QComboBox>
#include <QEvent>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QStyle>

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

constexpr int kTick_ms = 40;
constexpr double kSpeeds[] = {0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0};
constexpr int kIcon = 16;

/// A click goes where it points, not a page further.
class PositionSlider : public QSlider {
public:
    using QSlider::QSlider;

protected:
    void mousePressEvent(QMouseEvent* event) override {
        if (event->button() == Qt::LeftButton) {
            const int handle = style()->pixelMetric(QStyle::PM_SliderLength, nullptr, this);
            setValue(QStyle::sliderValueFromPosition(minimum(), maximum(), event->pos().x() - handle / 2,
                                                     width() - handle));
        }
        QSlider::mousePressEvent(event); // the handle is under the mouse now
    }
};

enum class Sign { Play, Pause, Replay };

QPixmap drawn(Sign sign, const QColor& colour, double devicePixelRatio) {
    QPixmap pixmap(QSize(kIcon, kIcon) * devicePixelRatio);
    pixmap.setDevicePixelRatio(devicePixelRatio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    if (sign == Sign::Replay) { // an arrow that goes round, with a triangle in it
        painter.setPen(QPen(colour, 1.6, Qt::SolidLine, Qt::RoundCap));
        painter.drawArc(QRectF(2, 2, 12, 12), 130 * 16, 320 * 16);
        painter.drawPolyline(QPolygonF{{2.2, 1.6}, {3.9, 4.4}, {7.0, 3.4}});
        painter.setPen(Qt::NoPen);
        painter.setBrush(colour);
        painter.drawPolygon(QPolygonF{{6.4, 5.2}, {6.4, 10.8}, {11.0, 8.0}});
        return pixmap;
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    if (sign == Sign::Play) {
        painter.drawPolygon(QPolygonF{{4, 2.5}, {4, 13.5}, {13.5, 8}});
    } else {
        painter.drawRect(QRectF(3.5, 2.5, 3, 11));
        painter.drawRect(QRectF(9.5, 2.5, 3, 11));
    }
    return pixmap;
}

int milliseconds(double time_s) {
    return static_cast<int>(std::lround(std::clamp(time_s, -2e6, 2e6) * 1e3));
}

} // namespace

TransportBar::TransportBar(const Clock& clock, QWidget* parent)
    : QWidget(parent), m_replay(clock), m_tag(new QFrame(this)), m_tagIcon(new QLabel(m_tag)),
      m_tagWord(new QLabel(m_tag)), m_play(new QPushButton(this)),
      m_slider(new PositionSlider(Qt::Horizontal, this)), m_time(new QLabel(this)),
      m_speedLabel(new QLabel(this)), m_speed(new QComboBox(this)) {
    m_tag->setObjectName(QStringLiteral("replayTag"));
    auto* tagRow = new QHBoxLayout(m_tag);
    tagRow->setContentsMargins(8, 3, 10, 3);
    tagRow->setSpacing(6);
    tagRow->addWidget(m_tagIcon);
    tagRow->addWidget(m_tagWord);
    m_play->setObjectName(QStringLiteral("replayPlay"));
    m_slider->setObjectName(QStringLiteral("replaySlider"));
    m_slider->setSingleStep(1000);
    m_slider->setPageStep(10000);
    m_slider->setMinimumWidth(90);
    m_time->setObjectName(QStringLiteral("replayTime"));
    m_time->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_speed->setObjectName(QStringLiteral("replaySpeed"));
    for (const double speed : kSpeeds)
        m_speed->addItem(QString(), speed);
    m_speed->setCurrentIndex(m_speed->findData(1.0));
    m_speedLabel->setBuddy(m_speed);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    row->addWidget(m_tag);
    row->addWidget(m_play);
    row->addWidget(m_slider, 1);
    row->addWidget(m_time);
    row->addWidget(m_speedLabel);
    row->addWidget(m_speed);

    m_timer.setInterval(kTick_ms);
    connect(&m_timer, &QTimer::timeout, this, &TransportBar::tick);
    connect(m_play, &QPushButton::clicked, this, &TransportBar::togglePlay);
    connect(m_slider, &QSlider::valueChanged, this, [this](int value_ms) {
        m_replay.seek(value_ms / 1e3);
        showPosition();
    });
    connect(m_speed, &QComboBox::currentIndexChanged, this,
            [this](int index) { m_replay.setSpeed(m_speed->itemData(index).toDouble()); });
    retranslate();
    restyle();
}

void TransportBar::setSpan(double begin_s, double end_s) {
    m_timer.stop();
    m_replay.setSpan(begin_s, end_s);
    {
        const QSignalBlocker quiet(m_slider);
        m_slider->setRange(milliseconds(m_replay.begin_s()), milliseconds(m_replay.end_s()));
    }
    const QString longest = formatDuration(m_replay.end_s());
    m_time->setMinimumWidth(m_time->fontMetrics().horizontalAdvance(QStringLiteral("%1 / %1").arg(longest)) +
                            4);
    setEnabled(m_replay.end_s() > m_replay.begin_s());
    showPosition();
}

void TransportBar::seek(double time_s) {
    m_replay.seek(time_s);
    showPosition();
}

void TransportBar::togglePlay() {
    if (m_replay.isPlaying())
        return pause();
    if (!isEnabled())
        return;
    m_replay.play();
    m_timer.start();
    showPosition();
}

void TransportBar::pause() {
    m_replay.pause();
    m_timer.stop();
    showPosition();
}

void TransportBar::tick() {
    if (m_replay.isPlaying())
        showPosition();
    else
        pause(); // at the end
}

void TransportBar::showPosition() {
    const double position_s = m_replay.position_s();
    {
        const QSignalBlocker quiet(m_slider); // a drag sets its value by itself
        if (!m_slider->isSliderDown())
            m_slider->setValue(milliseconds(position_s));
    }
    m_time->setText(
        QStringLiteral("%1 / %2").arg(formatDuration(position_s), formatDuration(m_replay.end_s())));
    sayWithText(m_time, tr("Position and length of the run"));
    showButton();
    emit moved(position_s);
}

void TransportBar::showButton() {
    const bool isPlaying = m_timer.isActive();
    const QString word = isPlaying ? tr("Pause") : tr("Play");
    if (m_play->text() == word)
        return;
    m_play->setText(word);
    m_play->setIcon(QIcon(drawn(isPlaying ? Sign::Pause : Sign::Play, palette().color(QPalette::ButtonText),
                                devicePixelRatioF())));
}

void TransportBar::retranslate() {
    m_tagWord->setText(tr("REPLAY"));
    m_tag->setToolTip(tr("What is shown here was recorded: nothing moves or heats by it."));
    m_tag->setAccessibleName(m_tagWord->text());
    m_play->setMinimumWidth(0);
    for (const QString& word : {tr("Pause"), tr("Play")}) { // as wide as the longer one: nothing shall jump
        m_play->setText(word);
        m_play->setIcon(QIcon(drawn(Sign::Play, Qt::black, 1.0)));
        m_play->setMinimumWidth(std::max(m_play->minimumWidth(), m_play->sizeHint().width()));
    }
    m_play->setText({});
    m_play->setToolTip(tr("Space, while nothing else on the page takes it"));
    m_slider->setAccessibleName(tr("Position in the run"));
    sayWithText(m_time, tr("Position and length of the run"));
    m_speedLabel->setText(tr("Speed"));
    m_speed->setAccessibleName(tr("Speed of the replay"));
    for (int i = 0; i < m_speed->count(); ++i)
        m_speed->setItemText(
            i, QStringLiteral("%1\u00d7").arg(QLocale().toString(m_speed->itemData(i).toDouble())));
    showButton();
}

void TransportBar::restyle() {
    const bool dark = isDark(this);
    const QColor colour = accentColor(dark);
    m_tag->setStyleSheet(QStringLiteral("#replayTag { border: 2px dotted %1; border-radius: 5px; } "
                                        "#replayTag QLabel { color: %1; font-weight: 600; }")
                             .arg(colour.name()));
    m_tagIcon->setPixmap(drawn(Sign::Replay, colour, devicePixelRatioF()));
    m_speedLabel->setPalette(captionPalette(palette()));
    m_play->setText({});
    showButton();
}

void TransportBar::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    if (m_timer.isActive())
        pause();
}

void TransportBar::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    else if (event->type() == QEvent::PaletteChange)
        restyle();
}

} // namespace bask
