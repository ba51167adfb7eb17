// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/madeup/Settlements.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "worldmaking/plan/Noise.h"

namespace worldmaking
{

namespace
{

constexpr double kSiteSearchM = 150.0, kSiteBorderM = 900.0, kSiteDiscM = 260.0;
constexpr double kSteepestSite = 0.09; ///< mean slope that a settlement bears
constexpr double kVillageKm2 = 60.0, kHamletKm2 = 45.0;
constexpr double kMostWaterM = 1500.0; ///< beyond it water counts as far
constexpr double kSiteStreamKm2 = 2.0;

struct Site
{
    glm::dvec2 place;
    double score; ///< higher is better
};

/// Mean slope of a disc, with more where any of it is no land. Nothing: no place to build.
std::optional<double> meanSlope(const GroundGrid& ground, const glm::dvec2& middle, double radiusM,
                                const std::function<bool(const glm::dvec2&)>& isFree)
{
    double sum = 0.0;
    int count = 0;
    for (const double share : {0.0, 0.45, 0.9})
        for (int i = 0; i < (share > 0.0 ? 8 : 1); ++i)
        {
            const double angle = 0.25 * std::numbers::pi * i;
            const glm::dvec2 place = middle + share * radiusM * glm::dvec2(std::cos(angle), std::sin(angle));
            if (!ground.isLand(place) || !isFree(place)) return std::nullopt;
            sum += ground.slope(place);
            ++count;
        }
    return sum / count;
}

/// How far the nearest stream or shore is, looked for along eight directions.
double waterDistanceM(const GroundGrid& ground, const Drainage& drainage, const glm::dvec2& place)
{
    for (double away = 60.0; away < kMostWaterM; away += 60.0)
        for (int i = 0; i < 8; ++i)
        {
            const double angle = 0.25 * std::numbers::pi * i;
            const glm::dvec2 at = place + away * glm::dvec2(std::cos(angle), std::sin(angle));
            if (drainage.areaKm2(at) > kSiteStreamKm2 ||
                (ground.hasSea() && ground.heightM(at) && !ground.isLand(at)))
                return away;
        }
    return kMostWaterM;
}

} // namespace

std::vector<Settlement> settlementsOn(const SiteRules& rules)
{
    const GroundGrid& ground = rules.ground;
    const Drainage& drainage = rules.drainage;
    std::vector<Site> sites;
    const MapBox& box = ground.box();
    std::size_t land = 0;
    double lowest = 1e9;
    for (double y = box.low.y; y < box.high.y; y += kSiteSearchM)
        for (double x = box.low.x; x < box.high.x; x += kSiteSearchM)
            if (ground.isLand({x, y}))
            {
                ++land;
                lowest = std::min(lowest, *ground.heightM({x, y}));
            }
    const double sideM = std::min(box.high.x - box.low.x, box.high.y - box.low.y);
    const double border = std::min(kSiteBorderM, 0.1 * sideM), discM = std::min(kSiteDiscM, 0.2 * sideM);
    for (double y = box.low.y + border; y < box.high.y - border; y += kSiteSearchM)
        for (double x = box.low.x + border; x < box.high.x - border; x += kSiteSearchM)
        {
            const glm::dvec2 place(x, y);
            if (!ground.isLand(place) || !rules.isReachable(place)) continue;
            const auto slope = meanSlope(ground, place, discM, rules.isFree);
            if (!slope || *slope > kSteepestSite || drainage.areaKm2(place) > kSiteStreamKm2) continue;
            const double water = waterDistanceM(ground, drainage, place) / kMostWaterM;
            const double high = (*ground.heightM(place) - lowest) / 1000.0;
            sites.push_back({place, roughNoiseAt(place, 4000.0, seedFor(rules.seed, 11)) - 9.0 * *slope -
                                        0.5 * water - high});
        }
    std::stable_sort(sites.begin(), sites.end(),
                     [](const Site& a, const Site& b) { return a.score > b.score; });
    std::vector<Settlement> chosen;
    const double landKm2 = static_cast<double>(land) * kSiteSearchM * kSiteSearchM * 1e-6;
    const auto choose = [&](SettlementKind kind, std::size_t count, double apartM)
    {
        for (const Site& site : sites)
        {
            if (count == 0) return;
            const bool isApart =
                std::all_of(chosen.begin(), chosen.end(),
                            [&](const Settlement& other)
                            { return glm::distance(other.middle, site.place) > apartM + other.radiusM(); });
            const Settlement made{kind, site.place};
            if (!isApart || !meanSlope(ground, site.place, made.radiusM(), rules.isFree)) continue;
            chosen.push_back(made);
            --count;
        }
    };
    const auto share = [&](double km2)
    { return static_cast<std::size_t>(std::clamp(landKm2 / km2, 0.0, 12.0)); };
    choose(SettlementKind::town, landKm2 >= kTownKm2 ? 1 : 0, 0.0);
    choose(SettlementKind::village, std::max<std::size_t>(landKm2 > 30.0 ? 2 : 1, share(kVillageKm2)),
           2200.0);
    choose(SettlementKind::hamlet, std::max<std::size_t>(chosen.empty() ? 1 : 0, share(kHamletKm2)), 1400.0);
    return chosen;
}

} // namespace worldmaking
