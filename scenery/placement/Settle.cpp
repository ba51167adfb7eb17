// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "scenery/placement/Arrangements.h"

namespace scenery
{

namespace
{

constexpr int kPlacesTried = 400;    ///< for a settlement
constexpr int kDirectionsTried = 12; ///< for its main street
constexpr double kPieceM = 20.0;     ///< of a street between two heights that are looked at
constexpr double kSteepestStreet = 0.09, kGentleStreet = 0.05; ///< height by length

struct Street
{
    glm::dvec2 from{0.0}, to{0.0};

    glm::dvec2 along() const { return glm::normalize(to - from); }
    double lengthM() const { return glm::length(to - from); }
};

/// The steepest piece of a street along it, and of the land to both sides across it, as height by length;
/// infinity where it leaves ground or area, or comes too near to what is to be kept clear.
double steepnessOf(const Site& site, const Street& street)
{
    double steepest = 0.0;
    const int pieces = std::max(1, static_cast<int>(street.lengthM() / kPieceM));
    const double reach = site.field().settlement.plotM;
    const glm::dvec2 across = reach * glm::dvec2(-street.along().y, street.along().x);
    std::optional<double> before;
    for (int i = 0; i <= pieces; ++i)
    {
        const glm::dvec2 place = street.from + (street.to - street.from) * (static_cast<double>(i) / pieces);
        const auto height = site.heightM(place), left = site.heightM(place + across),
                   right = site.heightM(place - across);
        if (!height || !left || !right || !site.isInArea(place) || !site.isClear(place, reach))
            return std::numeric_limits<double>::infinity();
        const double sides = std::max(std::abs(*left - *height), std::abs(*right - *height)) / reach;
        steepest = std::max(steepest, sides);
        if (before) steepest = std::max(steepest, std::abs(*height - *before) * pieces / street.lengthM());
        before = height;
    }
    return steepest;
}

Street streetAbout(glm::dvec2 middle, double headingRad, double lengthM)
{
    const glm::dvec2 half = 0.5 * lengthM * glm::dvec2(std::cos(headingRad), std::sin(headingRad));
    return {middle - half, middle + half};
}

/// The first main street that is gentle in one of its directions, or else the gentlest of many places.
std::optional<Street> findMainStreet(Site& site)
{
    Street best;
    double gentlest = kSteepestStreet;
    for (int i = 0; i < kPlacesTried; ++i)
    {
        const glm::dvec2 middle = site.anyPlace();
        if (!site.isInArea(middle)) continue;
        for (int k = 0; k < kDirectionsTried; ++k)
        {
            const Street street =
                streetAbout(middle, k * std::numbers::pi / kDirectionsTried, site.field().settlement.streetM);
            if (const double steepness = steepnessOf(site, street); steepness < gentlest)
            {
                gentlest = steepness;
                best = street;
            }
        }
        if (gentlest < kGentleStreet) return best;
    }
    if (gentlest >= kSteepestStreet) return std::nullopt;
    return best;
}

/// Side streets leave the main one by turns to either side, where the ground allows.
std::vector<Street> streetsOf(const Site& site, const Street& main)
{
    std::vector<Street> streets{main};
    const int sides = site.field().settlement.sideStreets;
    const glm::dvec2 across(-main.along().y, main.along().x);
    for (int i = 0; i < sides; ++i)
    {
        const glm::dvec2 from = main.from + (main.to - main.from) * ((i + 1.0) / (sides + 1.0));
        const Street street{from, from + across * (0.5 * main.lengthM() * (i % 2 == 0 ? 1.0 : -1.0))};
        if (steepnessOf(site, street) < kSteepestStreet) streets.push_back(street);
    }
    return streets;
}

/// Houses at both sides, entrances (which look towards -y of the house) to the street. Returns the number of
/// plots.
std::uint32_t build(Site& site, const Street& street)
{
    const SettlementLayout& layout = site.field().settlement;
    const glm::dvec2 along = street.along(), left(-along.y, along.x);
    const double heading = std::atan2(along.y, along.x);
    const int plots = static_cast<int>(street.lengthM() / layout.plotM);
    for (int i = 0; i < plots; ++i)
        for (const double side : {1.0, -1.0})
        {
            const std::uint32_t object = site.anyObject();
            const double scale = site.anyScale(), depth = -site.measures(object).baseLow.y * scale;
            // Bounding circles are kept off streets: the setback counts from there.
            const double off = 0.5 * layout.widthM +
                               std::max(layout.setbackM + depth, site.measures(object).radiusM * scale + 0.1);
            const glm::dvec2 place = street.from +
                                     along * ((i + 0.5 + site.dice().between(-0.1, 0.1)) * layout.plotM) +
                                     left * (side * off);
            site.put(object, place, side > 0.0 ? heading : heading + std::numbers::pi, scale);
        }
    return 2 * static_cast<std::uint32_t>(plots);
}

} // namespace

std::uint32_t settle(Site& site)
{
    std::uint32_t plots = 0;
    for (int i = 0; i < site.field().settlement.settlements; ++i)
    {
        const auto main = findMainStreet(site);
        if (!main) continue;
        const std::vector<Street> streets = streetsOf(site, *main);
        for (const Street& street : streets)
            site.addStreet({{street.from, street.to}, 0.5 * site.field().settlement.widthM});
        for (const Street& street : streets)
            plots += build(site, street);
    }
    return plots;
}

} // namespace scenery
