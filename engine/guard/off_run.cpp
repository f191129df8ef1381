#include "engine/guard/off_run.h"

#include <bit>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <poll.h>

namespace bask::guard {
namespace {

constexpr int kQuickPasses = 10; // then it is tried less often: memories of set points wear
constexpr int kAtOnce_ms = 10, kSoon_ms = 300, kLater_ms = 5000;
constexpr int kLook_ms = 1000, kSlowLooks = 5;
constexpr int kDrop_ms = 500;                         // a busy computer's own work on what has come
constexpr int kLoggedOften = 10, kLoggedSeldom = 100; // passes

double now_s() {
    timespec now{};
    ::clock_gettime(CLOCK_MONOTONIC, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// As it can be read: printable as it is, else in hexadecimal.
void show(char* out, std::size_t size, const unsigned char* bytes, std::size_t count) {
    std::size_t at = 0;
    for (std::size_t i = 0; i < count && at + 5 < size; ++i) {
        const bool isPlain = bytes[i] >= ' ' && bytes[i] <= '~';
        at +=
            static_cast<std::size_t>(std::snprintf(out + at, size - at, isPlain ? "%c" : "<%02x>", bytes[i]));
    }
    out[at] = '\0';
}

bool isBlank(unsigned char byte) {
    return byte == ' ' || byte == '\r' || byte == '\n';
}

/// A whole line "0.0 1", blanks around it.
bool isNumberLine(const char* line, const OffStep& step) {
    char* end = nullptr;
    const double number = std::strtod(line, &end);
    if (end == line || *end != ' ' || !(number <= step.max))
        return false;
    while (*end == ' ')
        ++end;
    if (std::strncmp(end, reinterpret_cast<const char*>(step.expect), step.expects) != 0)
        return false;
    for (end += step.expects; *end != '\0'; ++end)
        if (!isBlank(static_cast<unsigned char>(*end)))
            return false;
    return true;
}

bool hasNumber(const OffStep& step, const unsigned char* bytes, std::size_t count) {
    char line[128] = {};
    std::size_t length = 0;
    for (std::size_t i = 0; i < count; ++i) {
        if (bytes[i] != '\n' && bytes[i] != '\r') {
            if (length + 1 < sizeof line)
                line[length++] = static_cast<char>(bytes[i]);
            continue;
        }
        line[length] = '\0';
        if (length > 0 && isNumberLine(line, step))
            return true;
        length = 0;
    }
    return false;
}

/// As engine/protocols has it, which is not linked here.
unsigned modbusCrc(const unsigned char* bytes, std::size_t count) {
    unsigned crc = 0xffff;
    for (std::size_t i = 0; i < count; ++i) {
        crc ^= bytes[i];
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc & 1U) != 0 ? crc >> 1U ^ 0xa001U : crc >> 1U;
    }
    return crc;
}

double registerNumber(const OffStep& step, const unsigned char* data) {
    const auto word = [&](int i) { return static_cast<std::uint32_t>(data[2 * i] << 8 | data[2 * i + 1]); };
    const bool isShort = step.type == OffStep::Type::Int16 || step.type == OffStep::Type::Uint16;
    const std::uint32_t bits = isShort               ? word(0)
                               : step.isLowWordFirst ? word(1) << 16U | word(0)
                                                     : word(0) << 16U | word(1);
    switch (step.type) {
    case OffStep::Type::Int16:
        return static_cast<std::int16_t>(bits);
    case OffStep::Type::Int32:
        return static_cast<std::int32_t>(bits);
    case OffStep::Type::Float32:
        return static_cast<double>(std::bit_cast<float>(bits));
    case OffStep::Type::Uint16:
    case OffStep::Type::Uint32:
        break;
    }
    return bits;
}

bool hasRegister(const OffStep& step, const unsigned char* bytes, std::size_t count) {
    const std::size_t head = step.expects; // unit, function, bytes of data
    if (head != 3)
        return false;
    const std::size_t data = step.expect[2], whole = head + data + 2;
    for (std::size_t at = 0; at + whole <= count; ++at) {
        const unsigned char* frame = bytes + at;
        const unsigned crc = frame[whole - 2] | static_cast<unsigned>(frame[whole - 1]) << 8U;
        if (std::memcmp(frame, step.expect, head) != 0 || modbusCrc(frame, whole - 2) != crc)
            continue;
        const double number = registerNumber(step, frame + head);
        if (number >= step.min && number <= step.max)
            return true;
    }
    return false;
}

} // namespace

bool fits(const OffStep& step, const unsigned char* bytes, std::size_t count) {
    switch (step.reply) {
    case OffStep::Reply::None:
        return true;
    case OffStep::Reply::Bytes:
        return step.expects > 0 && ::memmem(bytes, count, step.expect, step.expects) != nullptr;
    case OffStep::Reply::Number:
        return hasNumber(step, bytes, count);
    case OffStep::Reply::Register:
        return hasRegister(step, bytes, count);
    }
    return false;
}

bool OffRun::isLogged() const {
    return m_passes <= kLoggedOften || m_passes % kLoggedSeldom == 0;
}

void OffRun::untilConfirmed() {
    if (m_port.isOpen())
        m_port.forget();
    for (;;) {
        ++m_passes;
        if (isOpen() && hear(nullptr, m_program.quiet_ms) && pass()) {
            m_log.say("the heat is confirmed off, at the %d. try", m_passes);
            return;
        }
        // One frame that was lost is no reason to wait.
        ::poll(nullptr, 0, m_passes == 1 ? kAtOnce_ms : m_passes < kQuickPasses ? kSoon_ms : kLater_ms);
    }
}

bool OffRun::isOpen() {
    if (m_port.isOpen())
        return true;
    if (m_port.isOpening())
        m_log.say("the port is still being opened");
    else
        m_port.open();
    std::size_t count = 0;
    for (int looks = 0; m_port.isOpening() && m_port.take(m_bytes, count) == GuardedPort::Event::None;
         ++looks) {
        if (looks == kSlowLooks)
            m_log.say("the port takes long to open");
        pollfd state{m_port.descriptor(), POLLIN, 0};
        ::poll(&state, 1, kLook_ms);
    }
    if (!m_port.isOpen() && isLogged())
        m_log.say("the port cannot be opened: %s", m_port.problem() == SerialLine::kExchanged
                                                       ? "another one is at its place"
                                                       : std::strerror(m_port.problem()));
    return m_port.isOpen();
}

bool OffRun::pass() {
    bool isOff = m_program.count > 0;
    for (std::size_t i = 0; i < m_program.count && m_port.isOpen(); ++i)
        isOff = take(m_program.steps[i]) && isOff;
    return isOff && m_port.isOpen();
}

bool OffRun::take(const OffStep& step) {
    if (step.mustFit)
        dropOld();
    if (!m_port.isOpen())
        return false;
    m_heard = 0;
    if (!m_port.write(step.send, step.sends) || !m_port.flush())
        m_port.forget();
    const bool hasCome = hear(&step, step.timeout_ms);
    if (isLogged()) {
        char sent[200], heard[120];
        show(sent, sizeof sent, step.send, step.sends);
        show(heard, sizeof heard, m_bytes, m_heard);
        m_log.say("sent \"%s\", read \"%s\"%s", sent, heard,
                  !hasCome && step.mustFit ? ", which is not off" : "");
    }
    (void)hear(nullptr, step.pause_ms);
    return hasCome || !step.mustFit;
}

void OffRun::lose() {
    m_log.say("the port was unplugged");
    m_port.close();
}

/// An answer to somebody's earlier question is no answer to this one.
void OffRun::dropOld() {
    m_port.drop();
    const double until_s = now_s() + 1e-3 * kDrop_ms;
    std::size_t count = 0;
    while (now_s() < until_s) {
        const GuardedPort::Event event = m_port.take(m_bytes, count);
        if (event == GuardedPort::Event::Lost)
            lose();
        if (event == GuardedPort::Event::Dropped || event == GuardedPort::Event::Lost)
            return;
        pollfd state{m_port.descriptor(), POLLIN, 0};
        ::poll(&state, 1, 10);
    }
}

/// The newest: what is wanted comes last.
void OffRun::keep(const unsigned char* bytes, std::size_t count) {
    if (count > sizeof m_bytes) {
        bytes += count - sizeof m_bytes;
        count = sizeof m_bytes;
    }
    if (m_heard + count > sizeof m_bytes)
        m_heard = 0;
    std::memcpy(m_bytes + m_heard, bytes, count);
    m_heard += count;
}

bool OffRun::hear(const OffStep* step, int ms) {
    const double until_s = now_s() + 1e-3 * ms;
    for (;;) {
        if (step != nullptr && step->reply != OffStep::Reply::None && fits(*step, m_bytes, m_heard))
            return true;
        const double left_ms = 1e3 * (until_s - now_s());
        if (left_ms <= 0.0 && (step == nullptr || step->reply != OffStep::Reply::None || m_port.isFlushed()))
            return step == nullptr || step->reply == OffStep::Reply::None;
        if (left_ms <= -1000.0)
            return false; // it takes nothing
        const int wait_ms = m_port.isFlushed() ? static_cast<int>(left_ms) : GuardedPort::kFlush_ms;
        pollfd state{m_port.descriptor(), POLLIN, 0};
        ::poll(&state, 1, wait_ms > 1 ? wait_ms : 1);
        unsigned char bytes[GuardedPort::kMaxBytes];
        std::size_t count = 0;
        const GuardedPort::Event event = m_port.take(bytes, count);
        if (event == GuardedPort::Event::Lost || !m_port.flush()) {
            lose();
            return false;
        }
        if (step != nullptr && event == GuardedPort::Event::Bytes)
            keep(bytes, count);
    }
}

} // namespace bask::guard
