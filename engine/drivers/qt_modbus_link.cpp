#include "engine/drivers/qt_modbus_link.h"

#include "engine/base/message_code.h"
#include "engine/drivers/modbus_pdu.h"
#include "engine/drivers/modbus_replies.h"
#include "engine/drivers/serial_port.h"

#include <QModbusReply>
#include <QModbusRequest>
#include <QModbusResponse>
#include <QModbusRtuSerialClient>
#include <QSerialPort>
#include <QVariant>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

namespace bask {
namespace {

constexpr int kFrameBytes = 8; // of a request that reads, and about those of a reply besides its registers

QSerialPort::Parity lineParity(char letter) {
    return letter == 'E'   ? QSerialPort::EvenParity
           : letter == 'O' ? QSerialPort::OddParity
                           : QSerialPort::NoParity;
}

} // namespace

struct QtModbusLink::Line {
    /// The request under way. Given up when its time is over; Qt may still wait for its reply.
    struct Asked {
        int number;
        ModbusRequest request;
        double until_s;
        QModbusReply* reply;
        bool isGivenUp = false;
    };

    Line(std::string where, const SerialSettings& how, const Clock& time, double reply_s, PortCheck which);
    ~Line() { abort(); }

    QSerialPort* port() const { return qobject_cast<QSerialPort*>(client.device()); }
    void configure();
    void look();
    void finished(QModbusReply* reply);
    ModbusReply judged(const QModbusReply& reply, const ModbusRequest& request);
    void deliver(ModbusReply reply);
    void giveUp();
    void keepSilent() { quietUntil_s = clock.now_s() + replyTime_s; }
    void lose(MessageCode code, std::vector<MessageArg> args);
    void abort();
    double timeFor(const ModbusRequest& request) const;
    Error wrong(const char* words) {
        ++discarded;
        return {MessageCode::DeviceAnswersWrong, "", {path, words}};
    }

    std::string path;
    SerialSettings settings;
    const Clock& clock;
    double replyTime_s;
    PortCheck check;
    Message problem;
    bool isLost = false;     ///< about to be closed
    bool isAnswered = false; ///< by the bytes that are being read
    std::optional<Asked> asked;
    ModbusReplies replies;
    std::map<int, std::vector<ModbusRequest>> unanswered; ///< by unit: answers to them may still come
    double quietUntil_s = -1e300;
    int lastNumber = 0, silent = 0, discarded = 0;
    QModbusRtuSerialClient client;
};

QtModbusLink::Line::Line(std::string where, const SerialSettings& how, const Clock& time, double reply_s,
                         PortCheck which)
    : path(std::move(where)), settings(how), clock(time), replyTime_s(reply_s), check(std::move(which)) {
    QObject::connect(&client, &QModbusDevice::errorOccurred, &client, [this](QModbusDevice::Error e) {
        // A terminal that is no true port refuses some settings; that is no harm.
        if (e == QModbusDevice::ConnectionError || e == QModbusDevice::ReadError ||
            e == QModbusDevice::WriteError || e == QModbusDevice::UnknownError)
            lose(MessageCode::LinkLost, {path, client.errorString().toStdString()});
    });
    QObject::connect(client.device(), &QIODevice::readyRead, &client, [this] {
        if (!std::exchange(isAnswered, false) && !asked)
            keepSilent(); // nobody asked for that
    });
}

void QtModbusLink::Line::configure() {
    const SerialSettings set = settableOf(path, settings);
    client.setConnectionParameter(QModbusDevice::SerialPortNameParameter, QString::fromStdString(path));
    client.setConnectionParameter(QModbusDevice::SerialBaudRateParameter, set.baud);
    client.setConnectionParameter(QModbusDevice::SerialDataBitsParameter, set.dataBits);
    client.setConnectionParameter(QModbusDevice::SerialParityParameter, lineParity(set.parity));
    client.setConnectionParameter(QModbusDevice::SerialStopBitsParameter, set.stopBits);
    client.setNumberOfRetries(0);
}

/// Sees to what is due, without the event loop: a port unplugged, bytes that have come, a deadline passed.
/// The deadline is first: what waited here unread is not to look new.
void QtModbusLink::Line::look() {
    if (isLost || client.state() != QModbusDevice::ConnectedState)
        return;
    if (asked && !asked->isGivenUp && clock.now_s() > asked->until_s)
        giveUp();
    switch (serialPortState(port()->handle())) {
    case SerialPortState::HungUp:
        return lose(MessageCode::LinkLost, {path, "it was unplugged"});
    case SerialPortState::Bytes:
        port()->waitForReadyRead(0);
        break;
    case SerialPortState::Nothing:
        break;
    }
    if (asked && asked->isGivenUp && clock.now_s() > asked->until_s + 4.0 * replyTime_s)
        lose(MessageCode::LinkStuck, {path}); // Qt waits for bytes to be written before it counts time
}

double QtModbusLink::Line::timeFor(const ModbusRequest& request) const {
    const double bytes =
        2.0 * kFrameBytes + 2.0 * std::max<double>(request.count, static_cast<double>(request.values.size()));
    return replyTime_s + bytes * (settings.dataBits + 3) / settings.baud;
}

void QtModbusLink::Line::finished(QModbusReply* reply) {
    reply->deleteLater();
    if (!asked || asked->reply != reply)
        return;
    const bool hasCome =
        reply->error() == QModbusDevice::NoError || reply->error() == QModbusDevice::ProtocolError;
    isAnswered = hasCome;
    if (!asked->isGivenUp && (!hasCome || clock.now_s() > asked->until_s))
        giveUp();
    if (asked->isGivenUp && hasCome)
        ++discarded;
    if (asked->isGivenUp)
        keepSilent();
    else
        deliver(judged(*reply, asked->request));
    asked.reset();
}

ModbusReply QtModbusLink::Line::judged(const QModbusReply& reply, const ModbusRequest& request) {
    silent = 0;
    if (const auto late = unanswered.find(request.unit); late != unanswered.end()) {
        keepSilent();
        bool isSameQuestion = true;
        for (const ModbusRequest& earlier : late->second)
            isSameQuestion = isSameQuestion && isSameOnTheLine(earlier, request);
        unanswered.erase(late);
        if (!isSameQuestion)
            return wrong("it may be late, to an earlier question");
    }
    const QModbusResponse response = reply.rawResult();
    if (response.isException())
        return Error(MessageCode::DeviceException, "",
                     {path, std::to_string(request.unit), std::to_string(response.exceptionCode())});
    if (auto registers = modbusRegisters(response.data().toStdString(), request))
        return std::move(*registers);
    keepSilent();
    return wrong(request.reads() ? "another number of registers" : "another write");
}

void QtModbusLink::Line::deliver(ModbusReply reply) {
    replies.deliver(asked->number, std::move(reply));
}

void QtModbusLink::Line::giveUp() {
    asked->isGivenUp = true;
    deliver(Error(MessageCode::DeviceSilent, "", {path, formatNumber(replyTime_s)}));
    keepSilent();
    std::vector<ModbusRequest>& earlier = unanswered[asked->request.unit];
    const bool isKnown = std::any_of(earlier.begin(), earlier.end(), [this](const ModbusRequest& request) {
        return isSameOnTheLine(request, asked->request);
    });
    if (!isKnown)
        earlier.push_back(asked->request);
    if (++silent >= kMaxSilent)
        lose(MessageCode::DeviceSilent, {path, formatNumber(silent * 2.0 * replyTime_s, 2)});
}

/// The port cannot be closed in its own slot; left open, an unplugged one raises errors as fast as the
/// processor can (Qt up to 6.7).
void QtModbusLink::Line::lose(MessageCode code, std::vector<MessageArg> args) {
    if (isLost || client.state() != QModbusDevice::ConnectedState)
        return;
    isLost = true;
    problem = {code, std::move(args)};
    const auto close = [this] {
        if (isLost)
            abort();
    };
    QMetaObject::invokeMethod(&client, close, Qt::QueuedConnection);
}

/// Closes; the request under way is told that there was no answer.
void QtModbusLink::Line::abort() {
    if (asked && !asked->isGivenUp)
        deliver(Error(MessageCode::DeviceSilent, "", {path, formatNumber(replyTime_s)}));
    asked.reset();
    unanswered.clear();
    quietUntil_s = -1e300;
    silent = 0;
    client.disconnectDevice();
    isLost = false;
}

QtModbusLink::QtModbusLink(std::string path, const SerialSettings& settings, const Clock& clock,
                           double replyTime_s, PortCheck check)
    : m_line(std::make_unique<Line>(std::move(path), settings, clock, replyTime_s, std::move(check))) {}

QtModbusLink::~QtModbusLink() = default;

void QtModbusLink::open() {
    if (isOpen())
        return;
    close();
    m_line->problem = m_line->check.look(m_line->path);
    if (m_line->problem.code != MessageCode::None)
        return;
    m_line->configure();
    const bool isOpened = m_line->client.connectDevice();
    if (isOpened && lockPort(m_line->port()->handle()))
        return;
    const bool isTaken = isOpened || m_line->port()->error() == QSerialPort::PermissionError;
    const std::string words = whyNotOpened(m_line->path, isTaken, m_line->client.errorString().toStdString());
    close();
    m_line->problem = {MessageCode::LinkNotOpened, {m_line->path, words}};
}

void QtModbusLink::close() {
    m_line->abort();
}

bool QtModbusLink::isOpen() const {
    m_line->look();
    return !m_line->isLost && m_line->client.state() == QModbusDevice::ConnectedState;
}

Message QtModbusLink::problem() const {
    return m_line->problem;
}

bool QtModbusLink::isFree() const {
    return isOpen() && !m_line->asked && m_line->clock.now_s() >= m_line->quietUntil_s;
}

int QtModbusLink::send(const ModbusRequest& request) {
    if (!isFree())
        throw std::logic_error("QtModbusLink: sends only when it is free");
    Line& line = *m_line;
    const double time_s = line.timeFor(request);
    line.client.setTimeout(static_cast<int>(std::ceil(1000.0 * time_s)));
    const QModbusRequest asked(static_cast<QModbusPdu::FunctionCode>(request.function),
                               QByteArray::fromStdString(modbusData(request)));
    QModbusReply* reply = line.client.sendRawRequest(asked, request.unit);
    if (reply == nullptr)
        throw std::logic_error("QtModbusLink: Qt refuses a request");
    line.asked = Line::Asked{++line.lastNumber, request, line.clock.now_s() + time_s, reply};
    QObject::connect(reply, &QModbusReply::finished, &line.client, [&line, reply] { line.finished(reply); });
    return line.lastNumber;
}

std::optional<ModbusReply> QtModbusLink::takeReply(int number) {
    m_line->look();
    return m_line->replies.take(number);
}

std::string QtModbusLink::portId() const {
    return m_line->check.found();
}

std::string QtModbusLink::name() const {
    return m_line->path;
}

int QtModbusLink::discarded() const {
    return m_line->discarded;
}

} // namespace bask
