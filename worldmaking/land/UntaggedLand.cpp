// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/land/UntaggedLand.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>

#include "worldmaking/plan/Noise.h"

namespace worldmaking
{

namespace
{

constexpr double kSlopeLookM = 60.0; ///< between the heights that slopes are taken from
constexpr double kPatchM = 500.0;
constexpr double kRoadM = 15.0;
constexpr std::uint64_t kSeed = 5;

/// Heights by squares, asked once each.
class SquareHeights
{
public:
    explicit SquareHeights(const foundation::HeightInPlan& height) : _height(height) {}

    struct Land
    {
        double heightM = 0.0, slope = 0.0;
    };
    std::optional<Land> at(const glm::dvec2& place)
    {
        const glm::dvec2 square = glm::floor(place / kSlopeLookM);
        const auto middle = cornerM(square), east = cornerM(square + glm::dvec2(1, 0)),
                   north = cornerM(square + glm::dvec2(0, 1));
        if (!middle || !east || !north) return std::nullopt;
        return Land{*middle, std::hypot(*east - *middle, *north - *middle) / kSlopeLookM};
    }

private:
    std::optional<double> cornerM(const glm::dvec2& square)
    {
        const auto key = static_cast<std::uint64_t>(static_cast<std::int64_t>(square.x)) << 32U ^
                         static_cast<std::uint32_t>(static_cast<std::int64_t>(square.y));
        const auto [found, isNew] = _heights.try_emplace(key);
        if (isNew) found->second = _height(kSlopeLookM * square);
        return found->second;
    }

    const foundation::HeightInPlan& _height;
    std::unordered_map<std::uint64_t, std::optional<double>> _heights;
};

} // namespace

double treeLineM(double latitudeDeg)
{
    const double latitude = std::abs(latitudeDeg);
    return latitude < 32.0 ? 3800.0 : std::max(3800.0 - 105.0 * (latitude - 32.0), 0.0);
}

std::size_t fillUntaggedLand(CoverRaster& cover, const UntaggedLand& land)
{
    PlanGrid houses;
    for (std::size_t i = 0; i < land.houses.size(); ++i)
    {
        const MapBox box = boxOf(land.houses[i].building.rings.front());
        houses.add(i, {box.low - kUntaggedRoomM, box.high + kUntaggedRoomM});
    }
    SquareHeights heights(land.height);
    const double line = treeLineM(land.latitudeDeg);
    std::size_t woods = 0;
    cover.fillRest(
        [&](const glm::dvec2& place)
        {
            const auto ground = heights.at(place);
            if (!ground || ground->heightM > line) return Cover::none;
            const double share = std::clamp(0.15 + 2.0 * ground->slope, 0.0, 0.75);
            // Its values lie between 0.15 and 0.85 nearly everywhere.
            if (roughNoiseAt(place, kPatchM, kSeed) > 0.15 + 0.7 * share) return Cover::none;
            bool isFree = true;
            houses.near({place, place}, [&](std::size_t) { isFree = false; });
            if (!isFree || land.roads.distanceM(place, kRoadM) < kRoadM) return Cover::none;
            ++woods;
            return Cover::trees;
        });
    return woods;
}

} // namespace worldmaking
