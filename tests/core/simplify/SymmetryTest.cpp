// SPDX-License-Identifier: Apache-2.0
// Simplification keeps a symmetric model symmetric.
#include <numbers>

#include <gtest/gtest.h>

#include <osgPMObjects/core/mesh/Extent.h>
#include <osgPMObjects/core/mesh/MeshCounts.h>
#include <osgPMObjects/core/mesh/SurfaceChange.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include "SimplifyMeshes.h"

namespace
{

using namespace osgPMObjects::core;

/// Rings around the x axis: `profile(0…1)` gives the point on the axis and the radius. `isRing`: the last
/// ring is the first.
template<class Profile>
Mesh turned(std::uint32_t rings, std::uint32_t segments, bool isRing, const Profile& profile)
{
    std::vector<glm::dvec3> positions;
    std::vector<Triangle> faces;
    for (std::uint32_t r = 0; r < rings + (isRing ? 0 : 1); ++r)
        for (std::uint32_t s = 0; s < segments; ++s)
        {
            const glm::dvec2 at = profile(double(r) / rings);
            const double angle = 2.0 * std::numbers::pi * (s + 0.5) / segments;
            positions.emplace_back(at.x, at.y * std::cos(angle), at.y * std::sin(angle));
        }
    for (std::uint32_t r = 0; r < rings; ++r)
        for (std::uint32_t s = 0; s < segments; ++s)
        {
            const std::uint32_t nextRing = isRing ? (r + 1) % rings : r + 1, next = (s + 1) % segments;
            const std::uint32_t a = r * segments + s, b = r * segments + next;
            const std::uint32_t c = nextRing * segments + s, d = nextRing * segments + next;
            if (s < segments / 2) // diagonals are mirrored, too
                faces.push_back({a, c, b}), faces.push_back({b, c, d});
            else
                faces.push_back({a, c, d}), faces.push_back({a, d, b});
        }
    return testsupport::meshOf(positions, faces);
}

Mesh fuselage()
{
    return turned(60, 48, false,
                  [](double t)
                  {
                      const double radius = std::sqrt(std::max(0.01, 1.0 - std::pow(2.0 * t - 1.0, 4)));
                      return glm::dvec2(12.0 * t, radius * (1.0 + 0.3 * std::cos(9.0 * t)));
                  });
}

Mesh wheel()
{
    return turned(48, 64, true,
                  [](double t)
                  {
                      const double angle = 2.0 * std::numbers::pi * t;
                      return glm::dvec2(0.3 * std::cos(angle), 1.0 + 0.3 * std::sin(angle));
                  });
}

/// Returns the distance of a level from its mirror image, in per cent of the diagonal, across the best of the
/// three planes.
double lopsidednessPercent(const Mesh& level, const Mesh& original)
{
    const Extent box = extentOf(original.positions);
    double least = 1e9;
    for (int axis = 0; axis < 3; ++axis)
    {
        Mesh image = level;
        for (glm::dvec3& p : image.positions)
            p[axis] = box.low[axis] + box.high[axis] - p[axis];
        least = std::min(least, surfaceChange(level, image, 5000).largest);
    }
    return 100.0 * least / diagonalOf(original);
}

TEST(Symmetry, IsKeptAtEveryLevelOfAFuselageAndAWheel)
{
    for (const Mesh& mesh : {fuselage(), wheel()})
        for (const Placement placement : {Placement::subset, Placement::optimal, Placement::quality})
        {
            const CollapseSequence sequence = simplify(mesh, {.placement = placement});
            ASSERT_TRUE(isSequenceOf(sequence, mesh));
            for (const double share : {0.5, 0.25, 0.1, 0.05, 0.01})
            {
                const auto faces = static_cast<std::size_t>(share * double(mesh.faces.size()));
                const Mesh level = meshAfter(mesh, sequence, stepsToFaces(sequence, faces));
                EXPECT_LE(lopsidednessPercent(level, mesh), 0.1) << faces << " faces";
            }
        }
}

TEST(Symmetry, IsLostWhereNobodyKeepsIt)
{ // control
    const Mesh mesh = wheel();
    const CollapseSequence sequence = simplify(mesh, {.keepSymmetry = false});
    const Mesh level = meshAfter(mesh, sequence, stepsToFaces(sequence, mesh.faces.size() / 20));
    EXPECT_GT(lopsidednessPercent(level, mesh), 0.5);
}

} // namespace
