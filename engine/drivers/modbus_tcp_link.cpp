#include "engine/drivers/modbus_tcp_link.h"

#include "engine/base/message_code.h"
#include "engine/drivers/modbus_pdu.h"
#include "engine/drivers/port_claim.h"

#include <QModbusReply>
#include <QModbusTcpClient>
#include <QTcpSocket>
#include <QVariant>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

namespace bask {

std::optional<NetworkAddress> networkAddress(const std::string& text, int usual) {
    NetworkAddress out{text, usual};
    std::size_t colon = std::string::npos;
    if (text.starts_with('[')) { // the address itself has colons
        const std::size_t end = text.find(']');
        if (end == std::string::npos || (end + 1 != text.size() && text[end + 1] != ':'))
            return std::nullopt;
        out.host = text.substr(1, end - 1);
        colon = end + 1 < text.size() ? end + 1 : std::string::npos;
    } else if (std::ranges::count(text, ':') == 1) {
        colon = text.find(':');
        out.host = text.substr(0, colon);
    }
    if (colon != std::string::npos) {
        const char* const end = text.data() + text.size();
        const auto read = std::from_chars(text.data() + colon + 1, end, out.port);
        if (read.ec != std::errc() || read.ptr != end)
            return std::nullopt;
    }
    const bool isHost = !out.host.empty() && out.host.find_first_of(" /\t") == std::string::npos;
    return isHost && out.port >= 1 && out.port <= 65535 ? std::optional(out) : std::nullopt;
}

struct ModbusTcpLink::Line {
    /// The request under way. Given up when its time is over.
    struct Asked {
        int number;
        ModbusRequest request;
        double until_s;
        QModbusReply* reply;
    };

    Line(std::string where, const Clock& time, double reply_s);
    ~Line() { abort(); }

    bool isConnected() const { return client.state() == QModbusDevice::ConnectedState; }
    std::string words() const;
    void look();
    void finished(QModbusReply* reply);
    ModbusReply judged(const QModbusReply& reply, const ModbusRequest& request) const;
    void deliver(ModbusReply reply);
    void giveUp();
    void lose(MessageCode code, std::vector<MessageArg> args);
    void abort();

    std::string address;
    const Clock& clock;
    double replyTime_s;
    Message problem;
    bool isWanted = false; ///< is open or being opened
    bool wasOpen = false;  ///< since it was opened
    double opened_s = -1e300;
    std::optional<Asked> asked;
    std::map<int, ModbusReply> replies;
    int lastNumber = 0, silent = 0;
    PortClaim claim;
    QModbusTcpClient client;
};

ModbusTcpLink::Line::Line(std::string where, const Clock& time, double reply_s)
    : address(std::move(where)), clock(time), replyTime_s(reply_s) {
    client.setNumberOfRetries(0);
    QObject::connect(&client, &QModbusDevice::errorOccurred, &client, [this](QModbusDevice::Error error) {
        if (error == QModbusDevice::ConnectionError || error == QModbusDevice::ReadError ||
            error == QModbusDevice::WriteError || error == QModbusDevice::UnknownError)
            lose(wasOpen ? MessageCode::LinkLost : MessageCode::LinkNotOpened, {address, words()});
    });
    QObject::connect(&client, &QModbusDevice::stateChanged, &client, [this](QModbusDevice::State state) {
        if (state == QModbusDevice::ConnectedState) {
            wasOpen = true;
            if (auto* socket = qobject_cast<QTcpSocket*>(client.device()))
                socket->setSocketOption(QAbstractSocket::LowDelayOption, 1);
        } else if (state == QModbusDevice::UnconnectedState) { // an error is told after it, in its words
            const auto look = [this] {
                if (client.state() == QModbusDevice::UnconnectedState)
                    lose(wasOpen ? MessageCode::LinkLost : MessageCode::LinkNotOpened,
                         {address, "it was closed"});
            };
            QMetaObject::invokeMethod(&client, look, Qt::QueuedConnection);
        }
    });
}

/// Of the socket, whose are plainer than those of Qt's client.
std::string ModbusTcpLink::Line::words() const {
    const auto* socket = qobject_cast<QTcpSocket*>(client.device());
    return (socket != nullptr ? socket->errorString() : client.errorString()).toStdString();
}

/// Sees to what is due, without the event loop.
void ModbusTcpLink::Line::look() {
    if (asked && clock.now_s() > asked->until_s)
        giveUp();
    if (isWanted && !wasOpen && clock.now_s() - opened_s > kOpening_s)
        lose(MessageCode::LinkNotOpened, {address, "the host does not answer"});
}

void ModbusTcpLink::Line::finished(QModbusReply* reply) {
    reply->deleteLater();
    if (!asked || asked->reply != reply)
        return;
    const bool hasCome =
        reply->error() == QModbusDevice::NoError || reply->error() == QModbusDevice::ProtocolError;
    if (!hasCome)
        return giveUp();
    silent = 0;
    deliver(judged(*reply, asked->request));
    asked.reset();
}

ModbusReply ModbusTcpLink::Line::judged(const QModbusReply& reply, const ModbusRequest& request) const {
    const QModbusResponse response = reply.rawResult();
    if (response.isException())
        return Error(MessageCode::DeviceException, "",
                     {address, std::to_string(request.unit), std::to_string(response.exceptionCode())});
    if (auto registers = modbusRegisters(response.data().toStdString(), request))
        return std::move(*registers);
    return Error(MessageCode::DeviceAnswersWrong, "",
                 {address, request.reads() ? "another number of registers" : "another write"});
}

void ModbusTcpLink::Line::deliver(ModbusReply reply) {
    replies.emplace(asked->number, std::move(reply));
    if (replies.size() > kMaxReplies)
        replies.erase(replies.begin());
}

void ModbusTcpLink::Line::giveUp() {
    deliver(Error(MessageCode::DeviceSilent, "", {address, formatNumber(replyTime_s)}));
    asked.reset();
    if (++silent >= kMaxSilent)
        lose(MessageCode::DeviceSilent, {address, formatNumber(silent * replyTime_s, 2)});
}

/// Qt's client cannot be closed in its own slot.
void ModbusTcpLink::Line::lose(MessageCode code, std::vector<MessageArg> args) {
    if (!std::exchange(isWanted, false))
        return;
    problem = {code, std::move(args)};
    QMetaObject::invokeMethod(
        &client,
        [this] {
            if (!isWanted)
                abort();
        },
        Qt::QueuedConnection);
}

void ModbusTcpLink::Line::abort() {
    isWanted = wasOpen = false;
    if (asked)
        deliver(Error(MessageCode::DeviceSilent, "", {address, formatNumber(replyTime_s)}));
    asked.reset();
    silent = 0;
    client.disconnectDevice();
    claim.release();
}

ModbusTcpLink::ModbusTcpLink(std::string address, const Clock& clock, double replyTime_s)
    : m_line(std::make_unique<Line>(std::move(address), clock, replyTime_s)) {}

ModbusTcpLink::~ModbusTcpLink() = default;

void ModbusTcpLink::open() {
    Line& line = *m_line;
    if (line.isWanted)
        return;
    line.abort();
    line.problem = {};
    const auto fail = [&line](const char* words) {
        line.problem = {MessageCode::LinkNotOpened, {line.address, words}};
    };
    const auto where = networkAddress(line.address, kPort);
    if (!where)
        return fail("it is no address such as 192.168.1.20 or logger:1502");
    if (!line.claim.take(where->host + ':' + std::to_string(where->port)))
        return fail("another Bask on this computer has it open");
    line.client.setConnectionParameter(QModbusDevice::NetworkAddressParameter,
                                       QString::fromStdString(where->host));
    line.client.setConnectionParameter(QModbusDevice::NetworkPortParameter, where->port);
    line.client.setTimeout(static_cast<int>(std::ceil(2000.0 * line.replyTime_s))); // look() is earlier
    line.isWanted = true;
    line.opened_s = line.clock.now_s();
    if (!line.client.connectDevice()) {
        line.isWanted = false;
        fail("it cannot be connected to");
    }
}

void ModbusTcpLink::close() {
    m_line->abort();
}

bool ModbusTcpLink::isOpen() const {
    m_line->look();
    return m_line->isWanted && m_line->isConnected();
}

Message ModbusTcpLink::problem() const {
    return m_line->problem;
}

bool ModbusTcpLink::isFree() const {
    return isOpen() && !m_line->asked;
}

int ModbusTcpLink::send(const ModbusRequest& request) {
    if (!isFree())
        throw std::logic_error("ModbusTcpLink: sends only when it is free");
    Line& line = *m_line;
    const QModbusRequest asked(static_cast<QModbusPdu::FunctionCode>(request.function),
                               QByteArray::fromStdString(modbusData(request)));
    QModbusReply* reply = line.client.sendRawRequest(asked, request.unit);
    if (reply == nullptr)
        throw std::logic_error("ModbusTcpLink: Qt refuses a request");
    line.asked = Line::Asked{++line.lastNumber, request, line.clock.now_s() + line.replyTime_s, reply};
    QObject::connect(reply, &QModbusReply::finished, &line.client, [&line, reply] { line.finished(reply); });
    return line.lastNumber;
}

std::optional<ModbusReply> ModbusTcpLink::takeReply(int number) {
    m_line->look();
    const auto it = m_line->replies.find(number);
    if (it == m_line->replies.end())
        return std::nullopt;
    std::optional<ModbusReply> out(std::move(it->second));
    m_line->replies.erase(it);
    return out;
}

std::string ModbusTcpLink::name() const {
    return m_line->address;
}

} // namespace bask
