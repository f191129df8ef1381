#include "engine/shape/dxf_groups.h"

#include "engine/base/message_code.h"
#include "engine/shape/contour_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace bask {
namespace {

constexpr std::size_t kMaxEntities = 300'000;
constexpr std::size_t kMaxValues = 2'000'000;
constexpr std::size_t kMaxKinds = 20; // told one by one
constexpr std::size_t kLongestName = 255;
constexpr double kLargestNumber = 1e15;
constexpr int kHighestSplineDegree = 15;
constexpr double kMinWeight = 1e-30;
constexpr std::string_view kBinaryMark = "AutoCAD Binary DXF";

constexpr int kName = 2, kLayer = 8, kInvisible = 60, kFlags = 70;

enum class Place { Header, Layers, Blocks, Drawn };

// A kind of record that dxflib gets, and the groups that it gets of it.
struct Kind {
    std::string_view name;
    Place place;
    std::vector<int> reals, integers;
    bool named = false;
};

const Kind* kindOf(std::string_view name) {
    static const std::array kKinds{
        Kind{"$INSUNITS", Place::Header, {}, {70}},
        Kind{"LAYER", Place::Layers, {}, {62, 70}, true},
        Kind{"BLOCK", Place::Blocks, {10, 20}, {}, true},
        Kind{"ENDBLK", Place::Blocks, {}, {}},
        Kind{"LINE", Place::Drawn, {10, 20, 11, 21}, {}},
        Kind{"ARC", Place::Drawn, {10, 20, 40, 50, 51}, {}},
        Kind{"CIRCLE", Place::Drawn, {10, 20, 40}, {}},
        Kind{"ELLIPSE", Place::Drawn, {10, 20, 11, 21, 40, 41, 42}, {}},
        Kind{"LWPOLYLINE", Place::Drawn, {10, 20, 42}, {70}},
        Kind{"POLYLINE", Place::Drawn, {}, {70}},
        Kind{"VERTEX", Place::Drawn, {10, 20, 42}, {70}},
        Kind{"SPLINE", Place::Drawn, {10, 20, 11, 21, 12, 22, 13, 23, 40, 41}, {70, 71}},
        Kind{"INSERT", Place::Drawn, {10, 20, 41, 42, 44, 45, 50}, {70, 71}, true},
    };
    const auto found = std::ranges::find(kKinds, name, &Kind::name);
    return found == kKinds.end() ? nullptr : &*found;
}

bool has(const std::vector<int>& codes, int code) {
    return std::ranges::find(codes, code) != codes.end();
}

std::string capitals(std::string_view text) {
    std::string upper(text);
    for (char& c : upper)
        c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    return upper;
}

struct Value {
    int code = 0;
    double number = 0.0;
    std::string_view name; // where the group is a name
};

// Lines one after the other, their ends LF or CR LF, or CR where the file has no LF.
class Lines {
public:
    explicit Lines(std::string_view text)
        : m_rest(text), m_end(text.find('\n') == std::string_view::npos ? '\r' : '\n') {}

    std::optional<std::string_view> next() {
        if (m_rest.empty())
            return std::nullopt;
        const std::size_t end = std::min(m_rest.find(m_end), m_rest.size());
        const std::string_view line = trimmed(m_rest.substr(0, end));
        m_rest.remove_prefix(std::min(m_rest.size(), end + 1));
        ++m_number;
        return line;
    }
    std::size_t number() const { return m_number; } // of the line read last, from 1

private:
    std::string_view m_rest;
    char m_end;
    std::size_t m_number = 0;
};

class Cleaner {
public:
    Cleaner(std::string_view bytes, const std::string& where) : m_lines(bytes), m_where(where) {}

    Result<CleanDxf> run() {
        for (;;) {
            const auto code = m_lines.next();
            const auto value = code ? m_lines.next() : code;
            if (!value)
                return Error{MessageCode::DxfCutOff, m_where};
            int number = 0;
            const auto [end, fault] = std::from_chars(code->data(), code->data() + code->size(), number);
            if (fault != std::errc() || end != code->data() + code->size())
                return damaged(m_lines.number() - 1);
            if (const auto taken = takeGroup(number, *value); !taken)
                return taken.error();
            if (number == 0 && *value == "EOF") {
                m_clean.text += "0\nEOF\n";
                return std::move(m_clean);
            }
        }
    }

private:
    Error damaged(std::size_t line) const {
        return {MessageCode::DxfDamaged, m_where, {std::to_string(line)}};
    }

    // A group that starts a record ends the one before it.
    Result<void> takeGroup(int code, std::string_view value) {
        if (code == 0 || code == 9) {
            if (const auto ended = endRecord(); !ended)
                return ended;
            startRecord(value);
        } else if (m_type == "SECTION" && code == kName) {
            m_section = value;
        } else if (m_kind) {
            return takeValue(code, value);
        }
        return {};
    }

    void startRecord(std::string_view type) {
        m_type = type;
        m_line = m_lines.number();
        m_values.clear();
        m_kind = nullptr;
        if (type == "SECTION" || type == "ENDSEC") {
            if (m_section == "BLOCKS")
                m_clean.text += "0\nENDBLK\n"; // where the file forgot it
            m_section = {};
        }
        const Kind* kind = kindOf(type);
        const bool drawing = m_section == "ENTITIES" || m_section == "BLOCKS";
        if (kind && ((kind->place == Place::Drawn && drawing) ||
                     (kind->place == Place::Blocks && m_section == "BLOCKS") ||
                     (kind->place == Place::Layers && m_section == "TABLES") ||
                     (kind->place == Place::Header && m_section == "HEADER")))
            m_kind = kind;
        // ends, labels and windows are part of something else
        else if (m_section == "ENTITIES" && type != "SEQEND" && type != "ATTRIB" && type != "VIEWPORT")
            leaveOut(capitals(type.substr(0, 40)));
    }

    void leaveOut(const std::string& kind) {
        const bool told = m_clean.left_out.size() < kMaxKinds || m_clean.left_out.contains(kind);
        ++m_clean.left_out[told ? kind : "..."];
    }

    Result<void> takeValue(int code, std::string_view value) {
        const bool drawn = m_kind->place == Place::Drawn;
        const bool isName = (m_kind->named && code == kName) || (drawn && code == kLayer);
        const bool isReal =
            has(m_kind->reals, code) || (drawn && (code == 210 || code == 220 || code == 230));
        const bool isInteger = has(m_kind->integers, code) || (drawn && (code == kInvisible || code == 67));
        if (!isName && !isReal && !isInteger)
            return {};
        if (++m_value_count > kMaxValues)
            return Error{MessageCode::FileTooLarge,
                         m_where,
                         {std::to_string(m_value_count) + " values", std::to_string(kMaxValues)}};
        if (isName) {
            if (value.size() > kLongestName)
                return damaged(m_lines.number());
            m_values.push_back({code, 0.0, value});
            return {};
        }
        const auto number = numberOf(value);
        if (!number)
            return number.error();
        if (isInteger && std::abs(*number) > std::numeric_limits<int>::max())
            return damaged(m_lines.number());
        m_values.push_back({code, isInteger ? std::trunc(*number) : *number, {}});
        return {};
    }

    Result<double> numberOf(std::string_view text) const {
        if (text.starts_with('+'))
            text.remove_prefix(1);
        double number = 0.0;
        const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
        if (end != text.data() + text.size() || fault == std::errc::invalid_argument)
            return Error{MessageCode::ContourNotANumber,
                         m_where,
                         {std::string(text.substr(0, 40)), std::to_string(m_lines.number())}};
        if (fault == std::errc::result_out_of_range && text.find('-', 1) != std::string_view::npos)
            return 0.0; // 1e-400
        if (fault != std::errc() || !(std::abs(number) <= kLargestNumber))
            return Error{
                MessageCode::ContourNotFinite, m_where, {"line " + std::to_string(m_lines.number())}};
        return number;
    }

    std::size_t count(int code) const {
        return static_cast<std::size_t>(std::ranges::count(m_values, code, &Value::code));
    }
    // Of a group that comes twice, the last, as dxflib takes it.
    int integer(int code, int otherwise) const {
        const auto found = std::find_if(m_values.rbegin(), m_values.rend(),
                                        [&](const Value& value) { return value.code == code; });
        return found == m_values.rend() ? otherwise : static_cast<int>(found->number);
    }

    Result<void> endRecord() {
        if (!m_kind)
            return {};
        if (m_kind->place == Place::Drawn && ++m_entities > kMaxEntities)
            return Error{MessageCode::FileTooLarge,
                         m_where,
                         {std::to_string(m_entities) + " entities", std::to_string(kMaxEntities)}};
        if (isDropped())
            return {};
        m_clean.text += m_type.starts_with('$') ? "9\n" : "0\n";
        m_clean.text += m_type;
        m_clean.text += '\n';
        if (m_type == "LWPOLYLINE")
            write(90, static_cast<double>(count(10)));
        if (m_type == "SPLINE") {
            if (!isSpline())
                return damaged(m_line);
            write(72, static_cast<double>(count(40)));
            write(73, static_cast<double>(count(10)));
            write(74, static_cast<double>(count(11)));
        }
        for (const Value& value : m_values)
            if (value.code == kLayer || (value.code == kName && m_kind->named))
                write(value.code, capitals(value.name));
            else
                write(value.code, value.number);
        return {};
    }

    // Invisible ones, meshes, and of curved polylines the control points, which they do not run through.
    bool isDropped() {
        constexpr int kMesh = 16, kPolyface = 64, kControlPoint = 16, kFaceRecord = 128;
        if (m_type == "VERTEX")
            return !m_keep_vertices || (integer(kFlags, 0) & (kControlPoint | kFaceRecord));
        const bool invisible = m_kind->place == Place::Drawn && integer(kInvisible, 0) == 1;
        const bool mesh = m_type == "POLYLINE" && (integer(kFlags, 0) & (kMesh | kPolyface));
        m_keep_vertices = m_type == "POLYLINE" && !invisible && !mesh;
        if (m_section == "ENTITIES") {
            m_clean.invisible += invisible;
            if (mesh && !invisible)
                leaveOut("MESH");
        }
        return invisible || mesh;
    }

    bool isSpline() const {
        const int degree = integer(71, 3);
        const std::size_t controls = count(10), weights = count(41);
        if (controls == 0)
            return count(11) >= 2;
        if (degree < 1 || degree > kHighestSplineDegree)
            return false;
        const auto order = static_cast<std::size_t>(degree) + 1;
        std::vector<double> knots;
        bool positive = true;
        for (const Value& value : m_values) {
            if (value.code == 40)
                knots.push_back(value.number);
            positive = positive && (value.code != 41 || value.number > kMinWeight);
        }
        return positive && (weights == 0 || weights == controls) && controls >= order &&
               knots.size() == controls + order && std::ranges::is_sorted(knots) &&
               knots[order - 1] < knots[controls];
    }

    void write(int code, std::string_view value) {
        m_clean.text += std::to_string(code);
        m_clean.text += '\n';
        m_clean.text += value;
        m_clean.text += '\n';
    }
    void write(int code, double number) {
        std::array<char, 32> text;
        char* const last = text.data() + text.size();
        const bool whole = std::trunc(number) == number && std::abs(number) <= 1e15; // never as 1e+05
        const auto end = whole ? std::to_chars(text.data(), last, static_cast<long long>(number)).ptr
                               : std::to_chars(text.data(), last, number).ptr;
        write(code, std::string_view(text.data(), static_cast<std::size_t>(end - text.data())));
    }

    Lines m_lines;
    std::string m_where;
    CleanDxf m_clean;
    std::string_view m_section, m_type; // of the record being read
    const Kind* m_kind = nullptr;
    std::size_t m_line = 0;
    std::vector<Value> m_values;
    bool m_keep_vertices = false;
    std::size_t m_entities = 0, m_value_count = 0;
};

} // namespace

Result<CleanDxf> cleanDxf(std::string_view bytes, const std::string& where) {
    if (bytes.starts_with(kBinaryMark))
        return Error{MessageCode::DxfBinary, where};
    if (bytes.starts_with("\xEF\xBB\xBF"))
        bytes.remove_prefix(3);
    return Cleaner(bytes, where).run();
}

} // namespace bask
