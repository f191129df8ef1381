#include "engine/experiment/faults_json.h"

#include <nlohmann/json.hpp>

namespace bask {
namespace {

using nlohmann::json;
using Json = nlohmann::ordered_json;

ScriptedFault readFault(const json& j, const std::string& path, Failure& failure) {
    std::map<std::string, SimulatedFault> words;
    for (int i = 1; i < kSimulatedFaults; ++i) {
        const auto fault = static_cast<SimulatedFault>(i);
        words[simulatedFaultName(fault)] = fault;
    }
    Fields fields(j, path, failure);
    ScriptedFault fault;
    int object = 0;
    fields.read("time_s", fault.time_s, true);
    fields.readWord("fault", words, fault.fault, true);
    fields.read("object", object);
    if (fields.find("until_s") != nullptr)
        fields.read("until_s", fault.until_s.emplace());
    fields.close();
    fault.object = static_cast<std::size_t>(object); // a negative one is out of range, whatever the objects
    return fault;
}

} // namespace

void readFaults(Fields& parent, const std::string& key, std::vector<ScriptedFault>& out) {
    readEach(parent, key, false, [&](const json& j, const std::string& path) {
        out.push_back(readFault(j, path, parent.failure()));
    });
}

Json faultsJson(const std::vector<ScriptedFault>& faults) {
    Json list = Json::array();
    for (const ScriptedFault& fault : faults) {
        Json j;
        j["time_s"] = fault.time_s;
        j["fault"] = simulatedFaultName(fault.fault);
        if (isOfObject(fault.fault))
            j["object"] = fault.object;
        if (fault.until_s)
            j["until_s"] = *fault.until_s;
        list.push_back(std::move(j));
    }
    return list;
}

} // namespace bask
