// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <foundation/Heights.h>

#include "scenery/roads/HeightFit.h"
#include "worldmaking/streets/Crossings.h"
#include "worldmaking/streets/HeightNodes.h"
#include "worldmaking/streets/Mouths.h"
#include "worldmaking/streets/SmoothGround.h"

namespace worldmaking
{

/// A tunnel, or a part of it, whose roof has to lie below the ground: nodes of a row.
struct DugTunnel
{
    std::size_t row = 0, first = 0, last = 0;
};

/// Finds the tunnels that no hill covers, or a part of which none covers: they are dug in, from one portal to
/// the other. A tunnel that a hill covers begins at the ground.
std::vector<DugTunnel> dugTunnels(const HeightNodes& nodes, const std::vector<double>& wishesM,
                                  const foundation::HeightInPlan& ground);

/// Returns between which heights nodes lie: tunnels below the ground, streets over and under what they cross
/// that has a height of its own, bridges over what stays on the ground, and what is sunk under it; where both
/// or none are lifted or sunk, nothing says who moves. Crossings of streets stay at the heights that the
/// ground asks for: near them bounds are as wide as the grade of the street allows.
std::vector<scenery::HeightBound> heightBoundsOf(const HeightNodes& nodes, const std::vector<ChainCut>& cuts,
                                                 std::span<const DugTunnel> tunnels,
                                                 const Crossings& crossings,
                                                 const std::vector<double>& wishesM,
                                                 const foundation::HeightInPlan& ground);

} // namespace worldmaking
