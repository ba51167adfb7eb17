// SPDX-License-Identifier: Apache-2.0
#include "scenery/lights/StreetLampBytes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <foundation/PlainBytes.h>

namespace scenery
{

namespace
{

/// Place, direction, height and whether it is of sodium.
using LampNumbers = std::array<double, 6>;

} // namespace

std::string bytesOf(const std::vector<StreetLamp>& lamps)
{
    std::vector<LampNumbers> all;
    for (const StreetLamp& lamp : lamps)
        all.push_back({lamp.place.x, lamp.place.y, lamp.towards.x, lamp.towards.y, lamp.heightM,
                       lamp.isSodium ? 1.0 : 0.0});
    std::string bytes;
    foundation::appendValues(bytes, all);
    return bytes;
}

std::optional<std::vector<StreetLamp>> streetLampsIn(std::string_view bytes)
{
    foundation::ValueTaker taker(bytes);
    std::vector<LampNumbers> all;
    if (!taker.take(all) || !taker.isEmpty()) return std::nullopt;
    std::vector<StreetLamp> lamps;
    for (const LampNumbers& numbers : all)
    {
        if (!std::all_of(numbers.begin(), numbers.end(), [](double n) { return std::isfinite(n); }))
            return std::nullopt;
        lamps.push_back({{numbers[0], numbers[1]}, {numbers[2], numbers[3]}, numbers[4], numbers[5] != 0.0});
    }
    return lamps;
}

} // namespace scenery
