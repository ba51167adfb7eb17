// SPDX-License-Identifier: Apache-2.0
// How a road vehicle meets what stands beside and on its way.
#include "simulation/vehicle/road/RoadVehicle.h"

namespace simulation
{

void RoadVehicle::lookAtObstacles()
{
    if (_meeting.look(_motion, _timeS + kStepS, kStepS)) _motion = _world->motion(_body);
}

} // namespace simulation
