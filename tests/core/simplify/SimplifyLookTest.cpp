// SPDX-License-Identifier: Apache-2.0
// Simplification keeps the appearance: wedges and materials.
#include <set>

#include <gtest/gtest.h>

#include <osgPMObjects/core/mesh/MeshCheck.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include "SimplifyMeshes.h"

namespace
{

using namespace osgPMObjects::core;

/// The largest difference of texture coordinates from those wanted at their positions; faces across the seam
/// have a large one.
double worstDrift(const Mesh& mesh, std::uint32_t columns, std::uint32_t rows)
{
    double worst = 0.0;
    for (const Face& face : mesh.faces)
        for (int corner = 0; corner < 3; ++corner)
        {
            const glm::dvec3& at = mesh.at(face, corner);
            double nearest = 1e9;
            for (int half = 0; half < 2; ++half)
                nearest =
                    std::min(nearest, glm::distance(glm::dvec2(mesh.texCoords[0][face.wedges[corner]]),
                                                    glm::dvec2(at.x / columns + 0.4 * half, at.y / rows)));
            worst = std::max(worst, nearest);
        }
    return worst;
}

TEST(SimplifyLook, KeepsASeamWhereItIs)
{
    const Mesh mesh = testsupport::texturedInHalves(24, 24);
    for (const Placement placement : {Placement::subset, Placement::optimal, Placement::quality})
    {
        const CollapseSequence sequence = simplify(mesh, {.placement = placement});
        ASSERT_TRUE(isSequenceOf(sequence, mesh));
        const Mesh level = meshAfter(mesh, sequence, stepsToFaces(sequence, 200));
        EXPECT_TRUE(isValid(level));
        EXPECT_LT(worstDrift(level, 24, 24), 4.0 / 1024);
        for (const Face& face : level.faces)
        { // no face crosses the seam: its corners are all in one half
            double least = 1e9, most = -1e9;
            for (int corner = 0; corner < 3; ++corner)
            {
                const double half = mesh.texCoords[0].empty() ? 0.0
                                                              : level.texCoords[0][face.wedges[corner]].x -
                                                                    level.at(face, corner).x / 24.0;
                least = std::min(least, half);
                most = std::max(most, half);
            }
            EXPECT_LT(most - least, 0.1);
        }
    }
}

TEST(SimplifyLook, LetsTexturesSlideWhenOnlyTheShapeCounts)
{ // control: the same without seams
    const Mesh mesh = testsupport::texturedInHalves(24, 24);
    const CollapseSequence sequence = simplify(mesh, {.keepSeams = false});
    std::size_t across = 0;
    const Mesh level = meshAfter(mesh, sequence, stepsToFaces(sequence, 100));
    for (const Face& face : level.faces)
        for (int corner = 0; corner < 3; ++corner)
        {
            const double x = level.at(face, corner).x, other = level.at(face, (corner + 1) % 3).x;
            across += x < 11.5 && other > 12.5;
        }
    EXPECT_GT(across, 0u);
}

TEST(SimplifyLook, KeepsAFaceOfEveryMaterialForLong)
{
    Mesh mesh = meshOf(testsupport::sphereMesh(30, 40));
    for (std::uint32_t i = 1; i < 12; ++i)
    {
        mesh.materials.push_back({.name = "spot"});
        mesh.faces[100 * i].material = i;
    }
    const auto materialsAt = [&](bool keepSeams)
    {
        const CollapseSequence sequence = simplify(mesh, {.keepSeams = keepSeams});
        std::set<std::uint32_t> materials;
        for (const Face& face : meshAfter(mesh, sequence, stepsToFaces(sequence, 120)).faces)
            materials.insert(face.material);
        return materials.size();
    };
    EXPECT_EQ(materialsAt(true), 12u);
    EXPECT_LT(materialsAt(false), 12u);
}

TEST(SimplifyLook, SaysHowFarTheTextureHasDrifted)
{
    const Mesh mesh = testsupport::texturedInHalves(24, 24);
    const CollapseSequence sequence = simplify(mesh);
    EXPECT_GT(sequence.steps.back().error.texCoord, 0.0f);
    EXPECT_EQ(simplify(mesh, {.keepSeams = false}).steps.back().error.texCoord, 0.0f);
}

} // namespace
