#include "widgets/thermal/thermal_picture_view.h"

#include "engine/base/message_code.h"
#include "widgets/common/display.h"
#include "widgets/common/elided_label.h"
#include "widgets/thermal/thermal_canvas.h"
#include "widgets/thermal/thermal_controls.h"
#include "widgets/thermal/thermal_histogram_plot.h"
#include "widgets/thermal/thermal_object_list.h"

#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLocale>
#include <QTimer>

#include <algorithm>

namespace bask {
namespace {

constexpr int kThermalGap = 8;
const QString kBetween = QStringLiteral("  \u00b7  ");
constexpr int kFirst = 1000; // stretch of what has the room before others have it

} // namespace

ThermalPictureView::ThermalPictureView(QWidget* parent)
    : QWidget(parent), m_controls(new ThermalControls(this)), m_canvas(new ThermalCanvas(this)),
      m_list(new ThermalObjectList(this)), m_histogram(new ThermalHistogramPlot(this)),
      m_status(new ElidedLabel(this)), m_legend(new QLabel(this)), m_panel(new QVBoxLayout),
      m_age(new QTimer(this)) {
    setObjectName(QStringLiteral("thermalPictureView"));
    m_panel->setSpacing(kThermalGap);
    m_panel->addWidget(m_list);
    m_panel->addWidget(m_histogram, kFirst);
    m_panel->addStretch(1);
    auto* row = new QHBoxLayout;
    row->setSpacing(2 * kThermalGap);
    row->addWidget(m_canvas, kFirst); // as large as it can be, the rest of the width for the others
    row->addLayout(m_panel, 1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, kThermalGap, 0, 0);
    layout->setSpacing(kThermalGap);
    layout->addWidget(m_controls);
    layout->addLayout(row, 1);
    m_status->setObjectName(QStringLiteral("thermalStatus"));
    m_legend->setObjectName(QStringLiteral("thermalLegend"));
    m_legend->setTextFormat(Qt::RichText);
    auto* line = new QHBoxLayout;
    line->setSpacing(2 * kThermalGap);
    line->addWidget(m_status, 1);
    line->addWidget(m_legend);
    layout->addLayout(line);

    connect(m_controls, &ThermalControls::changed, this, [this] {
        m_shown.reset(); // not held to what was shown with other limits
        refreshLimits();
        refreshHistogram();
    });
    connect(m_list, &ThermalObjectList::chosenChanged, this, &ThermalPictureView::refreshHistogram);
    constexpr int kAgeTold_ms = 500;
    m_age->setInterval(kAgeTold_ms);
    connect(m_age, &QTimer::timeout, this, [this] {
        refreshNotice();
        refreshHistogram();
    });
    refresh();
}

void ThermalPictureView::setView(const ThermalView& view) {
    constexpr double kNewest = 0.2;
    const double period_s = view.time_s - m_view.time_s;
    const bool isNext = view.picture && m_view.picture && period_s > 0.0;
    if (isNext)
        m_period_s = m_period_s > 0.0 ? (1.0 - kNewest) * m_period_s + kNewest * period_s : period_s;
    else if (!m_view.picture || period_s < 0.0)
        m_period_s = 0.0;
    m_view = view;
    m_since.start();
    if (isVisible())
        refresh();
}

void ThermalPictureView::setNames(const std::vector<QString>& names) {
    m_canvas->setNames(names);
    m_list->setNames(names);
    refresh();
}

void ThermalPictureView::setTemperatureUnit(TemperatureUnit unit) {
    m_unit = unit;
    m_controls->setTemperatureUnit(unit);
    m_canvas->setTemperatureUnit(unit);
    m_histogram->setTemperatureUnit(unit);
    refresh();
}

void ThermalPictureView::setRecorded() {
    m_isRecorded = true;
    refresh();
}

double ThermalPictureView::age_s() const {
    return m_view.age_s + (m_since.isValid() ? 1e-3 * static_cast<double>(m_since.elapsed()) : 0.0);
}

QString ThermalPictureView::sentence() const {
    if (m_view.problem.code != MessageCode::None)
        return sentenceText(m_view.problem, m_unit);
    if (!hasPicture(m_view))
        return m_isRecorded ? tr("No picture was recorded.")
                            : tr("The thermal camera has not given a picture yet.");
    return !m_isRecorded && age_s() > kOldAfter_s ? tr("This picture is %1.").arg(formatAge(age_s()))
                                                  : QString();
}

QString ThermalPictureView::statusText() const {
    if (!hasPicture(m_view))
        return {};
    QStringList words;
    if (m_isRecorded)
        words << tr("taken at %1").arg(formatDuration(m_view.time_s));
    if (!m_view.cameraName.empty())
        words << QString::fromStdString(m_view.cameraName);
    words << tr("%1 \u00d7 %2").arg(m_view.picture->width).arg(m_view.picture->height);
    if (m_isRecorded)
        return words.join(kBetween);
    if (m_view.leftOut.count > 0)
        words << tr("%n picture(s) left out", nullptr, static_cast<int>(m_view.leftOut.count));
    if (m_period_s > 0.0 && sentence().isEmpty())
        words << tr("%1 pictures/s").arg(QLocale().toString(1.0 / m_period_s, 'f', 1));
    if (m_view.sinceShutter_s)
        words << tr("shutter %1 ago, drift \u00b1 %2")
                     .arg(formatDuration(*m_view.sinceShutter_s),
                          formatDifference(m_view.drift_K, m_unit, 2).mid(1));
    words << tr("age %1 s").arg(QLocale().toString(age_s(), 'f', age_s() < 1.0 ? 2 : 1));
    return words.join(kBetween);
}

QString ThermalPictureView::leftOutText() const {
    if (!m_view.leftOut.last)
        return {};
    const Error& last = *m_view.leftOut.last;
    return tr("Left out last: %1")
        .arg(QFileInfo(QString::fromStdString(last.where)).fileName() + QStringLiteral(": ") +
             messageText(last.message, m_unit));
}

void ThermalPictureView::refresh() {
    m_canvas->setView(m_view);
    m_whole = hasPicture(m_view) ? rangeOfPicture(*m_view.picture) : std::nullopt;
    refreshLimits();
    refreshNotice();
    refreshHistogram();
    arrange();
}

void ThermalPictureView::refreshLimits() {
    if (m_controls->limits() == ThermalLimits::Fixed) {
        m_shown = m_controls->fixedRange();
    } else if (hasPicture(m_view)) {
        const auto objects =
            m_controls->limits() == ThermalLimits::Objects ? rangeOfObjects(m_view) : std::nullopt;
        if (const auto& wanted = objects ? objects : m_whole)
            m_shown = steadied(*wanted, m_shown);
    }
    m_controls->setShownRange(limits());
    m_canvas->setLook({m_controls->colours(), limits(), m_controls->isotherm()});
    m_canvas->setSmooth(m_controls->isSmooth());
    m_canvas->setZoomed(m_controls->isZoomed());
}

void ThermalPictureView::refreshNotice() {
    m_canvas->setNotice(sentence(), hasPicture(m_view) || m_view.problem.code != MessageCode::None);
    m_status->setText(statusText());
    m_status->setToolTip(leftOutText());
    m_legend->setText(m_canvas->legend());
    m_list->showView(m_view, m_whole, sentence().isEmpty(), m_unit);
    if (!m_isRecorded && hasPicture(m_view) && isVisible())
        m_age->start(); // again from now: nothing to do if another picture comes before
    else
        m_age->stop();
}

void ThermalPictureView::refreshHistogram() {
    const auto chosen = m_list->chosen();
    m_canvas->setChosen(chosen);
    std::vector<double> pixels_K;
    if (hasPicture(m_view) && sentence().isEmpty()) {
        if (!chosen)
            pixels_K = pixelsOf(*m_view.picture);
        else if (*chosen < m_view.objects.size())
            pixels_K = pixelsOf(*m_view.picture, m_view.objects[*chosen]);
    }
    m_histogram->setHistogram(m_list->chosenName(), thermalHistogram(pixels_K),
                              {m_controls->colours(), limits(), {}});
}

// A low view has the list and the histogram beside each other, or no histogram where that is too wide.
void ThermalPictureView::arrange() {
    constexpr int kLow = 330, kBeside = 480, kTallest = 300;
    m_canvas->setMaximumWidth(
        std::max(m_canvas->minimumSizeHint().width(), m_canvas->widthFor(m_canvas->height())));
    const int panel = width() - std::min(m_canvas->maximumWidth(), width()) - 2 * kThermalGap;
    const bool isLow = height() < kLow, isBeside = isLow && panel >= kBeside;
    m_panel->setDirection(isBeside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    m_panel->setStretch(0, isBeside ? kFirst : 0);
    m_panel->setStretch(m_panel->count() - 1, isBeside ? 0 : 1); // below them nothing
    m_histogram->setMaximumHeight(isBeside ? QWIDGETSIZE_MAX : kTallest);
    m_histogram->setVisible(isBeside || !isLow);
}

void ThermalPictureView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    arrange();
}

void ThermalPictureView::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    refresh();
}

void ThermalPictureView::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        refresh();
}

} // namespace bask
