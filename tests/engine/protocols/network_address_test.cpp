// Addresses of devices on a network, as people write them.

#include "engine/protocols/network_address.h"

#include <gtest/gtest.h>

namespace bask {

// Catches a port that is lost or made up, and a path or a sentence that is taken for a host.
TEST(NetworkAddress, IsReadAsPeopleWriteIt) {
    struct Written {
        const char* text;
        const char* host;
        int port; ///< 0: it is no address
    };
    for (const Written& each : {Written{"192.168.1.20", "192.168.1.20", 502},
                                {"logger:1502", "logger", 1502},
                                {"lab-7.example.org:65535", "lab-7.example.org", 65535},
                                {"[fe80::1]:503", "fe80::1", 503},
                                {"[::1]", "::1", 502},
                                {"fe80::1%eth0", "fe80::1%eth0", 502},
                                {"logger:", "", 0},
                                {":502", "", 0},
                                {"logger:65536", "", 0},
                                {"logger:0", "", 0},
                                {"logger:-1", "", 0},
                                {"logger:99999999999999999999", "", 0},
                                {"logger:5x", "", 0},
                                {"", "", 0},
                                {"[]", "", 0},
                                {"logger:502:503", "", 0},
                                {"::1%a b", "", 0},
                                {"[::1", "", 0},
                                {"[::1]x", "", 0},
                                {"/dev/ttyUSB0", "", 0},
                                {"http://logger", "", 0},
                                {"two words", "", 0},
                                {"a;b", "", 0}}) {
        const auto read = networkAddress(each.text, 502);
        ASSERT_EQ(read.has_value(), each.port != 0) << each.text;
        if (read) {
            EXPECT_EQ(*read, (NetworkAddress{each.host, each.port})) << each.text;
        }
    }
}

} // namespace bask
