#pragma once
// Requests to the Modbus devices on one line, one at a time; several drivers may share the line.

#include "engine/base/result.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace bask {

/// Function 3 or 4 reads `count` registers from `address` (counted from 0), 6 or 16 writes `values` there.
struct ModbusRequest {
    int unit = 1;
    int function = 3;
    int address = 0;
    int count = 1;
    std::vector<std::uint16_t> values = {};

    bool reads() const { return function == 3 || function == 4; }
};

/// The registers read: exactly as many as requested; none for a write. Errors: DeviceSilent, DeviceException,
/// DeviceAnswersWrong.
using ModbusReply = Result<std::vector<std::uint16_t>>;

/// Exceptions of a gateway that has no such unit behind it (Modbus application protocol 1.1b3, 7).
inline constexpr int kNoGatewayPath = 10;
inline constexpr int kNoGatewayAnswer = 11;
/// Returns the error of a request that a unit answered with an exception.
Error modbusException(const std::string& port, int unit, int exception);
/// Returns the exception of such an error; empty for any other.
std::optional<int> exceptionOf(const Error& error);

/// No function here waits. Use it only on the engine thread.
class ModbusLink {
public:
    virtual ~ModbusLink() = default;
    virtual void open() = 0;
    virtual void close() = 0;
    virtual bool isOpen() const = 0;
    /// Returns why it could not be opened, or was lost later; code None if neither. A lost link is closed.
    virtual Message problem() const = 0;
    /// False while a request is in progress, while the line stays silent after a timeout, or if the link is
    /// closed.
    virtual bool isFree() const = 0;
    /// Call it only if isFree(). Returns the request's number.
    virtual int send(const ModbusRequest& request) = 0;
    /// Returns whether a request may replace the one in progress, which is then abandoned: a command to
    /// switch off must not wait for an answer that may never arrive. False while that request, or its answer,
    /// is on the line.
    virtual bool mayOvertake() const { return isFree(); }
    /// Call it only if mayOvertake(). Like send(); the sender of the abandoned request is told that there was
    /// no answer.
    virtual int overtake(const ModbusRequest& request) { return send(request); }
    /// Returns the reply to that request, once; empty until it arrives. Every request gets one eventually.
    virtual std::optional<ModbusReply> takeReply(int number) = 0;
    virtual std::string name() const = 0;
    /// Returns the port's own name from the last time it was opened; empty if it has none.
    virtual std::string portId() const { return {}; }

protected:
    /// Unanswered requests in a row after which the port is opened again.
    static constexpr int kMaxSilent = 10;
};

} // namespace bask
