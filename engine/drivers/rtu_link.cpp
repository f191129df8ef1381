#include "engine/drivers/rtu_link.h"

#include "engine/base/message_code.h"
#include "engine/drivers/modbus_replies.h"
#include "engine/protocols/modbus_frame.h"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

namespace bask {
namespace {

constexpr std::size_t kExceptionBytes = 5, kWriteReplyBytes = 8;
constexpr double kLongestFrame = 256.0; // bytes
constexpr double kMinGap_s = 0.00175;   // from 19200 baud on

std::string frameOf(const ModbusRequest& request) {
    return modbusRequest({request.unit, request.function, request.address, request.count, request.values});
}

int byteAt(const std::string& bytes, std::size_t i) {
    return static_cast<unsigned char>(bytes[i]);
}

/// A whole frame with its CRC at the beginning of the bytes: 0 where it is none, or not yet.
std::size_t frameLength(const std::string& bytes, const ModbusRequest& request) {
    if (bytes.size() < kExceptionBytes || byteAt(bytes, 0) != request.unit ||
        (byteAt(bytes, 1) & 0x7f) != request.function)
        return 0;
    const bool isException = (byteAt(bytes, 1) & 0x80) != 0;
    const std::size_t length = isException ? kExceptionBytes
                               : request.reads()
                                   ? kExceptionBytes + static_cast<std::size_t>(byteAt(bytes, 2))
                                   : kWriteReplyBytes;
    if (bytes.size() < length)
        return 0;
    const int crc = modbusCrc(std::string_view(bytes).substr(0, length - 2));
    return crc == (byteAt(bytes, length - 2) | byteAt(bytes, length - 1) << 8) ? length : 0;
}

/// Skips what is before a frame: noise, or another unit's answer.
std::optional<std::string> takeFrame(std::string& bytes, const ModbusRequest& request) {
    for (std::size_t at = 0; at + kExceptionBytes <= bytes.size(); ++at) {
        const std::string rest = bytes.substr(at);
        if (const std::size_t length = frameLength(rest, request); length > 0) {
            bytes.erase(0, at + length);
            return rest.substr(0, length);
        }
    }
    return std::nullopt;
}

std::optional<std::vector<std::uint16_t>> registersIn(const std::string& frame,
                                                      const ModbusRequest& request) {
    std::vector<std::uint16_t> out;
    if (!request.reads())
        return frame.substr(0, 6) == frameOf(request).substr(0, 6) ? std::optional(out) : std::nullopt;
    if (byteAt(frame, 2) != 2 * request.count)
        return std::nullopt;
    for (std::size_t i = 3; i + 3 < frame.size(); i += 2)
        out.push_back(static_cast<std::uint16_t>(byteAt(frame, i) << 8 | byteAt(frame, i + 1)));
    return out;
}

} // namespace

struct RtuLink::Line {
    struct Asked {
        int number;
        ModbusRequest request;
        double until_s, overtakenFrom_s;
    };

    void look();
    void take();
    ModbusReply judged(const std::string& frame);
    void deliver(ModbusReply reply);
    void giveUp();
    void leave();
    int ask(const ModbusRequest& request);
    void forget();
    double gap_s() const { return std::max(kMinGap_s, onTheLine_s(settings, kModbusGapBytes)); }
    double longest_s() const { return kOvertake_s + onTheLine_s(settings, kLongestFrame); }
    void keepSilent() { quietUntil_s = clock.now_s() + replyTime_s; }
    Error wrong(const char* words);
    Error silence() const;

    std::unique_ptr<ByteLink> bytes;
    SerialSettings settings;
    const Clock& clock;
    double replyTime_s;
    std::string heard{};
    std::optional<Asked> asked{};
    ModbusReplies replies{};
    std::map<int, std::vector<ModbusRequest>> unanswered{}; ///< by unit: answers to them may still come
    Message problem{}; ///< nobody has answered for long; None: that of the bytes counts
    double quietUntil_s = -1e300;
    double gapUntil_s = -1e300; ///< after the last bytes that came
    double babbles_s = -1e300;  ///< bytes have come without a gap since
    int lastNumber = 0, silent = 0, discarded = 0;
};

RtuLink::RtuLink(std::unique_ptr<ByteLink> line, const SerialSettings& settings, const Clock& clock,
                 double replyTime_s)
    : m_line(new Line{std::move(line), settings, clock, replyTime_s}) {}

RtuLink::~RtuLink() = default;

void RtuLink::open() {
    if (isOpen())
        return;
    const bool wasByHand = m_line->bytes->problem().code == MessageCode::LinkByHand;
    m_line->forget();
    m_line->problem = {};
    m_line->bytes->open();
    if (wasByHand)
        m_line->keepSilent(); // an answer to the person may still come
}

void RtuLink::close() {
    m_line->forget();
    m_line->bytes->close();
}

bool RtuLink::isOpen() const {
    return m_line->bytes->isOpen();
}

/// The request under way is told that there was no answer.
void RtuLink::Line::forget() {
    if (asked)
        deliver(silence());
    asked.reset();
    unanswered.clear();
    heard.clear();
    quietUntil_s = gapUntil_s = -1e300;
    silent = 0;
}

Message RtuLink::problem() const {
    return m_line->problem.code == MessageCode::None ? m_line->bytes->problem() : m_line->problem;
}

bool RtuLink::isFree() const {
    m_line->look();
    return isOpen() && !m_line->asked && m_line->clock.now_s() >= m_line->quietUntil_s;
}

Error RtuLink::Line::wrong(const char* words) {
    ++discarded;
    return {MessageCode::DeviceAnswersWrong, "", {bytes->name(), words}};
}

Error RtuLink::Line::silence() const {
    return {MessageCode::DeviceSilent, "", {bytes->name(), formatNumber(replyTime_s)}};
}

/// The deadline is first: what waited here unread is not to look new.
void RtuLink::Line::look() {
    if (!bytes->isOpen()) {
        if (asked)
            forget();
        return;
    }
    if (asked && clock.now_s() > asked->until_s)
        giveUp();
    const std::string come = bytes->read();
    if (come.empty())
        return;
    if (clock.now_s() >= gapUntil_s)
        babbles_s = clock.now_s();
    gapUntil_s = clock.now_s() + gap_s();
    if (!asked) {
        keepSilent(); // nobody asked for that, or not now
        return;
    }
    heard += come;
    take();
}

void RtuLink::Line::take() {
    const auto frame = takeFrame(heard, asked->request);
    if (!frame)
        return;
    quietUntil_s = gapUntil_s;
    deliver(judged(*frame));
    asked.reset();
    heard.clear();
}

ModbusReply RtuLink::Line::judged(const std::string& frame) {
    const ModbusRequest& request = asked->request;
    silent = 0;
    if (const auto late = unanswered.find(request.unit); late != unanswered.end()) {
        keepSilent();
        bool isSameQuestion = true;
        for (const ModbusRequest& earlier : late->second)
            isSameQuestion = isSameQuestion &&
                             (earlier.function != request.function || frameOf(earlier) == frameOf(request));
        // Of another function this is not the answer, which may still come.
        std::erase_if(late->second,
                      [&](const ModbusRequest& earlier) { return earlier.function == request.function; });
        if (late->second.empty())
            unanswered.erase(late);
        if (!isSameQuestion)
            return wrong("it may be late, to an earlier question");
    }
    if ((byteAt(frame, 1) & 0x80) != 0)
        return modbusException(bytes->name(), request.unit, byteAt(frame, 2));
    if (auto registers = registersIn(frame, request))
        return std::move(*registers);
    keepSilent();
    return wrong(request.reads() ? "another number of registers" : "another write");
}

void RtuLink::Line::deliver(ModbusReply reply) {
    replies.deliver(asked->number, std::move(reply));
}

/// Its answer may still come.
void RtuLink::Line::leave() {
    deliver(silence());
    std::vector<ModbusRequest>& earlier = unanswered[asked->request.unit];
    const std::string frame = frameOf(asked->request);
    if (std::ranges::none_of(earlier, [&](const ModbusRequest& each) { return frameOf(each) == frame; }))
        earlier.push_back(asked->request);
    asked.reset();
    heard.clear();
}

void RtuLink::Line::giveUp() {
    leave();
    keepSilent();
    if (++silent < kMaxSilent)
        return;
    problem = {MessageCode::DeviceSilent, {bytes->name(), formatNumber(silent * 2.0 * replyTime_s, 2)}};
    bytes->close();
}

int RtuLink::Line::ask(const ModbusRequest& request) {
    const std::string frame = frameOf(request);
    const double reply = request.reads() ? 5.0 + 2.0 * request.count : static_cast<double>(kWriteReplyBytes);
    const double bytes_s = onTheLine_s(settings, static_cast<double>(frame.size()) + reply);
    const double now_s = clock.now_s();
    heard.clear();
    asked =
        Asked{++lastNumber, request, now_s + replyTime_s + bytes_s, now_s + kOvertake_s + bytes_s + gap_s()};
    bytes->write(frame);
    return lastNumber;
}

// The caller has asked isFree(), or mayOvertake(): what has come since then must not throw.
int RtuLink::send(const ModbusRequest& request) {
    if (m_line->asked)
        throw std::logic_error("RtuLink: sends only when it is free");
    return m_line->ask(request);
}

bool RtuLink::mayOvertake() const {
    m_line->look();
    const double now_s = m_line->clock.now_s();
    const bool isGap = now_s >= m_line->gapUntil_s;
    if (!isOpen() || (!isGap && now_s - m_line->babbles_s < m_line->longest_s()))
        return false; // who talks for longer than any answer has no end
    return !m_line->asked || now_s >= m_line->asked->overtakenFrom_s;
}

int RtuLink::overtake(const ModbusRequest& request) {
    if (m_line->asked && m_line->clock.now_s() < m_line->asked->overtakenFrom_s)
        throw std::logic_error("RtuLink: overtakes only when it may");
    if (m_line->asked)
        m_line->leave();
    m_line->quietUntil_s = -1e300;
    return m_line->ask(request);
}

std::optional<ModbusReply> RtuLink::takeReply(int number) {
    m_line->look();
    return m_line->replies.take(number);
}

std::string RtuLink::name() const {
    return m_line->bytes->name();
}

std::string RtuLink::portId() const {
    return m_line->bytes->portId();
}

int RtuLink::discarded() const {
    return m_line->discarded;
}

} // namespace bask
