// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/mesh/Tube.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace scenery::models
{

namespace
{

glm::dvec3 directionAt(const std::vector<glm::dvec3>& line, std::size_t i)
{
    const std::size_t before = i == 0 ? 0 : i - 1;
    const std::size_t after = i + 1 == line.size() ? i : i + 1;
    return glm::normalize(line[after] - line[before]);
}

/// Returns a unit vector perpendicular to a direction.
glm::dvec3 across(const glm::dvec3& direction)
{
    const glm::dvec3 other = std::abs(direction.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
    return glm::normalize(glm::cross(direction, other));
}

void addCap(ModelBuilder& builder, const std::vector<Corner>& ring, const glm::dvec3& middle, bool atEnd)
{
    const Corner centre{middle, ring.front().uv, {}, ring.front().light};
    for (std::size_t i = 0; i + 1 < ring.size(); ++i)
    {
        Corner a = ring[i];
        Corner b = ring[i + 1];
        a.normal = b.normal = {};
        if (atEnd)
            builder.triangle(centre, a, b);
        else
            builder.triangle(centre, b, a);
    }
}

} // namespace

void addTube(ModelBuilder& builder, const Tube& tube)
{
    std::vector<std::vector<Corner>> rings;
    glm::dvec3 u = across(directionAt(tube.line, 0));
    double along = 0.0;
    for (std::size_t p = 0; p < tube.line.size(); ++p)
    {
        const glm::dvec3 direction = directionAt(tube.line, p);
        u = glm::normalize(u - direction * glm::dot(u, direction));
        const glm::dvec3 v = glm::cross(direction, u);
        if (p > 0) along += glm::distance(tube.line[p], tube.line[p - 1]);
        std::vector<Corner>& ring = rings.emplace_back();
        const double swelling = tube.flareLobes > 0.0 ? 0.35 * std::exp(-3.0 * static_cast<double>(p)) : 0.0;
        for (int s = 0; s <= tube.sides; ++s)
        {
            const double turn = 2.0 * std::numbers::pi * (s % tube.sides) / tube.sides;
            const glm::dvec3 outward = u * std::cos(turn) + v * std::sin(turn);
            const double radius = tube.radiiM[p] * (1.0 + swelling * std::cos(tube.flareLobes * turn));
            ring.push_back({tube.line[p] + outward * radius,
                            {static_cast<float>(tube.repeats.x * s / tube.sides),
                             static_cast<float>(tube.repeats.y * along)},
                            glm::vec3(outward),
                            tube.light.empty() ? 1.0F : tube.light[p]});
        }
    }
    builder.grid(rings);
    if (tube.radiiM.front() > 0.0) addCap(builder, rings.front(), tube.line.front(), false);
    if (tube.radiiM.back() > 0.0) addCap(builder, rings.back(), tube.line.back(), true);
}

void addBar(ModelBuilder& builder, const glm::dvec3& from, const glm::dvec3& to, double radiusM, int sides,
            const glm::vec2& uv)
{
    const glm::dvec3 direction = glm::normalize(to - from);
    const glm::dvec3 u = across(direction) * radiusM;
    const glm::dvec3 v = glm::cross(direction, u);
    std::vector<std::vector<Corner>> rings(2);
    for (int s = 0; s <= sides; ++s)
    {
        const double turn = 2.0 * std::numbers::pi * (s % sides) / sides;
        const glm::dvec3 outward = u * std::cos(turn) + v * std::sin(turn);
        rings[0].push_back({from + outward, uv, glm::vec3(outward / radiusM)});
        rings[1].push_back({to + outward, uv, glm::vec3(outward / radiusM)});
    }
    builder.grid(rings);
    addCap(builder, rings[0], from, false);
    addCap(builder, rings[1], to, true);
}

} // namespace scenery::models
