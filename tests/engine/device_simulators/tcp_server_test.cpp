#include "engine/device_simulators/tcp_server.h"

#include "engine/base/message_code.h"
#include "tests/support/echo_device.h"

#include <gtest/gtest.h>

#include <chrono>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace bask {
namespace {

int connected(int port) {
    const int client = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(::connect(client, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
    return client;
}

/// Until `count` bytes are there, the connection has ended ("<end>"), or a second has passed.
std::string heard(TcpServer& server, int client, std::size_t count) {
    std::string all;
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(1);
    while (all.size() < count && std::chrono::steady_clock::now() < end) {
        server.work(0.0);
        char piece[256];
        const ssize_t n = ::recv(client, piece, sizeof piece, MSG_DONTWAIT);
        if (n == 0)
            return all + "<end>";
        if (n > 0)
            all.append(piece, static_cast<std::size_t>(n));
    }
    return all;
}

// Catches a server that dies of a client that goes while it is spoken to, and a port that cannot be had
// again.
TEST(TcpServer, clientsComeAndGoAndTheServerToo) {
    test::EchoDevice device;
    auto server = std::move(TcpServer::create(device).value());
    const int port = server->port();
    for (int round = 0; round < 3; ++round) {
        const int client = connected(port);
        EXPECT_EQ(::send(client, "hello", 5, 0), 5);
        EXPECT_EQ(heard(*server, client, 5), "HELLO") << "client " << round;
        ::close(client);
        for (int i = 0; i < 5; ++i) {
            device.toSay = "into the void";
            server->work(0.0);
        }
    }
    const int last = connected(port);
    server->work(0.0);
    server.reset();
    server = std::move(TcpServer::create(device, port).value());
    ::close(last);
    const int client = connected(port);
    EXPECT_EQ(::send(client, "again", 5, 0), 5);
    EXPECT_EQ(heard(*server, client, 5), "AGAIN");
    ::close(client);
}

// Catches two clients that hear each other's answers.
TEST(TcpServer, aSecondClientIsTurnedAway) {
    test::EchoDevice device;
    const auto server = std::move(TcpServer::create(device).value());
    const int first = connected(server->port());
    server->work(0.0);
    const int second = connected(server->port());
    EXPECT_EQ(heard(*server, second, 1), "<end>");
    EXPECT_EQ(::send(first, "x", 1, 0), 1);
    EXPECT_EQ(heard(*server, first, 1), "X");
    ::close(first);
    ::close(second);
}

// Catches a port of somebody else's taken without a word.
TEST(TcpServer, aTakenPortIsRefused) {
    test::EchoDevice device;
    const auto server = std::move(TcpServer::create(device).value());
    const auto second = TcpServer::create(device, server->port());
    ASSERT_FALSE(second.ok());
    EXPECT_EQ(second.error().code(), MessageCode::LinkNotOpened);
}

} // namespace
} // namespace bask
