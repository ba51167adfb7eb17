// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace worldmaking
{

/// What an arm of a crossing offers to traffic.
struct ArmLanes
{
    double headingRad = 0.0; ///< away from the crossing
    int in = 0, out = 0;     ///< lanes towards the crossing and away from it
};

/// One lane of an arm leads to one lane of another. Lanes are counted from the middle of the road, from 0.
struct Turn
{
    std::size_t fromArm = 0, toArm = 0;
    int fromLane = 0, toLane = 0;
};

/// Chooses which lanes lead where: straight on lane by lane, to the left from the innermost lane to the
/// innermost, to the right from the outermost to the outermost; every lane that comes in leads somewhere if
/// any exit is allowed. Nobody turns round.
/// `isAllowed`: for each pair of arms, fromArm · arms + toArm.
std::vector<Turn> turnsOf(const std::vector<ArmLanes>& arms, const std::vector<char>& isAllowed);

} // namespace worldmaking
