// SPDX-License-Identifier: Apache-2.0
#include "simulation/geodesy/LocalFrame.h"

namespace simulation
{

LocalFrame::LocalFrame(const Geodetic& origin)
    : _origin(origin), _cartesian(origin.latitudeDeg, origin.longitudeDeg, origin.heightM)
{
}

glm::dvec3 LocalFrame::localFromGeodetic(const Geodetic& geodetic) const
{
    glm::dvec3 local;
    _cartesian.Forward(geodetic.latitudeDeg, geodetic.longitudeDeg, geodetic.heightM, local.x, local.y,
                       local.z);
    return local;
}

Geodetic LocalFrame::geodeticFromLocal(const glm::dvec3& local) const
{
    Geodetic geodetic;
    _cartesian.Reverse(local.x, local.y, local.z, geodetic.latitudeDeg, geodetic.longitudeDeg,
                       geodetic.heightM);
    return geodetic;
}

} // namespace simulation
