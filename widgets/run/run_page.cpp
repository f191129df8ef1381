#include "widgets/run/run_page.h"

#include "engine/base/message_code.h"
#include "engine/model/mounting_check.h"
#include "widgets/common/belief_words.h"
#include "widgets/common/device_words.h"
#include "widgets/common/display.h"
#include "widgets/common/elided_label.h"
#include "widgets/common/labels.h"
#include "widgets/common/marker_words.h"
#include "widgets/common/object_tile.h"
#include "widgets/common/theme.h"
#include "widgets/common/tile_grid.h"
#include "widgets/plots/plot_place.h"
#include "widgets/plots/trace_plot.h"
#include "widgets/run/controller_panel.h"
#include "widgets/run/source_tile.h"
#include "widgets/scene/scene_view.h"
#include "widgets/thermal/thermal_picture_view.h"

#include <QAbstractItemView>
#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTabWidget>
#include <QToolButton>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace bask {
namespace {

/// How long the sensor of the object has told the same value, as its alarm says, s; NaN without one.
double toldSameFor_s(const std::vector<Alarm>& alarms, const std::string& object) {
    const auto found = std::ranges::find_if(alarms, [&](const Alarm& alarm) {
        const Message& told = alarm.message;
        return alarm.isActive && told.args.size() > 1 && told.args[0].text() == object &&
               (told.code == MessageCode::SafetySensorFrozen || told.code == MessageCode::SafetySensorQuiet);
    });
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    if (found == alarms.end())
        return kNaN;
    bool isNumber = false;
    const double same_s = QString::fromStdString(found->message.args[1].text()).toDouble(&isNumber);
    return isNumber ? same_s : kNaN;
}

/// The share of the source that the others hide from an object, in whole percent; 0 if it is not known.
int shade_percent(const ObjectSample& object) {
    const double share = shadedShare(object);
    return std::isfinite(share) ? qRound(100.0 * share) : 0;
}

/// "speed, workspace x".
QString limitWords(const ActiveLimits& limits) {
    const std::pair<Limit, QString> named[] = {
        {Limit::Speed, RunPage::tr("speed")},
        {Limit::Rotation, RunPage::tr("rotation")},
        {Limit::Acceleration, RunPage::tr("acceleration")},
        {Limit::AngularAcceleration, RunPage::tr("angular acceleration")},
        {Limit::Clearance, RunPage::tr("clearance")},
    };
    const char* const axes[] = {"x", "y", "z", "\u03b8x", "\u03b8y", "\u03b8z"};
    QStringList words;
    for (const auto& [limit, word] : named)
        if (limits.has(limit))
            words << word;
    for (int k = 0; k < 6; ++k)
        if (limits.has(Limit::Workspace, k))
            words << RunPage::tr("workspace %1").arg(QString::fromUtf8(axes[k]));
    return words.join(QStringLiteral(", "));
}

} // namespace

void RunPage::setExperiment(const Experiment& experiment) {
    QStringList names;
    m_title = QString::fromStdString(experiment.title);
    nameRun();
    m_targets_K.clear();
    m_names.clear();
    for (const ObjectSpec& object : experiment.objects) {
        names << QString::fromStdString(object.name);
        m_names.push_back(names.back());
        m_targets_K.push_back(object.target_K);
    }
    m_tiles->setObjects(QStringLiteral("objectTile."), names);
    m_tiles->setLimits(experiment);
    for (std::size_t i = 0; i < m_tiles->tiles().size(); ++i)
        connect(m_tiles->tiles()[i], &ObjectTile::confirmRequested, this,
                [this, i] { emit sensorConfirmed(i); });
    for (TracePlot* plot : m_plots) {
        plot->setObjects(names);
        plot->setSpeedLimits({experiment.robot.maxSpeed_m_s, experiment.robot.maxRotation_rad_s});
    }
    setPrediction({});
    m_source->clear();
    m_scene->setExperiment(experiment);
    m_thermal->setNames(m_names);
    m_thermal->setView({});
    showThermalTab(thermalProfile(experiment, !experiment.rig).has_value());
    m_tabs->setTabVisible(m_shadeTab, mayShade(experiment));
    m_controller->setSettings(experiment.controller);
    m_controller->setWrongRates(wrongRatesFactor(experiment));
    m_runId.reset();
    beginTrace();
}

void RunPage::beginTrace() {
    for (TracePlot* plot : m_plots)
        plot->clear();
    m_events.clear();
    m_notes.clear();
    for (std::size_t i = 0; i < m_targets_K.size(); ++i)
        m_tiles->tiles()[i]->clear(m_targets_K[i]);
    m_scene->clearTrace();
    setFollow(true);
}

void RunPage::apply(const Snapshot& snapshot) {
    if (m_runId && *m_runId != snapshot.runId)
        beginTrace();
    m_runId = snapshot.runId;
    if (!snapshot.newSamples.empty()) {
        m_traces->append(snapshot.newSamples);
        for (TracePlot* plot : m_plots)
            plot->showNewSamples();
        m_scene->appendSamples(snapshot.newSamples);
    }
    addMarkers(snapshot.newEvents, snapshot.newNotes);
    m_events.insert(m_events.end(), snapshot.newEvents.begin(), snapshot.newEvents.end());
    m_notes.insert(m_notes.end(), snapshot.newNotes.begin(), snapshot.newNotes.end());
    showTiles(snapshot);
    m_source->apply(snapshot);
    showScene(snapshot);
    showLimits(snapshot);
    showShade(snapshot);
    m_controller->setSettings(snapshot.controller);
    m_speedRow->setVisible(snapshot.simulated);
    if (const int index = m_speed->findData(snapshot.simulationSpeed);
        index >= 0 && !m_speed->view()->isVisible())
        m_speed->setCurrentIndex(index);
    showBehind();
    emit applied(snapshot);
}

std::vector<ShownObject> RunPage::shownObjects() const {
    std::vector<ShownObject> objects;
    for (const ObjectTile* tile : m_tiles->tiles())
        objects.push_back(tile->shown());
    return objects;
}

void RunPage::showScene(const Snapshot& snapshot) {
    std::vector<double> temperatures_K;
    for (const ObjectSample& object : snapshot.latest.objects)
        temperatures_K.push_back(object.valid ? object.measured_K : std::numeric_limits<double>::quiet_NaN());
    m_scene->setPose(snapshot.latest.coordinates);
    m_scene->setSourcePose(snapshot.latest.source);
    m_scene->setSourceTemperature_K(snapshot.source_K.value_or(std::numeric_limits<double>::quiet_NaN()));
    const bool isUnasked = shownHeat(snapshot) == ShownHeat::Unasked;
    m_scene->setSourceHeat(
        snapshot.isSourceManual ? std::nullopt : std::optional(isUnasked ? HeatState::On : snapshot.heat));
    m_scene->setTemperatures(temperatures_K);
}

void RunPage::setAnswering(bool answering) {
    if (answering)
        return; // the next snapshot tells
    m_scene->setSourceTemperature_K(std::numeric_limits<double>::quiet_NaN());
    m_scene->setSourceHeat(HeatState::Unknown);
}

void RunPage::showTiles(const Snapshot& snapshot) {
    if (snapshot.targets_K.size() == m_targets_K.size())
        m_targets_K = snapshot.targets_K;
    const std::size_t count = std::min(m_targets_K.size(), snapshot.latest.objects.size());
    for (std::size_t i = 0; i < count; ++i) {
        ObjectSample sample = snapshot.latest.objects[i];
        if (snapshot.targets_K.size() == m_targets_K.size() || !(sample.target_K > 0.0))
            sample.target_K = m_targets_K[i]; // the engine's present target; the sample may be older
        SensorView sensor;
        if (i < snapshot.sensors.size())
            sensor = {snapshot.sensors[i], snapshot.readingAges_s[i], snapshot.toldReadings_K[i]};
        if (i < snapshot.uncertainties_K.size())
            sensor.uncertainty_K = snapshot.uncertainties_K[i];
        sensor.sameFor_s = toldSameFor_s(snapshot.alarms, m_names[i].toStdString());
        m_tiles->tiles()[i]->setSample(snapshot.sampleTime_s, sample, sensor); // runs on between runs
    }
}

void RunPage::showLimits(const Snapshot& snapshot) {
    showUnknown(m_placeMark, m_limits, snapshot.place == PlaceState::Unknown);
    if (snapshot.place == PlaceState::Unknown) {
        m_limits->setText(tr("Place UNKNOWN, what is drawn is %1.").arg(formatAge(snapshot.placeAge_s)));
        return m_limits->setToolTip(m_limits->text());
    }
    if (snapshot.place == PlaceState::Unsure) {
        m_limits->setText(tr("The robot is not sure of its place."));
        return m_limits->setToolTip(m_limits->text());
    }
    const bool controlled = snapshot.state == RunState::Running || snapshot.state == RunState::Settled;
    const ActiveLimits& limits = snapshot.latest.limits;
    const QString words = limitWords(limits);
    if (!controlled)
        m_limits->clear();
    else if (!limits.any())
        m_limits->setText(tr("No limit holds the robot back."));
    else
        m_limits->setText(words.isEmpty() ? tr("A limit holds the robot back.")
                                          : tr("Held back by: %1").arg(words));
    m_limits->setToolTip(m_limits->text());
}

/// That of the most shaded one; the tip has all.
void RunPage::showShade(const Snapshot& snapshot) {
    int most = 0;
    QString first;
    QStringList all;
    const std::size_t count = std::min(m_names.size(), snapshot.latest.objects.size());
    for (std::size_t i = 0; i < count; ++i)
        if (const int share = shade_percent(snapshot.latest.objects[i]); share > 0) {
            all << tr("%1 %2 %", "the name of an object, and how much of the source the others hide from it")
                       .arg(m_names[i])
                       .arg(share);
            if (share > most) {
                most = share;
                first = all.back();
            }
        }
    const bool isPlaceKnown = snapshot.place != PlaceState::Unknown && snapshot.place != PlaceState::Unsure;
    m_shade->setText(most > 0 && isPlaceKnown ? tr("Shaded: %1").arg(first) : QString());
    m_shade->setToolTip(
        m_shade->text().isEmpty()
            ? QString()
            : tr("How much of the source the other objects hide: %1. The view factors count it.")
                  .arg(all.join(listSeparator())));
}

void RunPage::addMarkers(const std::vector<TraceEvent>& events, const std::vector<TraceNote>& notes) {
    for (TracePlot* plot : m_plots) {
        for (const TraceEvent& event : events)
            if (const QString word = markerWord(event.message.code); !word.isEmpty())
                plot->addMarker(event.time_s, word);
        for (const TraceNote& note : notes)
            plot->addMarker(note.time_s, QString::fromStdString(note.text));
    }
}

void RunPage::setPrediction(const PredictedRun& run) {
    for (TracePlot* plot : m_plots)
        plot->setPrediction(run);
    m_prediction = run;
    showPlan();
}

bool RunPage::isPredictionSeen() const {
    return isVisible() || m_places.front()->isOut();
}

bool RunPage::isPredictionShown() const {
    return m_showPrediction->isChecked();
}

void RunPage::showPlan() {
    m_scene->setPlan(isPredictionShown() ? m_prediction : PredictedRun());
}

void RunPage::setTemperatureUnit(TemperatureUnit unit) {
    m_unit = unit;
    m_tiles->setTemperatureUnit(unit);
    m_source->setTemperatureUnit(unit);
    for (TracePlot* plot : m_plots)
        plot->setTemperatureUnit(unit);
    m_scene->setTemperatureUnit(unit);
    m_thermal->setTemperatureUnit(unit);
}

void RunPage::showMoment(double time_s) {
    const double half =
        std::max(15.0, 0.5 * (m_plots.front()->visibleTo_s() - m_plots.front()->visibleFrom_s()));
    for (TracePlot* plot : m_plots)
        plot->setTimeRange(time_s - half, time_s + half);
    setFollow(false);
}

/// For the titles of plots in windows of their own.
void RunPage::nameRun() {
    for (PlotPlace* place : m_places)
        place->setRun(m_title.isEmpty() ? tr("present run") : tr("run of %1").arg(m_title));
}

void RunPage::showThermalTab(bool hasCamera) {
    const int tab = m_tabs->indexOf(m_thermal);
    if (hasCamera && tab < 0)
        m_tabs->addTab(m_thermal, tr("Thermal picture"));
    else if (!hasCamera && tab >= 0)
        m_tabs->removeTab(tab);
}

bool RunPage::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_thermal && (event->type() == QEvent::Show || event->type() == QEvent::Hide))
        emit thermalPictureWatched(event->type() == QEvent::Show);
    return QWidget::eventFilter(watched, event);
}

void RunPage::setThermalView(const ThermalView& view) {
    m_thermal->setView(view);
}

void RunPage::setFollow(bool follow) {
    m_follow->setChecked(follow);
    for (TracePlot* plot : m_plots)
        plot->setFollowLive(follow);
    showBehind();
}

void RunPage::showBehind() {
    const bool follow = m_plots.front()->followsLive();
    m_jump->setVisible(!follow);
    if (follow)
        return;
    const double behind_s = m_plots.front()->behind_s();
    m_jump->setText(behind_s >= 1.0 ? tr("Behind by %1 \u2014 jump to live").arg(formatDuration(behind_s))
                                    : tr("Jump to live"));
}

void RunPage::addNote() {
    const QString text = m_note->text().trimmed();
    if (text.isEmpty())
        return;
    m_note->clear();
    setFocus(); // so that N works again
    emit noteAdded(text);
}

void RunPage::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (m_speed == nullptr)
        return;
    if (event->type() == QEvent::LanguageChange)
        retranslateUi();
    else if (event->type() == QEvent::PaletteChange)
        restyle();
}

} // namespace bask
