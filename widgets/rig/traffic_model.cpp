#include "widgets/rig/traffic_model.h"

#include <QDateTime>
#include <QFontDatabase>

#include <algorithm>
#include <cctype>

namespace bask {
namespace {

constexpr std::size_t kShown = 400; ///< characters of one row

/// Empty if all of it is shown.
std::optional<QString> cutText(const TrafficLine& line) {
    const std::string text = shownBytes(std::string_view(line.bytes).substr(0, kShown));
    if (text.size() <= kShown && line.bytes.size() <= kShown)
        return std::nullopt;
    return QString::fromStdString(text.substr(0, kShown));
}

QString timeText(const TrafficLine& line) {
    return QDateTime::fromMSecsSinceEpoch(line.utc_ms).toString(QStringLiteral("HH:mm:ss.zzz"));
}

bool contains(const std::string& bytes, const std::string& part) {
    const auto isSame = [](char a, char b) {
        return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
    };
    return std::search(bytes.begin(), bytes.end(), part.begin(), part.end(), isSame) != bytes.end();
}

} // namespace

std::optional<std::string> bytesOfDigits(const QString& text) {
    const QByteArray digits = text.simplified().remove(u' ').toLatin1().toLower();
    const QByteArray bytes = QByteArray::fromHex(digits);
    const bool isHex = !digits.isEmpty() && bytes.toHex() == digits;
    return isHex ? std::optional(bytes.toStdString()) : std::nullopt;
}

int TrafficModel::take(const TrafficLog& log) {
    const auto kept = log.from(0, 1);
    const std::uint64_t oldest = kept.empty() ? 0 : kept.front()->number;
    int gone = 0;
    while (static_cast<std::size_t>(gone) < m_lines.size() &&
           m_lines[static_cast<std::size_t>(gone)]->number < oldest)
        ++gone;
    if (gone > 0) {
        beginRemoveRows({}, 0, gone - 1);
        m_lines.erase(m_lines.begin(), m_lines.begin() + gone);
        endRemoveRows();
    }
    const auto lines = log.from(m_next, kAtOnce);
    if (lines.empty())
        return 0;
    const int rows = rowCount(), added = static_cast<int>(lines.size());
    beginInsertRows({}, rows, rows + added - 1);
    m_lines.insert(m_lines.end(), lines.begin(), lines.end());
    m_next = lines.back()->number + 1;
    endInsertRows();
    return added;
}

int TrafficModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_lines.size());
}

int TrafficModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : kColumns;
}

QVariant TrafficModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || (role != Qt::DisplayRole && role != Qt::FontRole))
        return {};
    if (role == Qt::FontRole)
        return index.column() == kBytes || index.column() == kTime
                   ? QVariant(QFontDatabase::systemFont(QFontDatabase::FixedFont))
                   : QVariant();
    const TrafficLine& at = line(index.row());
    switch (index.column()) {
    case kTime:
        return timeText(at);
    case kLink:
        return QString::fromStdString(at.link);
    case kDirection:
        switch (at.kind) {
        case TrafficKind::Sent:
            return tr("sent");
        case TrafficKind::SentByHand:
            return tr("sent by hand");
        case TrafficKind::Received:
            return tr("received");
        case TrafficKind::ErrorOutput:
            return tr("error output");
        case TrafficKind::Opened:
            return tr("opened");
        case TrafficKind::Closed:
            return tr("closed");
        }
        return {};
    default:
        if (const auto cut = cutText(at))
            return tr("%1… (%n bytes)", nullptr, static_cast<int>(at.bytes.size())).arg(*cut);
        return QString::fromStdString(shownBytes(at.bytes));
    }
}

QVariant TrafficModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    switch (section) {
    case kTime:
        return tr("Time");
    case kLink:
        return tr("Link");
    case kDirection:
        return tr("Direction");
    default:
        return tr("Bytes");
    }
}

QString TrafficModel::rowText(int row) const {
    const TrafficLine& at = line(row);
    return QStringList{timeText(at), QString::fromStdString(at.link),
                       QString::fromLatin1(trafficKindWord(at.kind)),
                       QString::fromStdString(shownBytes(at.bytes))}
        .join(u'\t');
}

void TrafficModel::retranslate() {
    emit headerDataChanged(Qt::Horizontal, 0, kColumns - 1); // the rows are read anew when they are painted
}

void TrafficFilter::setFilter(const QString& link, TrafficDirection direction, const QString& text) {
    m_link = link.toStdString();
    m_direction = direction;
    m_text = text.toStdString();
    m_bytes = bytesOfDigits(text).value_or(std::string());
    invalidateFilter();
}

bool TrafficFilter::filterAcceptsRow(int row, const QModelIndex&) const {
    const TrafficLine& at = static_cast<const TrafficModel*>(sourceModel())->line(row);
    const bool isReceived = at.kind == TrafficKind::Received || at.kind == TrafficKind::ErrorOutput;
    const bool isSent = at.kind == TrafficKind::Sent || at.kind == TrafficKind::SentByHand;
    if ((!m_link.empty() && at.link != m_link) || (m_direction == TrafficDirection::Sent && !isSent) ||
        (m_direction == TrafficDirection::Received && !isReceived))
        return false;
    return m_text.empty() || contains(at.bytes, m_text) || (!m_bytes.empty() && contains(at.bytes, m_bytes));
}

} // namespace bask
