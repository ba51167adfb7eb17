// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/madeup/Lakes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "worldmaking/plan/Noise.h"

namespace worldmaking
{

namespace
{

constexpr double kLakeSearchM = 150.0, kLakesApartM = 4000.0, kLakeStepM = 12.0;
constexpr double kLargestLakeM = 420.0, kSmallestLakeM = 120.0; ///< from the middle to the shore
constexpr double kAboveSeaM = 2.0, kLakeStreamKm2 = 1.0;
constexpr int kLakeDirections = 40;

/// How far the ground stays level in each direction.
std::vector<double> reachOf(const GroundGrid& ground, const glm::dvec2& middle, const AreaSet& avoided)
{
    std::vector<double> reach(kLakeDirections, 0.0);
    const auto level = ground.heightM(middle);
    if (!level) return reach;
    for (int i = 0; i < kLakeDirections; ++i)
    {
        const double angle = 2.0 * std::numbers::pi * i / kLakeDirections;
        const glm::dvec2 way(std::cos(angle), std::sin(angle));
        for (double away = kLakeStepM; away <= kLargestLakeM; away += kLakeStepM)
        {
            const auto height = ground.heightM(middle + away * way);
            if (!height || !ground.isLand(middle + away * way) || std::abs(*height - *level) > kMostShoreM ||
                avoided.contains(middle + away * way))
                break;
            reach[static_cast<std::size_t>(i)] = away;
        }
    }
    return reach;
}

} // namespace

std::vector<PlanRings> lakesOn(const GroundGrid& ground, const Drainage& drainage, std::uint64_t seed,
                               std::size_t most, const AreaSet& avoided)
{
    struct Site
    {
        double score;
        glm::dvec2 place;
    };
    std::vector<Site> sites;
    const MapBox& box = ground.box();
    const double border = std::min(800.0, 0.1 * (box.high.x - box.low.x));
    for (double y = box.low.y + border; y < box.high.y - border; y += kLakeSearchM)
        for (double x = box.low.x + border; x < box.high.x - border; x += kLakeSearchM)
        {
            const glm::dvec2 place(x, y);
            const auto height = ground.heightM(place);
            if (!height || !ground.isLand(place) || (ground.hasSea() && *height < kAboveSeaM) ||
                ground.slope(place) > 0.02 || avoided.contains(place))
                continue;
            const auto reach = reachOf(ground, place, avoided);
            const double least = *std::min_element(reach.begin(), reach.end());
            if (least < kSmallestLakeM) continue;
            double wet = 0.0;
            for (const double dx : {-200.0, 0.0, 200.0})
                for (const double dy : {-200.0, 0.0, 200.0})
                    wet = std::max(wet, drainage.areaKm2(place + glm::dvec2(dx, dy)));
            sites.push_back({least + (wet > kLakeStreamKm2 ? 120.0 : 0.0) + 0.1 * *height, place});
        }
    std::stable_sort(sites.begin(), sites.end(),
                     [](const Site& a, const Site& b) { return a.score > b.score; });
    std::vector<PlanRings> lakes;
    std::vector<glm::dvec2> middles;
    for (const Site& site : sites)
    {
        if (lakes.size() >= most) break;
        if (std::any_of(middles.begin(), middles.end(),
                        [&](const glm::dvec2& other)
                        { return glm::distance(other, site.place) < kLakesApartM; }))
            continue;
        const auto reach = reachOf(ground, site.place, avoided);
        std::vector<glm::dvec2> shore;
        for (int i = 0; i < kLakeDirections; ++i)
        {
            double shortest = kLargestLakeM; // of three directions: no spikes
            for (int j = -2; j <= 2; ++j)
                shortest = std::min(
                    shortest, reach[static_cast<std::size_t>((i + j + kLakeDirections) % kLakeDirections)]);
            const double angle = 2.0 * std::numbers::pi * i / kLakeDirections;
            const glm::dvec2 way(std::cos(angle), std::sin(angle));
            const double rough = 0.6 + 0.4 * roughNoiseAt(site.place + 150.0 * way, 110.0, seedFor(seed, 61));
            shore.push_back(site.place + shortest * rough * way);
        }
        middles.push_back(site.place);
        lakes.push_back({shore});
    }
    return lakes;
}

} // namespace worldmaking
