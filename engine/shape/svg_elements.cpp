#include "engine/shape/svg_elements.h"

#include <QHash>
#include <QRegularExpression>
#include <QSet>
#include <QStringConverter>
#include <QXmlStreamReader>

#include <algorithm>
#include <cmath>

namespace bask::svg {

std::optional<Length> lengthOf(const QString& text) {
    static const QRegularExpression kForm(
        QStringLiteral(R"(^\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*(%|[a-zA-Z]*)\s*$)"));
    const auto match = kForm.match(text);
    if (!match.hasMatch())
        return std::nullopt;
    bool ok = false;
    const double value = match.captured(1).toDouble(&ok);
    if (!ok || !std::isfinite(value))
        return std::nullopt;
    return Length{value, match.captured(2).toLower()};
}

std::optional<double> pixelsOf(const QString& unit) {
    static const QHash<QString, double> kPixels{
        {"", 1.0},    {"px", 1.0},         {"mm", 96.0 / 25.4}, {"cm", 96.0 / 2.54}, {"q", 24.0 / 25.4},
        {"in", 96.0}, {"pt", 96.0 / 72.0}, {"pc", 16.0},        {"em", 16.0},        {"ex", 8.0}};
    const auto it = kPixels.find(unit);
    return it == kPixels.end() ? std::nullopt : std::optional(*it);
}

const QStringList& lengthsOf(const QString& element) {
    static const QHash<QString, QStringList> kLengths{{"rect", {"x", "y", "width", "height", "rx", "ry"}},
                                                      {"circle", {"cx", "cy", "r"}},
                                                      {"ellipse", {"cx", "cy", "rx", "ry"}},
                                                      {"line", {"x1", "y1", "x2", "y2"}},
                                                      {"use", {"x", "y", "width", "height"}},
                                                      {"svg", {"x", "y", "width", "height"}}};
    static const QStringList kNone;
    const auto it = kLengths.find(element);
    return it == kLengths.end() ? kNone : *it;
}

bool isLength(const QString& attribute, const QString& text) {
    static const QSet<QString> kMayBeAuto{"width", "height", "rx", "ry"};
    if (text.trimmed().isEmpty() || (text.trimmed() == "auto" && kMayBeAuto.contains(attribute)))
        return true;
    const auto length = lengthOf(text);
    return length && (length->unit == "%" || pixelsOf(length->unit));
}

std::optional<Box> viewBoxOf(const QXmlStreamAttributes& attributes) {
    static const QRegularExpression kSeparator(QStringLiteral(R"([\s,]+)"));
    const QStringList parts = attributes.value("viewBox").toString().split(kSeparator, Qt::SkipEmptyParts);
    double numbers[4]{};
    if (parts.size() != 4)
        return std::nullopt;
    for (int k = 0; k < 4; ++k) {
        bool ok = false;
        numbers[k] = parts[k].toDouble(&ok);
        if (!ok || !std::isfinite(numbers[k]))
            return std::nullopt;
    }
    if (!(numbers[2] > 0.0) || !(numbers[3] > 0.0))
        return std::nullopt;
    return Box{numbers[0], numbers[1], numbers[2], numbers[3]};
}

Eigen::Affine2d viewTransform(const Box& view, const Box& port, const QString& preserve) {
    double sx = port.width / view.width, sy = port.height / view.height;
    if (!preserve.contains("none"))
        sx = sy = preserve.contains("slice") ? std::max(sx, sy) : std::min(sx, sy);
    const auto share = [&](const char* atStart, const char* atEnd) {
        return preserve.contains(QLatin1String(atStart)) ? 0.0
               : preserve.contains(QLatin1String(atEnd)) ? 1.0
                                                         : 0.5;
    };
    const double dx = share("xMin", "xMax") * (port.width - sx * view.width);
    const double dy = share("YMin", "YMax") * (port.height - sy * view.height);
    Eigen::Affine2d transform = Eigen::Affine2d::Identity();
    transform.translate(Eigen::Vector2d(port.x + dx, port.y + dy));
    transform.scale(Eigen::Vector2d(sx, sy));
    transform.translate(Eigen::Vector2d(-view.x, -view.y));
    return transform;
}

QString nameOf(const QXmlStreamReader& reader) {
    const QString name = reader.qualifiedName().toString();
    return name.startsWith("svg:") ? name.mid(4) : name;
}

QString hrefOf(const QXmlStreamAttributes& attributes) {
    const auto link = attributes.value("href");
    return (link.isEmpty() ? attributes.value("xlink:href") : link).toString().trimmed();
}

QString linkOf(const QXmlStreamAttributes& attributes) {
    const QString link = hrefOf(attributes);
    return link.startsWith('#') ? link.mid(1) : QString();
}

bool isGroup(const QString& name) {
    static const QSet<QString> kGroups{"svg", "g", "a", "defs", "symbol", "switch"};
    return kGroups.contains(name);
}
bool isShape(const QString& name) {
    static const QSet<QString> kShapes{"path", "rect", "circle", "ellipse", "line", "polyline", "polygon"};
    return kShapes.contains(name);
}
bool isPaint(const QString& name) {
    static const QSet<QString> kPaints{"linearGradient", "radialGradient", "meshgradient", "pattern",
                                       "hatch"};
    return kPaints.contains(name);
}
bool isDrawn(const QString& name) {
    return isGroup(name) || isShape(name) || name == "use";
}
bool isSeen(const QString& name) {
    static const QSet<QString> kSeen{"text", "image", "foreignObject", "clipPath", "mask", "marker"};
    return kSeen.contains(name);
}

bool isHidden(const QXmlStreamAttributes& attributes) {
    static const QRegularExpression kHidden(
        QStringLiteral(R"((display\s*:\s*none|visibility\s*:\s*(hidden|collapse)))"));
    const auto visibility = attributes.value("visibility").trimmed();
    return attributes.value("display").trimmed() == QLatin1String("none") ||
           visibility == QLatin1String("hidden") || visibility == QLatin1String("collapse") ||
           kHidden.match(attributes.value("style").toString()).hasMatch();
}

void feed(QXmlStreamReader& reader, const QByteArray& bytes) {
    static const QRegularExpression kDeclared(
        QStringLiteral(R"(^\s*<\?xml[^>]*encoding\s*=\s*["']([\w.:-]+)["'])"));
    const auto match = kDeclared.match(QString::fromLatin1(bytes.left(200)));
    if (match.hasMatch() && !QStringConverter::encodingForName(match.captured(1).toLatin1().constData()))
        reader.addData(QString::fromLatin1(bytes));
    else
        reader.addData(bytes);
    reader.setNamespaceProcessing(false); // prefixes without a declaration are common
}

} // namespace bask::svg
