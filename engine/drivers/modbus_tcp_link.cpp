#include "engine/drivers/modbus_tcp_link.h"

#include "engine/base/message_code.h"
#include "engine/drivers/modbus_replies.h"
#include "engine/protocols/modbus_frame.h"

#include <stdexcept>
#include <utility>

namespace bask {
namespace {

constexpr std::size_t kCrcBytes = 2, kEchoBytes = 6; // an echo: unit, function, two words
constexpr int kTransactions = 0x10000;

/// Unit, function and data.
std::string tcpRequest(const ModbusRequest& request) {
    std::string frame =
        modbusRequest({request.unit, request.function, request.address, request.count, request.values});
    frame.resize(frame.size() - kCrcBytes);
    return frame;
}

int unsignedAt(const std::string& bytes, std::size_t i) {
    return static_cast<unsigned char>(bytes[i]);
}

/// The registers of a reply of that unit and function; empty if it does not answer the request.
std::optional<std::vector<std::uint16_t>> tcpRegisters(const std::string& reply,
                                                       const ModbusRequest& request) {
    std::vector<std::uint16_t> out;
    if (!request.reads())
        return reply == tcpRequest(request).substr(0, kEchoBytes) ? std::optional(out) : std::nullopt;
    if (unsignedAt(reply, 2) != 2 * request.count ||
        reply.size() != 3 + 2 * static_cast<std::size_t>(request.count))
        return std::nullopt;
    for (std::size_t i = 3; i + 1 < reply.size(); i += 2)
        out.push_back(static_cast<std::uint16_t>(unsignedAt(reply, i) << 8 | unsignedAt(reply, i + 1)));
    return out;
}

} // namespace

struct ModbusTcpLink::Line {
    struct Asked {
        int number;
        ModbusRequest request;
        double until_s, overtakenFrom_s;
    };

    void look();
    void take(const ModbusTcpFrame& frame);
    ModbusReply judged(const std::string& reply) const;
    void deliver(ModbusReply reply);
    void leave();
    void giveUp();
    void lose(Message why);
    int ask(const ModbusRequest& request);
    void forget();
    /// The number of a request in its frame.
    static int transaction(int number) { return number % kTransactions; }
    Error wrong(const char* words) const {
        return {MessageCode::DeviceAnswersWrong, "", {bytes->name(), words}};
    }

    std::unique_ptr<ByteLink> bytes;
    const Clock& clock;
    double replyTime_s;
    std::string heard{};
    std::optional<Asked> asked{};
    ModbusReplies replies{};
    Message problem{}; ///< None: that of the bytes counts
    int lastNumber = 0, silent = 0, discarded = 0;
};

ModbusTcpLink::ModbusTcpLink(std::unique_ptr<ByteLink> line, const Clock& clock, double replyTime_s)
    : m_line(new Line{std::move(line), clock, replyTime_s}) {}

ModbusTcpLink::~ModbusTcpLink() = default;

void ModbusTcpLink::open() {
    if (isOpen())
        return;
    m_line->forget();
    m_line->problem = {};
    m_line->bytes->open();
}

void ModbusTcpLink::close() {
    m_line->forget();
    m_line->bytes->close();
}

bool ModbusTcpLink::isOpen() const {
    return m_line->bytes->isOpen();
}

/// The request under way is told that there was no answer.
void ModbusTcpLink::Line::forget() {
    if (asked)
        leave();
    heard.clear();
    silent = 0;
}

Message ModbusTcpLink::problem() const {
    return m_line->problem.code == MessageCode::None ? m_line->bytes->problem() : m_line->problem;
}

/// The deadline is first: what waited here unread is not to look new.
void ModbusTcpLink::Line::look() {
    if (!bytes->isOpen())
        return forget();
    if (asked && clock.now_s() > asked->until_s)
        giveUp();
    heard += bytes->read();
    std::string_view left = heard;
    while (const auto frame = takeModbusTcpFrame(left))
        take(*frame);
    heard.erase(0, heard.size() - left.size());
    if (isModbusTcpBroken(heard))
        lose(wrong("what came is no Modbus TCP").message);
}

void ModbusTcpLink::Line::take(const ModbusTcpFrame& frame) {
    const std::string& reply = frame.unitAndPdu;
    if (!asked || frame.transaction != transaction(asked->number)) {
        ++discarded; // late, or nobody has asked
        return;
    }
    silent = 0;
    auto verdict = judged(reply);
    discarded += !verdict && verdict.error().code() == MessageCode::DeviceAnswersWrong ? 1 : 0;
    deliver(std::move(verdict));
    asked.reset();
}

ModbusReply ModbusTcpLink::Line::judged(const std::string& reply) const {
    const ModbusRequest& request = asked->request;
    if (unsignedAt(reply, 0) != request.unit)
        return wrong("another unit");
    if ((unsignedAt(reply, 1) & 0x7f) != request.function)
        return wrong("another function");
    if ((unsignedAt(reply, 1) & 0x80) != 0)
        return modbusException(bytes->name(), request.unit, unsignedAt(reply, 2));
    if (auto registers = tcpRegisters(reply, request))
        return std::move(*registers);
    return wrong(request.reads() ? "another number of registers" : "another write");
}

void ModbusTcpLink::Line::deliver(ModbusReply reply) {
    replies.deliver(asked->number, std::move(reply));
}

void ModbusTcpLink::Line::leave() {
    deliver(Error(MessageCode::DeviceSilent, "", {bytes->name(), formatNumber(replyTime_s)}));
    asked.reset();
}

void ModbusTcpLink::Line::giveUp() {
    leave();
    if (++silent >= kMaxSilent)
        lose({MessageCode::DeviceSilent, {bytes->name(), formatNumber(silent * replyTime_s, 2)}});
}

void ModbusTcpLink::Line::lose(Message why) {
    forget();
    bytes->close();
    problem = std::move(why);
}

int ModbusTcpLink::Line::ask(const ModbusRequest& request) {
    const double now_s = clock.now_s();
    asked = Asked{++lastNumber, request, now_s + replyTime_s, now_s + kOvertake_s};
    bytes->write(modbusTcpFrame(transaction(asked->number), tcpRequest(request)));
    return asked->number;
}

bool ModbusTcpLink::isFree() const {
    m_line->look();
    return isOpen() && !m_line->asked;
}

// The caller has asked isFree(), or mayOvertake(): what has come since then must not throw.
int ModbusTcpLink::send(const ModbusRequest& request) {
    if (m_line->asked)
        throw std::logic_error("ModbusTcpLink: sends only when it is free");
    return m_line->ask(request);
}

bool ModbusTcpLink::mayOvertake() const {
    m_line->look();
    return isOpen() && (!m_line->asked || m_line->clock.now_s() >= m_line->asked->overtakenFrom_s);
}

int ModbusTcpLink::overtake(const ModbusRequest& request) {
    if (m_line->asked && m_line->clock.now_s() < m_line->asked->overtakenFrom_s)
        throw std::logic_error("ModbusTcpLink: overtakes only when it may");
    if (m_line->asked)
        m_line->leave();
    return m_line->ask(request);
}

std::optional<ModbusReply> ModbusTcpLink::takeReply(int number) {
    m_line->look();
    return m_line->replies.take(number);
}

std::string ModbusTcpLink::name() const {
    return m_line->bytes->name();
}

std::string ModbusTcpLink::portId() const {
    return m_line->bytes->portId();
}

int ModbusTcpLink::discarded() const {
    return m_line->discarded;
}

} // namespace bask
