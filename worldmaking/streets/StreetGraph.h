// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "worldmaking/map/StreetMap.h"
#include "worldmaking/streets/StreetTraits.h"

namespace worldmaking
{

/// A street from one crossing or dead end to the next.
struct StreetChain
{
    struct Piece ///< between two points
    {
        std::size_t traits = 0; ///< index into StreetGraph::traits; already seen along the chain
        std::int64_t way = 0;   ///< of the map
    };

    std::vector<std::uint32_t> points;        ///< indices into the map's nodes, two or more
    std::vector<Piece> pieces;                ///< one fewer than points
    int startCrossing = -1, endCrossing = -1; ///< indices into StreetGraph::crossings; -1: a dead end
};

/// The end of a chain at a crossing.
struct StreetArm
{
    std::size_t chain = 0;
    bool isEnd = false; ///< else the chain's start
};

/// A place where three or more pieces meet, or where a ring is closed.
struct Crossing
{
    std::vector<std::uint32_t> points; ///< of the map that fell into one, the first is its middle
    std::vector<StreetArm> arms;
};

/// The streets of a map as chains between crossings.
struct StreetGraph
{
    std::vector<StreetTraits> traits;
    std::vector<StreetChain> chains;
    std::vector<Crossing> crossings;
    std::size_t closedWays = 0; ///< not for cars

    const StreetTraits& traitsAt(const StreetChain& chain, std::size_t piece) const
    {
        return traits[chain.pieces[piece].traits];
    }
};

/// Parts the streets of a map into chains. `places`: of the map's nodes in a plan, metres. Chains between two
/// crossings that are shorter than `shortestM` vanish, and their crossings become one. A piece that two ways
/// share counts once. `traits`: of what ways a graph is made.
StreetGraph graphOf(
    const StreetMap& map, const std::vector<glm::dvec2>& places, double shortestM,
    const std::function<std::optional<StreetTraits>(const Tags&)>& traits = [](const Tags& tags)
    { return traitsOf(tags); });

} // namespace worldmaking
