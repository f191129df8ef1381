#pragma once
// Temperatures that a device prints unasked, line by line, as sketches for the MAX31865 do:
//   Temperature = 15.09      one channel; "Ratio = ...", "RTD value: ..." and other words are ignored
//   T2 = 23.4                channel 2, counted from 1
//   23.4,25.1,30.0           all channels, with commas, semicolons or blanks between
//   Fault 0x40, T2 Fault 0x40   the fault register, of all channels or of one
// Source: Adafruit_MAX31865, examples/max31865; fault bits and codes: Analog Devices' data sheet of MAX31865.

#include "engine/protocols/line_splitter.h"

#include <vector>

namespace bask {

enum class RtdFault { None, Open, Short, OutOfRange, Other };

/// A value of one channel.
struct RtdValue {
    int channel = 0;       ///< from 0
    double value_degC = 0; ///< 0 if there is a fault
    RtdFault fault = RtdFault::None;
    double stamp = 0.0; ///< the stamp of its line
};

/// A sketch prints a temperature even if the sensor has a fault, and reports the fault before or after it.
/// Therefore a temperature waits for the next line, and a fault invalidates the temperature before it and the
/// next one.
class RtdStream {
public:
    explicit RtdStream(int channels);

    /// Adds received bytes; `stamp` is stored with their values.
    void add(std::string_view bytes, double stamp);
    /// Call after a time without data: the waiting values become final.
    void settle();
    bool isWaiting() const;
    /// Returns and removes the values that became final.
    std::vector<RtdValue> take();
    /// Returns and removes the lines that could not be read; unknown words are not counted.
    std::vector<std::string> takeDiscarded();
    /// Call when the line was opened again: the first line may be incomplete.
    void clear();

private:
    struct Channel {
        bool isWaiting = false;
        RtdValue value;
        RtdFault next = RtdFault::None; ///< invalidates the next temperature
    };
    bool readLine(std::string_view line, double stamp);
    bool readFault(std::string_view line);
    bool readNamed(std::string_view key, std::string_view value, double stamp);
    bool readRow(std::string_view line, double stamp);
    void told(int channel, double value_degC, RtdFault fault, double stamp);

    LineSplitter m_lines;
    std::vector<Channel> m_channels;
    std::vector<RtdValue> m_certain;
    std::vector<std::string> m_discarded;
    std::size_t m_columns = 0; ///< of the newest row; 0: none yet
    bool m_isFirst = true;
};

} // namespace bask
