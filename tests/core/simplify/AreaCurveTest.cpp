// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include <osgPMObjects/core/mesh/MeshCheck.h>
#include <osgPMObjects/core/simplify/AreaCurve.h>
#include <osgPMObjects/core/simplify/RemoveVertices.h>

#include "ClosedMeshes.h"

namespace
{

using namespace osgPMObjects::core;
using namespace testsupport;

double areaOf(const Mesh& mesh)
{
    double area = 0.0;
    for (const Face& face : mesh.faces)
        area += 0.5 * glm::length(glm::cross(mesh.at(face, 1) - mesh.at(face, 0),
                                             mesh.at(face, 2) - mesh.at(face, 0)));
    return area;
}

TEST(AreaCurve, EveryLevelHasTheAreaOfItsFaces)
{
    const Mesh mesh = torus(20, 12);
    const RemovalSequence sequence = removeVertices(mesh);
    const AreaCurve curve = areaCurve(mesh, sequence);
    ASSERT_EQ(curve.areas.size(), sequence.steps.size() + 1);
    for (std::size_t k = 0; k < curve.areas.size(); ++k)
    {
        const Mesh level = meshAfter(mesh, sequence, k).mesh;
        ASSERT_EQ(curve.faces[k], level.faces.size()) << k;
        ASSERT_NEAR(curve.areas[k], areaOf(level), 1e-9) << k;
    }
}

TEST(AreaCurve, AFlatSheetKeepsItsAreaDownToTwoTriangles)
{
    const Mesh sheet = grid(9, 9);
    const AreaCurve curve = areaCurve(sheet, removeVertices(sheet));
    EXPECT_NEAR(curve.areas.front(), 81.0, 1e-9);
    EXPECT_NEAR(curve.meanDeviation(2), 0.0, 1e-9);
    EXPECT_GT(curve.meanDeviation(1), 1e-3) << "of one triangle a half is left";
}

TEST(AreaCurve, TheDeviationOfACurveByHand)
{
    // 8 faces of area 1, then 4 of 0.9, then 2 of 0.5: from 8 down to 4 there are two faces at most when F <
    // 4 only.
    const AreaCurve curve{{8, 4, 2}, {1.0, 0.9, 0.5}};
    EXPECT_EQ(curve.levelOf(9), 0u);
    EXPECT_EQ(curve.levelOf(8), 0u);
    EXPECT_EQ(curve.levelOf(7), 1u);
    EXPECT_EQ(curve.levelOf(4), 1u);
    EXPECT_EQ(curve.levelOf(3), 2u);
    EXPECT_EQ(curve.levelOf(1), 2u);
    EXPECT_NEAR(curve.meanDeviation(4), 0.1, 1e-9);
    EXPECT_NEAR(curve.meanDeviation(2), 0.5 * (0.1 + 0.5), 1e-9);
}

TEST(AreaCurve, AShapeHasOneWedgeAPositionAndNothingElse)
{
    Mesh mesh = ball(5, 8);
    paint(mesh, [](const glm::dvec3& centre) { return centre.z > 0.0; });
    const Mesh shape = shapeOf(mesh);
    EXPECT_EQ(defectOf(shape), "");
    EXPECT_EQ(shape.wedgeCount(), mesh.positions.size());
    EXPECT_EQ(shape.materials.size(), 1u);
    ASSERT_EQ(shape.faces.size(), mesh.faces.size());
    for (std::size_t i = 0; i < mesh.faces.size(); ++i)
        for (int c = 0; c < 3; ++c)
            EXPECT_EQ(shape.positionOf(shape.faces[i], c), mesh.positionOf(mesh.faces[i], c));
}

} // namespace
