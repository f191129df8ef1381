#pragma once
// The reference of make_radiometry_reference.py.

#include "engine/thermography/band_radiance.h"

#include <nlohmann/json.hpp>

#include <fstream>
#include <map>
#include <string>

namespace bask::test {

inline const nlohmann::json& radiometryReference() {
    static const nlohmann::json kReference = [] {
        std::ifstream file(BASK_TEST_DATA "/thermography/radiometry.json");
        return nlohmann::json::parse(file);
    }();
    return kReference;
}

/// The band of a curve of the reference, "flat" or "bolometer".
inline const BandRadiance& referenceBand(const std::string& name) {
    static std::map<std::string, BandRadiance> made;
    if (const auto it = made.find(name); it != made.end())
        return it->second;
    std::vector<BandResponse> curve;
    for (const auto& point : radiometryReference()["curves_m"][name])
        curve.push_back({point[0].get<double>(), point[1].get<double>()});
    return made.emplace(name, BandRadiance(curve)).first->second;
}

} // namespace bask::test
