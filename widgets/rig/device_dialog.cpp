#include "widgets/rig/device_dialog.h"

#include "engine/base/message_code.h"
#include "widgets/common/dialog_frame.h"
#include "widgets/common/display.h"
#include "widgets/common/file_folders.h"
#include "widgets/common/labels.h"
#include "widgets/common/message_bar.h"
#include "widgets/common/number_field.h"
#include "widgets/common/parameter_form.h"
#include "widgets/rig/axis_table.h"
#include "widgets/rig/coordinate_words.h"
#include "widgets/rig/profile_choice.h"
#include "widgets/rig/serial_form.h"
#include "widgets/rig/thermal_camera_form.h"
#include "widgets/rig/unit_finder.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QFile>
#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include <algorithm>

namespace bask {
namespace {

constexpr qint64 kMaxProfile = 1 << 20;

/// The values of all drivers' parameters, as the device that is set up has them.
template <class Driver, class Spec>
void takeValues(const std::vector<Driver>& drivers, const Spec& spec,
                std::map<const ParameterFacts*, double>& out) {
    for (const Driver& driver : drivers)
        for (const DeviceParameter<Spec>& parameter : driver.parameters)
            out[parameter.facts] = parameter.get(spec);
}

template <class Spec> void giveValues(const std::map<const ParameterFacts*, double>& values, Spec& out) {
    for (const DeviceParameter<Spec>& parameter : driverOf(out).parameters)
        parameter.set(out, values.at(parameter.facts));
}

template <class Driver>
void addFacts(const std::vector<Driver>& drivers, SetupStep step, std::vector<const ParameterFacts*>& out) {
    for (const Driver& driver : drivers)
        for (const auto& parameter : driver.parameters)
            if (parameter.step == step && std::ranges::find(out, parameter.facts) == out.end())
                out.push_back(parameter.facts);
}

template <class Spec> std::vector<const ParameterFacts*> appliedFacts(const std::optional<Spec>& spec) {
    std::vector<const ParameterFacts*> out;
    if (spec)
        for (const auto& parameter : driverOf(*spec).parameters)
            if (parameter.applies(*spec))
                out.push_back(parameter.facts);
    return out;
}

/// Another driver's, which nobody has touched.
bool areUsualAxes(const std::vector<AxisSpec>& axes) {
    return std::ranges::find(robotDrivers(), axes, &RobotDriver::usualAxes) != robotDrivers().end();
}

} // namespace

DeviceDialog::DeviceDialog(DeviceRole role, const RigSpec& rig, const std::vector<std::string>& objects,
                           QWidget* parent)
    : QDialog(parent), m_role(role), m_objects(objects), m_driver(new QComboBox(this)),
      m_port(new QComboBox(this)), m_profile(new QComboBox(this)), m_homing(new QComboBox(this)),
      m_homingLabel(new QLabel(this)), m_driverLabel(new QLabel(this)), m_portLabel(new QLabel(this)),
      m_portDescription(new QLabel(this)), m_lineLabel(new QLabel(this)), m_axesLabel(new QLabel(this)),
      m_profileLabel(new QLabel(this)), m_channelsLabel(new QLabel(this)), m_result(new QLabel(this)),
      m_refresh(new QPushButton(this)), m_profileFile(new QPushButton(this)), m_try(new QPushButton(this)),
      m_use(new QPushButton(this)), m_cancel(new QPushButton(this)), m_portPart(new QWidget(this)),
      m_profilePart(new QWidget(this)), m_channelsPart(new QWidget(this)), m_trialPart(new QWidget(this)),
      m_line(new SerialForm(this)), m_axes(new AxisTable(this)), m_thermal(new ThermalCameraForm(this)),
      m_finder(new UnitFinder(this)), m_probe(new QCheckBox(this)), m_unattended(new QCheckBox(this)),
      m_message(new MessageBar(this)) {
    setObjectName("deviceDialog");
    setModal(false);
    build();
    fill(rig);
    retranslate();
    showParts();
}

void DeviceDialog::build() {
    m_driver->setObjectName("driver");
    m_port->setObjectName("port");
    m_port->setEditable(true);
    m_port->setInsertPolicy(QComboBox::NoInsert);
    m_port->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_port->setMinimumContentsLength(30);
    m_portDescription->setObjectName("portDescription");
    m_refresh->setObjectName("refreshPorts");
    m_try->setObjectName("tryDevice");
    m_result->setObjectName("tryResult");
    m_result->setWordWrap(true);
    m_result->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_use->setObjectName("useDevice");
    m_cancel->setObjectName("cancelDevice");
    m_message->setObjectName("deviceMessage");
    for (QPushButton* button : {m_refresh, m_profileFile, m_try, m_cancel})
        button->setAutoDefault(false);

    m_form = new QFormLayout;
    m_parameters = new ParameterForm({}, *m_form, this);
    connect(m_parameters, &ParameterForm::edited, this,
            [this](const ParameterFacts* facts, std::optional<double> si) {
                m_values[facts] = si.value();
                m_parameters->setValue(*facts, si);
            });
    buildDevice();
    buildConnection();
    buildTrial();
    buildUse();
    auto* buttons = new QHBoxLayout;
    buttons->addStretch(1);
    buttons->addWidget(m_cancel);
    buttons->addWidget(m_use);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_message);
    QSizePolicy kept = m_message->sizePolicy();
    kept.setRetainSizeWhenHidden(true); // nothing moves under the pointer when it comes
    m_message->setSizePolicy(kept);
    layout->addLayout(m_form);
    layout->addStretch(1);
    layout->addSpacing(6);
    layout->addLayout(buttons);
    setMinimumWidth(520);

    connect(m_driver, &QComboBox::activated, this, &DeviceDialog::takeDriver);
    connect(m_profile, &QComboBox::currentIndexChanged, this, &DeviceDialog::showParts);
    connect(m_profileFile, &QPushButton::clicked, this, &DeviceDialog::chooseProfileFile);
    connect(m_port, &QComboBox::editTextChanged, this, &DeviceDialog::showPort);
    connect(m_port, &QComboBox::editTextChanged, this, [this](const QString& text) {
        if (text.trimmed().toStdString() != m_searched)
            endSearch(); // what was found is not there
    });
    connect(m_refresh, &QPushButton::clicked, this, &DeviceDialog::portsWanted);
    connect(m_try, &QPushButton::clicked, this, &DeviceDialog::tryDevice);
    connect(m_use, &QPushButton::clicked, this, [this] {
        if (takeRefusalBy(m_use, *this))
            return;
        m_message->clear();
        emit useWanted(device());
    });
    connect(m_cancel, &QPushButton::clicked, this, &QDialog::reject);
}

QLabel* DeviceDialog::addStep() {
    QLabel* title = boldLabel(this);
    title->setContentsMargins(0, m_form->rowCount() > 0 ? 8 : 0, 0, 0);
    m_form->addRow(title);
    return title;
}

void DeviceDialog::buildDevice() {
    m_profile->setObjectName("profile");
    m_profileFile->setObjectName("profileFile");
    auto* profile = new QHBoxLayout(m_profilePart);
    profile->setContentsMargins(0, 0, 0, 0);
    profile->addWidget(m_profile, 1);
    profile->addWidget(m_profileFile);
    m_deviceStep = addStep();
    m_form->addRow(m_driverLabel, m_driver);
    m_form->addRow(m_profileLabel, m_profilePart);
    m_form->addRow(m_thermal);
    connect(m_thermal, &ThermalCameraForm::failed, this, &DeviceDialog::showError);
}

void DeviceDialog::buildConnection() {
    m_portDescription->setWordWrap(true);
    auto* port = new QGridLayout(m_portPart);
    port->setContentsMargins(0, 0, 0, 0);
    port->setColumnStretch(0, 1);
    port->addWidget(m_port, 0, 0);
    port->addWidget(m_refresh, 0, 1);
    port->addWidget(m_portDescription, 1, 0, 1, 2);
    m_connectionStep = addStep();
    m_form->addRow(m_portLabel, m_portPart);
    m_form->addRow(m_lineLabel, m_line);
    addParameters(SetupStep::Connection);
    m_form->addRow(QString(), m_finder);
    connect(m_finder, &UnitFinder::findWanted, this, &DeviceDialog::search);
    connect(m_finder, &UnitFinder::stopWanted, this, &DeviceDialog::endSearch);
    connect(m_finder, &UnitFinder::chosen, this, &DeviceDialog::takeFound);
}

/// A row for each that some driver of the role has.
void DeviceDialog::addParameters(SetupStep step) {
    std::vector<const ParameterFacts*> facts;
    if (m_role == DeviceRole::Robot)
        addFacts(robotDrivers(), step, facts);
    else if (m_role == DeviceRole::Thermometer)
        addFacts(thermometerDrivers(), step, facts);
    else if (m_role == DeviceRole::HeatSource)
        addFacts(heatSourceDrivers(), step, facts);
    for (const ParameterFacts* each : facts)
        m_parameters->addRow(*each, false);
}

void DeviceDialog::buildTrial() {
    auto* trial = new QHBoxLayout(m_trialPart);
    trial->setContentsMargins(0, 0, 0, 0);
    trial->addWidget(m_try, 0, Qt::AlignTop);
    trial->addWidget(m_result, 1);
    m_trialStep = addStep();
    m_form->addRow(m_trialPart);
}

void DeviceDialog::buildUse() {
    m_homing->setObjectName("homing");
    for (int i = 0; i < 3; ++i)
        m_homing->addItem(QString());
    m_probe->setObjectName("probe");
    auto* channels = new QGridLayout(m_channelsPart);
    channels->setContentsMargins(0, 0, 0, 0);
    channels->setColumnStretch(2, 1);
    for (std::size_t i = 0; i < m_objects.size(); ++i) {
        auto* field = new WholeNumberField(m_channelsPart);
        field->setObjectName(QStringLiteral("channel.%1").arg(i));
        field->setAccessibleName(QString::fromStdString(m_objects[i]));
        channels->addWidget(new QLabel(QString::fromStdString(m_objects[i]), m_channelsPart),
                            static_cast<int>(i), 0);
        channels->addWidget(field, static_cast<int>(i), 1);
        m_channels.push_back(field);
    }
    m_useStep = addStep();
    m_form->addRow(m_axesLabel, m_axes);
    m_form->addRow(m_homingLabel, m_homing);
    m_form->addRow(m_channelsLabel, m_channelsPart);
    addParameters(SetupStep::Use);
    m_form->addRow(QString(), m_probe);
    m_unattended->setObjectName("unattended");
    m_form->addRow(QString(), m_unattended);
}

void DeviceDialog::fill(const RigSpec& rig) {
    for (const DriverFacts* driver : driversOf(m_role))
        m_driver->addItem(QString(), QString::fromLatin1(driver->key));
    const auto choose = [this](const std::string& key) {
        m_driver->setCurrentIndex(m_driver->findData(QString::fromStdString(key)));
    };
    if (m_role == DeviceRole::Robot) {
        const RobotDeviceSpec robot = rig.robot.value_or(RobotDeviceSpec());
        choose(robot.driver);
        takeValues(robotDrivers(), robot, m_values);
        m_line->setLine(rig.robot ? robot.serial : driver().serial);
        m_axes->setAxes(robot.axes);
        m_homing->setCurrentIndex(robot.mustHome ? (*robot.mustHome ? 1 : 2) : 0);
    } else if (m_role == DeviceRole::Thermometer) {
        const ThermometerDeviceSpec thermometer = rig.thermometer.value_or(ThermometerDeviceSpec());
        choose(thermometer.driver);
        takeValues(thermometerDrivers(), thermometer, m_values);
        m_line->setLine(rig.thermometer ? thermometer.serial : driver().serial);
        offerProfiles();
        if (rig.thermometer && isModbus())
            listAndChoose(*m_profile, m_profiles, thermometer.profile);
        const std::vector<int> channels = channelsFor(thermometer.channels, m_objects.size());
        for (std::size_t i = 0; i < m_channels.size(); ++i)
            m_channels[i]->setValue(channels[i]);
    } else if (m_role == DeviceRole::HeatSource) {
        const HeatSourceDeviceSpec source = rig.source.value_or(HeatSourceDeviceSpec());
        choose(source.driver);
        takeValues(heatSourceDrivers(), source, m_values);
        m_line->setLine(rig.source && hasPort() ? source.serial : driver().serial);
        offerProfiles();
        if (rig.source && isModbus())
            listAndChoose(*m_profile, m_profiles, source.profile);
        m_probe->setChecked(source.isProbeUsed);
        m_unattended->setChecked(source.mayHeatUnattended);
    } else if (rig.thermalCamera) {
        m_thermal->setCamera(*rig.thermalCamera);
    }
    for (const auto& [facts, si] : m_values)
        m_parameters->setValue(*facts, si);
    m_port->setEditText(portText(rig, m_role));
    m_port->lineEdit()->setCursorPosition(0); // of a long command its beginning
}

/// Those that fit the role.
void DeviceDialog::offerProfiles() {
    for (const ModbusProfile& profile : shippedProfiles()) {
        const bool isThermometer = profile.channel.has_value();
        const bool isController = profile.processValue && profile.setPoint;
        if (m_role == DeviceRole::Thermometer ? isThermometer : isController)
            listAndChoose(*m_profile, m_profiles, profile);
    }
    m_profile->setCurrentIndex(m_profiles.empty() ? -1 : 0);
    std::vector<std::pair<std::string, std::string>> titles;
    for (const ModbusProfile& profile : m_profiles)
        titles.emplace_back(profile.name, profile.title);
    m_finder->setProfiles(titles);
}

void DeviceDialog::chooseProfileFile() {
    const QString path =
        askFileToOpen(this, tr("Take a profile from a file"), tr("Profiles (*.json)"), FileFolder::Imports);
    if (!path.isEmpty())
        useProfileFile(path);
}

void DeviceDialog::useProfileFile(const QString& path) {
    QFile file(path);
    const auto fail = [this, &path](const Message& message) {
        showError(path + QStringLiteral(": ") + messageText(message));
    };
    if (!file.open(QIODevice::ReadOnly))
        return fail({MessageCode::FileUnreadable, {file.errorString().toStdString()}});
    if (file.size() > kMaxProfile)
        return fail({MessageCode::FileTooLarge, {std::to_string(file.size() >> 20) + " MiB", "1 MiB"}});
    const auto profile = modbusProfileFromJson(file.readAll().toStdString(), {});
    if (!profile)
        return showError(path + QStringLiteral(": ") + QString::fromStdString(profile.error().where) +
                         QStringLiteral(": ") + messageText(profile.error().message));
    m_message->clear();
    listAndChoose(*m_profile, m_profiles, *profile);
}

void DeviceDialog::takeDriver() {
    m_line->setLine(driver().serial);
    if (m_role == DeviceRole::Robot && areUsualAxes(m_axes->axes()))
        m_axes->setAxes(driverOf(*device().robot).usualAxes);
    m_isTried = false;
    endSearch();
    showParts();
}

const DriverFacts& DeviceDialog::driver() const {
    static constexpr DriverFacts kCamera{"", "", DriverLink::None};
    const auto drivers = driversOf(m_role);
    return drivers.empty() ? kCamera : *drivers.at(static_cast<std::size_t>(m_driver->currentIndex()));
}

bool DeviceDialog::hasPort() const {
    return isCamera() || driver().link != DriverLink::None;
}

bool DeviceDialog::hasLine() const {
    return driver().link == DriverLink::Serial;
}

RigSpec DeviceDialog::device() const {
    RigSpec rig;
    const std::string port = m_port->currentText().trimmed().toStdString();
    const ModbusProfile profile = isModbus() && m_profile->currentIndex() >= 0
                                      ? m_profiles[static_cast<std::size_t>(m_profile->currentIndex())]
                                      : ModbusProfile();
    const auto give = [&](auto& spec) {
        spec.driver = driver().key;
        if (hasPort()) {
            spec.port = port;
            spec.serial = m_line->line();
        }
        giveValues(m_values, spec);
    };
    switch (m_role) {
    case DeviceRole::Robot: {
        RobotDeviceSpec& robot = rig.robot.emplace();
        give(robot);
        robot.axes = m_axes->axes();
        if (m_homing->currentIndex() > 0)
            robot.mustHome = m_homing->currentIndex() == 1;
        break;
    }
    case DeviceRole::Thermometer: {
        ThermometerDeviceSpec& thermometer = rig.thermometer.emplace();
        give(thermometer);
        thermometer.profile = profile;
        for (const WholeNumberField* channel : m_channels)
            thermometer.channels.push_back(channel->whole());
        break;
    }
    case DeviceRole::HeatSource: {
        HeatSourceDeviceSpec& source = rig.source.emplace();
        give(source);
        if (!hasPort())
            break;
        source.profile = profile;
        source.isProbeUsed = driverOf(source).hasProbe && m_probe->isChecked();
        source.mayHeatUnattended = m_unattended->isVisibleTo(this) && m_unattended->isChecked();
        break;
    }
    case DeviceRole::Camera:
        rig.camera = port;
        break;
    case DeviceRole::ThermalCamera:
        rig.thermalCamera = m_thermal->camera();
        rig.thermalCamera->device = port;
        break;
    }
    return rig;
}

void DeviceDialog::tryDevice() {
    if (takeRefusalBy(m_try, *this)) // the device is tried with what the fields show
        return;
    m_message->clear();
    endSearch(); // the trial needs the port
    m_isTried = true;
    m_result->setText(tr("Asking…"));
    emit tryWanted(device());
}

void DeviceDialog::endSearch() {
    if (m_searched.empty())
        return;
    m_searched.clear();
    m_finder->reset();
    emit searchEnded();
}

void DeviceDialog::search() {
    m_message->clear();
    ModbusSearchSpec spec;
    spec.port = m_port->currentText().trimmed().toStdString();
    spec.isNetwork = !hasLine();
    m_searched = spec.port;
    m_isTried = false;
    sayNotTried();
    const SerialSettings own = m_line->line();
    spec.lines = {own};
    if (hasLine()) {
        if (own.baud <= 0)
            spec.lines.clear();
        std::ranges::copy_if(kCommonModbusLines, std::back_inserter(spec.lines),
                             [&](const SerialSettings& line) { return line != own; });
    }
    emit searchWanted(spec);
}

void DeviceDialog::setSearch(const ModbusSearchState& state) {
    if (m_finder->setState(state))
        adjustSize();
}

void DeviceDialog::takeFound(int unit, const QString& profile, const SerialSettings& line) {
    for (auto& [facts, si] : m_values)
        if (facts->name == std::string_view("unit")) {
            si = unit;
            m_parameters->setValue(*facts, si);
        }
    const auto known = std::ranges::find(m_profiles, profile.toStdString(), &ModbusProfile::name);
    if (known != m_profiles.end())
        m_profile->setCurrentIndex(static_cast<int>(known - m_profiles.begin()));
    if (hasLine())
        m_line->setLine(line);
}

void DeviceDialog::setTemperatureUnit(TemperatureUnit unit) {
    m_unit = unit;
    m_finder->setTemperatureUnit(unit);
}

void DeviceDialog::setPorts(const std::vector<SerialPort>& ports) {
    m_ports = ports;
    m_arePortsKnown = true;
    const QString typed = m_port->currentText();
    m_port->clear();
    if (hasLine())
        for (const SerialPort& port : ports)
            m_port->addItem(QString::fromStdString(port.path));
    m_port->setEditText(typed.isEmpty() && m_port->count() > 0 ? m_port->itemText(0) : typed);
    showPort();
}

void DeviceDialog::showPort() {
    const auto it = std::ranges::find(m_ports, m_port->currentText().toStdString(), &SerialPort::path);
    const bool isNoneFound =
        m_arePortsKnown && m_ports.empty() && hasLine() && m_port->currentText().isEmpty();
    m_portDescription->setText(
        isNoneFound ? tr("No serial port was found. Plug the device in and refresh, or type a path.")
        : it == m_ports.end() ? QString()
                              : QString::fromStdString(it->description));
    m_portDescription->setVisible(!m_portDescription->text().isEmpty());
}

QString DeviceDialog::triedText(const TriedDevice& tried) const {
    const DeviceStatus& status = tried.state.status;
    QStringList lines{linkWord(status.link)};
    if (!status.identity.empty())
        lines.front() += QStringLiteral(": ") + QString::fromStdString(status.identity);
    if (m_role == DeviceRole::Thermometer) {
        QStringList channels;
        for (std::size_t i = 0; i < tried.temperatures_K.size(); ++i)
            channels << QStringLiteral("%1: %2").arg(i).arg(
                formatTemperature(tried.temperatures_K[i], m_unit));
        if (!channels.isEmpty())
            lines << tr("Channels %1").arg(channels.join(QStringLiteral(", ")));
    } else if (m_role == DeviceRole::ThermalCamera && tried.temperatures_K.size() == 2) {
        lines << tr("Picture from %1 to %2")
                     .arg(formatTemperature(tried.temperatures_K[0], m_unit),
                          formatTemperature(tried.temperatures_K[1], m_unit));
    } else if (!tried.temperatures_K.empty()) {
        lines << tr("Temperature %1").arg(formatTemperature(tried.temperatures_K.front(), m_unit));
    }
    if (tried.coordinates) {
        QStringList at;
        for (const AxisSpec& axis : m_axes->axes())
            at << coordinateWord(axis.coordinate) + u' ' +
                      coordinateReadout(axis.coordinate, (*tried.coordinates)[axis.coordinate]);
        lines << at.join(listSeparator());
    }
    if (status.problem.code != MessageCode::None)
        lines << sentenceText(status.problem);
    return lines.join(u'\n');
}

void DeviceDialog::setTried(const TriedDevice& tried) {
    if (const QString text = triedText(tried); text != m_result->text())
        m_result->setText(text);
}

void DeviceDialog::sayNotTried() {
    if (!m_isTried)
        m_result->setText(tr("Asks the device without using it. Nothing moves or heats."));
}

void DeviceDialog::showError(const QString& sentence) {
    m_isTried = false;
    sayNotTried();
    m_message->say(MessageBar::Kind::Problem, sentence);
}

void DeviceDialog::showParts() {
    const auto showRow = [this](QWidget* field, bool show) {
        field->setVisible(show);
        if (QWidget* label = m_form->labelForField(field))
            label->setVisible(show);
    };
    const RigSpec rig = device();
    const auto applied = m_role == DeviceRole::Robot         ? appliedFacts(rig.robot)
                         : m_role == DeviceRole::Thermometer ? appliedFacts(rig.thermometer)
                                                             : appliedFacts(rig.source);
    for (const auto& [facts, si] : m_values)
        m_parameters->setShown(*facts, std::ranges::find(applied, facts) != applied.end());
    const int profile = m_profile->currentIndex();
    const bool isWatched = isModbus() && m_role == DeviceRole::HeatSource && profile >= 0 &&
                           m_profiles[static_cast<std::size_t>(profile)].watchdog;
    showRow(m_driver, !isCamera());
    m_thermal->setVisible(m_role == DeviceRole::ThermalCamera);
    showRow(m_portPart, hasPort());
    m_refresh->setVisible(hasLine());
    showRow(m_line, hasLine());
    showRow(m_axes, m_role == DeviceRole::Robot);
    showRow(m_homing, rig.robot && driverOf(*rig.robot).canHome);
    showRow(m_profilePart, isModbus());
    showRow(m_finder, isModbus());
    showRow(m_channelsPart, m_role == DeviceRole::Thermometer);
    showRow(m_probe, rig.source && driverOf(*rig.source).hasProbe);
    showRow(m_unattended, m_role == DeviceRole::HeatSource && hasPort() && !isWatched);
    const bool mayTry = hasPort() && m_role != DeviceRole::Camera;
    m_deviceStep->setVisible(mayTry); // the others have one step
    m_connectionStep->setVisible(mayTry);
    m_trialStep->setVisible(mayTry);
    showRow(m_trialPart, mayTry);
    m_useStep->setVisible(mayTry && !isCamera() && (m_role != DeviceRole::HeatSource || hasPort()));
    sayNotTried();
    if (rig.thermometer) {
        const int channels = !isModbus()    ? driverOf(*rig.thermometer).maxChannels
                             : profile >= 0 ? m_profiles[static_cast<std::size_t>(profile)].channels
                                            : ThermometerDriver().maxChannels;
        for (WholeNumberField* channel : m_channels)
            channel->setMaximum(std::max(1, channels) - 1);
    }
    retranslateParts();
    showPort();
    adjustSize();
}

void DeviceDialog::retranslateParts() {
    if (m_role == DeviceRole::ThermalCamera) {
        m_portLabel->setText(tr("Device"));
        m_port->setToolTip(
            tr("A number (0), a device (/dev/video0), a recorded frame or a folder of frames"));
    } else if (m_role == DeviceRole::Camera) {
        m_portLabel->setText(tr("Camera"));
        m_port->setToolTip(
            tr("A number (0), a device (/dev/video0), a video file, a folder of pictures or an address "
               "(rtsp://…)"));
    } else {
        const bool isProgram = driver().link == DriverLink::Program;
        m_portLabel->setText(hasLine() ? tr("Port") : isProgram ? tr("Command") : tr("Address"));
        m_port->setToolTip(hasLine()   ? tr("Choose one, or type its path")
                           : isProgram ? tr("The program and its arguments: python3 /home/lab/my_robot.py")
                                       : tr("Host name or IP address of the device"));
    }
    m_homing->setItemText(0, driver().link == DriverLink::Program
                                 ? tr("When its program says so")
                                 : tr("Once it is homed, if its controller can; else once it is confirmed"));
    nameChoice(m_port, m_portLabel->text());
    m_port->lineEdit()->setPlaceholderText(m_port->toolTip());
    m_useStep->setText(m_role == DeviceRole::Robot         ? tr("4. Its axes")
                       : m_role == DeviceRole::Thermometer ? tr("4. The objects' channels")
                                                           : tr("4. The device's own settings"));
}

void DeviceDialog::retranslate() {
    setWindowTitle(tr("Set up: %1").arg(roleWord(m_role)));
    m_deviceStep->setText(tr("1. Which device"));
    m_connectionStep->setText(tr("2. Where it is connected"));
    m_trialStep->setText(tr("3. Does it answer?"));
    m_driverLabel->setText(tr("Driver"));
    m_driver->setAccessibleName(tr("Driver"));
    for (int i = 0; i < m_driver->count(); ++i)
        m_driver->setItemText(i, driverWord(*driversOf(m_role).at(static_cast<std::size_t>(i))));
    m_refresh->setText(tr("Refresh"));
    m_refresh->setToolTip(tr("Look for ports anew"));
    m_lineLabel->setText(tr("Line"));
    m_axesLabel->setText(tr("Axes"));
    m_homingLabel->setText(tr("Its place is sure"));
    m_homing->setAccessibleName(m_homingLabel->text());
    m_homing->setItemText(1, tr("Once it is homed"));
    m_homing->setItemText(2, tr("Once it is homed or confirmed"));
    m_profileLabel->setText(tr("Device"));
    m_profile->setAccessibleName(tr("Device"));
    m_profileFile->setText(tr("From file…"));
    m_profileFile->setToolTip(tr("Take what the device's registers mean from a file"));
    m_channelsLabel->setText(tr("Channels"));
    m_channelsPart->setToolTip(tr("The channel of each object's sensor, counted from 0"));
    m_probe->setText(tr("Its external probe measures the surface"));
    m_unattended->setText(tr("May heat without a watchdog"));
    m_unattended->setToolTip(
        tr("Then the source stays hot when Bask or the computer stops. Never leave it alone."));
    m_try->setText(tr("Test read"));
    sayNotTried();
    m_use->setText(tr("Use"));
    m_use->setToolTip(tr("Use this device in the experiment"));
    m_cancel->setText(tr("Cancel"));
    retranslateParts();
}

void DeviceDialog::changeEvent(QEvent* event) {
    QDialog::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

} // namespace bask
