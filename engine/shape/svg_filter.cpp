#include "engine/shape/svg_filter.h"

#include "engine/base/message_code.h"
#include "engine/shape/svg_survey.h"

#include <QRegularExpression>
#include <QXmlStreamReader>
#include <QXmlStreamWriter>

#include <array>
#include <cmath>
#include <numbers>

namespace bask {
namespace {

using namespace svg;

// What Qt's readers take too long or too much memory for; found by trying.
constexpr int kMaxAttributes = 5'000;    // of one element: QXmlStreamReader compares each with each
constexpr int kMaxDeclarations = 5'000;  // and comments
constexpr int kMaxReferences = 2'000;    // where entities are declared: each is up to 4096 characters
constexpr qsizetype kLongPath = 1 << 16; // characters: it may have more parts than QtSvg reads

// QtSvg knows visibility as an attribute only, not in styles.
QString hiddenAsNone(QString css) {
    static const QRegularExpression kHidden(QStringLiteral(R"(visibility\s*:\s*(hidden|collapse))"));
    return css.replace(kHidden, "display:none");
}

QString matrixText(const Eigen::Affine2d& transform) {
    const auto& m = transform.matrix();
    QStringList numbers;
    for (const double value : {m(0, 0), m(1, 0), m(0, 1), m(1, 1), m(0, 2), m(1, 2)})
        numbers << QString::number(value, 'g', 12);
    return QStringLiteral("matrix(%1)").arg(numbers.join(' '));
}

struct Polygon {
    QString name, points;
};

// A long path of one outline in absolute straight lines ("M 0 0 L 1 0 ... Z") as a polygon, of which QtSvg
// reads any number of points.
std::optional<Polygon> asPolygon(QString path) {
    if (path.size() < kLongPath)
        return std::nullopt;
    path = path.trimmed();
    const bool closed = path.endsWith('z', Qt::CaseInsensitive);
    path.chop(closed ? 1 : 0);
    if (!path.startsWith('M'))
        return std::nullopt;
    path[0] = ' ';
    path.replace('L', ' ');
    static const QRegularExpression kOther(QStringLiteral("[^0-9eE+.,\\s-]"));
    if (path.contains(kOther))
        return std::nullopt;
    return Polygon{closed ? "polygon" : "polyline", path};
}

class Copy {
public:
    Copy(const svg::Survey& survey, std::string where)
        : m_survey(survey), m_where(std::move(where)), m_writer(&m_xml) {}

    Result<PlainSvg> run(const QByteArray& bytes) {
        QXmlStreamReader reader;
        feed(reader, bytes);
        while (!reader.atEnd()) {
            reader.readNext();
            if (reader.isStartElement()) {
                if (m_ports.empty()) {
                    if (const auto root = writeRoot(reader.attributes()); !root)
                        return root.error();
                } else {
                    writeElement(reader);
                }
            } else if (reader.isEndElement()) {
                for (int k = m_ends.back(); k > 0; --k)
                    m_writer.writeEndElement();
                m_ends.pop_back();
                m_ports.pop_back();
            }
        }
        m_plain.xml = m_xml.toStdString();
        m_plain.unread = m_survey.unread;
        return std::move(m_plain);
    }

private:
    Error unusable(const QString& words) const {
        return {MessageCode::SvgSizeUnusable, m_where, {words.left(80).toStdString()}};
    }

    // Width or height of the drawing in pixels; none where it is left to the view box.
    Result<std::optional<double>> rootLength(const QXmlStreamAttributes& attributes, const char* which) {
        const QString text = attributes.value(QLatin1String(which)).toString().trimmed();
        if (text.isEmpty() || text == "auto" || text.endsWith('%'))
            return std::optional<double>();
        const auto length = lengthOf(text);
        const auto pixels = length ? pixelsOf(length->unit) : std::nullopt;
        if (!pixels || !(length->value > 0.0))
            return unusable(text);
        if (m_plain.unit.empty() && !length->unit.isEmpty())
            m_plain.unit = length->unit.toStdString();
        return std::optional(length->value * *pixels);
    }

    Result<void> writeRoot(const QXmlStreamAttributes& attributes) {
        const auto width = rootLength(attributes, "width"), height = rootLength(attributes, "height");
        if (!width || !height)
            return width ? height.error() : width.error();
        if (m_plain.unit.empty())
            m_plain.unit = "px";
        const auto view = viewBoxOf(attributes);
        if (!view && attributes.hasAttribute("viewBox"))
            return unusable(attributes.value("viewBox").toString());
        Box port{0.0, 0.0, width->value_or(0.0), height->value_or(0.0)};
        if (view && !*width)
            port.width = *height ? **height * view->width / view->height : view->width;
        if (view && !*height)
            port.height = *width ? **width * view->height / view->width : view->height;
        const QString preserve = attributes.value("preserveAspectRatio").toString();
        m_plain.toPixels = view ? viewTransform(*view, port, preserve) : Eigen::Affine2d::Identity();
        m_plain.toPixels.pretranslate(
            Eigen::Vector2d(0.0, -port.height)); // the lower left corner is the origin
        open("svg", attributes, view.value_or(port));
        writeHead();
        return {};
    }

    // Style sheets first, and for each gradient or pattern one that says no more than that something is
    // painted.
    void writeHead() {
        if (!m_survey.css.isEmpty())
            m_writer.writeTextElement("style", hiddenAsNone(m_survey.css));
        for (const QString& id : m_survey.paints) {
            m_writer.writeStartElement("linearGradient");
            m_writer.writeAttribute("id", id);
            m_ids.insert(id);
            for (const char* offset : {"0", "1"}) {
                m_writer.writeStartElement("stop");
                m_writer.writeAttribute("offset", QLatin1String(offset));
                m_writer.writeEndElement();
            }
            m_writer.writeEndElement();
        }
    }

    void writeElement(QXmlStreamReader& reader) {
        const QString name = nameOf(reader);
        const QXmlStreamAttributes attributes = reader.attributes();
        if (!isGroup(name)) {
            if (isShape(name))
                write(name, attributes);
            else if (name == "use")
                writeUse(attributes);
            return reader.skipCurrentElement();
        }
        if (name == "svg")
            return openViewport(attributes);
        if (name != "symbol")
            return open(name == "a" ? "g" : name, attributes, m_ports.back());
        m_writer.writeStartElement("defs");
        open("g", attributes, viewBoxOf(attributes).value_or(m_ports.back()));
        ++m_ends.back();
    }

    void openViewport(const QXmlStreamAttributes& attributes) {
        const auto view = viewBoxOf(attributes);
        const Box port = portOf(attributes);
        const auto transform =
            view ? viewTransform(*view, port, attributes.value("preserveAspectRatio").toString())
                 : Eigen::Affine2d(Eigen::Translation2d(port.x, port.y));
        open("g", attributes, view.value_or(port), transform);
    }

    void writeUse(const QXmlStreamAttributes& attributes) {
        const QString link = linkOf(attributes);
        const Box port = portOf(attributes);
        const Symbol symbol = m_survey.symbols.value(link);
        const auto transform = symbol.view ? viewTransform(*symbol.view, port, symbol.preserve)
                                           : Eigen::Affine2d(Eigen::Translation2d(port.x, port.y));
        begin("use", attributes, transform);
        m_writer.writeAttribute("xlink:href", "#" + link);
        m_writer.writeEndElement();
    }

    // x, y, width and height of an element with a viewport of its own.
    Box portOf(const QXmlStreamAttributes& attributes) const {
        const Box& outer = m_ports.back();
        const auto take = [&](const char* which, double otherwise) {
            const QString text = attributes.value(QLatin1String(which)).toString();
            return text.isEmpty() ? otherwise : plainLength(QLatin1String(which), text).value_or(otherwise);
        };
        return {take("x", 0.0), take("y", 0.0), take("width", outer.width), take("height", outer.height)};
    }

    // A length in user units; percent are of the viewport.
    std::optional<double> plainLength(const QString& which, const QString& text) const {
        const auto length = lengthOf(text);
        if (!length)
            return std::nullopt;
        const Box& port = m_ports.back();
        if (length->unit == "%") {
            static const QSet<QString> kAcross{"x", "width", "cx", "rx", "x1", "x2"};
            const double whole = which == "r" ? std::hypot(port.width, port.height) / std::numbers::sqrt2
                                 : kAcross.contains(which) ? port.width
                                                           : port.height;
            return length->value / 100.0 * whole;
        }
        const auto pixels = pixelsOf(length->unit);
        return pixels ? std::optional(length->value * *pixels) : std::nullopt;
    }

    void begin(const QString& name, const QXmlStreamAttributes& attributes,
               const std::optional<Eigen::Affine2d>& transform = std::nullopt) {
        m_writer.writeStartElement(name);
        QString placed;
        for (const QXmlStreamAttribute& attribute : attributes) {
            const QString which = attribute.qualifiedName().toString();
            if (which == "transform")
                placed = attribute.value().toString();
            else
                writeAttribute(name, which, attribute.value().toString());
        }
        if (transform)
            placed += " " + matrixText(*transform);
        if (!placed.isEmpty())
            m_writer.writeAttribute("transform", placed);
    }

    void write(const QString& name, const QXmlStreamAttributes& attributes) {
        const auto polygon = name == "path" ? asPolygon(attributes.value("d").toString()) : std::nullopt;
        begin(polygon ? polygon->name : name, attributes);
        if (polygon)
            m_writer.writeAttribute("points", polygon->points);
        m_writer.writeEndElement();
    }

    void open(const QString& name, const QXmlStreamAttributes& attributes, const Box& port,
              const std::optional<Eigen::Affine2d>& transform = std::nullopt) {
        begin(name, attributes, transform);
        m_ports.push_back(port);
        m_ends.push_back(1);
    }

    void writeAttribute(const QString& element, const QString& which, const QString& value) {
        static const QSet<QString> kLengths{"x",  "y",  "width", "height", "cx", "cy", "r",
                                            "rx", "ry", "x1",    "y1",     "x2", "y2"};
        static const QSet<QString> kTaken{"class",
                                          "d",
                                          "points",
                                          "fill",
                                          "fill-rule",
                                          "fill-opacity",
                                          "stroke",
                                          "stroke-width",
                                          "stroke-opacity",
                                          "opacity",
                                          "display",
                                          "visibility",
                                          "color",
                                          "systemLanguage",
                                          "requiredFeatures",
                                          "requiredExtensions"};
        if (kLengths.contains(which)) {
            const auto length = isShape(element) ? plainLength(which, value) : std::nullopt;
            if (length)
                m_writer.writeAttribute(which, QString::number(*length, 'g', 15));
        } else if (which == "id") {
            if (!m_ids.contains(value)) // the first one counts
                m_writer.writeAttribute("id", value);
            m_ids.insert(value);
        } else if (which == "style") {
            m_writer.writeAttribute("style", hiddenAsNone(value));
        } else if (kTaken.contains(which)) {
            m_writer.writeAttribute(which, value);
        }
    }

    const svg::Survey& m_survey;
    std::string m_where;
    PlainSvg m_plain;
    QByteArray m_xml;
    QXmlStreamWriter m_writer;
    QSet<QString> m_ids;
    std::vector<Box> m_ports; // of the open elements
    std::vector<int> m_ends;  // ends that each will need
};

// Seen before a reader is trusted with the bytes; without zeros, UTF-16 looks like ASCII.
bool isTooMuch(const std::string& bytes) {
    int attributes = 0, defaults = 0, declarations = 0, references = 0;
    bool entities = false, attributeList = false;
    std::array<char, 3> last{};
    for (const char c : bytes) {
        if (c == 0)
            continue;
        last = {last[1], last[2], c};
        declarations += last[0] == '<' && last[1] == '!';
        entities = entities || last == std::array{'<', '!', 'E'};
        attributeList = last == std::array{'<', '!', 'A'} || (attributeList && c != '<');
        attributes = c == '<' ? 0 : attributes + (c == '=');
        defaults += attributeList && (c == '"' || c == '\'');
        references += c == '&' || c == '%';
        if (attributes > kMaxAttributes || defaults > kMaxAttributes)
            return true;
    }
    return declarations > kMaxDeclarations || (entities && references > kMaxReferences);
}

} // namespace

Result<PlainSvg> plainSvg(const std::string& bytes, const std::string& where) {
    if (isTooMuch(bytes))
        return Error{MessageCode::DrawingTooFull, where};
    const auto data = QByteArray::fromRawData(bytes.data(), static_cast<qsizetype>(bytes.size()));
    const auto survey = svg::survey(data, where);
    if (!survey)
        return survey.error();
    return Copy(*survey, where).run(data);
}

} // namespace bask
