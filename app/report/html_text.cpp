#include "app/report/html_text.h"

namespace bask::html {

Table::Table(const QStringList& header, QList<int> numbers) : m_numbers(std::move(numbers)) {
    m_header = row(header, "th");
}

QString Table::row(const QStringList& cells, const char* tag) const {
    QString text = QStringLiteral("<tr>");
    for (int k = 0; k < cells.size(); ++k)
        text += QStringLiteral("<%1%2>%3</%1>")
                    .arg(QLatin1String(tag),
                         m_numbers.contains(k) ? QStringLiteral(" class=\"number\" align=\"right\"")
                                               : QStringLiteral(" align=\"left\""),
                         cells[k].toHtmlEscaped());
    return text + QStringLiteral("</tr>\n");
}

void Table::add(const QStringList& cells) {
    m_rows += row(cells, "td");
}

QString Table::text() const {
    if (m_rows.isEmpty())
        return {};
    return QStringLiteral("<table width=\"100%\" cellspacing=\"0\" cellpadding=\"4\"><thead>") + m_header +
           QStringLiteral("</thead><tbody>\n") + m_rows + QStringLiteral("</tbody></table>\n");
}

QString heading(const QString& text) {
    return QStringLiteral("<h2>%1</h2>\n").arg(text.toHtmlEscaped());
}

QString subheading(const QString& text) {
    return QStringLiteral("<h3>%1</h3>\n").arg(text.toHtmlEscaped());
}

QString paragraph(const QString& text, const char* kind) {
    return QStringLiteral("<p%1>%2</p>\n")
        .arg(*kind == '\0' ? QString() : QStringLiteral(" class=\"%1\"").arg(QLatin1String(kind)),
             text.toHtmlEscaped());
}

QString facts(const QList<std::pair<QString, QString>>& rows) {
    QString text =
        QStringLiteral("<table class=\"facts\" width=\"100%\" cellspacing=\"0\" cellpadding=\"3\">\n");
    for (const auto& [name, value] : rows)
        text += QStringLiteral("<tr><td class=\"name\" width=\"28%\">%1</td><td>%2</td></tr>\n")
                    .arg(name.toHtmlEscaped(), value.toHtmlEscaped());
    return text + QStringLiteral("</table>\n");
}

} // namespace bask::html
