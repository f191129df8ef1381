#include "engine/drivers/serial_ports.h"

#include <QSerialPortInfo>

#include <filesystem>
#include <map>

namespace bask {
namespace {

constexpr const char* kById = "/dev/serial/by-id";

/// "/dev/ttyUSB0" -> "/dev/serial/by-id/usb-FTDI_...".
std::map<std::string, std::string> pathsById() {
    namespace fs = std::filesystem;
    std::map<std::string, std::string> out;
    std::error_code code;
    for (fs::directory_iterator it(kById, code), end; !code && it != end; it.increment(code)) {
        std::error_code broken;
        if (const fs::path port = fs::canonical(it->path(), broken); !broken)
            out[port.string()] = it->path().string();
    }
    return out;
}

} // namespace

std::vector<SerialPort> serialPorts() {
    const auto byId = pathsById();
    std::vector<SerialPort> out;
    for (const QSerialPortInfo& info : QSerialPortInfo::availablePorts()) {
        const std::string path = info.systemLocation().toStdString();
        const auto it = byId.find(path);
        QStringList words;
        for (const QString& word : {info.manufacturer(), info.description(), info.portName()})
            if (!word.isEmpty())
                words.push_back(word);
        out.push_back({it == byId.end() ? path : it->second, words.join(", ").toStdString()});
    }
    return out;
}

} // namespace bask
