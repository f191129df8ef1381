#include "widgets/plots/trace_plot.h"

#include "engine/recording/recorded_session.h"
#include "widgets/common/scrolling.h"
#include "widgets/common/theme.h"
#include "widgets/plots/plot_table.h"
#include "widgets/plots/trace_canvas.h"

#include <QEvent>
#include <QKeyEvent>
#include <QVBoxLayout>

#include <algorithm>

namespace bask {

TracePlot::TracePlot(Quantity quantity, QWidget* parent)
    : QWidget(parent), m_canvas(std::make_unique<Canvas>(this)) {
    setObjectName(QStringLiteral("tracePlot"));
    setFocusPolicy(Qt::StrongFocus);
    setProperty(kZoomsByWheel, true);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_canvas.get());
    m_canvas->dark = isDark(this);
    m_canvas->setQuantity(quantity);
    m_canvas->setContextMenuPolicy(Qt::CustomContextMenu);    // it keeps what the mouse does to itself
    m_canvas->setAttribute(Qt::WA_NoMousePropagation, false); // but a wheel that is the page's
    connect(m_canvas.get(), &QWidget::customContextMenuRequested, this,
            [this](const QPoint& at) { emit customContextMenuRequested(m_canvas->mapTo(this, at)); });
}

TracePlot::TracePlot(QWidget* parent) : TracePlot(Quantity::Temperature, parent) {}
TracePlot::~TracePlot() = default;

void TracePlot::setObjects(const QStringList& names) {
    m_canvas->setObjects(names);
}
void TracePlot::setQuantity(Quantity quantity) {
    m_canvas->setQuantity(quantity);
}
Quantity TracePlot::quantity() const {
    return m_canvas->quantity;
}
void TracePlot::setRightQuantity(std::optional<Quantity> quantity) {
    m_canvas->setRight(quantity);
}
std::optional<Quantity> TracePlot::rightQuantity() const {
    return m_canvas->rightAxis.quantity;
}
void TracePlot::setSpeedLimits(const SpeedLimits& limits) {
    m_canvas->setLimits(limits);
}
void TracePlot::setStore(std::shared_ptr<TraceStore> store) {
    m_canvas->traces = std::move(store);
    m_canvas->rebuild();
}

void TracePlot::showNewSamples() {
    m_canvas->showNewSamples();
}

void TracePlot::append(const std::vector<TraceSample>& samples) {
    m_canvas->append(samples);
}

void TracePlot::setSamples(const std::vector<TraceSample>& samples) {
    m_canvas->clearData();
    m_canvas->traces->keepAll();
    m_canvas->append(samples);
}

void TracePlot::setRun(std::shared_ptr<RecordedSession> run) {
    m_canvas->names.clear();
    for (const ObjectSpec& object : run->facts().experiment.objects)
        m_canvas->names << QString::fromStdString(object.name);
    m_canvas->setRun(std::move(run));
}

void TracePlot::clear() {
    m_canvas->clearData();
}
void TracePlot::addMarker(double time_s, const QString& text) {
    m_canvas->addMarker(time_s, text);
}
void TracePlot::clearMarkers() {
    m_canvas->clearMarkers();
}

void TracePlot::setMarkerTextsVisible(bool visible) {
    m_canvas->showMarkerTexts(visible);
}

void TracePlot::addOverlay(const QString& mark, std::shared_ptr<RecordedSession> run) {
    m_canvas->addOverlay(mark, std::move(run));
}

void TracePlot::setRunNames(const QStringList& names) {
    m_canvas->runNames = names;
}

void TracePlot::clearOverlays() {
    m_canvas->clearOverlays();
}

void TracePlot::setPrediction(const PredictedRun& run) {
    m_canvas->setPrediction(run);
}

void TracePlot::setPredictionVisible(bool visible) {
    m_canvas->showPrediction(visible);
}

void TracePlot::setPosition(std::optional<double> time_s) {
    m_canvas->setPosition(time_s);
}

void TracePlot::setTemperatureUnit(TemperatureUnit unit) {
    m_canvas->setUnit(unit);
}
void TracePlot::setTheme(bool dark) {
    m_canvas->restyle(dark);
}
bool TracePlot::followsLive() const {
    return m_canvas->follow;
}
void TracePlot::setFollowLive(bool follow) {
    m_canvas->setFollow(follow);
}

void TracePlot::setFollowWindow_s(double window_s) {
    m_canvas->window_s = std::max(0.0, window_s);
    m_canvas->schedule();
}

double TracePlot::behind_s() const {
    return m_canvas->follow ? 0.0
                            : std::max(0.0, m_canvas->traces->lastTime_s() - m_canvas->xAxis->range().upper);
}

void TracePlot::setTimeRange(double from_s, double to_s) {
    m_canvas->showTime(from_s, to_s);
}

double TracePlot::visibleFrom_s() const {
    m_canvas->updateRanges();
    return m_canvas->xAxis->range().lower;
}

double TracePlot::visibleTo_s() const {
    m_canvas->updateRanges();
    return m_canvas->xAxis->range().upper;
}

double TracePlot::visibleLowest() const {
    m_canvas->updateRanges();
    return m_canvas->yAxis->range().lower;
}

double TracePlot::visibleHighest() const {
    m_canvas->updateRanges();
    return m_canvas->yAxis->range().upper;
}

int TracePlot::seriesCount() const {
    return static_cast<int>(bask::seriesCount(m_canvas->quantity, m_canvas->traces->objects()));
}

QString TracePlot::seriesName(int series) const {
    return m_canvas->seriesName(series);
}

QList<QPointF> TracePlot::seriesPoints(int series) const {
    return m_canvas->allPoints(m_canvas->quantity, series);
}

QList<QPointF> TracePlot::predictedPoints(int series) const {
    return m_canvas->predictedPoints(series);
}

QString TracePlot::predictionLabel() const {
    return m_canvas->predictionWords();
}

QString TracePlot::valueAxisLabel() const {
    return m_canvas->axisText();
}

QString TracePlot::shownAxisLabel() const {
    return m_canvas->yAxis->label();
}

QList<QPointF> TracePlot::rightPoints(int series) const {
    const auto right = m_canvas->rightAxis.quantity;
    return right ? m_canvas->allPoints(*right, series) : QList<QPointF>();
}

double TracePlot::rightLowest() const {
    m_canvas->updateRanges();
    return m_canvas->yAxis2->range().lower;
}

double TracePlot::rightHighest() const {
    m_canvas->updateRanges();
    return m_canvas->yAxis2->range().upper;
}

QString TracePlot::rightAxisLabel() const {
    return m_canvas->rightAxisText();
}

QStringList TracePlot::markerTexts() const {
    QStringList texts;
    for (const auto& marker : std::as_const(m_canvas->markers))
        texts << marker.text;
    return texts;
}

QStringList TracePlot::overlayLabels() const {
    QStringList texts;
    for (const Canvas::Overlay& overlay : m_canvas->overlays)
        for (const QCPItemText* label : overlay.labels)
            texts << label->text();
    return texts;
}

std::optional<double> TracePlot::position_s() const {
    return m_canvas->position_s;
}

std::optional<double> TracePlot::cursor_s() const {
    return m_canvas->pinned_s;
}

QString TracePlot::readout(double time_s, std::optional<double> pinned_s) const {
    QStringList parts;
    for (const auto& part : m_canvas->readout(time_s, pinned_s))
        parts << part.words;
    return parts.join(QStringLiteral("   "));
}

void TracePlot::measureFrom(std::optional<QPoint> at) {
    m_canvas->measureFrom(at ? std::optional(m_canvas->mapFrom(this, *at).x()) : std::nullopt);
}

void TracePlot::takeCursorAway() {
    m_canvas->pinCursor(std::nullopt);
}

void TracePlot::redraw() {
    m_canvas->redrawNow();
    m_canvas->replot(QCustomPlot::rpImmediateRefresh);
}

bool TracePlot::isEmpty() const {
    return m_canvas->traces->rows() == 0 && m_canvas->overlays.empty() && predictedPoints(0).isEmpty();
}

QByteArray TracePlot::figure(const QString& unrecorded, FigureFormat format, const QString& comment,
                             const FigureLayout& layout) const {
    return m_canvas->figure(unrecorded, format, comment, layout);
}

PlotTable TracePlot::table(const QString& mark) const {
    return m_canvas->table(mark);
}

void TracePlot::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (m_canvas == nullptr)
        return;
    if (event->type() == QEvent::LanguageChange)
        m_canvas->retranslate();
    else if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        m_canvas->restyle(isDark(this));
}

void TracePlot::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    m_canvas->schedule();
}

void TracePlot::keyPressEvent(QKeyEvent* event) {
    if (!m_canvas->handleKey(event))
        QWidget::keyPressEvent(event);
}

} // namespace bask
