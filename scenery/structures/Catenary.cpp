// SPDX-License-Identifier: Apache-2.0
#include "scenery/structures/Catenary.h"

#include <cmath>

namespace scenery
{

std::vector<glm::dvec3> catenary(const glm::dvec3& from, const glm::dvec3& to, double aM, int pieces)
{
    const double lengthM = glm::distance(glm::dvec2(from), glm::dvec2(to)), rise = to.z - from.z;
    // a (cosh((L - m) / a) - cosh(m / a)) = rise gives the lowest place m.
    const double half = 0.5 * lengthM / aM;
    const double lowest =
        lengthM > 0.0 ? 0.5 * lengthM - aM * std::asinh(rise / (2.0 * aM * std::sinh(half))) : 0.0;
    std::vector<glm::dvec3> points;
    for (int i = 0; i <= pieces; ++i)
    {
        const double share = static_cast<double>(i) / pieces, at = share * lengthM;
        const double height = from.z + aM * (std::cosh((at - lowest) / aM) - std::cosh(lowest / aM));
        points.emplace_back(glm::mix(glm::dvec2(from), glm::dvec2(to), share), height);
    }
    points.back() = to;
    return points;
}

} // namespace scenery
