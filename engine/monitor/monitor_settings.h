#pragma once
// Where a run can be watched from elsewhere: a broker (MQTT) and files. A setting of this computer, never of
// an experiment. Bask publishes only: it takes no order from anywhere.

#include "engine/base/result.h"

#include <optional>
#include <string>

namespace bask {

/// A broker that speaks MQTT 3.1.1.
struct BrokerSettings {
    std::string address; ///< as networkAddress() takes it; port: usualPort()
    bool usesTls = false;
    std::string caFile;         ///< certificates (PEM) that are trusted; empty: those of the system
    std::string user;           ///< empty: none
    std::string passwordFile;   ///< its first line is the password; nobody else may read the file
    std::string topic = "bask"; ///< in front of all topics

    int usualPort() const { return usesTls ? 8883 : 1883; }
    bool operator==(const BrokerSettings&) const = default;
};

struct MonitorSettings {
    bool usesBroker = false;
    BrokerSettings broker; ///< kept also while it is not used
    bool usesFiles = false;
    std::string statusFolder; ///< of the status files (status_files.h)

    std::optional<BrokerSettings> activeBroker() const {
        return usesBroker ? std::optional(broker) : std::nullopt;
    }
    std::optional<std::string> activeFolder() const {
        return usesFiles ? std::optional(statusFolder) : std::nullopt;
    }
    bool isOn() const { return usesBroker || usesFiles; }
    bool operator==(const MonitorSettings&) const = default;
};

/// Refuses what is used and no address, topic or folder, and a password without a user. Files are not looked
/// at.
Result<void> validate(const MonitorSettings& settings);

/// Returns the password. Errors: a file that cannot be read, is empty, or that others can read
/// (MonitorSecretOpen).
Result<std::string> readPassword(const std::string& file);

/// Reads the settings from a file (docs/monitoring.md); nothing is on if there is no such file. Errors: those
/// of a JSON file, and those of validate().
Result<MonitorSettings> readMonitorSettings(const std::string& path);
Result<void> writeMonitorSettings(const MonitorSettings& settings, const std::string& path);

} // namespace bask
