// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/StartCheck.h"

#include <cmath>
#include <string>

namespace simulation
{
namespace
{

constexpr double kLeastClearanceM = 2.0; ///< of the centre of mass in flight
constexpr double kMostInsideM = 1.0;     ///< of a start that is meant to be on the ground

std::string whole(double number)
{
    return std::to_string(std::lround(number));
}

foundation::Error insideGround(const VehicleStart& start, double depthM, double raiseM)
{
    return noStart(start, "lies " + whole(depthM) + " m inside the ground",
                   "raise it above " + whole(raiseM) + " m");
}

} // namespace

foundation::Error noStart(const VehicleStart& start, const std::string& what, const std::string& remedy)
{
    return {"the start at " + whole(start.position.x) + " m east, " + whole(start.position.y) + " m north, " +
                whole(start.position.z) + " m high",
            what, remedy};
}

foundation::Outcome checkFlyingStart(const VehicleStart& start, const GroundPoint& below)
{
    const double clearanceM = start.position.z - below.heightM;
    if (!below.isKnown || clearanceM >= kLeastClearanceM) return foundation::success();
    const double raiseM = below.heightM + kLeastClearanceM;
    if (clearanceM < 0.0) return insideGround(start, -clearanceM, raiseM);
    return noStart(start, "is too low to fly there", "raise it above " + whole(raiseM) + " m");
}

foundation::Outcome checkStandingStart(const VehicleStart& start, const GroundPoint& below)
{
    if (!below.isKnown) return noStart(start, "there is no ground", "move it onto the terrain or a road");
    if (below.kind == GroundKind::water) return noStart(start, "lies in water", "move it onto land");
    const double depthM = below.heightM - start.position.z;
    if (depthM > kMostInsideM) return insideGround(start, depthM, below.heightM - kMostInsideM);
    return foundation::success();
}

} // namespace simulation
