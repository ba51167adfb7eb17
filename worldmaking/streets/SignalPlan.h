// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "worldmaking/streets/CentreLine.h"
#include "worldmaking/streets/Mouths.h"
#include "worldmaking/streets/StreetGraph.h"

namespace worldmaking
{

/// What holds for those who come to a crossing on one arm. Units: metres before the end of the arm's road.
struct ArmSignals
{
    enum class Sign
    {
        none,
        stop,
        giveWay
    };

    int place = -1; ///< of the crossing at this end, as in SignalPlan::placeOf
    bool isLit = false;
    std::optional<double> lineM; ///< where the map has the light or the sign
    std::optional<double> footM; ///< where people on foot cross who have a light
    Sign sign = Sign::none;
};

/// Lights between crossings. Units: metres along the road.
struct StreetLight
{
    std::size_t chain = 0;
    double atM = 0.0;
    bool isForward = false, isBackward = false; ///< for those who drive along the chain, against it
    bool isFoot = false;                        ///< people on foot have lights, too
};

/// Where lights and signs stand.
struct SignalPlan
{
    std::vector<std::array<ArmSignals, 2>> arms; ///< of each chain, at its start and its end
    std::vector<int> placeOf; ///< of each crossing; those with one number have one programme; -1: no lights
    int places = 0;
    std::vector<StreetLight> between;
};

/// Finds who has lights and signs from the nodes of a map.
/// A light at the middle of a crossing is for all who come to it. One beside it is for those who drive in its
/// direction to the crossing ahead, within 60 m; without a direction for those who come to the nearer one,
/// within 30 m. A crossing has lights where two of its arms have, and at least half of those that lead to it:
/// then all have, but service ways. So it has where people on foot have lights at two arms and at half of
/// all, within 25 m. Crossings with lights that are at most 30 m apart have one programme, and no lights
/// between them. Other lights, also for people on foot alone, stop both directions of the street. Signs to
/// stop and to give way are for those who come to the crossing ahead; at arms with lights there are none.
/// `lines`, `cuts`: of the chains. Distances are chosen.
/// Source: the OpenStreetMap wiki, *Tag:highway=traffic_signals*: both ways of mapping a junction.
SignalPlan signalPlanOf(const StreetMap& map, const StreetGraph& graph, const std::vector<CentreLine>& lines,
                        const std::vector<ChainCut>& cuts);

} // namespace worldmaking
