#pragma once
// The part of YAML that camera and dictionary files are written in, by OpenCV and by ROS: mappings by
// indentation, plain and quoted scalars, flow and block lists of scalars. OpenCV's own reader wants a header
// that ROS does not write.

#include "engine/base/result.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace bask {

/// Scalars by their path, as "camera_matrix/data"; a scalar is a list of one. Keeps what it understands and
/// steps over the rest: who asks for a key tells what is missing.
class PlainYaml {
public:
    /// Never fails; hostile text gives an empty one, or wrong scalars that number() refuses.
    explicit PlainYaml(std::string_view text);

    bool has(const std::string& path) const { return m_scalars.contains(path); }
    /// A scalar of the list there, empty when there is none.
    std::string text(const std::string& path, std::size_t index = 0) const;
    /// The list of finite numbers there. Errors: JsonMissingKey, NumbersUnusable.
    Result<std::vector<double>> numbers(const std::string& path, const std::string& where) const;
    /// The one whole number there, between the limits. Errors: JsonMissingKey, NumbersUnusable,
    /// ValueOutOfRange.
    Result<int> whole(const std::string& path, int least, int most, const std::string& where) const;

private:
    std::map<std::string, std::vector<std::string>> m_scalars;
};

} // namespace bask
