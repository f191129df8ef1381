#pragma once
// Pieces of HTML that both browsers and QTextDocument can draw.

#include <QString>
#include <QStringList>

namespace bask::html {

/// A table that is being written: cells are escaped texts; the columns in `numbers` are right-aligned.
class Table {
public:
    explicit Table(const QStringList& header, QList<int> numbers = {});
    void add(const QStringList& cells);
    /// Returns the HTML of the finished table; empty if it has no rows.
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
/// Returns a table of names and values in two columns.
QString facts(const QList<std::pair<QString, QString>>& rows);

} // namespace bask::html
