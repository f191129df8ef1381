#include "engine/shape/svg_survey.h"

#include "engine/base/message_code.h"
#include "engine/base/plain_text.h"
#include "engine/shape/svg_filter.h"
#include "engine/shape/svg_grammar.h"

#include <QRegularExpression>
#include <QXmlStreamReader>

#include <algorithm>
#include <optional>

namespace bask::svg {
namespace {

// What Qt's readers take too long or too much memory for; found by trying.
constexpr double kMaxPairs = 3e7;           // of attributes, in all elements
constexpr qsizetype kMaxCss = 1 << 20;      // characters of style sheets
constexpr double kMaxCssWork = 5e6;         // cssParts times elements: QtSvg tries each rule on each
constexpr qsizetype kMaxTold = 60;          // characters of a link
constexpr double kMaxCharacters = 32 << 20; // of path data and points, after <use> has multiplied them

// Parts of selectors and values, roughly.
double cssParts(const QString& css) {
    const QString plain = css.simplified();
    return double(std::ranges::count_if(plain, [](QChar c) { return !c.isLetterOrNumber(); })) +
           1e-3 * double(plain.size());
}

class Surveyor {
public:
    explicit Surveyor(std::string where) : m_where(std::move(where)) {}

    Result<Survey> run(const QByteArray& bytes) {
        QXmlStreamReader reader;
        feed(reader, bytes);
        while (!reader.atEnd()) {
            reader.readNext();
            if (reader.isStartElement()) {
                if (const auto entered = enter(reader); !entered)
                    return entered.error();
            } else if (reader.isEndElement()) {
                leave();
            } else if (reader.isCharacters() && !m_open.empty() && m_open.back().kind == Opened::Style) {
                m_found.css += reader.text();
            }
        }
        if (reader.hasError())
            return Error{MessageCode::XmlBroken,
                         m_where,
                         {reader.errorString().toStdString(), std::to_string(reader.lineNumber())}};
        static const QRegularExpression kFonts(QStringLiteral(R"(@font-face\s*\{[^}]*\})"));
        m_found.css.remove(kFonts);
        if (m_found.css.size() > kMaxCss || cssParts(m_found.css) * m_elements > kMaxCssWork)
            return tooFull();
        if (const auto measured = measure(); !measured)
            return measured.error();
        return std::move(m_found);
    }

private:
    // A root or an element with an id: what <use> can name. Counts are those of its content down to the next
    // such.
    struct Node {
        struct Part {
            int level = 0;       // below the node
            int node = -1;       // contained
            QString href;        // or used: as it stands in the file
            QString link;        // and the id that it names
            qint64 useLine = 0;  // 0: it is none
            bool isShown = true; // whether it is drawn where the node is
        };
        std::vector<Part> parts;
        double elements = 0.0, characters = 0.0; // drawn
        int levels = 0;
        enum { Unknown, Open, Known } state = Unknown;
        bool isSeen = false; // drawn from the root
    };
    struct Opened {
        int node;
        int level; // below the node
        enum { Group, Style, Skipped } kind;
        bool isShown = true; // whether it is drawn where the node is
    };

    Error tooFull() const { return {MessageCode::DrawingTooFull, m_where, {}}; }

    Result<void> enter(const QXmlStreamReader& reader) {
        const QString name = nameOf(reader);
        if (m_open.empty() && name != "svg")
            return Error{MessageCode::NotSvg, m_where};
        if (m_open.size() >= kMaxSvgLevels)
            return Error{MessageCode::XmlTooDeep, m_where, {std::to_string(kMaxSvgLevels)}};
        const double attributes = double(reader.attributes().size());
        m_pairs += attributes * attributes;
        if (++m_elements > kMaxSvgElements || m_pairs > kMaxPairs)
            return tooFull();
        Opened opened = m_open.empty() ? Opened{-1, 0, Opened::Group} : m_open.back();
        const bool isLooked = opened.kind == Opened::Group;
        if (isLooked)
            look(name, reader, opened);
        else
            opened.kind = Opened::Skipped;
        const bool isRoot = m_open.empty();
        m_open.push_back(opened);
        m_ids.insert(reader.attributes().value("id").toString());
        return isLooked && !isRoot && isDrawn(name) ? check(name, reader) : Result<void>();
    }

    // What QtSvg would leave out, or read up to its damage: another shape.
    Result<void> check(const QString& name, const QXmlStreamReader& reader) const {
        const QXmlStreamAttributes attributes = reader.attributes();
        const std::string line = std::to_string(reader.lineNumber()), element = name.toStdString();
        const auto from = [](const QString& text, qsizetype at) {
            return plainWords(text.mid(at, 20).toStdString());
        };
        const QString data = attributes.value("d").toString(), points = attributes.value("points").toString(),
                      transform = attributes.value("transform").toString();
        if (const auto at = name == "path" ? pathDamage(data) : std::nullopt)
            return Error{MessageCode::SvgPathDamaged, m_where, {line, from(data, *at)}};
        if (const auto at = name.startsWith("poly") ? pointsDamage(points) : std::nullopt)
            return Error{MessageCode::SvgPointsDamaged, m_where, {line, element, from(points, *at)}};
        if (const auto at = transformDamage(transform))
            return Error{MessageCode::SvgTransformDamaged, m_where, {line, element, from(transform, *at)}};
        for (const QString& which : lengthsOf(name))
            if (const QString text = attributes.value(which).toString(); !isLength(which, text))
                return Error{MessageCode::SvgLengthDamaged,
                             m_where,
                             {line, which.toStdString(), element, from(text, 0)}};
        const QString view = attributes.value("viewBox").toString();
        if ((name == "svg" || name == "symbol") && !view.trimmed().isEmpty() && !viewBoxOf(attributes))
            return Error{MessageCode::SvgSizeUnusable, m_where, {from(view, 0)}};
        return {};
    }

    // An element in a group: what it is, and what is to be done with its content.
    void look(const QString& name, const QXmlStreamReader& reader, Opened& opened) {
        const QXmlStreamAttributes attributes = reader.attributes();
        const QString id = attributes.value("id").toString();
        ++opened.level;
        opened.kind = isGroup(name) ? Opened::Group : name == "style" ? Opened::Style : Opened::Skipped;
        if (isPaint(name) && !id.isEmpty())
            m_found.paints.insert(id);
        else if (isSeen(name))
            leaveOut(name.toStdString());
        if (!isDrawn(name))
            return;
        opened.isShown = opened.isShown && name != "defs" && name != "symbol" && !isHidden(attributes);
        if (opened.node < 0 || (!id.isEmpty() && !m_byId.contains(id))) {
            opened = addNode(opened, id);
            opened.isShown = !isHidden(attributes);
        }
        Node& node = m_nodes[opened.node];
        node.levels = std::max(node.levels, opened.level);
        node.elements += 1.0;
        node.characters += double(attributes.value("d").size() + attributes.value("points").size());
        if (name == "use")
            node.parts.push_back({opened.level, -1, hrefOf(attributes), linkOf(attributes),
                                  reader.lineNumber(), opened.isShown});
        else if (name == "symbol" && !m_found.symbols.contains(id))
            m_found.symbols.insert(
                id, {viewBoxOf(attributes), attributes.value("preserveAspectRatio").toString()});
    }

    void leave() {
        if (!m_open.empty())
            m_open.pop_back();
    }

    Opened addNode(const Opened& opened, const QString& id) {
        const int number = static_cast<int>(m_nodes.size());
        if (opened.node >= 0)
            m_nodes[opened.node].parts.push_back({opened.level, number, {}, {}, 0, opened.isShown});
        m_nodes.emplace_back();
        if (!id.isEmpty())
            m_byId.insert(id, number);
        return {number, 0, opened.kind};
    }

    // What is drawn from the root, and how deep; refuses uses that lead back to what holds them.
    Result<void> measure() {
        const bool isWalked = walk(0, 0);
        if (m_ofItself)
            return Error{MessageCode::SvgUseOfItself,
                         m_where,
                         {std::to_string(m_ofItself->useLine),
                          plainWords(m_ofItself->link.left(kMaxTold).toStdString())}};
        if (!isWalked)
            return Error{MessageCode::XmlTooDeep, m_where, {std::to_string(kMaxSvgLevels)}};
        if (m_nodes[0].levels > kMaxSvgLevels)
            return Error{MessageCode::XmlTooDeep, m_where, {std::to_string(kMaxSvgLevels)}};
        if (m_nodes[0].elements > kMaxSvgDrawn || m_nodes[0].characters > kMaxCharacters)
            return tooFull();
        see(0);
        if (!m_ofNothing)
            return {};
        return Error{MessageCode::SvgUseOfNothing,
                     m_where,
                     {std::to_string(m_ofNothing->useLine),
                      plainWords(m_ofNothing->href.left(kMaxTold).toStdString())}};
    }

    // What is drawn from here: not what is only defined, and used nowhere.
    void see(int number) {
        m_nodes[number].isSeen = true;
        for (const Node::Part& part : m_nodes[number].parts) {
            if (!part.isShown)
                continue;
            const int next = part.useLine == 0 ? part.node : m_byId.value(part.link, -1);
            if (next >= 0 && !m_nodes[next].isSeen)
                see(next);
            else if (next < 0 && !part.link.isEmpty() && m_ids.contains(part.link))
                leaveOut("use"); // of what is no outline
            else if (next < 0 && !part.href.isEmpty() &&
                     (!m_ofNothing || part.useLine < m_ofNothing->useLine))
                m_ofNothing = part;
        }
    }

    void leaveOut(const std::string& element) {
        if (std::ranges::find(m_found.unread, element) == m_found.unread.end())
            m_found.unread.push_back(element);
    }

    bool walk(int number, int depth) {
        if (depth > kMaxSvgLevels)
            return false;
        m_nodes[number].state = Node::Open;
        for (std::size_t k = 0; k < m_nodes[number].parts.size(); ++k) {
            const Node::Part& part = m_nodes[number].parts[k];
            const int next = part.useLine == 0 ? part.node : m_byId.value(part.link, -1);
            if (next < 0)
                continue;
            if (m_nodes[next].state == Node::Open) {
                m_ofItself = part;
                return false;
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
    Survey m_found;
    std::vector<Node> m_nodes;
    QHash<QString, int> m_byId;
    std::vector<Opened> m_open;
    int m_elements = 0;
    QSet<QString> m_ids;                   // of all elements
    std::optional<Node::Part> m_ofItself;  // a use that draws what holds it
    std::optional<Node::Part> m_ofNothing; // the first use of what is not there
    double m_pairs = 0.0;
};

} // namespace

Result<Survey> survey(const QByteArray& bytes, const std::string& where) {
    return Surveyor(where).run(bytes);
}

} // namespace bask::svg
