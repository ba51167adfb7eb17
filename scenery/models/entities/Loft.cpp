// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/entities/Loft.h"

#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "scenery/models/roads/RoadModelParts.h"

namespace scenery::models
{

namespace
{

LoftRing hullRing(const HullSection& section, double power)
{
    return {{section.x, 0.0, 0.5 * (section.low + section.high)},
            {0.0, section.halfWidth, 0.0},
            {0.0, 0.0, 0.5 * (section.high - section.low)},
            power};
}

LoftRing tipAt(const HullSection& section)
{
    return {{section.x, 0.0, 0.5 * (section.low + section.high)}, {}, {}, 2.0};
}

} // namespace

void addLoft(ModelBuilder& builder, const std::vector<LoftRing>& rings, int sides)
{
    std::vector<std::vector<Corner>> rows;
    for (const LoftRing& ring : rings)
    {
        std::vector<Corner>& row = rows.emplace_back();
        for (int i = 0; i <= sides; ++i)
        {
            const double turn = 2.0 * std::numbers::pi * (i % sides) / sides;
            const auto rounded = [&](double c)
            { return std::copysign(std::pow(std::abs(c), 2.0 / ring.power), c); };
            row.push_back(
                {ring.middle + ring.halfA * rounded(std::cos(turn)) + ring.halfB * rounded(std::sin(turn)),
                 plainUv()});
        }
    }
    builder.grid(rows);
}

void addHull(ModelBuilder& builder, const std::vector<HullSection>& sections, double power)
{
    constexpr int kSides = 32;
    std::vector<LoftRing> rings{tipAt(sections.front())};
    for (const HullSection& section : sections)
        rings.push_back(hullRing(section, power));
    rings.push_back(tipAt(sections.back()));
    addLoft(builder, rings, kSides);
}

void addLimb(ModelBuilder& builder, const glm::dvec3& from, const glm::dvec3& to, double fromRadiusM,
             double toRadiusM)
{
    constexpr int kSides = 12;
    constexpr std::array<std::pair<double, double>, 4> kCap{
        {{-1.0, 0.0}, {-0.85, 0.53}, {-0.5, 0.87}, {0.0, 1.0}}}; // along and across, shares of the radius
    const glm::dvec3 along = glm::normalize(to - from);
    const glm::dvec3 aside = std::abs(along.z) > 0.9 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0);
    const glm::dvec3 a = glm::normalize(glm::cross(aside, along)), b = glm::cross(along, a);
    std::vector<LoftRing> rings;
    for (const auto& [at, wide] : kCap)
        rings.push_back({from + along * at * fromRadiusM, a * wide * fromRadiusM, b * wide * fromRadiusM});
    for (auto cap = kCap.rbegin(); cap != kCap.rend(); ++cap)
        rings.push_back(
            {to - along * cap->first * toRadiusM, a * cap->second * toRadiusM, b * cap->second * toRadiusM});
    addLoft(builder, rings, kSides);
}

} // namespace scenery::models
