// SPDX-License-Identifier: Apache-2.0
#include "PatchCheck.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include <osgPMObjects/core/mesh/TriangleTree.h>

#include "Shares.h"

namespace osgPMObjects::core
{

namespace
{

constexpr double kLeastTurnCosine = 0.2; ///< of the angle that a face may turn by
constexpr double kNeedle = 1e-3;     ///< about height over longest side; thinner faces may not get thinner
constexpr double kNormalSlip = 0.1;  ///< weight of a difference of unit normals, as a share of the way
constexpr double kColourSlip = 0.1;  ///< the same for colours
constexpr double kLargestSlip = 0.1; ///< of the diagonal: a texture of almost no extent has no meaning

double longestSquared(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
    return std::max({glm::dot(b - a, b - a), glm::dot(c - b, c - b), glm::dot(a - c, a - c)});
}

/// The nearest face of a group, and the nearest point of it.
struct Nearest
{
    const Star::Spoked* face = nullptr;
    glm::dvec3 at{0.0};
    double squared = std::numeric_limits<double>::infinity();
    double doubleArea = 0.0; ///< of the group, before the collapse
};

template<class InGroup>
Nearest nearestOf(const Patch& patch, const InGroup& inGroup)
{
    const glm::dvec3& middle = patch.positions[patch.star.middle];
    Nearest nearest;
    for (const Star::Spoked& spoked : patch.star.faces)
    {
        if (spoked.has(patch.besides) || !inGroup(spoked)) continue;
        const glm::dvec3 at =
            nearestPoint(middle, patch.to, patch.positions[spoked.second], patch.positions[spoked.third]);
        const double squared = glm::dot(at - middle, at - middle);
        nearest.doubleArea += spoked.doubleArea;
        if (squared < nearest.squared) nearest.face = &spoked, nearest.at = at, nearest.squared = squared;
    }
    return nearest;
}

/// Returns the length on the surface of a unit of texture coordinates.
double lengthPerTexture(const std::array<glm::dvec3, 3>& corners, const std::array<Wedge, 3>& wedges,
                        std::size_t set)
{
    const double area = glm::length(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    const glm::dvec2 b = wedges[1].texCoords[set] - wedges[0].texCoords[set];
    const glm::dvec2 c = wedges[2].texCoords[set] - wedges[0].texCoords[set];
    const double texture = std::abs(b.x * c.y - b.y * c.x);
    return texture > 0.0 ? std::sqrt(area / texture) : 0.0;
}

/// Compares the appearance of the removed position with that of the nearest point of the patch.
struct Comparison
{
    LevelError gap;
    double slipSquared = 0.0;
    double lengthPerTexture = 0.0;
};

Comparison compare(const Patch& patch, const Nearest& nearest, const WedgeChange& change, const Look& look)
{
    const std::array<glm::dvec3, 3> corners{patch.to, patch.positions[nearest.face->second],
                                            patch.positions[nearest.face->third]};
    const Triangle& p = look.stars.positions(nearest.face->face);
    const Triangle& w = look.stars.wedges(nearest.face->face);
    const int middle = p[0] == patch.star.middle ? 0 : p[1] == patch.star.middle ? 1 : 2;
    const std::array<Wedge, 3> wedges{change.attributes, wedgeOf(look.mesh, w[(middle + 1) % 3]),
                                      wedgeOf(look.mesh, w[(middle + 2) % 3])};
    const Wedge is = mixtureOf(wedges, sharesOf(nearest.at, corners));
    const Material& material = look.mesh.materials[look.mesh.faces[nearest.face->face].material];
    const Wedge was = wedgeOf(look.mesh, change.wedge);
    const double way = glm::length(patch.to - patch.positions[patch.star.middle]);
    Comparison comparison;
    comparison.gap.distance = static_cast<float>(std::sqrt(nearest.squared));
    const auto addSlip = [&](double slip)
    {
        const double counted = std::min(slip, kLargestSlip);
        comparison.slipSquared += counted * counted;
    };
    if (material.has(Material::normal))
    {
        comparison.gap.normal = glm::distance(is.normal, was.normal);
        addSlip(kNormalSlip * way * comparison.gap.normal);
    }
    for (std::size_t set = 0; set < Mesh::kTexCoordSets; ++set)
    {
        if (!material.has(set == 0 ? Material::texCoord0 : Material::texCoord1)) continue;
        const float drift = glm::distance(is.texCoords[set], was.texCoords[set]);
        comparison.gap.texCoord = std::max(comparison.gap.texCoord, drift);
        const double length = lengthPerTexture(corners, wedges, set);
        comparison.lengthPerTexture = std::max(comparison.lengthPerTexture, length);
        addSlip(drift * length);
    }
    if (material.has(Material::colour))
    {
        const glm::vec4 gap = glm::abs(is.colour - was.colour);
        comparison.gap.colour = std::max({gap.x, gap.y, gap.z, gap.w});
        addSlip(kColourSlip * way * comparison.gap.colour);
    }
    return comparison;
}

} // namespace

PatchTurn turnOf(const Patch& patch)
{
    PatchTurn turn;
    const glm::dvec3& middle = patch.positions[patch.star.middle];
    for (const Star::Spoked& spoked : patch.star.faces)
    {
        if (spoked.has(patch.besides) || spoked.doubleArea <= 0.0) continue;
        const glm::dvec3 &second = patch.positions[spoked.second], &third = patch.positions[spoked.third];
        const glm::dvec3 normal = glm::cross(second - patch.to, third - patch.to);
        const double doubleArea = glm::length(normal);
        if (glm::dot(normal, spoked.normal) < kLeastTurnCosine * doubleArea || !(doubleArea > 0.0))
            return {true, 0.0};
        const double longest = longestSquared(patch.to, second, third);
        if (doubleArea < kNeedle * longest &&
            doubleArea * longestSquared(middle, second, third) < spoked.doubleArea * longest)
            return {true, 0.0};
        turn.doubleArea += doubleArea - spoked.doubleArea;
    }
    return turn;
}

PatchGap gapOf(const Patch& patch, std::span<const WedgeChange> changes, const Look& look)
{
    PatchGap total;
    for (const WedgeChange& change : changes)
    {
        const Nearest nearest =
            nearestOf(patch, [&](const Star::Spoked& spoked) { return spoked.wedge == change.wedge; });
        if (nearest.face == nullptr) continue;
        const Comparison comparison = compare(patch, nearest, change, look);
        total.gap.distance = std::max(total.gap.distance, comparison.gap.distance);
        total.gap.normal = std::max(total.gap.normal, comparison.gap.normal);
        total.gap.texCoord = std::max(total.gap.texCoord, comparison.gap.texCoord);
        total.gap.colour = std::max(total.gap.colour, comparison.gap.colour);
        total.slipCost += look.weight.of(nearest.doubleArea) * comparison.slipSquared;
        total.lengthPerTexture = std::max(total.lengthPerTexture, comparison.lengthPerTexture);
    }
    return total;
}

float distanceFrom(const Patch& patch)
{
    const Nearest nearest = nearestOf(patch, [](const Star::Spoked&) { return true; });
    return nearest.face == nullptr ? 0.0f : static_cast<float>(std::sqrt(nearest.squared));
}

} // namespace osgPMObjects::core
