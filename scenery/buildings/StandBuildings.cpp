// SPDX-License-Identifier: Apache-2.0
#include "scenery/buildings/StandBuildings.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "scenery/buildings/BuildingRules.h"
#include "scenery/buildings/Outline.h"

namespace scenery
{

namespace
{

constexpr double kOutlineStepM = 1.0;
constexpr double kLeastDoorEdgeM = 2.5;
constexpr double kThresholdM = 0.05; ///< of a floor above the ground at its door

/// The edge of the outer ring whose middle is nearest to the street, of those that are long enough for a
/// door; else the longest one.
std::size_t doorEdgeOf(const std::vector<glm::dvec2>& ring, double groundM, const NearestStreet& street)
{
    glm::dvec2 middle(0.0);
    for (const glm::dvec2& corner : ring)
        middle += corner / static_cast<double>(ring.size());
    const auto to = street ? street(glm::dvec3(middle, groundM)) : std::nullopt;
    std::size_t best = 0;
    double most = -1e300;
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
        const glm::dvec2 &from = ring[i], &next = ring[(i + 1) % ring.size()];
        const double lengthM = glm::length(next - from);
        const bool isNarrow = lengthM < kLeastDoorEdgeM;
        const double rank = !to ? lengthM : (isNarrow ? -1e6 : 0.0) - glm::length(0.5 * (from + next) - *to);
        if (rank <= most) continue;
        most = rank;
        best = i;
    }
    return best;
}

/// The lowest floor above the ground at the door; higher where walls would lie too deep in the ground.
double floorOf(const StandingBuilding& standing, const GroundSpan& span, bool isByStreet)
{
    const double mostM = span.lowM + std::max(kMostCellarM, 0.5 * standing.building.eavesM);
    const double doorM = std::clamp(standing.groundAt(0, standing.doorEdge, 0.5), span.lowM,
                                    isByStreet ? span.highM : std::min(span.highM, mostM));
    return std::max(doorM + kThresholdM, std::min(span.highM - kMostWallSunkM, mostM));
}

/// Puts a building on the ground, and returns what lies below it; nothing: some of it lies beyond.
std::optional<GroundSpan> stand(StandingBuilding& standing, const foundation::HeightInPlan& ground,
                                const NearestStreet& street)
{
    const Building& building = standing.building;
    const auto span = groundUnder(building.rings, ground);
    if (!span) return std::nullopt;
    for (const auto& ring : building.rings)
    {
        standing.groundM.emplace_back();
        for (const glm::dvec2& corner : ring)
            standing.groundM.back().push_back(ground(corner).value_or(span->lowM));
    }
    standing.doorEdge = doorEdgeOf(building.rings.front(), span->lowM, street);
    standing.floorM = floorOf(standing, *span, static_cast<bool>(street));
    standing.footM = span->lowM - kFootM;
    return span;
}

/// The parts of one building that stand.
struct StandingParts
{
    std::vector<std::size_t> of;   ///< their places among the buildings
    std::vector<GroundSpan> spans; ///< the ground below each
};

/// Whether a part on this floor shows a storey of its walls above its ground; one over a passage, whether
/// something of it is left above what passes.
bool showsOn(double floorM, const Building& part, const GroundSpan& span)
{
    const double topM = floorM + part.eavesM;
    if (part.liftedM >= kPassedM) return topM > span.highM + kPassedM;
    return topM >= span.lowM + std::min(kMostWallSunkM, part.eavesM);
}

/// The part whose floor others share: the largest on the ground. Returns its place among the parts.
std::size_t leadOf(const StandingParts& parts, const std::vector<StandingBuilding>& buildings)
{
    const auto rank = [&](std::size_t i)
    {
        const Building& building = buildings[i].building;
        return std::pair(building.liftedM <= 0.0, areaOf(building.rings));
    };
    const auto lead = std::max_element(parts.of.begin(), parts.of.end(),
                                       [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
    return static_cast<std::size_t>(lead - parts.of.begin());
}

/// The floor of a building's lead over the ground of some of its parts; its own where it would lie in the
/// ground on that.
double sharedFloorOf(const StandingParts& parts, std::size_t lead,
                     const std::vector<StandingBuilding>& buildings, bool isByStreet)
{
    GroundSpan all{1e300, -1e300};
    for (const GroundSpan& span : parts.spans)
        all = {std::min(all.lowM, span.lowM), std::max(all.highM, span.highM)};
    const StandingBuilding& standing = buildings[parts.of[lead]];
    const double floorM = floorOf(standing, all, isByStreet);
    return showsOn(floorM, standing.building, parts.spans[lead]) ? floorM : standing.floorM;
}

/// Takes from `parts` those that would lie in the ground on a floor, and returns them; never the lead.
StandingParts sunkOn(double floorM, std::size_t lead, StandingParts& parts,
                     const std::vector<StandingBuilding>& buildings)
{
    StandingParts sunk, kept;
    for (std::size_t k = 0; k < parts.of.size(); ++k)
    {
        const bool stays = k == lead || showsOn(floorM, buildings[parts.of[k]].building, parts.spans[k]);
        StandingParts& group = stays ? kept : sunk;
        group.of.push_back(parts.of[k]);
        group.spans.push_back(parts.spans[k]);
    }
    parts = std::move(kept);
    return sunk;
}

/// Puts the parts of a building on one floor, but for those that would lie in the ground there: it returns
/// them. Each keeps its own foot.
StandingParts shareFloor(StandingParts parts, std::vector<StandingBuilding>& buildings, bool isByStreet)
{
    StandingParts others;
    double floorM = 0.0;
    for (bool isSettled = false; !isSettled;)
    {
        const std::size_t lead = leadOf(parts, buildings); // it stays the same one
        floorM = sharedFloorOf(parts, lead, buildings, isByStreet);
        const StandingParts sunk = sunkOn(floorM, lead, parts, buildings);
        isSettled = sunk.of.empty();
        others.of.insert(others.of.end(), sunk.of.begin(), sunk.of.end());
        others.spans.insert(others.spans.end(), sunk.spans.begin(), sunk.spans.end());
    }
    for (std::size_t k = 0; k < parts.of.size(); ++k)
    {
        StandingBuilding& part = buildings[parts.of[k]];
        part.floorM = floorM;
        double& liftedM = part.building.liftedM;
        const double wantedM = parts.spans[k].highM + kPassedM - floorM;
        if (liftedM >= kPassedM && wantedM > liftedM && wantedM < part.building.eavesM) liftedM = wantedM;
    }
    return others;
}

} // namespace

std::optional<GroundSpan> groundUnder(const std::vector<std::vector<glm::dvec2>>& rings,
                                      const foundation::HeightInPlan& ground)
{
    GroundSpan span{1e300, -1e300};
    const auto look = [&](const glm::dvec2& place)
    {
        const auto heightM = ground(place);
        if (!heightM) return false;
        span.lowM = std::min(span.lowM, *heightM);
        span.highM = std::max(span.highM, *heightM);
        return true;
    };
    for (const auto& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i)
        {
            const glm::dvec2 &from = ring[i], &to = ring[(i + 1) % ring.size()];
            const int steps =
                std::max(1, static_cast<int>(std::ceil(glm::length(to - from) / kOutlineStepM)));
            for (int k = 0; k < steps; ++k)
                if (!look(glm::mix(from, to, static_cast<double>(k) / steps))) return std::nullopt;
        }
    return span;
}

StandingBuildings standBuildings(const osgTerrainROAM::core::ShapeSet& shapes,
                                 const foundation::HeightInPlan& ground, const NearestStreet& street)
{
    StandingBuildings standing;
    std::map<std::string, StandingParts, std::less<>> wholes;
    for (const auto& shape : shapes.shapes)
    {
        const auto id = static_cast<std::uint64_t>(shape.id);
        auto building =
            shape.isArea() ? buildingOf(shape.rings, shape.tags, id) : towerOf(shape.point, shape.tags, id);
        if (!building)
        {
            ++standing.unusable;
            continue;
        }
        StandingBuilding placed{*std::move(building)};
        const auto span = stand(placed, ground, street);
        if (!span)
        {
            ++standing.beyondGround;
            continue;
        }
        if (const auto whole = shape.tags.find(kWholeTag); whole != shape.tags.end())
        {
            StandingParts& parts = wholes[whole->second];
            parts.of.push_back(standing.buildings.size());
            parts.spans.push_back(*span);
        }
        standing.buildings.push_back(std::move(placed));
    }
    for (auto& [whole, parts] : wholes)
        while (!parts.of.empty())
            parts = shareFloor(std::move(parts), standing.buildings, static_cast<bool>(street));
    return standing;
}

} // namespace scenery
