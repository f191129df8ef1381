#include "engine/protocols/axis_map.h"

#include "engine/base/message_code.h"
#include "engine/base/units.h"

#include <algorithm>
#include <stdexcept>
#include <string_view>

namespace bask {
namespace {

constexpr std::string_view kLetters = "XYZABCR";
constexpr double kMillimetres = 1000.0; // a metre has

double scale(const AxisSpec& axis) { // of the axis' numbers a metre or radian
    const double size = axis.coordinate < 3 ? kMillimetres : degFromRad(1.0);
    return axis.reversed ? -size : size;
}

} // namespace

AxisMap::AxisMap(std::vector<AxisSpec> axes, const Vector6d& fixed)
    : m_axes(std::move(axes)), m_fixed(fixed) {
    if (const auto fit = checkAxes(m_axes); !fit)
        throw std::invalid_argument("AxisMap: " + describe(fit.error()));
}

std::vector<double> AxisMap::positions(const Vector6d& coordinates) const {
    std::vector<double> out;
    for (const AxisSpec& axis : m_axes)
        out.push_back((coordinates[axis.coordinate] - axis.origin) * scale(axis));
    return out;
}

Vector6d AxisMap::coordinates(const std::vector<double>& positions) const {
    if (positions.size() != m_axes.size())
        throw std::invalid_argument("AxisMap: one position an axis");
    Vector6d out = m_fixed;
    for (std::size_t i = 0; i < m_axes.size(); ++i)
        out[m_axes[i].coordinate] = m_axes[i].origin + positions[i] / scale(m_axes[i]);
    return out;
}

Result<void> checkAxes(const std::vector<AxisSpec>& axes) {
    if (axes.empty())
        return Error(MessageCode::AxesNone, "axes");
    for (std::size_t i = 0; i < axes.size(); ++i) {
        const AxisSpec& axis = axes[i];
        const std::string where = "axes[" + std::to_string(i) + "]";
        const auto isBefore = [&](auto member) {
            return std::any_of(axes.begin(), axes.begin() + static_cast<std::ptrdiff_t>(i),
                               [&](const AxisSpec& other) { return other.*member == axis.*member; });
        };
        if (kLetters.find(axis.letter) == std::string_view::npos)
            return Error(MessageCode::AxisLetterUnknown, where, {std::string(1, axis.letter)});
        if (axis.coordinate < 0 || axis.coordinate > 5)
            return Error(MessageCode::ValueOutOfRange, where,
                         {std::to_string(axis.coordinate), "0", "5", ""});
        if (isBefore(&AxisSpec::letter))
            return Error(MessageCode::AxisLetterTwice, where, {std::string(1, axis.letter)});
        if (isBefore(&AxisSpec::coordinate))
            return Error(MessageCode::AxisCoordinateTwice, where,
                         {kCoordinateNames[static_cast<std::size_t>(axis.coordinate)]});
    }
    return {};
}

} // namespace bask
