#pragma once
// Pieces of HTML that browsers and QTextDocument both draw.

#include <QString>
#include <QStringList>

namespace bask::html {

/// A table being written: cells are texts, escaped; the columns of `numbers` are on the right.
class Table {
public:
    explicit Table(const QStringList& header, QList<int> numbers = {});
    void add(const QStringList& cells);
    /// HTML of the finished table; empty without a row.
    QString text() const;

private:
    QString row(const QStringList& cells, const char* tag) const;

    QList<int> m_numbers;
    QString m_header;
    QString m_rows;
};

QString heading(const QString& text);
QString subheading(const QString& text);
QString paragraph(const QString& text, const char* kind = "");
/// Names and values in two columns.
QString facts(const QList<std::pair<QString, QString>>& rows);

} // namespace bask::html
