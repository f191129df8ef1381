#include "engine/experiment/json_quantities.h"

#include <nlohmann/json.hpp>

namespace bask {

using Json = nlohmann::ordered_json;

void putQuantity(Json& j, std::string_view name, EdgeUnit unit, double si) {
    const ReadableValue readable = fromSi(si, unit);
    if (readable.exact)
        j[readableKey(name, unit)] = readable.value;
    else
        j[siKey(name, unit)] = si; // no readable number gives back the same double
}

Json coordinatesJson(const Vector6d& q) {
    Json j = Json::object();
    for (int k = 0; k < 6; ++k)
        putQuantity(j, kCoordinateNames[static_cast<std::size_t>(k)], coordinateUnit(k), q[k]);
    return j;
}

} // namespace bask
