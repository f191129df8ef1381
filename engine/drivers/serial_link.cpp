#include "engine/drivers/serial_link.h"

#include "engine/base/message_code.h"
#include "engine/drivers/serial_port.h"

#include <QSerialPort>

#include <poll.h>
#include <sys/ioctl.h>

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

bool takesBytes(int descriptor) {
    pollfd state{descriptor, POLLOUT, 0};
    return ::poll(&state, 1, 0) > 0 && state.revents == POLLOUT;
}

/// A port waits up to half a minute for what its other end does not take; the last few bytes, which may be a
/// stop, are given the moment that they need.
void dropUnsent(QSerialPort& port) {
    constexpr int kTries = 20;
    constexpr int kTry_ms = 1;
    int unsent = 0;
    for (int i = 0; i < kTries && ::ioctl(port.handle(), TIOCOUTQ, &unsent) == 0 && unsent > 0; ++i)
        ::poll(nullptr, 0, kTry_ms);
    if (unsent > 0 || port.bytesToWrite() > 0)
        port.clear(QSerialPort::Output);
}

} // namespace

struct SerialLink::Port {
    Port(std::string where, const SerialSettings& how, PortCheck which);

    Message notOpened(bool isLocked) const;
    void lose(MessageCode code, const std::string& words);

    std::string path;
    SerialSettings settings;
    PortCheck check;
    Message problem;
    bool isLost = false; ///< about to be closed
    QSerialPort serial;
};

SerialLink::Port::Port(std::string where, const SerialSettings& how, PortCheck which)
    : path(std::move(where)), settings(how), check(std::move(which)) {
    serial.setPortName(QString::fromStdString(path));
    serial.setReadBufferSize(65536);
    QObject::connect(&serial, &QSerialPort::errorOccurred, &serial, [this](QSerialPort::SerialPortError e) {
        // A terminal that is no true port refuses some settings; that is no harm.
        if (e != QSerialPort::NoError && e != QSerialPort::TimeoutError &&
            e != QSerialPort::UnsupportedOperationError)
            lose(MessageCode::LinkLost, serial.errorString().toStdString());
    });
}

Message SerialLink::Port::notOpened(bool isLocked) const {
    const bool isTaken = isLocked || serial.error() == QSerialPort::PermissionError;
    return {MessageCode::LinkNotOpened,
            {path, whyNotOpened(path, isTaken, serial.errorString().toStdString())}};
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
        if (isLost) {
            dropUnsent(serial);
            serial.close();
        }
    };
    QMetaObject::invokeMethod(&serial, close, Qt::QueuedConnection);
}

SerialLink::SerialLink(std::string path, const SerialSettings& settings, PortCheck check)
    : m_port(std::make_unique<Port>(std::move(path), settings, std::move(check))) {}

SerialLink::~SerialLink() {
    close();
}

void SerialLink::open() {
    close();
    m_port->problem = m_port->check.look(m_port->path);
    if (m_port->problem.code != MessageCode::None)
        return;
    apply(settableOf(m_port->path, m_port->settings), m_port->serial);
    const bool isOpened = m_port->serial.open(QIODevice::ReadWrite);
    const bool isOurs = isOpened && lockPort(m_port->serial.handle());
    if (isOurs)
        m_port->serial.clear();
    else
        m_port->problem = m_port->notOpened(isOpened);
    if (isOpened && !isOurs)
        m_port->serial.close();
}

void SerialLink::close() {
    if (m_port->serial.isOpen())
        dropUnsent(m_port->serial);
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
    // Asked here and not left to the event loop: what has come is not to wait for the loop's next turn.
    switch (serialPortState(m_port->serial.handle())) {
    case SerialPortState::HungUp:
        m_port->lose(MessageCode::LinkLost, "it was unplugged");
        break;
    case SerialPortState::Bytes:
        m_port->serial.waitForReadyRead(0);
        break;
    case SerialPortState::Nothing:
        break;
    }
    return m_port->serial.readAll().toStdString();
}

void SerialLink::write(std::string_view bytes) {
    if (!isOpen())
        return;
    if (static_cast<std::size_t>(m_port->serial.bytesToWrite()) + bytes.size() > kMaxQueued) {
        m_port->lose(MessageCode::LinkStuck, {});
        return;
    }
    m_port->serial.write(bytes.data(), static_cast<qint64>(bytes.size()));
    if (takesBytes(m_port->serial.handle())) // Qt takes a full line for an error
        m_port->serial.flush();
}

std::string SerialLink::portId() const {
    return m_port->check.found();
}

std::string SerialLink::name() const {
    return m_port->path;
}

} // namespace bask
