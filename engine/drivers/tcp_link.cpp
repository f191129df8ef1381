#include "engine/drivers/tcp_link.h"

#include "engine/base/message_code.h"
#include "engine/drivers/port_claim.h"

#include <QDeadlineTimer>
#include <QTcpSocket>

namespace bask {

struct TcpLink::Socket {
    Socket(std::string where, int which);

    std::string name() const {
        const bool hasColons = host.find(':') != std::string::npos;
        return (hasColons ? '[' + host + ']' : host) + ':' + std::to_string(port);
    }
    bool isConnected() const { return tcp.state() == QAbstractSocket::ConnectedState; }
    bool isConnecting() const { return tcp.state() != QAbstractSocket::UnconnectedState && !isConnected(); }
    void lose(MessageCode code, const std::string& words);

    std::string host;
    int port;
    Message problem;
    bool wasConnected = false; ///< since it was opened
    QDeadlineTimer opening;
    PortClaim claim; ///< unlike a serial port, the far end may take a second one
    QTcpSocket tcp;
};

TcpLink::Socket::Socket(std::string where, int which) : host(std::move(where)), port(which) {
    tcp.setReadBufferSize(65536);
    QObject::connect(&tcp, &QAbstractSocket::connected, &tcp, [this] {
        wasConnected = true;
        tcp.setSocketOption(QAbstractSocket::LowDelayOption, 1);
    });
    QObject::connect(&tcp, &QAbstractSocket::errorOccurred, &tcp, [this] {
        lose(wasConnected ? MessageCode::LinkLost : MessageCode::LinkNotOpened,
             tcp.errorString().toStdString());
    });
}

void TcpLink::Socket::lose(MessageCode code, const std::string& words) {
    problem = {code, {name()}};
    if (!words.empty())
        problem.args.push_back(words);
}

TcpLink::TcpLink(std::string host, int port) : m_socket(std::make_unique<Socket>(std::move(host), port)) {}

TcpLink::~TcpLink() {
    m_socket->tcp.disconnect(); // it tells its end to nobody
}

void TcpLink::open() {
    if (m_socket->isConnecting() && !m_socket->opening.hasExpired())
        return;
    close();
    m_socket->problem = {};
    if (!m_socket->claim.take(name()))
        return m_socket->lose(MessageCode::LinkNotOpened, "another Bask on this computer has it open");
    m_socket->opening.setRemainingTime(static_cast<qint64>(kOpening_s * 1000.0));
    m_socket->tcp.connectToHost(QString::fromStdString(m_socket->host), static_cast<quint16>(m_socket->port));
}

void TcpLink::close() {
    m_socket->tcp.abort();
    m_socket->wasConnected = false;
    m_socket->claim.release();
}

bool TcpLink::isOpen() const {
    return m_socket->isConnected() && m_socket->problem.code == MessageCode::None;
}

Message TcpLink::problem() const {
    return m_socket->problem;
}

std::string TcpLink::read() {
    return isOpen() ? m_socket->tcp.readAll().toStdString() : std::string();
}

void TcpLink::write(std::string_view bytes) {
    if (!isOpen())
        return;
    if (static_cast<std::size_t>(m_socket->tcp.bytesToWrite()) + bytes.size() > kMaxQueued) {
        m_socket->lose(MessageCode::LinkStuck, {});
        close();
        return;
    }
    m_socket->tcp.write(bytes.data(), static_cast<qint64>(bytes.size()));
    m_socket->tcp.flush();
}

std::string TcpLink::name() const {
    return m_socket->name();
}

} // namespace bask
