#pragma once
// The subset of YAML that OpenCV and ROS use for camera and dictionary files: mappings by indentation, plain
// and quoted scalars, flow and block lists of scalars. OpenCV's own reader needs a header that ROS does not
// write.

#include "engine/base/result.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace bask {

/// Scalars by their path, such as "camera_matrix/data"; a scalar is a list of one. Stores what it understands
/// and skips the rest; reading a missing key reports the error.
class PlainYaml {
public:
    /// Never fails; malformed text gives an empty object, or wrong scalars that number() refuses.
    explicit PlainYaml(std::string_view text);

    bool has(const std::string& path) const { return m_scalars.contains(path); }
    /// Returns a scalar of the list at `path`; empty if there is none.
    std::string text(const std::string& path, std::size_t index = 0) const;
    /// Returns the list of finite numbers at `path`. Errors: JsonMissingKey, NumbersUnusable.
    Result<std::vector<double>> numbers(const std::string& path, const std::string& where) const;
    /// Returns the single whole number at `path`, between the limits. Errors: JsonMissingKey,
    /// NumbersUnusable, ValueOutOfRange.
    Result<int> whole(const std::string& path, int min, int max, const std::string& where) const;

private:
    std::map<std::string, std::vector<std::string>> m_scalars;
};

} // namespace bask
