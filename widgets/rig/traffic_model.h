#pragma once
// The traffic of the links as a table, and the rows of it that a person wants to see.

#include "engine/drivers/traffic_log.h"

#include <QAbstractTableModel>
#include <QSortFilterProxyModel>

#include <deque>
#include <optional>

namespace bask {

/// Returns the bytes that a text writes as hexadecimal digits, with or without spaces; empty if it is none.
std::optional<std::string> bytesOfDigits(const QString& text);

class TrafficModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { kTime, kLink, kDirection, kBytes, kColumns };

    using QAbstractTableModel::QAbstractTableModel;

    /// Takes what is new in the log, and leaves out what the log no longer keeps. Returns the number of new
    /// rows; they are the last ones.
    int take(const TrafficLog& log);
    const TrafficLine& line(int row) const { return *m_lines[static_cast<std::size_t>(row)]; }
    /// Returns a row as text with all its bytes: "14:05:03.120  /dev/ttyUSB0  sent  ?".
    QString rowText(int row) const;
    void retranslate();

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    static constexpr std::size_t kAtOnce = 5000; ///< lines of one call of take()

    std::deque<TrafficLog::Line> m_lines;
    std::uint64_t m_next = 0;
};

enum class TrafficDirection { Both, Sent, Received };

class TrafficFilter : public QSortFilterProxyModel {
    Q_OBJECT

public:
    using QSortFilterProxyModel::QSortFilterProxyModel;

    /// An empty link takes all. A row must contain the text, or the bytes that it writes as hexadecimal
    /// digits.
    void setFilter(const QString& link, TrafficDirection direction, const QString& text);

protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

private:
    std::string m_link;
    TrafficDirection m_direction = TrafficDirection::Both;
    std::string m_text, m_bytes;
};

} // namespace bask
