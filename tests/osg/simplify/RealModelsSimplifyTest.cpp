// SPDX-License-Identifier: Apache-2.0
// The guarantees of simplification, on real models.
#include <cmath>
#include <filesystem>
#include <set>

#include <gtest/gtest.h>

#include <osgPMObjects/core/mesh/Extent.h>
#include <osgPMObjects/core/mesh/MeshCheck.h>
#include <osgPMObjects/core/mesh/MeshCounts.h>
#include <osgPMObjects/core/mesh/SurfaceChange.h>
#include <osgPMObjects/core/simplify/Simplify.h>
#include <osgPMObjects/core/simplify/TextureSmear.h>

#include "Foliage.h"
#include "RealData.h"
#include "compare/objects/CheckerCoordinates.h"
#include "pmtool/Models.h"

namespace
{

using namespace osgPMObjects;
using namespace osgPMObjects::core;

class RealModel : public testing::TestWithParam<const char*>
{
};

/// Reads a model and prepares it for simplification; fails the test and returns no faces if it cannot be
/// read.
Mesh meshFrom(const std::filesystem::path& file)
{
    const auto model = pmtool::readClean(file.string(), {});
    if (model) return model->read.imported.mesh;
    ADD_FAILURE() << model.error().message();
    return {};
}

std::set<std::uint32_t> materialsOf(const Mesh& mesh)
{
    std::set<std::uint32_t> materials;
    for (const Face& face : mesh.faces)
        materials.insert(face.material);
    return materials;
}

/// Returns how far a mesh reaches beyond a box.
double excess(const Mesh& mesh, const Extent& box)
{
    const Extent own = extentOf(mesh.positions);
    double most = 0.0;
    for (int axis = 0; axis < 3; ++axis)
        most = std::max({most, box.low[axis] - own.low[axis], own.high[axis] - box.high[axis]});
    return most;
}

using EveryModel = RealModel;

TEST_P(EveryModel, ReachesEveryCountStaysInItsBoxAndKeepsItsMaterials)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(file, std::filesystem::path("models") / GetParam());
    const Mesh mesh = meshFrom(file);
    const Extent box = extentOf(mesh.positions);
    for (const Placement placement : {Placement::subset, Placement::optimal, Placement::quality})
    {
        const CollapseSequence sequence = simplify(mesh, {.placement = placement});
        ASSERT_TRUE(isSequenceOf(sequence, mesh));
        for (const double share : {0.25, 0.1, 0.05, 0.01})
        {
            const auto wanted = static_cast<std::size_t>(std::llround(share * double(mesh.faces.size())));
            const Mesh level = meshAfter(mesh, sequence, stepsToFaces(sequence, wanted));
            EXPECT_TRUE(isValid(level));
            EXPECT_LE(level.faces.size(), wanted);
            EXPECT_LE(double(wanted - level.faces.size()), std::max(0.01 * double(wanted), 4.0));
            EXPECT_LE(excess(level, box), 1e-9 * diagonalOf(mesh));
            if (share == 0.25)
            {
                EXPECT_EQ(materialsOf(level), materialsOf(mesh));
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    Models, EveryModel,
    testing::Values("aircraft/KC-130.ac", "aircraft/a4-f-tanker.ac", "aircraft/cessna.obj",
                    "building/coolingtower.ac", "building/hochhaus_asemwald.ac",
                    "building/lasnamae_korghoone.ac", "building/zone_maisons-ba.ac",
                    "cad/2CylinderEngine.glb", "cad/blob5.obj", "cad/club.obj", "cad/spheretext.obj",
                    "cad/standingblob.obj", "cad/teapot.obj", "cad/vintageFan.obj", "character/pirate.obj",
                    "character/spider.obj", "character/spot.obj", "ship/CG-57.ac.gz", "ship/vinson.ac",
                    "tree/eztree_bush_1.obj", "tree/eztree_oak_medium.obj", "vehicle/110Bus.ac",
                    "vehicle/CesiumMilkTruck.obj", "vehicle/Forklift.ac", "vehicle/Goldhofert.ac",
                    "vehicle/ICE3firstcar.ac", "vehicle/evo_wrc.obj", "vehicle/fox_wrc.obj",
                    "vehicle/hoskosh-ti-1500.ac"));

using Tree = RealModel;

/// Returns the part of the projected area that a hundredth of the faces still covers, from three sides.
double coverAtAHundredth(const Mesh& mesh, const SimplifySettings& settings)
{
    const CollapseSequence sequence = simplify(mesh, settings);
    const Mesh level = meshAfter(mesh, sequence, stepsToFaces(sequence, mesh.faces.size() / 100));
    const Extent box = extentOf(mesh.positions);
    return double(testsupport::cover(level, box)) / double(testsupport::cover(mesh, box));
}

TEST_P(Tree, CoversMoreWhenItsLeavesGrow)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(file, std::filesystem::path("models") / GetParam());
    const Mesh mesh = meshFrom(file);
    for (const Placement placement : {Placement::subset, Placement::optimal, Placement::quality})
    {
        const double grown = coverAtAHundredth(mesh, {.placement = placement});
        EXPECT_GT(grown, 1.1 * coverAtAHundredth(mesh, {.placement = placement, .growLeaves = false}));
        EXPECT_LT(grown, 1.05);
    }
}

INSTANTIATE_TEST_SUITE_P(Models, Tree,
                         testing::Values("tree/eztree_oak_medium.obj", "tree/eztree_bush_1.obj"));

/// Returns the share of a level's area that shows its texture farther from its place than the level is from
/// the original.
double smearedShare(const Mesh& mesh, const SimplifySettings& settings, double share)
{
    const CollapseSequence sequence = simplify(mesh, settings);
    const auto faces = static_cast<std::size_t>(share * static_cast<double>(mesh.faces.size()));
    const Mesh level = meshAfter(mesh, sequence, stepsToFaces(sequence, faces));
    const MeasuredSurface before(mesh), after(level);
    const auto smear = TextureSmearMeter(before).measure(after, surfaceChange(before, after).largest);
    return smear ? smear->farShare : 1.0;
}

TEST(TexturedModel, IsHardlySmearedDownToATwentieth)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(file, std::filesystem::path("models/vehicle/CesiumMilkTruck.obj"));
    Mesh mesh = meshFrom(file);
    pmtool::addCheckerCoordinates(mesh);
    SimplifySettings settings;
    EXPECT_LT(smearedShare(mesh, settings, 0.1), 0.04);
    settings.placement = Placement::optimal;
    EXPECT_LT(smearedShare(mesh, settings, 0.1), 0.012);
    EXPECT_LT(smearedShare(mesh, settings, 0.05), 0.05);
    EXPECT_LT(smearedShare(mesh, settings, 0.01), 0.16);
    settings.keepSeams = false; // the mutation: what is seen has no cost
    EXPECT_GT(smearedShare(mesh, settings, 0.05), 0.06);
}

using LeaflessModel = RealModel;

TEST_P(LeaflessModel, IsNotTakenForATree)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(file, std::filesystem::path("models") / GetParam());
    const Mesh mesh = meshFrom(file);
    const CollapseSequence sequence = simplify(mesh), thin = simplify(mesh, {.growLeaves = false});
    ASSERT_EQ(sequence.steps.size(), thin.steps.size());
    for (std::size_t i = 0; i < thin.steps.size(); ++i)
        ASSERT_TRUE(sequence.steps[i].from == thin.steps[i].from && sequence.steps[i].to == thin.steps[i].to);
    EXPECT_EQ(sequence.wedges, thin.wedges);
}

INSTANTIATE_TEST_SUITE_P(Models, LeaflessModel,
                         testing::Values("building/zone_maisons-ba.ac", "building/hochhaus_asemwald.ac",
                                         "ship/CG-57.ac.gz", "ship/vinson.ac", "vehicle/Forklift.ac",
                                         "vehicle/Goldhofert.ac"));

using EnvelopedModel = RealModel;

TEST_P(EnvelopedModel, NeverLeavesItsEnvelope)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(file, std::filesystem::path("models") / GetParam());
    const Mesh mesh = meshFrom(file);
    const double distance = 0.005 * diagonalOf(mesh);
    for (const Placement placement : {Placement::subset, Placement::optimal})
    {
        const CollapseSequence sequence = simplify(mesh, {.placement = placement, .envelope = distance});
        ASSERT_FALSE(sequence.steps.empty());
        for (std::size_t level = 1; level <= 5; ++level)
        {
            const std::size_t steps = sequence.steps.size() * level / 5;
            EXPECT_LE(surfaceChange(mesh, meshAfter(mesh, sequence, steps), 20000).largest, distance);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Models, EnvelopedModel,
                         testing::Values("building/coolingtower.ac", "cad/teapot.obj", "character/spider.obj",
                                         "character/spot.obj", "vehicle/110Bus.ac", "vehicle/evo_wrc.obj"));

} // namespace
