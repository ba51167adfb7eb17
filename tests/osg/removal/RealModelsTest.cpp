// SPDX-License-Identifier: Apache-2.0
// Removal of vertices on models of other authors.
#include <set>

#include <gtest/gtest.h>

#include <osgPMObjects/core/consolidate/Consolidate.h>
#include <osgPMObjects/core/mesh/MeshCounts.h>
#include <osgPMObjects/core/simplify/AreaCurve.h>
#include <osgPMObjects/core/simplify/RemoveVertices.h>
#include <osgPMObjects/core/simplify/VertexClustering.h>

#include "RealData.h"
#include "pmtool/Models.h"

namespace
{

using namespace osgPMObjects::core;

class RealModels : public testing::TestWithParam<const char*>
{
};

std::set<std::uint32_t> materialsOf(const Mesh& mesh)
{
    std::set<std::uint32_t> materials;
    for (const Face& face : mesh.faces)
        materials.insert(face.material);
    return materials;
}

TEST_P(RealModels, ShapesGoDownToAHundredthOfTheirFacesAndSequencesAreSound)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(file, std::string("models/") + GetParam());
    auto model = pmtool::read(file.string(), {});
    ASSERT_TRUE(model) << model.error().message();
    consolidate(model->imported.mesh);
    const Mesh shape = shapeOf(model->imported.mesh);
    const RemovalSequence sequence = removeVertices(shape);
    ASSERT_EQ(removalDefectOf(sequence, shape), "");
    EXPECT_LE(sequence.facesAfter(sequence.steps.size()), shape.faces.size() / 100);
    const std::size_t steps = sequence.stepsToFaces(shape.faces.size() / 10);
    const MeshCounts counts = countMesh(meshAfter(shape, sequence, steps).mesh);
    EXPECT_EQ(counts.nonManifoldEdges + counts.duplicates, 0u);
}

TEST_P(RealModels, WithSeamsEveryMaterialStaysAndSequencesAreSound)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(file, std::string("models/") + GetParam());
    auto model = pmtool::read(file.string(), {});
    ASSERT_TRUE(model) << model.error().message();
    Mesh& mesh = model->imported.mesh;
    consolidate(mesh);
    const RemovalSequence sequence = removeVertices(mesh);
    ASSERT_EQ(removalDefectOf(sequence, mesh), "");
    EXPECT_EQ(materialsOf(meshAfter(mesh, sequence, sequence.steps.size()).mesh), materialsOf(mesh));
}

TEST_P(RealModels, ClustersAreThoseOfTheMesh)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(file, std::string("models/") + GetParam());
    auto model = pmtool::read(file.string(), {});
    ASSERT_TRUE(model) << model.error().message();
    const Mesh& mesh = model->imported.mesh;
    for (const double share : {0.002, 0.02, 0.2})
    {
        const auto clustered = clusterVertices(mesh, share * diagonalOf(mesh));
        ASSERT_TRUE(clustered);
        EXPECT_EQ(clusteringDefectOf(*clustered, mesh), "") << share;
    }
}

INSTANTIATE_TEST_SUITE_P(Models, RealModels,
                         testing::Values("aircraft/KC-130.ac", "aircraft/a4-f-tanker.ac",
                                         "aircraft/cessna.obj", "cad/teapot.obj", "character/pirate.obj",
                                         "character/spot.obj", "vehicle/Forklift.ac", "vehicle/Goldhofert.ac",
                                         "tree/eztree_oak_medium.obj"));

} // namespace
