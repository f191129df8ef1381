// The table of a map, to the letter.

#include "engine/exchange/reachable_file.h"

#include "engine/base/units.h"

#include <gtest/gtest.h>

namespace bask {
namespace {

// Catches: rows in another order, edges of cells for their centres, kelvin, names of other objects, a target
// outside that is told of as one inside.
TEST(ReachableFile, IsATableWithItsDefinitions) {
    ReachableMap map;
    map.first = 0;
    map.second = 2;
    map.cells = 2;
    map.lower_K = {kelvinFromCelsius(20.0), kelvinFromCelsius(40.0)};
    map.upper_K = {kelvinFromCelsius(40.0), kelvinFromCelsius(80.0)};
    map.density = {0.25, 0.75, 0.0, 0.0};
    map.reachable = {true, true, true, false};
    map.target_K = {kelvinFromCelsius(30.0), kelvinFromCelsius(45.5)};
    map.targetReachable = true;
    map.distance_K = 2.5;
    const std::vector<std::string> names{"circle", "bunny", "hand"};
    const std::string text = reachableCsv(names, map);
    EXPECT_EQ(
        text,
        std::string(kReachableMark) +
            "\n# first: circle\n# second: hand\n"
            "# target_C: 30 45.5; a pose holds it, K to the boundary: 2.5\n"
            "# first_C, second_C: centre of a cell. share: of the sampled poses, in the cell. reachable: 1 "
            "where some pose comes into the cell\n"
            "first_C,second_C,share,reachable\n"
            "25,50,0.25,1\n35,50,0.75,1\n25,70,0,1\n35,70,0,0\n");
    map.targetReachable = false;
    EXPECT_NE(
        reachableCsv(names, map).find("; no pose holds it, K to the nearest pair that one holds: 2.5\n"),
        std::string::npos);
    EXPECT_EQ(reachableFileStem(0, 2), "reachable-1-3");
}

} // namespace
} // namespace bask
