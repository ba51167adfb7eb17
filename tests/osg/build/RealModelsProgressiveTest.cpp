// SPDX-License-Identifier: Apache-2.0
// Real models as progressive meshes: at each level the same faces as by collapses alone, in whatever order.
#include <algorithm>
#include <array>
#include <filesystem>

#include <gtest/gtest.h>

#include <osgPMObjects/core/progressive/PmFile.h>
#include <osgPMObjects/core/progressive/ProgressiveLevel.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include "RealData.h"
#include "compare/objects/CacheRow.h"
#include "compare/objects/SimplifyTool.h"
#include "pmtool/Models.h"

namespace
{

using namespace osgPMObjects::core;

class RealModelProgressive : public testing::TestWithParam<const char*>
{
};

/// Sorted faces by the positions and texture coordinates of their corners, each face from its least corner
/// on.
using SeenFaces = std::vector<std::array<std::array<double, 5>, 3>>;

void add(SeenFaces& faces, const Mesh& mesh, const Triangle& wedges)
{
    auto& face = faces.emplace_back();
    for (int corner = 0; corner < 3; ++corner)
    {
        const Wedge w = wedgeOf(mesh, wedges[corner]);
        const glm::dvec3& at = mesh.positions[w.position];
        face[corner] = {at.x, at.y, at.z, w.texCoords[0].x, w.texCoords[0].y};
    }
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
}

SeenFaces drawn(const ProgressiveMesh& mesh, const ProgressiveLevel& level)
{
    SeenFaces faces;
    std::vector<SlotRange> ranges;
    for (std::uint32_t group = 0; group < mesh.groups.size(); ++group)
        level.appendRanges(group, ranges);
    for (const SlotRange& range : ranges)
        for (std::uint32_t slot = range.first; slot < range.first + range.count; ++slot)
            if (const Triangle face = level.face(slot); !repeatsCorner(face)) add(faces, mesh.mesh, face);
    std::sort(faces.begin(), faces.end());
    return faces;
}

SeenFaces expected(const Mesh& mesh, const CollapseSequence& sequence, std::uint32_t steps)
{
    const Mesh level = meshAfter(mesh, sequence, steps);
    SeenFaces faces;
    for (const Face& face : level.faces)
        add(faces, level, face.wedges);
    std::sort(faces.begin(), faces.end());
    return faces;
}

TEST_P(RealModelProgressive, HasTheFacesOfItsLevelsInEveryOrder)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(file, std::filesystem::path("models") / GetParam());
    const auto model = pmtool::readClean(file.string(), {});
    ASSERT_TRUE(model) << model.error().message();
    const Mesh& mesh = model->read.imported.mesh;
    const CollapseSequence sequence = simplify(mesh);
    for (const Arrangement arrangement :
         {Arrangement::plain, Arrangement::tswap, Arrangement::blocks, Arrangement::windows})
    {
        const ProgressiveMesh progressive =
            buildProgressiveMesh(mesh, sequence, {.arrangement = arrangement});
        ASSERT_TRUE(isValid(progressive));
        ProgressiveLevel level(progressive);
        constexpr std::uint32_t kLevels = 12;
        for (std::uint32_t i = 0; i <= kLevels; ++i)
        {
            const std::uint32_t steps = progressive.stepCount * i / kLevels;
            level.moveTo(steps);
            ASSERT_EQ(drawn(progressive, level), expected(mesh, sequence, steps))
                << "arrangement " << static_cast<int>(arrangement) << ", step " << steps;
        }
    }
}

TEST_P(RealModelProgressive, IsDrawnNearlyAsFromScratch)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(file, std::filesystem::path("models") / GetParam());
    const auto model = pmtool::readClean(file.string(), {});
    ASSERT_TRUE(model) << model.error().message();
    const pmtool::CacheSubject subject(pmtool::shapeOf(model->read.imported.mesh), 21, {});
    const auto ours = pmtool::cacheRow(subject, "ours");
    const auto scratch = pmtool::cacheRow(subject, "scratch");
    const double mean = ours["meanTransformsPerVertex"].get<double>();
    EXPECT_LE(mean, 1.40);
    EXPECT_LE(mean, 1.06 * scratch["meanTransformsPerVertex"].get<double>());
    EXPECT_LE(ours["worstLevel"].get<double>(), 1.6);
    EXPECT_LE(ours["faceWritesPerEcol"].get<double>(), 4.0);
    EXPECT_LE(ours["bytesPerVertex"].get<double>(), 16.0);
    // The control: slots that move cost bytes.
    EXPECT_GT(pmtool::cacheRow(subject, "tswap")["bytesPerVertex"].get<double>(),
              ours["bytesPerVertex"].get<double>());
    // The mutation: a random order exceeds that bound.
    EXPECT_GT(pmtool::cacheRow(subject, "random")["meanTransformsPerVertex"].get<double>(),
              1.06 * scratch["meanTransformsPerVertex"].get<double>());
}

INSTANTIATE_TEST_SUITE_P(Models, RealModelProgressive,
                         testing::Values("vehicle/Forklift.ac", "aircraft/KC-130.ac", "aircraft/cessna.obj",
                                         "character/spot.obj", "cad/club.obj", "cad/standingblob.obj",
                                         "cad/blob5.obj", "ship/vinson.ac", "tree/eztree_oak_medium.obj"));

} // namespace
