#pragma once
// Requests to the Modbus devices on one line, one at a time; several drivers may share the line.

#include "engine/base/result.h"

#include <cstdint>
#include <optional>
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

/// Registers as read: as many as were asked for, never fewer; none of a write. Errors: DeviceSilent,
/// DeviceException, DeviceAnswersWrong.
using ModbusReply = Result<std::vector<std::uint16_t>>;

/// Nothing here waits. Used on the engine thread only.
class ModbusLink {
public:
    virtual ~ModbusLink() = default;
    virtual void open() = 0;
    virtual void close() = 0;
    virtual bool isOpen() const = 0;
    /// Why it could not be opened, or was lost since; code None: neither. A lost link is closed.
    virtual Message problem() const = 0;
    /// False: one is under way, the line is kept silent after a timeout, or the link is closed.
    virtual bool isFree() const = 0;
    /// Only when free. Answers the request's number.
    virtual int send(const ModbusRequest& request) = 0;
    /// Whether a request may go before what is under way now: that is given up, since an off is not to wait
    /// for an answer that may not come. False while it, or its answer, is on the line.
    virtual bool mayOvertake() const { return isFree(); }
    /// Only then. As send(); who asked before is told that there was no answer.
    virtual int overtake(const ModbusRequest& request) { return send(request); }
    /// Of that request, once; empty until it is there. Each request gets one, in time.
    virtual std::optional<ModbusReply> takeReply(int number) = 0;
    virtual std::string name() const = 0;
    /// The port's own name, when it was opened last; empty: it has none.
    virtual std::string portId() const { return {}; }

protected:
    static constexpr int kMaxSilent = 10;          ///< requests in a row; then the port is opened anew
    static constexpr std::size_t kMaxReplies = 16; ///< that nobody has taken
};

} // namespace bask
