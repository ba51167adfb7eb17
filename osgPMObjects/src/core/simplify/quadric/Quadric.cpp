// SPDX-License-Identifier: Apache-2.0
#include <osgPMObjects/core/simplify/Quadric.h>

namespace osgPMObjects::core
{

void Quadric::addPlane(const glm::dvec3& n, double weight)
{
    const glm::dvec3 w = weight * n;
    xx += w.x * n.x;
    yy += w.y * n.y;
    zz += w.z * n.z;
    xy += w.x * n.y;
    xz += w.x * n.z;
    yz += w.y * n.z;
}

double Quadric::at(const glm::dvec3& p) const
{
    return p.x * (xx * p.x + 2.0 * (xy * p.y + xz * p.z)) + p.y * (yy * p.y + 2.0 * yz * p.z) +
           zz * p.z * p.z;
}

} // namespace osgPMObjects::core
