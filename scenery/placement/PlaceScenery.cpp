// SPDX-License-Identifier: Apache-2.0
#include "scenery/placement/PlaceScenery.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "scenery/placement/Arrangements.h"

namespace scenery
{

namespace
{

constexpr int kAreaDarts = 2000;
constexpr double kMostObjects = 1e7;

/// How much land the field's area is, by darts of its own: those that place objects stay the same.
std::uint32_t wantedByDensity(const Site& site)
{
    models::Dice dice(1);
    int hits = 0;
    const Site::Box& box = site.box();
    for (int i = 0; i < kAreaDarts; ++i)
    {
        const double east = dice.between(box.low.x, box.high.x);
        hits += site.isInArea({east, dice.between(box.low.y, box.high.y)}) ? 1 : 0;
    }
    const double km2 = box.area() * 1e-6 * hits / kAreaDarts;
    return static_cast<std::uint32_t>(std::min(kMostObjects, std::round(km2 * site.field().densityPerKm2)));
}

std::uint32_t fill(Site& site)
{
    if (site.field().arrangement == Arrangement::settlement) return settle(site);
    const std::uint32_t wanted = site.field().count > 0 ? site.field().count : wantedByDensity(site);
    switch (site.field().arrangement)
    {
    case Arrangement::parked:
        park(site, wanted);
        break;
    case Arrangement::rows:
        plantRows(site, wanted);
        break;
    default:
        scatter(site, wanted);
        break;
    }
    return wanted;
}

} // namespace

PlacedScenery placeScenery(const SceneryDescription& description, std::span<const Measures> measures,
                           const Ground& ground, const Ways& ways)
{
    std::vector<std::uint32_t> order(description.fields.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b)
              {
                  const SceneryField &first = description.fields[a], &second = description.fields[b];
                  return first.arrangement != second.arrangement ? first.arrangement < second.arrangement
                                                                 : first.name < second.name;
              });
    Site site(description, measures, ground, ways);
    PlacedScenery placed;
    placed.reports.resize(order.size());
    for (const std::uint32_t number : order)
    {
        site.begin(number);
        FieldReport& report = placed.reports[number];
        report.name = site.field().name;
        report.wanted = fill(site);
        report.placed = site.placed();
    }
    placed.placements = std::move(site.placements);
    for (const auto& [field, street] : site.streets())
        placed.streets.push_back(street);
    return placed;
}

} // namespace scenery
