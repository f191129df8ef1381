#include "widgets/review/replay_view.h"

#include "engine/model/mounting_check.h"
#include "widgets/common/marker_words.h"
#include "widgets/common/object_tile.h"
#include "widgets/common/theme.h"
#include "widgets/common/tile_grid.h"
#include "widgets/plots/plot_place.h"
#include "widgets/plots/quantity_words.h"
#include "widgets/plots/trace_plot.h"
#include "widgets/review/comparison_view.h"
#include "widgets/review/recorded_pictures.h"
#include "widgets/review/transport_bar.h"
#include "widgets/scene/scene_view.h"
#include "widgets/thermal/thermal_picture_view.h"

#include <QEvent>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTabWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <limits>
#include <utility>

namespace bask {
namespace {

constexpr int kGap = 6;
constexpr int kLowestPlot = 180; // px: where there is no room the page scrolls
constexpr int kLongestKey = 260; // px, of a run that is laid over
static_assert(ReadingTrend::kOver_s <= ObjectTile::kSettledAfter_s, "a tile is given so much of the past");

/// A short line in the dashes of overlay `index`, in no object's colour.
QIcon overlayIcon(int index, const QColor& ink, double devicePixelRatio) {
    QPixmap pixmap(QSize(32, 12) * devicePixelRatio);
    pixmap.setDevicePixelRatio(devicePixelRatio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    QPen pen(ink, 2.0);
    pen.setCapStyle(Qt::FlatCap);
    pen.setDashPattern(TracePlot::overlayDashes(index));
    painter.setPen(pen);
    painter.drawLine(QPointF(0, 6), QPointF(28, 6));
    return QIcon(pixmap);
}

/// The newest sample at or before a moment, else the first, after those by which a tile judges it.
Result<std::vector<TraceSample>> samplesUntil(RecordedSession& run, double time_s) {
    const auto now = run.sampleAt(time_s);
    if (!now)
        return now.error();
    const auto begin = run.sampleAt(now->time_s - ObjectTile::kSettledAfter_s);
    if (!begin)
        return begin.error();
    return run.samples(begin->time_s, now->time_s);
}

} // namespace

ReplayView::ReplayView(QWidget* parent)
    : QWidget(parent), m_transport(new TransportBar(m_clock, this)), m_legend(new QWidget(this)),
      m_tiles(new TileGrid(this)) {
    m_legendLayout = new QGridLayout(m_legend);
    m_legendLayout->setContentsMargins(0, 0, 0, 0);
    m_legendLayout->setSpacing(4);
    m_legendLayout->setColumnStretch(3, 1);
    m_legend->hide();

    auto* stack = new QSplitter(Qt::Vertical, this);
    stack->setChildrenCollapsible(false);
    stack->setHandleWidth(kGap);
    stack->addWidget(makePlot(Quantity::Temperature));
    m_tabs = new QTabWidget(stack);
    m_tabs->setObjectName(QStringLiteral("reviewTabs"));
    m_tabs->setDocumentMode(true);
    m_tabs->setUsesScrollButtons(true);
    for (const Quantity quantity : furtherQuantities()) {
        const int tab = m_tabs->addTab(makePlot(quantity), QString());
        if (quantity == Quantity::Shade)
            m_shadeTab = tab;
    }
    m_sceneTab = new QWidget(m_tabs);
    (new QVBoxLayout(m_sceneTab))->setContentsMargins(0, 0, 0, 0);
    m_tabs->addTab(m_sceneTab, QString());
    m_picture = new ThermalPictureView(m_tabs);
    m_picture->setObjectName(QStringLiteral("reviewPicture"));
    m_picture->setRecorded();
    m_picture->hide();
    m_comparison = new ComparisonView(m_tabs);
    m_comparison->hide();
    stack->addWidget(m_tabs);
    stack->setSizes({300, 240});
    stack->setStretchFactor(0, 3);
    stack->setStretchFactor(1, 2);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(kGap);
    layout->addWidget(m_transport);
    layout->addWidget(m_tiles);
    layout->addWidget(m_legend);
    layout->addWidget(stack, 1);

    connectPlots();
    connect(m_transport, &TransportBar::moved, this, &ReplayView::moveTo);
    connect(m_tabs, &QTabWidget::currentChanged, this, &ReplayView::fillShown);
    retranslate();
}

ReplayView::~ReplayView() = default;

PlotPlace* ReplayView::makePlot(Quantity quantity) {
    auto* plot = new TracePlot(quantity, this);
    plot->setObjectName(QStringLiteral("review.") + quantityKey(quantity));
    plot->setMarkerTextsVisible(quantity == Quantity::Temperature);
    plot->setMinimumHeight(kLowestPlot);
    m_plots.push_back({new PlotPlace(plot, this), plot, false});
    return m_plots.back().place;
}

void ReplayView::connectPlots() {
    for (const Plot& each : m_plots) {
        TracePlot* plot = each.plot;
        connect(plot, &TracePlot::momentClicked, this, &ReplayView::seek);
        connect(plot, &TracePlot::timeRangeChosen, this, [this, plot](double from_s, double to_s) {
            m_visible_s = std::pair{from_s, to_s};
            for (const Plot& other : m_plots)
                if (other.plot != plot)
                    other.plot->setTimeRange(from_s, to_s);
        });
        connect(plot, &TracePlot::followLiveChanged, this, [this, plot](bool whole) {
            if (!whole)
                return;
            m_visible_s.reset();
            for (const Plot& other : m_plots)
                if (other.plot != plot)
                    other.plot->setFollowLive(true);
        });
    }
}

void ReplayView::setRun(std::shared_ptr<RecordedSession> run) {
    m_run = std::move(run);
    m_runs.setOpen(m_run);
    m_way.clear();
    m_sample.reset();
    m_isFailureTold = false;
    m_visible_s.reset();
    m_names = objectNames(*m_run);
    m_tiles->setObjects(QStringLiteral("reviewTile."), m_names);
    m_tiles->setLimits(m_run->facts().experiment);
    nameRun();
    clearTiles();
    const auto& robot = m_run->facts().experiment.robot;
    for (Plot& each : m_plots) {
        each.isFilled = false;
        each.plot->clearOverlays();
        each.plot->setObjects(m_names);
        each.plot->setSpeedLimits({robot.maxSpeed_m_s, robot.maxRotation_rad_s});
        each.plot->setPosition(std::nullopt);
    }
    m_tabs->setTabVisible(m_shadeTab, mayShade(m_run->facts().experiment));
    showPictureTab();
    fillScene();
    fill(m_plots.front());
    fillShown();
    showOverlays();
    const bool isEmpty = m_run->size() == 0;
    m_transport->setSpan(isEmpty ? 0.0 : m_run->overview().from_s(0), m_run->lastTime_s());
    emit overlaysChanged();
}

void ReplayView::clear() {
    m_run.reset();
    m_runs.setOpen(nullptr);
    m_way.clear();
    m_sample.reset();
    nameRun();
    showPictureTab();
    for (Plot& each : m_plots) {
        each.plot->clear();
        each.plot->clearOverlays();
        each.plot->setPosition(std::nullopt);
        each.isFilled = false;
    }
    m_transport->setSpan(0.0, 0.0);
    showOverlays();
    emit overlaysChanged();
}

void ReplayView::fill(Plot& each) {
    if (each.isFilled || !m_run)
        return;
    each.isFilled = true;
    const QSignalBlocker quiet(each.plot); // it begins with the whole run, and the others keep their stretch
    if (each.plot->quantity() == Quantity::Temperature)
        each.plot->setPrediction(m_run->facts().prediction);
    each.plot->setRun(m_run);
    addMarkers(*each.plot);
    for (std::size_t k = 0; k < m_runs.over().size(); ++k)
        each.plot->addOverlay(OverlaidRuns::mark(k + 1), m_runs.over()[k].session);
    if (m_visible_s)
        each.plot->setTimeRange(m_visible_s->first, m_visible_s->second);
}

/// What the chosen tab and windows of their own show, made when it is looked at.
void ReplayView::fillShown() {
    for (Plot& each : m_plots)
        if (each.place == m_tabs->currentWidget() || each.place->isOut())
            fill(each);
    if (m_tabs->currentWidget() == m_sceneTab && m_scene == nullptr)
        makeScene();
    if (m_run)
        showMoment(m_transport->position_s());
}

/// For the titles of plots in windows of their own.
void ReplayView::nameRun() {
    const QString name =
        m_run ? QFileInfo(QString::fromStdString(m_run->facts().path)).completeBaseName() : QString();
    for (const Plot& each : m_plots)
        each.place->setRun(m_run ? tr("recorded run %1").arg(name) : tr("no recorded run"));
}

void ReplayView::makeScene() {
    m_scene = new SceneView(m_sceneTab);
    m_scene->setObjectName(QStringLiteral("reviewScene"));
    m_scene->setTemperatureUnit(m_unit);
    m_sceneTab->layout()->addWidget(m_scene);
    fillScene();
    retranslate();
}

void ReplayView::fillScene() {
    if (m_scene == nullptr || !m_run)
        return;
    m_scene->setExperiment(m_run->facts().experiment);
    m_scene->setSamples(m_way);
}

void ReplayView::setWay(std::vector<TraceSample> way) {
    m_way = std::move(way);
    fillScene();
    showScene();
}

void ReplayView::addMarkers(TracePlot& plot) const {
    for (const TraceEvent& event : m_run->facts().events)
        if (const QString word = markerWord(event.message.code); !word.isEmpty())
            plot.addMarker(event.time_s, word);
    for (const TraceNote& note : m_run->facts().notes)
        plot.addMarker(note.time_s, QString::fromStdString(note.text));
}

void ReplayView::clearTiles() {
    const std::vector<ObjectSpec>& objects = m_run->facts().experiment.objects;
    for (std::size_t i = 0; i < objects.size(); ++i)
        m_tiles->tiles()[i]->clear(objects[i].target_K);
}

/// Takes the sample of a moment.
void ReplayView::showTiles(double time_s) {
    m_sample.reset();
    const auto past = samplesUntil(*m_run, time_s);
    if (!past) {
        clearTiles();
        return tellFailure(past.error());
    }
    m_sample = past->back();
    for (std::size_t i = 0; i < m_tiles->tiles().size(); ++i)
        m_tiles->tiles()[i]->setMoment(*past, past->size() - 1, i);
}

void ReplayView::tellFailure(const Error& error) {
    if (!std::exchange(m_isFailureTold, true))
        emit readFailed(error);
}

/// Turns the page of a zoomed plot, not beyond the end of the run.
void ReplayView::moveTo(double time_s) {
    if (m_run && m_visible_s && (time_s < m_visible_s->first || time_s > m_visible_s->second)) {
        const double width_s = m_visible_s->second - m_visible_s->first;
        const double from_s = std::max(0.0, std::min(time_s - 0.1 * width_s, m_run->lastTime_s() - width_s));
        m_visible_s = std::pair{from_s, from_s + width_s};
        for (const Plot& each : m_plots)
            each.plot->setTimeRange(from_s, from_s + width_s);
    }
    showMoment(time_s);
}

void ReplayView::showMoment(double time_s) {
    if (!m_run || m_run->size() == 0)
        return;
    showTiles(time_s);
    for (const Plot& each : m_plots)
        each.plot->setPosition(time_s);
    showScene();
    showPicture(time_s);
}

void ReplayView::showPictureTab() {
    const int tab = m_tabs->indexOf(m_picture);
    if (!m_run || !m_run->hasThermalFrames() ||
        !thermalProfile(m_run->facts().experiment, m_run->facts().simulated)) {
        m_pictures.reset();
        if (tab >= 0)
            m_tabs->removeTab(tab);
        return;
    }
    m_pictures = std::make_unique<RecordedPictures>(m_run);
    m_picture->setView({});
    m_picture->setNames({m_names.begin(), m_names.end()});
    if (tab < 0)
        m_tabs->addTab(m_picture, tr("Thermal picture"));
}

void ReplayView::showPicture(double time_s) {
    if (!m_pictures || m_tabs->currentWidget() != m_picture)
        return;
    auto view = m_pictures->at(time_s);
    if (!view) {
        ThermalView failed;
        failed.problem = view.error().message;
        m_picture->setView(failed);
        return tellFailure(view.error());
    }
    m_picture->setView(*view);
}

bool ReplayView::isSceneShown() const {
    return m_scene != nullptr && m_tabs->currentWidget() == m_sceneTab;
}

void ReplayView::showScene() {
    if (!isSceneShown() || !m_sample)
        return;
    std::vector<double> temperatures_K;
    for (const ObjectSample& object : m_sample->objects)
        temperatures_K.push_back(object.valid ? object.measured_K : std::numeric_limits<double>::quiet_NaN());
    m_scene->setPose(m_sample->coordinates);
    m_scene->setSourcePose(m_sample->source);
    m_scene->setSourceTemperature_K(m_sample->source_K);
    m_scene->setTemperatures(temperatures_K);
}

bool ReplayView::addOverlay(std::shared_ptr<RecordedSession> run) {
    if (!m_runs.add(std::move(run), kMaxOverlays))
        return false;
    showOverlays();
    emit overlaysChanged();
    return true;
}

bool ReplayView::isOver(const QString& path) const {
    return std::ranges::any_of(m_runs.over(),
                               [&](const OverlaidRuns::Run& run) { return run.path() == path; });
}

void ReplayView::removeOverlay(const QString& path) {
    m_runs.remove(path);
    showOverlays();
    emit overlaysChanged();
}

void ReplayView::setMetrics(const QString& path, const RunMetrics* metrics) {
    m_runs.setMetrics(path, metrics);
    if (metrics != nullptr && m_run && path == QString::fromStdString(m_run->facts().path))
        for (std::size_t i = 0; i < std::min(m_tiles->tiles().size(), metrics->objects.size()); ++i)
            m_tiles->tiles()[i]->setRecordedUncertainty(
                metrics->objects[i].readingUncertainty_K.value_or(std::numeric_limits<double>::quiet_NaN()));
    showComparison();
}

/// Lines, legend and table anew: marks and dashes are by the place in the list.
void ReplayView::showOverlays() {
    for (const Plot& each : m_plots) {
        each.plot->clearOverlays();
        for (std::size_t k = 0; k < m_runs.over().size(); ++k)
            if (each.isFilled)
                each.plot->addOverlay(OverlaidRuns::mark(k + 1), m_runs.over()[k].session);
    }
    nameOverlays();
    showComparison();
}

/// In figures and beside the plots.
void ReplayView::nameOverlays() {
    const QStringList keys = m_runs.keys(m_unit);
    for (const Plot& each : m_plots)
        each.plot->setRunNames(keys);
    showLegend(keys);
}

void ReplayView::showLegend(const QStringList& keys) {
    while (QLayoutItem* item = m_legendLayout->takeAt(0)) {
        if (item->widget() != nullptr)
            item->widget()->deleteLater(); // it may be the button that was just clicked
        delete item;
    }
    m_legend->setVisible(!m_runs.over().empty());
    if (m_runs.over().empty())
        return;
    auto* caption = new QLabel(tr("Laid over it:"), m_legend);
    caption->setPalette(captionPalette(palette()));
    m_legendLayout->addWidget(caption, 0, 0);
    for (std::size_t k = 0; k < m_runs.over().size(); ++k) {
        const QString mark = OverlaidRuns::mark(k + 1), path = m_runs.over()[k].path();
        const QString file = QFileInfo(path).completeBaseName();
        QString key =
            fontMetrics().elidedText(keys.value(static_cast<qsizetype>(k) + 1), Qt::ElideRight, kLongestKey);
        auto* button = new QPushButton(
            overlayIcon(static_cast<int>(k), palette().color(QPalette::ButtonText), devicePixelRatioF()),
            QStringLiteral("%1  %2  \u2715").arg(mark, key.replace(u'&', QStringLiteral("&&"))), m_legend);
        button->setObjectName(QStringLiteral("overlay.") + mark);
        button->setIconSize({32, 12});
        button->setFlat(true);
        button->setAccessibleName(tr("Take %1 away").arg(file));
        button->setToolTip(button->accessibleName());
        connect(button, &QPushButton::clicked, this, [this, path] { removeOverlay(path); });
        m_legendLayout->addWidget(button, static_cast<int>(k) / 2, 1 + static_cast<int>(k) % 2);
    }
    auto* exports = new QPushButton(tr("Export figure"), m_legend);
    exports->setObjectName(QStringLiteral("overlayExport"));
    exports->setToolTip(tr("The temperatures of all runs as they are shown; other plots by their own menus"));
    auto* forms = new QMenu(exports);
    m_plots.front().place->addExports(*forms);
    exports->setMenu(forms);
    m_legendLayout->addWidget(exports, 0, 4);
}

void ReplayView::showComparison() {
    const int tab = m_tabs->indexOf(m_comparison);
    if (m_runs.over().empty()) {
        if (tab >= 0)
            m_tabs->removeTab(tab);
        return m_comparison->setRuns({});
    }
    m_comparison->setRuns(m_runs.compared());
    if (tab < 0)
        m_tabs->addTab(m_comparison, tr("Comparison"));
}

void ReplayView::seek(double time_s) {
    m_transport->seek(time_s);
}

void ReplayView::togglePlay() {
    m_transport->togglePlay();
}

void ReplayView::pause() {
    m_transport->pause();
}

double ReplayView::position_s() const {
    return m_transport->position_s();
}

void ReplayView::setTemperatureUnit(TemperatureUnit unit) {
    m_unit = unit;
    m_tiles->setTemperatureUnit(unit);
    for (const Plot& each : m_plots)
        each.plot->setTemperatureUnit(unit);
    m_picture->setTemperatureUnit(unit);
    m_comparison->setTemperatureUnit(unit);
    nameOverlays();
    if (m_scene != nullptr)
        m_scene->setTemperatureUnit(unit);
}

void ReplayView::retranslate() {
    for (std::size_t i = 1; i < m_plots.size(); ++i)
        m_tabs->setTabText(static_cast<int>(i) - 1, quantityTitle(m_plots[i].plot->quantity()));
    m_tabs->setTabText(m_tabs->indexOf(m_sceneTab), tr("Scene"));
    if (const int tab = m_tabs->indexOf(m_picture); tab >= 0)
        m_tabs->setTabText(tab, tr("Thermal picture"));
    if (const int tab = m_tabs->indexOf(m_comparison); tab >= 0)
        m_tabs->setTabText(tab, tr("Comparison"));
    m_tabs->setAccessibleName(tr("Further traces and the scene"));
    if (m_scene != nullptr)
        m_scene->setAccessibleName(tr("3-D scene of the run: source, objects and their paths"));
    nameRun();
    if (!m_run)
        return;
    for (const Plot& each : m_plots) {
        if (!each.isFilled)
            continue;
        each.plot->clearMarkers();
        addMarkers(*each.plot);
    }
    showOverlays();
}

void ReplayView::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (m_tabs == nullptr)
        return;
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    else if (event->type() == QEvent::PaletteChange && m_run)
        showOverlays();
}

} // namespace bask
