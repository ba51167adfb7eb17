// SPDX-License-Identifier: Apache-2.0
#include "scenery/structures/Beams.h"

#include <cmath>
#include <numbers>

namespace scenery
{

void Beams::face(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d)
{
    _facets.addPolygon(
        {glm::vec3(a - _origin), glm::vec3(b - _origin), glm::vec3(c - _origin), glm::vec3(d - _origin)},
        std::vector<glm::vec2>(4, glm::vec2(0.5F)), _colour);
}

void Beams::bar(const glm::dvec3& from, const glm::dvec3& to, double fromRadiusM, double toRadiusM, int sides)
{
    const glm::dvec3 along = glm::normalize(to - from);
    const glm::dvec3 a = glm::normalize(
        glm::cross(along, std::abs(along.z) > 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1)));
    const glm::dvec3 b = glm::cross(along, a);
    const auto out = [&](int side)
    {
        const double angle = 2.0 * std::numbers::pi * side / sides;
        return std::cos(angle) * a + std::sin(angle) * b;
    };
    for (int side = 0; side < sides; ++side)
    {
        const glm::dvec3 first = out(side), second = out(side + 1);
        face(from + fromRadiusM * first, from + fromRadiusM * second, to + toRadiusM * second,
             to + toRadiusM * first);
    }
}

void Beams::slab(const Slab& slab)
{
    const glm::dvec3 left(slab.across, 0.0);
    const auto low = [](const glm::dvec3& top, double footM) { return glm::dvec3(top.x, top.y, footM); };
    const glm::dvec3 a = slab.from + left, b = slab.from - left, c = slab.to - left, d = slab.to + left;
    const glm::dvec3 e = low(a, slab.fromFootM), f = low(b, slab.fromFootM), g = low(c, slab.toFootM),
                     h = low(d, slab.toFootM);
    face(b, c, d, a);
    face(f, g, c, b);
    face(h, e, a, d);
    face(e, f, b, a);
    face(g, h, d, c);
}

void Beams::box(const glm::dvec3& middle, const glm::dvec2& forward, const glm::dvec3& halfM)
{
    const glm::dvec3 ahead(halfM.x * forward, halfM.z);
    slab({middle - glm::dvec3(halfM.x * forward, -halfM.z), middle + ahead,
          halfM.y * glm::dvec2(-forward.y, forward.x), middle.z - halfM.z, middle.z - halfM.z});
}

} // namespace scenery
