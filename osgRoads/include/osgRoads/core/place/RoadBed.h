// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace osgRoads::core
{

/// How a road lies in the ground. The road's mesh has a verge beside its outermost lanes, then a skirt; under
/// lanes and verge the ground is a bed that lies lower, and comes up through the verge's outer part. So no
/// two surfaces lie in one plane, and at any level of detail the mesh covers the ground by more than either
/// may err.
/// Units: metres.
struct RoadBed
{
    double vergeM = 2.5;     ///< width of the verge
    double vergeFall = 0.06; ///< of the verge, outwards, metres per metre
    double depthM = 0.5;     ///< of the bed below the surface
    double skirtM = 1.5;     ///< depth of the skirt below the verge's outer edge
    double skirtSlope = 2.0; ///< of the skirt, fall over run
};

} // namespace osgRoads::core
