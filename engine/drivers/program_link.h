#pragma once
// The standard input and output of a program as a link of bytes.

#include "engine/drivers/byte_link.h"

#include <memory>

namespace bask {

class ConfirmedPrograms;
class TrafficLog;

/// Runs the program on a thread of its own, so that nothing here waits: without a shell or a terminal, in a
/// session and process group of its own. A program that ends is started again after 0.5 s, then 1, 2, 4 and
/// 8 s. close() ends its input; what has not ended a second later gets SIGTERM with all that it has started,
/// and SIGKILL after another second. One that writes more than kMaxPerSecond is ended.
class ProgramLink final : public ByteLink {
public:
    static constexpr std::size_t kMaxPerSecond = 256 * 1024;

    /// `command` as in programFiles(). Only one program of a command runs for a `device` ("robot") on this
    /// computer. It is started only if `confirmed` has its fingerprint; null: never. What it writes to its
    /// standard error is added to `traffic`; null: only its last line is kept.
    ProgramLink(std::string command, std::string device, std::shared_ptr<const ConfirmedPrograms> confirmed,
                std::shared_ptr<TrafficLog> traffic = nullptr);
    /// Returns at once; the program is ended as by close().
    ~ProgramLink() override;

    /// No effect while it is started, or must not be started yet.
    void open() override;
    void close() override;
    bool isOpen() const override;
    Message problem() const override;
    std::string read() override;
    double emptyAt_s() const override;
    void write(std::string_view bytes) override;
    std::string name() const override;

    /// Waits until all programs that were started have ended, for at most the time that this takes by force.
    /// Call it before the process ends.
    static void waitForAll();

private:
    class Runner;
    std::shared_ptr<Runner> m_runner;
};

} // namespace bask
