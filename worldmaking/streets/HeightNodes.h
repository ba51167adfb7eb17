// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include <osgRoads/core/geometry/PlanPoint.h>

#include "worldmaking/streets/CentreLine.h"
#include "worldmaking/streets/Mouths.h"
#include "worldmaking/streets/StreetGraph.h"

namespace worldmaking
{

/// The places of one road at which its height is looked for: evenly spaced along it, the first and the last
/// at its mouths.
/// Units: metres, metres per metre.
struct HeightRow
{
    static constexpr double kStepM = 12.0; ///< between neighbours, about
    static constexpr int kLeastCells = 3;  ///< two nodes at each end lie in the planes of its crossings

    std::size_t first = 0; ///< number of its first node
    double stepM = 0.0;
    std::vector<osgRoads::core::PlanPoint> points;
    std::vector<double> steepest; ///< that the class of the street allows at each node
    std::vector<char> isFree;     ///< of each node: on a bridge or in a tunnel
    std::vector<char> isTunnel;   ///< of each node
    /// So many nodes after the first and before the last lie in the planes of the crossings there: one, and
    /// more where the road shares its paving with other arms.
    std::size_t heldStart = 1, heldEnd = 1;

    std::size_t last() const { return points.size() - 1; }
    bool isHeld(std::size_t k) const { return k <= heldStart || k + heldEnd >= last(); }
    double lengthM() const { return stepM * static_cast<double>(last()); }

    /// The nodes before and after a place of the road, as places in this row.
    std::array<std::size_t, 2> around(double alongM) const
    {
        const double most = static_cast<double>(last()), place = alongM / stepM;
        const auto at = [&](double node) { return static_cast<std::size_t>(std::clamp(node, 0.0, most)); };
        return {at(std::floor(place)), at(std::ceil(place))};
    }
};

/// Crossings that lie in one plane: roads between them are too short to lead from one plane to another.
struct CrossingArea
{
    std::vector<StreetArm> arms; ///< of roads that leave it, and of those within
    glm::dvec2 middle{0.0};      ///< of the mouths
    bool isFree = true;          ///< all its arms begin on bridges or in tunnels
};

/// The nodes of all heights of a network: one for each area, then the rows, without gaps.
struct HeightNodes
{
    std::vector<CrossingArea> areas;
    std::vector<int> areaOf;     ///< of each crossing
    std::vector<HeightRow> rows; ///< of each chain
    std::size_t count = 0;

    /// The area at a crossing, or nothing at a dead end.
    std::optional<std::size_t> areaAt(int crossing) const
    {
        if (crossing < 0) return std::nullopt;
        return static_cast<std::size_t>(areaOf[static_cast<std::size_t>(crossing)]);
    }

    /// The node at which an arm begins.
    std::size_t mouth(const StreetArm& arm) const { return arm.isEnd ? rows[arm.chain].last() : 0; }
    const osgRoads::core::PlanPoint& mouthPoint(const StreetArm& arm) const
    {
        return rows[arm.chain].points[mouth(arm)];
    }
};

HeightNodes heightNodesOf(const StreetGraph& graph, const std::vector<CentreLine>& lines,
                          const std::vector<ChainCut>& cuts);

} // namespace worldmaking
