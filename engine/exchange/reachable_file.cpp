#include "engine/exchange/reachable_file.h"

#include "engine/base/message.h"
#include "engine/base/units.h"

namespace bask {

std::string reachableFileStem(int first, int second) {
    return "reachable-" + std::to_string(first + 1) + "-" + std::to_string(second + 1);
}

std::string reachableCsv(const std::vector<std::string>& names, const ReachableMap& map) {
    const auto degC = [](double t_K) { return formatNumber(celsiusFromKelvin(t_K), 6); };
    std::string text = std::string(kReachableMark) +
                       "\n# first: " + names[static_cast<std::size_t>(map.first)] +
                       "\n# second: " + names[static_cast<std::size_t>(map.second)] +
                       "\n# target_C: " + degC(map.target_K.x()) + " " + degC(map.target_K.y()) +
                       (map.targetReachable ? "; a pose holds it, K to the boundary: "
                                            : "; no pose holds it, K to the nearest pair that one holds: ") +
                       formatNumber(map.distance_K) +
                       "\n# first_C, second_C: centre of a cell. share: of the sampled poses, in the cell. "
                       "reachable: 1 where some pose comes into the cell\n"
                       "first_C,second_C,share,reachable\n";
    for (int y = 0; y < map.cells; ++y)
        for (int x = 0; x < map.cells; ++x) {
            const Eigen::Vector2d centre_K =
                map.lower_K + map.cell_K().cwiseProduct(Eigen::Vector2d(x + 0.5, y + 0.5));
            const auto k = static_cast<std::size_t>(y * map.cells + x);
            text += degC(centre_K.x()) + "," + degC(centre_K.y()) + "," + formatNumber(map.density[k]) +
                    (map.reachable[k] ? ",1\n" : ",0\n");
        }
    return text;
}

} // namespace bask
