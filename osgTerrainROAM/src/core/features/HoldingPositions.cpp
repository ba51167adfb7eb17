// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <foundation/NearestOnSegment.h>

#include "HoldingPlaces.h"
#include "RoadChains.h"

namespace osgTerrainROAM::core
{

namespace
{

/// How far from a runway's centre line one waits.
double holdingM(double lengthM)
{
    return lengthM < 800.0 ? 30.0 : lengthM < 1200.0 ? 40.0 : 75.0;
}

/// Places along a path, a metre apart; no two are the same.
std::vector<glm::dvec2> everyMetre(const std::vector<glm::dvec2>& path)
{
    constexpr double kSameM = 1e-3;
    std::vector<glm::dvec2> places;
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
    {
        if (glm::distance(path[i], path[i + 1]) < kSameM) continue;
        const int pieces = std::max(1, static_cast<int>(std::lround(glm::distance(path[i], path[i + 1]))));
        for (int piece = 0; piece < pieces; ++piece)
            places.push_back(glm::mix(path[i], path[i + 1], static_cast<double>(piece) / pieces));
    }
    places.push_back(path.back());
    return places;
}

/// The designators of a runway as one has them who looks at it against `away`; at its ends, that end's alone.
std::string runwaysSeenFrom(const HoldingPosition& position, const RunwayFrame& runway)
{
    constexpr double kEndM = 60.0;
    const double lengthM = glm::distance(runway.a, runway.b);
    const glm::dvec2 along = (runway.b - runway.a) / lengthM;
    const auto [atA, atB] = designatorsOf(runway);
    const double fromAM = glm::dot(position.place - runway.a, along);
    if (fromAM < kEndM) return atA;
    if (fromAM > lengthM - kEndM) return atB;
    const glm::dvec2 left(position.away.y, -position.away.x); // of who looks against `away`
    return glm::dot(along, left) < 0.0 ? atA + '-' + atB : atB + '-' + atA;
}

/// Adds where the places, a taxiway's in their order, leave a runway.
void addHoldingPositions(const std::vector<glm::dvec2>& places, double widthM, const RunwayFrame& runway,
                         std::vector<HoldingPosition>& found)
{
    constexpr double kOnM = 3.0, kBeforeEndM = 12.0, kLeastClearM = 15.0;
    const double lengthM = glm::distance(runway.a, runway.b), edgeM = 0.5 * runway.widthM,
                 holdM = std::max(holdingM(lengthM), edgeM + kLeastClearM);
    const auto awayM = [&](std::size_t i)
    { return glm::distance(places[i], foundation::nearestOnSegment(places[i], runway.a, runway.b)); };
    for (std::size_t i = 1; i < places.size(); ++i)
    {
        if (awayM(i - 1) > edgeM + kOnM || awayM(i) <= edgeM + kOnM) continue;
        std::size_t at = i;
        while (at < places.size() && awayM(at) > edgeM + kOnM && awayM(at) < holdM)
            ++at;
        if (at == places.size())
        {
            at -= std::min(at, static_cast<std::size_t>(kBeforeEndM) + 1);
            if (at < i || awayM(at) < edgeM + kLeastClearM) continue;
        }
        if (awayM(at) <= edgeM + kOnM) continue;
        HoldingPosition position{
            places[at], glm::normalize(places[at] - places[at - 1]), widthM, lengthM, {}};
        position.runways = runwaysSeenFrom(position, runway);
        found.push_back(std::move(position));
    }
}

} // namespace

std::vector<HoldingPosition> holdingPositionsAlong(const std::vector<glm::dvec2>& path, double widthM,
                                                   std::span<const RunwayFrame> runways)
{
    if (path.size() < 2) return {};
    std::vector<HoldingPosition> found;
    std::vector<glm::dvec2> places = everyMetre(path);
    for (int way = 0; way < 2; ++way)
    {
        for (const RunwayFrame& runway : runways)
            addHoldingPositions(places, widthM, runway, found);
        std::reverse(places.begin(), places.end());
    }
    return found;
}

std::vector<HoldingPosition> holdingPositions(const std::vector<GroundFeature>& features)
{
    std::vector<HoldingPosition> all;
    const std::vector<RunwayFrame> runways = runwaysOf(features);
    for (const Chain& chain : joinedLines(features))
        if (isPavedTaxiway(chain.style))
            for (HoldingPosition& position : holdingPositionsAlong(chain.points, chain.style.widthM, runways))
                all.push_back(std::move(position));
    return all;
}

} // namespace osgTerrainROAM::core
