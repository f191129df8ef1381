#pragma once
// The reference of make_radiometry_reference.py.

#include "engine/thermography/band_radiance.h"

#include <nlohmann/json.hpp>

#include <fstream>
#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace bask::test {

inline const nlohmann::json& radiometryReference() {
    static const nlohmann::json kReference = [] {
        std::ifstream file(BASK_TEST_DATA "/thermography/radiometry.json");
        return nlohmann::json::parse(file);
    }();
    return kReference;
}

/// The band of a curve of the reference, "flat" or "bolometer".
inline const BandRadiance& referenceBand(std::string_view name) {
    static std::map<std::string, BandRadiance, std::less<>> made;
    if (const auto it = made.find(name); it != made.end())
        return it->second;
    std::vector<BandResponse> curve;
    for (const auto& point : radiometryReference()["curves_m"][std::string(name)])
        curve.push_back({point[0].get<double>(), point[1].get<double>()});
    return made.emplace(std::string(name), BandRadiance(curve)).first->second;
}

} // namespace bask::test
