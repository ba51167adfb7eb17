// SPDX-License-Identifier: Apache-2.0
// Meshes on which no two faces share a wedge.
#include <gtest/gtest.h>

#include <osgPMObjects/core/mesh/Wedge.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include "SimplifyMeshes.h"

namespace
{

using namespace osgPMObjects::core;

/// A mesh in which every face has its own piece of the texture.
Mesh shattered(const Mesh& whole)
{
    Mesh mesh = whole;
    mesh.wedgePositions.clear();
    mesh.materials[0].attributes |= Material::texCoord0;
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f)
        for (std::uint32_t& number : mesh.faces[f].wedges)
        {
            Wedge wedge{.position = whole.wedgePositions[number]};
            wedge.texCoords[0] = {static_cast<float>(f), static_cast<float>(wedge.position)};
            number = appendWedge(mesh, wedge);
        }
    return mesh;
}

TEST(ShatteredWedges, StayGoneWithTheirFaces)
{
    const Mesh mesh = shattered(testsupport::waves(24, 24));
    for (const Placement placement : {Placement::subset, Placement::optimal, Placement::quality})
        for (const bool keepSeams : {true, false})
        {
            const CollapseSequence sequence =
                simplify(mesh, {.placement = placement, .keepSeams = keepSeams});
            EXPECT_TRUE(isSequenceOf(sequence, mesh)) << static_cast<int>(placement) << keepSeams;
            for (std::size_t steps = 1; steps <= sequence.steps.size(); steps += 7)
                ASSERT_EQ(meshAfter(mesh, sequence, steps).faces.size(), sequence.steps[steps - 1].facesAfter)
                    << static_cast<int>(placement) << keepSeams;
        }
}

} // namespace
