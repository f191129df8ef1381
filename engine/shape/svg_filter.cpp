#include "engine/shape/svg_filter.h"

#include "engine/base/message_code.h"

#include <QHash>
#include <QRegularExpression>
#include <QSet>
#include <QStringConverter>
#include <QXmlStreamReader>
#include <QXmlStreamWriter>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace bask {
namespace {

// What Qt's readers take too long or too much memory for; found by trying.
constexpr int kMostAttributes = 5'000;       // of one element: QXmlStreamReader compares each with each
constexpr double kMostPairs = 3e7;           // of attributes, in all elements
constexpr int kMostDeclarations = 5'000;     // and comments
constexpr int kMostReferences = 2'000;       // where entities are declared: each is up to 4096 characters
constexpr qsizetype kMostCss = 1 << 20;      // characters of style sheets
constexpr double kMostCssWork = 5e6;         // cssParts times elements: QtSvg tries each rule on each
constexpr double kMostCharacters = 32 << 20; // of path data and points, after <use> has multiplied them
constexpr qsizetype kLongPath = 1 << 16;     // characters: it may have more parts than QtSvg reads

// ---- Lengths

struct Length {
    double value = 0.0;
    QString unit; // "" for a plain number
};

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

// Pixels of an absolute unit, and of em and ex at the usual 16 px letter.
std::optional<double> pixelsOf(const QString& unit) {
    static const QHash<QString, double> kPixels{
        {"", 1.0},    {"px", 1.0},         {"mm", 96.0 / 25.4}, {"cm", 96.0 / 2.54}, {"q", 24.0 / 25.4},
        {"in", 96.0}, {"pt", 96.0 / 72.0}, {"pc", 16.0},        {"em", 16.0},        {"ex", 8.0}};
    const auto it = kPixels.find(unit);
    return it == kPixels.end() ? std::nullopt : std::optional(*it);
}

// ---- Viewports

struct Box {
    double x = 0.0, y = 0.0, width = 0.0, height = 0.0;
};

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

// From the view box to the viewport, as preserveAspectRatio says.
Eigen::Affine2d viewTransform(const Box& view, const Box& port, const QString& preserve) {
    double sx = port.width / view.width, sy = port.height / view.height;
    if (!preserve.contains("none"))
        sx = sy = preserve.contains("slice") ? std::max(sx, sy) : std::min(sx, sy);
    const auto share = [&](const char* least, const char* most) {
        return preserve.contains(QLatin1String(least))  ? 0.0
               : preserve.contains(QLatin1String(most)) ? 1.0
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

QString matrixText(const Eigen::Affine2d& transform) {
    const auto& m = transform.matrix();
    QStringList numbers;
    for (const double value : {m(0, 0), m(1, 0), m(0, 1), m(1, 1), m(0, 2), m(1, 2)})
        numbers << QString::number(value, 'g', 12);
    return QStringLiteral("matrix(%1)").arg(numbers.join(' '));
}

// ---- Elements

QString nameOf(const QXmlStreamReader& reader) {
    const QString name = reader.qualifiedName().toString();
    return name.startsWith("svg:") ? name.mid(4) : name;
}

QString linkOf(const QXmlStreamAttributes& attributes) {
    QString link = attributes.value("href").toString();
    if (link.isEmpty())
        link = attributes.value("xlink:href").toString();
    link = link.trimmed();
    return link.startsWith('#') ? link.mid(1) : QString(); // other files are never opened
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
// Left out, though it would be seen.
bool isSeen(const QString& name) {
    static const QSet<QString> kSeen{"text", "image", "foreignObject", "clipPath", "mask", "marker"};
    return kSeen.contains(name);
}

// QtSvg knows visibility as an attribute only, not in styles.
QString hiddenAsNone(QString css) {
    static const QRegularExpression kHidden(QStringLiteral(R"(visibility\s*:\s*(hidden|collapse))"));
    return css.replace(kHidden, "display:none");
}

// Parts of selectors and values, roughly.
double cssParts(const QString& css) {
    const QString plain = css.simplified();
    return double(std::ranges::count_if(plain, [](QChar c) { return !c.isLetterOrNumber(); })) +
           1e-3 * double(plain.size());
}

// A reader that takes a declared encoding which Qt does not know for Latin-1: names and numbers are ASCII.
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

// ---- First pass: what there is, and what <use> makes of it

struct Symbol {
    std::optional<Box> view;
    QString preserve;
};

class Survey {
public:
    explicit Survey(std::string where) : m_where(std::move(where)) {}

    Result<void> run(const QByteArray& bytes) {
        QXmlStreamReader reader;
        feed(reader, bytes);
        while (!reader.atEnd()) {
            reader.readNext();
            if (reader.isStartElement()) {
                if (const auto entered = enter(reader); !entered)
                    return entered;
            } else if (reader.isEndElement()) {
                leave();
            } else if (reader.isCharacters() && !m_open.empty() && m_open.back().kind == Opened::Style) {
                css += reader.text();
            }
        }
        if (reader.hasError())
            return Error{MessageCode::XmlBroken,
                         m_where,
                         {reader.errorString().toStdString(), std::to_string(reader.lineNumber())}};
        static const QRegularExpression kFonts(QStringLiteral(R"(@font-face\s*\{[^}]*\})"));
        css.remove(kFonts);
        if (css.size() > kMostCss || cssParts(css) * m_elements > kMostCssWork)
            return tooFull();
        return measure();
    }

    QString css;
    QSet<QString> paints; // ids of gradients and patterns
    QHash<QString, Symbol> symbols;
    QSet<int> recursive; // numbers of <use> elements to leave out
    std::vector<std::string> unread;

private:
    // A root or an element with an id: what <use> can name. Counts are those of its content down to the next
    // such.
    struct Node {
        struct Part {
            int level = 0; // below the node
            int node = -1; // contained
            QString link;  // or used
            int use = -1;
        };
        std::vector<Part> parts;
        double elements = 0.0, characters = 0.0; // drawn
        int levels = 0;
        enum { Unknown, Open, Known } state = Unknown;
    };
    struct Opened {
        int node;
        int level; // below the node
        enum { Group, Style, Skipped } kind;
    };

    Error tooFull() const { return {MessageCode::DrawingTooFull, m_where, {}}; }

    Result<void> enter(const QXmlStreamReader& reader) {
        const QString name = nameOf(reader);
        if (m_open.empty() && name != "svg")
            return Error{MessageCode::NotSvg, m_where};
        if (m_open.size() >= kMostSvgLevels)
            return Error{MessageCode::XmlTooDeep, m_where, {std::to_string(kMostSvgLevels)}};
        const double attributes = double(reader.attributes().size());
        m_pairs += attributes * attributes;
        if (++m_elements > kMostSvgElements || m_pairs > kMostPairs)
            return tooFull();
        Opened opened = m_open.empty() ? Opened{-1, 0, Opened::Group} : m_open.back();
        if (opened.kind == Opened::Group)
            look(name, reader.attributes(), opened);
        else
            opened.kind = Opened::Skipped;
        m_open.push_back(opened);
        return {};
    }

    // An element in a group: what it is, and what is to be done with its content.
    void look(const QString& name, const QXmlStreamAttributes& attributes, Opened& opened) {
        const QString id = attributes.value("id").toString();
        ++opened.level;
        opened.kind = isGroup(name) ? Opened::Group : name == "style" ? Opened::Style : Opened::Skipped;
        if (isPaint(name) && !id.isEmpty())
            paints.insert(id);
        else if (isSeen(name) && std::ranges::find(unread, name.toStdString()) == unread.end())
            unread.push_back(name.toStdString());
        if (!isDrawn(name))
            return;
        if (opened.node < 0 || (!id.isEmpty() && !m_byId.contains(id)))
            opened = addNode(opened, id);
        Node& node = m_nodes[opened.node];
        node.levels = std::max(node.levels, opened.level);
        node.elements += 1.0;
        node.characters += double(attributes.value("d").size() + attributes.value("points").size());
        if (name == "use")
            node.parts.push_back({opened.level, -1, linkOf(attributes), m_uses++});
        else if (name == "symbol" && !symbols.contains(id))
            symbols.insert(id, {viewBoxOf(attributes), attributes.value("preserveAspectRatio").toString()});
    }

    void leave() {
        if (!m_open.empty())
            m_open.pop_back();
    }

    Opened addNode(const Opened& opened, const QString& id) {
        const int number = static_cast<int>(m_nodes.size());
        if (opened.node >= 0)
            m_nodes[opened.node].parts.push_back({opened.level, number, {}, -1});
        m_nodes.emplace_back();
        if (!id.isEmpty())
            m_byId.insert(id, number);
        return {number, 0, opened.kind};
    }

    // What is drawn from the root, and how deep; finds the uses that lead back to what holds them.
    Result<void> measure() {
        if (!walk(0, 0))
            return Error{MessageCode::XmlTooDeep, m_where, {std::to_string(kMostSvgLevels)}};
        if (m_nodes[0].levels > kMostSvgLevels)
            return Error{MessageCode::XmlTooDeep, m_where, {std::to_string(kMostSvgLevels)}};
        if (m_nodes[0].elements > kMostSvgDrawn || m_nodes[0].characters > kMostCharacters)
            return tooFull();
        return {};
    }

    bool walk(int number, int depth) {
        if (depth > kMostSvgLevels)
            return false;
        m_nodes[number].state = Node::Open;
        for (std::size_t k = 0; k < m_nodes[number].parts.size(); ++k) {
            const Node::Part& part = m_nodes[number].parts[k];
            const int next = part.use < 0 ? part.node : m_byId.value(part.link, -1);
            if (next < 0)
                continue;
            if (m_nodes[next].state == Node::Open) {
                recursive.insert(part.use);
                continue;
            }
            if (m_nodes[next].state == Node::Unknown && !walk(next, depth + 1))
                return false;
            m_nodes[number].elements += m_nodes[next].elements;
            m_nodes[number].characters += m_nodes[next].characters;
            m_nodes[number].levels = std::max(m_nodes[number].levels, part.level + m_nodes[next].levels);
        }
        m_nodes[number].state = Node::Known;
        return true;
    }

    std::string m_where;
    std::vector<Node> m_nodes;
    QHash<QString, int> m_byId;
    std::vector<Opened> m_open;
    int m_elements = 0, m_uses = 0;
    double m_pairs = 0.0;
};

// ---- Second pass: the plain copy

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
    Copy(const Survey& survey, std::string where)
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
            else if (name == "use" && !m_survey.recursive.contains(m_uses++))
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

    const Survey& m_survey;
    std::string m_where;
    PlainSvg m_plain;
    QByteArray m_xml;
    QXmlStreamWriter m_writer;
    QSet<QString> m_ids;
    std::vector<Box> m_ports; // of the open elements
    std::vector<int> m_ends;  // ends that each will need
    int m_uses = 0;
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
        if (attributes > kMostAttributes || defaults > kMostAttributes)
            return true;
    }
    return declarations > kMostDeclarations || (entities && references > kMostReferences);
}

} // namespace

Result<PlainSvg> plainSvg(const std::string& bytes, const std::string& where) {
    if (isTooMuch(bytes))
        return Error{MessageCode::DrawingTooFull, where};
    const auto data = QByteArray::fromRawData(bytes.data(), static_cast<qsizetype>(bytes.size()));
    Survey survey(where);
    if (const auto surveyed = survey.run(data); !surveyed)
        return surveyed.error();
    return Copy(survey, where).run(data);
}

} // namespace bask
