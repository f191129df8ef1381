#pragma once
// Selected channels of a thermometer that reads all of its own.

#include "engine/devices/thermometer.h"

#include <memory>
#include <utility>

namespace bask {

class PickedChannels final : public Thermometer {
public:
    PickedChannels(std::unique_ptr<Thermometer> all, std::vector<int> picked)
        : m_all(std::move(all)), m_picked(std::move(picked)) {}

    int channels() const override { return static_cast<int>(m_picked.size()); }
    void setPeriod(double period_s) override { m_all->setPeriod(period_s); }
    Result<std::vector<Reading>> read() override {
        const auto all = m_all->read();
        if (!all)
            return all.error();
        std::vector<Reading> out;
        for (const int channel : m_picked)
            out.push_back(all->at(static_cast<std::size_t>(channel)));
        return out;
    }

private:
    std::unique_ptr<Thermometer> m_all;
    std::vector<int> m_picked;
};

} // namespace bask
