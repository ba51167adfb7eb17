// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <map>

#include <gtest/gtest.h>

#include <osgPMObjects/core/progressive/ProgressiveLevel.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include "ClosedMeshes.h"
#include "SimplifyMeshes.h"

namespace
{

using namespace osgPMObjects::core;

struct Subject
{
    std::string name;
    Mesh mesh;
};

std::vector<Subject> subjects()
{
    Mesh two = testsupport::together(testsupport::waves(9, 7), testsupport::torus(12, 8), {20.0, 0.0, 0.0});
    return {{"open", testsupport::waves(14, 11)},
            {"closed", testsupport::torus(17, 9)},
            {"seam", testsupport::texturedInHalves(12, 10)},
            {"two materials", std::move(two)},
            {"soup", testsupport::faceSoup(3, 60, 90)}};
}

/// A corner as it is seen: what must be the same whatever its number.
using SeenCorner = std::array<double, 5>;
using SeenFace = std::array<SeenCorner, 3>;

SeenCorner seen(const Mesh& mesh, std::uint32_t wedge)
{
    const Wedge w = wedgeOf(mesh, wedge);
    const glm::dvec3& at = mesh.positions[w.position];
    return {at.x, at.y, at.z, w.texCoords[0].x, w.texCoords[0].y};
}

void add(std::vector<std::pair<std::uint32_t, SeenFace>>& faces, const Mesh& mesh, std::uint32_t material,
         std::array<std::uint32_t, 3> wedges)
{
    SeenFace face{seen(mesh, wedges[0]), seen(mesh, wedges[1]), seen(mesh, wedges[2])};
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    faces.emplace_back(material, face);
}

using SeenFaces = std::vector<std::pair<std::uint32_t, SeenFace>>;

SeenFaces seenOf(const Mesh& level)
{
    SeenFaces faces;
    for (const Face& face : level.faces)
        add(faces, level, face.material, face.wedges);
    std::sort(faces.begin(), faces.end());
    return faces;
}

std::vector<std::uint32_t> indicesOf(const ProgressiveLevel& level)
{
    if (!level.hasNarrowIndices()) return {level.wideIndices().begin(), level.wideIndices().end()};
    return {level.narrowIndices().begin(), level.narrowIndices().end()};
}

/// What is drawn, holes left out; and how many holes there are.
SeenFaces drawnOf(const ProgressiveMesh& progressive, const ProgressiveLevel& level, std::size_t& holes)
{
    SeenFaces faces;
    holes = 0;
    const std::vector<std::uint32_t> indices = indicesOf(level);
    for (std::uint32_t group = 0; group < progressive.groups.size(); ++group)
    {
        std::vector<SlotRange> ranges;
        level.appendRanges(group, ranges);
        for (const SlotRange& range : ranges)
            for (std::uint32_t slot = range.first; slot < range.first + range.count; ++slot)
            {
                const std::uint32_t* const at = &indices[3 * std::size_t{slot}];
                EXPECT_LT(std::max({at[0], at[1], at[2]}), level.wedgeCount());
                if (at[0] == at[1])
                    ++holes;
                else
                    add(faces, progressive.mesh, progressive.groups[group].material, {at[0], at[1], at[2]});
            }
    }
    std::sort(faces.begin(), faces.end());
    return faces;
}

constexpr std::array kArrangements{Arrangement::plain, Arrangement::tswap, Arrangement::blocks,
                                   Arrangement::windows};

ArrangementSettings small(Arrangement arrangement)
{
    return {.arrangement = arrangement, .blockFaces = arrangement == Arrangement::windows ? 40u : 8u};
}

TEST(ProgressiveLevel, DrawsTheFacesOfEveryLevelWhateverTheirOrder)
{
    for (const Subject& subject : subjects())
    {
        const CollapseSequence sequence = simplify(subject.mesh);
        for (const Arrangement arrangement : kArrangements)
        {
            const ProgressiveMesh progressive =
                buildProgressiveMesh(subject.mesh, sequence, small(arrangement));
            ASSERT_EQ(progressive.stepCount, sequence.steps.size()) << subject.name;
            ASSERT_TRUE(isValid(progressive)) << subject.name;
            ProgressiveLevel level(progressive);
            std::size_t mostHoles = 0;
            for (std::uint32_t steps = 0; steps <= progressive.stepCount; ++steps)
            {
                level.moveTo(steps);
                std::size_t holes = 0;
                const SeenFaces drawn = drawnOf(progressive, level, holes);
                mostHoles = std::max(mostHoles, holes);
                ASSERT_EQ(drawn.size(), level.faceCount());
                ASSERT_EQ(drawn, seenOf(meshAfter(subject.mesh, sequence, steps)))
                    << subject.name << ", arrangement " << static_cast<int>(arrangement) << ", step "
                    << steps;
            }
            EXPECT_EQ(mostHoles > 0, arrangement == Arrangement::windows) << subject.name;
        }
    }
}

TEST(ProgressiveLevel, GoesUpThroughTheVeryBuffersThatItWentDown)
{
    for (const Subject& subject : subjects())
    {
        const CollapseSequence sequence = simplify(subject.mesh);
        for (const Arrangement arrangement : kArrangements)
        {
            const ProgressiveMesh progressive =
                buildProgressiveMesh(subject.mesh, sequence, small(arrangement));
            ProgressiveLevel level(progressive);
            std::vector<std::vector<std::uint32_t>> down;
            for (std::uint32_t steps = 0; steps <= progressive.stepCount; ++steps)
            {
                level.moveTo(steps);
                down.push_back(indicesOf(level));
            }
            for (std::uint32_t steps = progressive.stepCount + 1; steps-- > 0;)
            {
                level.moveTo(steps);
                ASSERT_EQ(indicesOf(level), down[steps])
                    << subject.name << ", arrangement " << static_cast<int>(arrangement) << ", step "
                    << steps;
            }
        }
    }
}

} // namespace
