// SPDX-License-Identifier: Apache-2.0
#include "compare/objects/CheckerCoordinates.h"

#include <gtest/gtest.h>

#include <osgPMObjects/core/mesh/MeshCheck.h>
#include <osgPMObjects/core/mesh/MeshCounts.h>

#include "MadeMeshes.h"

namespace
{

using namespace osgPMObjects::core;

TEST(CheckerCoordinates, ProjectEachSideOfACubeAndCutBetween)
{
    const Mesh cube = testsupport::cube();
    Mesh checked = cube;
    pmtool::addCheckerCoordinates(checked);
    ASSERT_EQ(defectOf(checked), "");
    EXPECT_EQ(checked.wedgeCount(), 24u) << "each corner once for each of its sides";
    EXPECT_EQ(positionTriangles(checked), positionTriangles(cube));
    EXPECT_TRUE(checked.materials[0].has(Material::texCoord0));
    for (const Face& face : checked.faces)
        for (int corner = 0; corner < 3; ++corner)
        {
            const int next = (corner + 1) % 3;
            const double along = glm::length(checked.at(face, next) - checked.at(face, corner));
            const auto& uv = checked.texCoords[0];
            EXPECT_NEAR(glm::length(uv[face.wedges[next]] - uv[face.wedges[corner]]), along, 1e-6)
                << "nothing is stretched that faces an axis";
        }
}

TEST(CheckerCoordinates, AreASeamBetweenPartsToo)
{
    Mesh plane = testsupport::grid(2, 1);
    plane.parts = {{"left"}, {"right"}};
    pmtool::addCheckerCoordinates(plane);
    const std::size_t asOnePart = 6;
    EXPECT_EQ(plane.wedgeCount(), asOnePart);
    for (std::size_t f = 2; f < 4; ++f)
        plane.faces[f].part = 1;
    pmtool::addCheckerCoordinates(plane);
    EXPECT_EQ(plane.wedgeCount(), asOnePart + 2);
}

} // namespace
