#include "widgets/rig/rig_page.h"

#include "engine/base/message_code.h"
#include "engine/model/limits_widened.h"
#include "widgets/common/device_words.h"
#include "widgets/common/display.h"
#include "widgets/common/floating_place.h"
#include "widgets/common/labels.h"
#include "widgets/common/message_bar.h"
#include "widgets/common/upright_scroll.h"
#include "widgets/rig/check_list.h"
#include "widgets/rig/device_console.h"
#include "widgets/rig/device_dialog.h"
#include "widgets/rig/heat_panel.h"
#include "widgets/rig/jog_panel.h"
#include "widgets/rig/limits_panel.h"
#include "widgets/rig/program_question.h"
#include "widgets/rig/reading_panel.h"
#include "widgets/rig/rig_devices.h"
#include "widgets/rig/safety_panel.h"
#include "widgets/rig/way_up_question.h"
#include "widgets/rig/zero_panel.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QTabWidget>

#include <algorithm>
#include <utility>

namespace bask {
namespace {

constexpr int kPanelWidth = 440, kPanelLines = 26; // px; of text, where that is larger
const QString kQuestion = QStringLiteral("limitQuestion");

} // namespace

RigPage::RigPage(QWidget* parent)
    : QWidget(parent), m_message(new MessageBar(this)), m_devices(new RigDevices(this)),
      m_checks(new CheckList(this)), m_tabs(new QTabWidget(this)), m_reason(new QLabel(this)),
      m_robotTitle(boldLabel(this)), m_heatTitle(boldLabel(this)), m_jog(new JogPanel(this)),
      m_heat(new HeatPanel(this)), m_limits(new LimitsPanel(this)), m_safety(new SafetyPanel(this)),
      m_zero(new ZeroPanel(this)), m_readings(new ReadingPanel(this)) {
    m_message->setObjectName("rigMessage");
    m_tabs->setObjectName("rigTabs");
    m_tabs->setDocumentMode(true);
    m_tabs->setFixedWidth(std::max(kPanelWidth, kPanelLines * fontMetrics().height()));
    m_tabs->addTab(scrolled(buildManual()), QString());
    m_tabs->addTab(scrolled(buildLimits()), QString());

    auto* columns = new QHBoxLayout;
    columns->setSpacing(12);
    columns->addWidget(scrolled(buildLeft()), 1);
    columns->addWidget(m_tabs);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(12, 12, 12, 12);
    layout->setSpacing(8);
    layout->addLayout(columns, 1);
    new FloatingPlace(*m_message, *this);
    connectAll();
    retranslate();
}

QScrollArea* RigPage::scrolled(QWidget* content) {
    auto* inside = new QWidget(this);
    auto* column = new QVBoxLayout(inside);
    column->setContentsMargins(2, 8, 8, 4);
    column->addWidget(content);
    column->addStretch(1);
    return new UprightScroll(inside, this);
}

QWidget* RigPage::buildLeft() {
    auto* part = new QWidget(this);
    auto* column = new QVBoxLayout(part);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(14);
    column->addWidget(m_devices);
    column->addWidget(m_checks);
    column->addWidget(m_readings);
    column->addWidget(m_zero);
    return part;
}

QWidget* RigPage::buildManual() {
    auto* part = new QWidget(this);
    m_reason->setObjectName("manualReason");
    m_reason->setWordWrap(true);
    auto* column = new QVBoxLayout(part);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    column->addWidget(m_reason);
    column->addWidget(m_robotTitle);
    column->addWidget(m_jog);
    column->addSpacing(8);
    column->addWidget(m_heatTitle);
    column->addWidget(m_heat);
    return part;
}

QWidget* RigPage::buildLimits() {
    auto* part = new QWidget(this);
    auto* column = new QVBoxLayout(part);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(12);
    column->addWidget(m_limits);
    column->addWidget(m_safety);
    return part;
}

void RigPage::connectAll() {
    connect(m_devices, &RigDevices::simulatedWanted, this, &RigPage::useSimulated);
    connect(m_devices, &RigDevices::realWanted, this, [this] { useRig(m_kept.value_or(RigSpec())); });
    connect(m_devices, &RigDevices::openWanted, this, &RigPage::openRigRequested);
    connect(m_devices, &RigDevices::saveWanted, this, &RigPage::saveRigRequested);
    connect(m_devices, &RigDevices::consoleWanted, this, &RigPage::openConsole);
    connect(m_devices, &RigDevices::setUpWanted, this, &RigPage::setUp);
    connect(m_devices, &RigDevices::removeWanted, this, &RigPage::remove);
    connect(m_devices, &RigDevices::acceptWanted, this,
            [this](DeviceRole role) { emit commandIssued(AcceptDevice{role}); });
    connect(m_devices, &RigDevices::confirmWanted, this, [this](DeviceRole role) {
        if (m_experiment.rig)
            confirmProgram(portText(*m_experiment.rig, role).toStdString());
    });
    connect(m_devices, &RigDevices::named, this, [this](const QString& name) {
        Experiment changed = m_experiment;
        if (!changed.rig)
            return;
        changed.rig->name = name.toStdString();
        edit(changed);
    });
    connect(m_limits, &LimitsPanel::edited, this, &RigPage::editLimits);
    connect(m_safety, &SafetyPanel::edited, this, &RigPage::editLimits);
    connect(m_readings, &ReadingPanel::chosen, this, &RigPage::readObject);
    connect(m_zero, &ZeroPanel::zeroWanted, this, [this] { emit commandIssued(ZeroSensors{}); });
    connect(m_jog, &JogPanel::commandWanted, this, &RigPage::commandIssued);
    connect(m_jog, &JogPanel::homeWanted, this, &RigPage::homeRequested);
    connect(m_heat, &HeatPanel::commandWanted, this, &RigPage::commandIssued);
}

bool RigPage::edit(const Experiment& experiment) {
    m_refusal.clear();
    m_message->clear();
    emit experimentEdited(experiment);
    if (m_refusal.isEmpty())
        return true;
    m_devices->setRig(m_experiment.rig); // as it still is
    m_message->say(MessageBar::Kind::Problem, m_refusal);
    return false;
}

void RigPage::editLimits(const Experiment& experiment, const QString& words) {
    dropQuestion(this, kQuestion);
    if (!m_experiment.rig || !widensLimits(m_experiment, experiment)) {
        edit(experiment);
        return;
    }
    askOnTheWayUp(
        this, kQuestion, tr("Raise a limit of the real rig"),
        words + QStringLiteral("\n\n") +
            tr("This allows the rig more than before. Do robot, source, objects and sensors bear it?"),
        tr("Raise the limit"), [this, experiment] { edit(experiment); });
}

void RigPage::useSimulated() {
    Experiment changed = m_experiment;
    changed.rig.reset();
    edit(changed);
}

void RigPage::useRig(const RigSpec& rig) {
    Experiment changed = m_experiment;
    changed.rig = rig;
    const std::size_t sensors = contactSensors(changed.objects);
    const std::size_t channels = rig.thermometer ? rig.thermometer->channels.size() : sensors;
    if (rig.thermometer)
        changed.rig->thermometer->channels = channelsFor(rig.thermometer->channels, sensors);
    const auto use = [this, changed, channels, sensors] {
        if (edit(changed) && channels != sensors)
            m_message->say(MessageBar::Kind::Note,
                           tr("The rig was set up for %1 objects, and there are %2: check the thermometer's "
                              "channels.")
                               .arg(channels)
                               .arg(sensors));
    };
    dropQuestion(this, kQuestion);
    QStringList lines;
    for (const Message& limit : widenedOnRealRig(m_experiment, changed, m_keptRobot))
        lines << sentenceText(limit);
    if (lines.isEmpty())
        return use();
    askOnTheWayUp(this, kQuestion, tr("Limits of the real rig"),
                  tr("This rig is allowed more than now, or than is usual:") + QStringLiteral("\n\n") +
                      lines.join(u'\n') + QStringLiteral("\n\n") +
                      tr("Do robot, source, objects and sensors bear it?"),
                  tr("Use these limits"), use);
}

void RigPage::setUp(DeviceRole role) {
    if (m_dialog && m_dialog->role() == role) {
        m_dialog->raise();
        return m_dialog->activateWindow();
    }
    closeDialog();
    m_dialog =
        new DeviceDialog(role, m_experiment.rig.value_or(RigSpec()), withSensors(m_experiment.objects), this);
    m_dialog->setAttribute(Qt::WA_DeleteOnClose);
    m_dialog->setTemperatureUnit(m_unit);
    connect(m_dialog, &DeviceDialog::portsWanted, this, [this] { emit commandIssued(ListPorts{}); });
    connect(m_dialog, &DeviceDialog::tryWanted, this, [this](const RigSpec& device) {
        endTrial();
        m_isTrying = true;
        m_isProgramAsked = false;
        emit commandIssued(TryDevice{device});
    });
    connect(m_dialog, &DeviceDialog::searchWanted, this, [this](const ModbusSearchSpec& spec) {
        endTrial();
        m_isSearching = true;
        emit commandIssued(FindUnits{spec, ++m_searchNumber});
    });
    connect(m_dialog, &DeviceDialog::searchEnded, this, &RigPage::endTrial);
    connect(m_dialog, &DeviceDialog::useWanted, this,
            [this, role](const RigSpec& device) { take(role, device); });
    connect(m_dialog, &QDialog::finished, this, &RigPage::endTrial);
    emit commandIssued(ListPorts{});
    m_dialog->show();
}

/// The port is free again for the rig.
void RigPage::endTrial() {
    if (std::exchange(m_isTrying, false))
        emit commandIssued(TryDevice{});
    if (std::exchange(m_isSearching, false))
        emit commandIssued(FindUnits{});
}

void RigPage::openConsole() {
    if (!m_console) {
        m_console = new DeviceConsole(this);
        m_console->setAttribute(Qt::WA_DeleteOnClose);
        connect(m_console, &DeviceConsole::sendWanted, this,
                [this](const SendByHand& send) { emit commandIssued(send); });
    }
    m_console->show();
    m_console->raise();
    m_console->activateWindow();
}

void RigPage::take(DeviceRole role, const RigSpec& device) {
    endTrial();
    Experiment changed = m_experiment;
    changed.rig = withDevice(changed.rig.value_or(RigSpec()), role, device);
    if (edit(changed))
        return closeDialog();
    m_message->clear();
    m_dialog->showError(m_refusal);
}

void RigPage::closeDialog() {
    if (m_dialog)
        m_dialog->close(); // which ends its trial, too
}

void RigPage::remove(DeviceRole role) {
    Experiment changed = m_experiment;
    if (!changed.rig)
        return;
    changed.rig = withoutDevice(*changed.rig, role);
    edit(changed);
}

void RigPage::readObject(std::size_t object, ReadBy readBy) {
    Experiment changed = m_experiment;
    changed.objects.at(object).readBy = readBy;
    if (!changed.rig && readsByCamera(changed) && !changed.simulation.thermalCamera)
        changed.simulation.thermalCamera.emplace();
    if (changed.rig && changed.rig->thermometer)
        changed.rig->thermometer->channels = channelsAsBefore(changed.objects);
    edit(changed);
}

/// A sensor that is used again is where it was.
std::vector<int> RigPage::channelsAsBefore(const std::vector<ObjectSpec>& objects) {
    const std::vector<std::string> old = withSensors(m_experiment.objects), now = withSensors(objects);
    std::vector<int> channels = m_experiment.rig->thermometer->channels;
    for (std::size_t i = 0; i < std::min(old.size(), channels.size()); ++i)
        m_channels[old[i]] = channels[i];
    keepChannels(m_experiment.objects, objects, channels);
    for (std::size_t i = 0; i < now.size(); ++i)
        if (const auto known = m_channels.find(now[i]);
            known != m_channels.end() && std::ranges::find(channels, known->second) == channels.end())
            channels[i] = known->second;
    return channels;
}

void RigPage::setExperiment(const Experiment& experiment) {
    if (m_experiment.rig && !experiment.rig) {
        m_kept = m_experiment.rig;
        m_keptRobot = m_experiment.robot;
    }
    if (m_experiment != experiment)
        dropQuestion(this, kQuestion); // it was about the old one
    const bool areLimitsNew = m_experiment.robot != experiment.robot;
    const bool isRigNew = m_experiment.rig != experiment.rig;
    m_experiment = experiment;
    if (isRigNew)
        m_devices->setRig(experiment.rig);
    m_devices->showRole(DeviceRole::ThermalCamera,
                        experiment.rig.has_value() || thermalProfile(experiment, true).has_value());
    m_checks->setExperiment(experiment);
    if (areLimitsNew)
        m_jog->setLimits(experiment.robot);
    m_heat->setUsual(experiment.source.temperature_K);
    m_limits->setExperiment(experiment);
    m_safety->setExperiment(experiment);
    m_zero->setObjects(experiment.objects);
    m_readings->setExperiment(experiment);
}

void RigPage::apply(const Snapshot& snapshot, bool editable) {
    const bool isFree = editable && snapshot.state != RunState::Fault && snapshot.state != RunState::Idle;
    if (m_place != snapshot.place || m_remedy != snapshot.remedy.code) {
        m_place = snapshot.place;
        m_remedy = snapshot.remedy.code;
        showManual();
    }
    if (m_editable != editable || m_state != snapshot.state) {
        m_editable = editable;
        m_state = snapshot.state;
        m_devices->setEditable(editable);
        m_limits->setEditable(editable);
        m_safety->setEditable(editable);
        m_readings->setEditable(editable);
        if (!editable)
            dropQuestion(this, kQuestion);
        showManual();
    }
    m_devices->setStates(snapshot.devices);
    m_checks->apply(snapshot);
    m_zero->apply(snapshot);
    m_jog->apply(snapshot, isFree);
    m_heat->apply(snapshot, isFree);
    m_limits->setMeasured(sourceTemperature_K(snapshot));
    if (m_console)
        m_console->apply(snapshot, editable && !snapshot.isMoving);
    if (!m_dialog)
        return;
    if (snapshot.ports)
        m_dialog->setPorts(*snapshot.ports);
    if (snapshot.tried && m_isTrying)
        showTried(*snapshot.tried);
    if (snapshot.search && m_isSearching && snapshot.search->number == m_searchNumber)
        m_dialog->setSearch(*snapshot.search);
    if (!editable)
        closeDialog();
}

void RigPage::showTried(const TriedDevice& tried) {
    m_dialog->setTried(tried);
    if (tried.state.status.problem.code == MessageCode::ProgramNotConfirmed &&
        !std::exchange(m_isProgramAsked, true))
        confirmProgram(tried.state.port);
}

void RigPage::confirmProgram(const std::string& command) {
    askForProgram(this, command, [this](const ConfirmProgram& program) { emit commandIssued(program); });
}

void RigPage::setTemperatureUnit(TemperatureUnit unit) {
    m_unit = unit;
    m_checks->setTemperatureUnit(unit);
    m_heat->setTemperatureUnit(unit);
    m_limits->setTemperatureUnit(unit);
    m_safety->setTemperatureUnit(unit);
    m_zero->setTemperatureUnit(unit);
    if (m_dialog)
        m_dialog->setTemperatureUnit(unit);
}

void RigPage::showManual() {
    QString reason;
    if (!m_editable)
        reason = tr("A run is armed or on: it has the robot and the heat.");
    else if (m_state == RunState::Fault && m_place == PlaceState::Unsure)
        reason = tr("A stop or a fault is latched. Home the robot or confirm its place, then press Reset.");
    else if (m_state == RunState::Fault && m_remedy == MessageCode::RemedyWait)
        reason = tr("A stop or a fault is latched. Reset is possible when its cause is over.");
    else if (m_state == RunState::Fault)
        reason = tr("A stop or a fault is latched. Press Reset first.");
    m_reason->setText(reason);
    m_reason->setVisible(!reason.isEmpty());
}

void RigPage::retranslate() {
    m_tabs->setTabText(0, tr("By hand"));
    m_tabs->setTabText(1, tr("Source and limits"));
    m_robotTitle->setText(tr("Robot"));
    m_heatTitle->setText(tr("Heat"));
    setAccessibleName(tr("Rig"));
    m_message->clear(); // it speaks the old language
    showManual();
}

void RigPage::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

} // namespace bask
