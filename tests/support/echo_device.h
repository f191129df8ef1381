#pragma once
// A device for tests of servers and links: says back in capitals what it is told, and what the test has it
// say.

#include "engine/device_simulators/byte_device.h"

#include <cctype>
#include <utility>

namespace bask::test {

class EchoDevice final : public ByteDevice {
public:
    void receive(std::string_view bytes, double) override {
        heard += bytes;
        for (const char c : bytes)
            toSay += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    }
    std::string transmit(double) override { return std::exchange(toSay, {}); }
    std::vector<std::string> faults() const override { return {"none"}; }
    Result<void> setFault(const std::string&) override { return {}; }

    std::string heard, toSay;
};

} // namespace bask::test
