// SPDX-License-Identifier: Apache-2.0
#include "simulation/scenario/Trajectory.h"

namespace simulation
{

bool TrajectoryPosition::operator==(const TrajectoryPosition& other) const
{
    return *trajectory == *other.trajectory && sM == other.sM && tM == other.tM &&
           orientation == other.orientation;
}

} // namespace simulation
