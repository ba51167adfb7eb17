// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <gtest/gtest.h>

#include <osgPMObjects/core/mesh/MeshCheck.h>
#include <osgPMObjects/core/progressive/LevelMesh.h>
#include <osgPMObjects/core/selection/LevelTable.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include "ClosedMeshes.h"
#include "SimplifyMeshes.h"

namespace
{

using namespace osgPMObjects::core;

struct Subject
{
    Mesh mesh = testsupport::together(testsupport::texturedInHalves(14, 11), testsupport::torus(12, 8),
                                      {20.0, 0.0, 0.0});
    CollapseSequence sequence = simplify(mesh);
    ProgressiveMesh progressive = buildProgressiveMesh(mesh, sequence);
};

/// Returns the positions of the corners of each face, by material, the least first.
auto placesOf(const Mesh& mesh)
{
    std::vector<std::pair<std::uint32_t, std::array<std::array<double, 3>, 3>>> places;
    for (const Face& face : mesh.faces)
    {
        std::array<std::array<double, 3>, 3> corners;
        for (int corner = 0; corner < 3; ++corner)
        {
            const glm::dvec3& p = mesh.at(face, corner);
            corners[static_cast<std::size_t>(corner)] = {p.x, p.y, p.z};
        }
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
        places.emplace_back(face.material, corners);
    }
    std::sort(places.begin(), places.end());
    return places;
}

TEST(LevelMesh, IsThatOfTheCollapsesAtEveryLevel)
{
    const Subject subject;
    for (std::uint32_t steps = 0; steps <= subject.progressive.stepCount; ++steps)
    {
        const Mesh level = meshAfter(subject.progressive, steps);
        ASSERT_EQ(defectOf(level), "") << steps;
        ASSERT_EQ(placesOf(level), placesOf(meshAfter(subject.mesh, subject.sequence, steps))) << steps;
    }
}

TEST(LevelTableOfAProgressiveMesh, IsThatOfItsSequenceButForTheErrorsThatAreKept)
{
    const Subject subject;
    const LevelTable table = LevelTable::of(subject.progressive);
    const LevelTable expected = LevelTable::of(subject.mesh, subject.sequence);
    EXPECT_TRUE(isLevelTable(table));
    EXPECT_EQ(table.positions, expected.positions);
    EXPECT_NEAR(table.area, expected.area, 1e-9 * expected.area);
    ASSERT_EQ(table.faces, expected.faces);
    for (std::size_t level = 0; level < table.errors.size(); ++level)
        EXPECT_GE(table.errors[level].distance, expected.errors[level].distance) << "an upper bound";
}

} // namespace
