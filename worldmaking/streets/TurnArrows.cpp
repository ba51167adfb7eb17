// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/streets/TurnArrows.h"

#include <string>
#include <vector>

#include <osgRoads/core/query/LaneSpan.h>

namespace worldmaking
{

namespace
{

using osgRoads::core::LaneType;
using osgRoads::core::Road;
using osgRoads::core::RoadObject;

constexpr double kArrowM = 5.0, kNearArrowM = 8.0, kFarArrowM = 30.0;
constexpr double kLeastLaneM = 2.0; ///< narrower lanes end or begin there

/// Paints arrows across one direction at s. `sign`: of its lanes.
void addRow(const std::vector<std::string>& arrows, int sign, double s, Road& road)
{
    const auto* section = osgRoads::core::sectionAt(road, s);
    if (!section) return;
    std::size_t lane = 0;
    const auto take = [&](const osgRoads::core::LaneSpan& span)
    {
        const bool isOwn = span.lane->type == LaneType::driving &&
                           span.lane->direction != osgRoads::core::LaneDirection::both;
        if (!isOwn || lane >= arrows.size()) return true;
        const std::string subtype = arrowSubtypeOf(arrows[lane++]);
        if (subtype.empty() || span.width() < kLeastLaneM) return true;
        RoadObject arrow;
        arrow.id = road.id + "-a" + std::to_string(road.objects.size());
        arrow.type = "roadMark";
        arrow.subtype = subtype;
        arrow.name = subtype;
        arrow.s = s;
        arrow.t = 0.5 * (span.innerT + span.outerT);
        arrow.orientation = sign < 0 ? '+' : '-';
        arrow.length = kArrowM;
        arrow.width = 1.0;
        road.objects.push_back(std::move(arrow));
        return true;
    };
    osgRoads::core::forLanesOutwards(road, *section, sign, s, take);
}

} // namespace

std::string arrowSubtypeOf(std::string_view turns)
{
    const auto has = [&](std::string_view word) { return turns.find(word) != std::string_view::npos; };
    if (has("merge_to")) return has("merge_to_right") ? "arrowMergeRight" : "arrowMergeLeft";
    const bool isLeft = has("left") || has("reverse"), isRight = has("right"), isAhead = has("through");
    if (!isLeft && !isRight && !isAhead) return {};
    return std::string("arrow") + (isAhead ? "Straight" : "") + (isLeft ? "Left" : "") +
           (isRight ? "Right" : "");
}

void addTurnArrows(const StreetGraph& graph, const StreetChain& chain, Road& road)
{
    for (const double beforeM : {kNearArrowM, kFarArrowM})
    {
        if (road.length < 2.0 * beforeM) return;
        if (chain.endCrossing >= 0)
            addRow(graph.traitsAt(chain, chain.pieces.size() - 1).forwardArrows, -1, road.length - beforeM,
                   road);
        if (chain.startCrossing >= 0) addRow(graph.traitsAt(chain, 0).backwardArrows, 1, beforeM, road);
    }
}

} // namespace worldmaking
