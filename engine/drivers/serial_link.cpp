#include "engine/drivers/serial_link.h"

#include "engine/base/message_code.h"

#include <QSerialPort>

#include <poll.h>
#include <unistd.h>

namespace bask {
namespace {

QSerialPort::Parity parityOf(char letter) {
    return letter == 'E'   ? QSerialPort::EvenParity
           : letter == 'O' ? QSerialPort::OddParity
                           : QSerialPort::NoParity;
}

void apply(const SerialSettings& settings, QSerialPort& port) {
    port.setBaudRate(settings.baud);
    port.setDataBits(static_cast<QSerialPort::DataBits>(settings.dataBits));
    port.setParity(parityOf(settings.parity));
    port.setStopBits(settings.stopBits == 2 ? QSerialPort::TwoStop : QSerialPort::OneStop);
    port.setFlowControl(QSerialPort::NoFlowControl);
}

/// What the terminal has for us; hung up when the cable or its adapter is out.
enum class Waiting { Nothing, Bytes, HungUp };

Waiting waitingAt(int descriptor) {
    pollfd state{descriptor, POLLIN, 0};
    if (::poll(&state, 1, 0) <= 0)
        return Waiting::Nothing;
    return (state.revents & (POLLHUP | POLLERR | POLLNVAL)) != 0 ? Waiting::HungUp : Waiting::Bytes;
}

bool takesBytes(int descriptor) {
    pollfd state{descriptor, POLLOUT, 0};
    return ::poll(&state, 1, 0) > 0 && state.revents == POLLOUT;
}

} // namespace

struct SerialLink::Port {
    Port(std::string where, const SerialSettings& how);

    Message notOpened() const;
    void lose(MessageCode code, const std::string& words);

    std::string path;
    SerialSettings settings;
    Message problem;
    bool isLost = false; ///< about to be closed
    QSerialPort serial;
};

SerialLink::Port::Port(std::string where, const SerialSettings& how) : path(std::move(where)), settings(how) {
    serial.setPortName(QString::fromStdString(path));
    serial.setReadBufferSize(65536);
    QObject::connect(&serial, &QSerialPort::errorOccurred, &serial, [this](QSerialPort::SerialPortError e) {
        // A terminal that is no true port refuses some settings; that is no harm.
        if (e != QSerialPort::NoError && e != QSerialPort::TimeoutError &&
            e != QSerialPort::UnsupportedOperationError)
            lose(MessageCode::LinkLost, serial.errorString().toStdString());
    });
}

/// Nearly everybody meets it once: the port belongs to a group that the user is not in.
Message SerialLink::Port::notOpened() const {
    std::string words = serial.errorString().toStdString();
    if (::access(path.c_str(), F_OK) != 0)
        words = "there is no such port";
    else if (::access(path.c_str(), R_OK | W_OK) != 0)
        words =
            "you have no right to use it; have yourself added to its group, often \"dialout\", and log in "
            "again";
    else if (serial.error() == QSerialPort::PermissionError)
        words = "another program has it open";
    return {MessageCode::LinkNotOpened, {path, words}};
}

/// In a slot of the port the port cannot be closed at once; left open, an unplugged one raises errors as fast
/// as the processor can (Qt up to 6.7).
void SerialLink::Port::lose(MessageCode code, const std::string& words) {
    if (isLost || !serial.isOpen())
        return;
    isLost = true;
    problem = {code, {path}};
    if (!words.empty())
        problem.args.push_back(words);
    const auto close = [this] {
        if (isLost)
            serial.close();
    };
    QMetaObject::invokeMethod(&serial, close, Qt::QueuedConnection);
}

SerialLink::SerialLink(std::string path, const SerialSettings& settings)
    : m_port(std::make_unique<Port>(std::move(path), settings)) {}

SerialLink::~SerialLink() = default;

void SerialLink::open() {
    close();
    m_port->problem = {};
    apply(m_port->settings, m_port->serial);
    if (m_port->serial.open(QIODevice::ReadWrite))
        m_port->serial.clear();
    else
        m_port->problem = m_port->notOpened();
}

void SerialLink::close() {
    m_port->serial.close();
    m_port->isLost = false;
}

bool SerialLink::isOpen() const {
    return m_port->serial.isOpen() && !m_port->isLost;
}

Message SerialLink::problem() const {
    return m_port->problem;
}

std::string SerialLink::read() {
    if (!isOpen())
        return {};
    // Asked here and not left to the event loop: of a port that was unplugged Qt tells too often (up to 6.7)
    // or not at all (since), and what has come is not to wait for the loop's next turn.
    switch (waitingAt(m_port->serial.handle())) {
    case Waiting::HungUp:
        m_port->lose(MessageCode::LinkLost, "it was unplugged");
        break;
    case Waiting::Bytes:
        m_port->serial.waitForReadyRead(0);
        break;
    case Waiting::Nothing:
        break;
    }
    return m_port->serial.readAll().toStdString();
}

void SerialLink::write(std::string_view bytes) {
    if (!isOpen())
        return;
    if (static_cast<std::size_t>(m_port->serial.bytesToWrite()) + bytes.size() > kMostQueued) {
        m_port->lose(MessageCode::LinkStuck, {});
        return;
    }
    m_port->serial.write(bytes.data(), static_cast<qint64>(bytes.size()));
    if (takesBytes(m_port->serial.handle())) // Qt takes a full line for an error
        m_port->serial.flush();
}

std::string SerialLink::name() const {
    return m_port->path;
}

} // namespace bask
