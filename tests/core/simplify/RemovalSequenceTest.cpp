// SPDX-License-Identifier: Apache-2.0
// The check of removal sequences finds their defects.
#include <algorithm>
#include <functional>
#include <map>

#include <gtest/gtest.h>

#include <osgPMObjects/core/simplify/RemoveVertices.h>

#include "ClosedMeshes.h"

namespace
{

using namespace osgPMObjects::core;
using namespace testsupport;

struct Mutation
{
    const char* name;
    std::function<void(RemovalSequence&)> mutate;
};

/// A step in the middle of a sequence, that removes an inner position.
std::size_t middleOf(const RemovalSequence& s)
{
    std::size_t step = s.steps.size() / 2;
    while (s.addedBy(step).size() < 3)
        ++step;
    return step;
}

const std::vector<Mutation> kMutations = {
    {"another position", [](RemovalSequence& s) { s.steps[middleOf(s)].position = s.steps[0].position; }},
    {"a position that does not exist", [](RemovalSequence& s) { s.steps[middleOf(s)].position = ~0u; }},
    {"an error that decreases", [](RemovalSequence& s) { s.steps[middleOf(s)].error = -1.0; }},
    {"an error that is none", [](RemovalSequence& s) { s.steps[middleOf(s)].error = std::nan(""); }},
    {"a face removed twice",
     [](RemovalSequence& s)
     {
         s.removedFaces[s.steps[middleOf(s)].firstRemoved] =
             s.removedFaces[s.steps[middleOf(s)].firstRemoved + 1];
     }},
    {"a face less removed", [](RemovalSequence& s) { ++s.steps[middleOf(s)].firstRemoved; }},
    {"a face less added", [](RemovalSequence& s) { ++s.steps[middleOf(s)].firstAdded; }},
    {"a face turned over",
     [](RemovalSequence& s)
     {
         Face& face = s.addedFaces[s.steps[middleOf(s)].firstAdded];
         std::swap(face.wedges[0], face.wedges[1]);
     }},
    {"a face with another corner",
     [](RemovalSequence& s)
     {
         const auto first = s.steps[middleOf(s)].firstAdded;
         Face &a = s.addedFaces[first], &b = s.addedFaces[first + 1];
         for (const std::uint32_t wedge : b.wedges)
             if (std::find(a.wedges.begin(), a.wedges.end(), wedge) == a.wedges.end()) a.wedges[0] = wedge;
     }},
    {"a face with a corner from elsewhere", [](RemovalSequence& s)
     { s.addedFaces[s.steps[middleOf(s)].firstAdded].wedges[0] = s.addedFaces[0].wedges[0] == 0 ? 1 : 0; }},
    {"a wedge that does not exist",
     [](RemovalSequence& s) { s.addedFaces[s.steps[middleOf(s)].firstAdded].wedges[0] = ~0u; }},
    {"another material",
     [](RemovalSequence& s) { s.addedFaces[s.steps[middleOf(s)].firstAdded].material ^= 1u; }},
    {"an apex where the new faces do not meet",
     [](RemovalSequence& s) { s.steps[middleOf(s)].apex = s.steps[middleOf(s)].position == 0 ? 1 : 0; }},
    {"a step that is said to be of a part", [](RemovalSequence& s) { s.steps[middleOf(s)].isOfPart = true; }},
    {"the last step left out",
     [](RemovalSequence& s)
     {
         s.removedFaces.resize(s.steps.back().firstRemoved);
         s.addedFaces.resize(s.steps.back().firstAdded);
         s.steps.pop_back();
     }},
    {"other positions counted", [](RemovalSequence& s) { ++s.positionCount; }},
    {"other faces counted", [](RemovalSequence& s) { --s.faceCount; }},
    {"a reason less", [](RemovalSequence& s) { s.left.fill(0); }},
    {"steps in another order",
     [](RemovalSequence& s) { std::swap(s.steps[middleOf(s)].position, s.steps[middleOf(s) + 1].position); }},
};

TEST(RemovalSequence, TheCheckSeesEveryMutation)
{
    Mesh mesh = ball(9, 16);
    paint(mesh, [](const glm::dvec3& centre) { return centre.z > 0.0; });
    const RemovalSequence sequence = removeVertices(mesh);
    ASSERT_EQ(removalDefectOf(sequence, mesh), "");
    for (const Mutation& mutation : kMutations)
    {
        RemovalSequence mutated = sequence;
        mutation.mutate(mutated);
        EXPECT_NE(removalDefectOf(mutated, mesh), "") << mutation.name;
    }
}

TEST(RemovalSequence, TheCheckSeesAFilledHoleThatWasNotClosed)
{
    // An open fan of two faces whose middle is removed: its closing edge belongs to an added face, or no hole
    // is filled.
    const Mesh fan =
        meshOf({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {-1, 2, 0}}, {{0, 1, 2}, {0, 2, 3}, {3, 2, 4}});
    RemovalSequence sequence;
    sequence.positionCount = 5;
    sequence.faceCount = 3;
    sequence.steps = {{0, 0, 0, false, 0.0}};
    sequence.removedFaces = {0, 1};
    sequence.addedFaces = {{{1, 2, 3}, 0, 0}};
    sequence.left[0] = 4;
    EXPECT_EQ(removalDefectOf(sequence, fan), "");
    sequence.addedFaces.clear();
    EXPECT_NE(removalDefectOf(sequence, fan), "");
    sequence.addedFaces = {{{1, 2, 3}, 0, 0}, {{1, 2, 3}, 0, 0}};
    EXPECT_NE(removalDefectOf(sequence, fan), "");
}

TEST(RemovalSequence, TheCheckSeesAPartOfWhichSomethingIsLeft)
{
    const Mesh triangles =
        meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {9, 0, 0}, {8, 0, 0}, {9, 1, 0}}, {{0, 1, 2}, {3, 5, 4}});
    RemovalSequence sequence;
    sequence.positionCount = 6;
    sequence.faceCount = 2;
    sequence.steps = {{0, 0, 0, true, 1.0}, {1, 1, 0, true, 1.0}, {2, 1, 0, true, 1.0}};
    sequence.removedFaces = {0};
    sequence.left[0] = 3;
    EXPECT_EQ(removalDefectOf(sequence, triangles), "");
    sequence.steps.pop_back();
    sequence.left[0] = 4;
    EXPECT_NE(removalDefectOf(sequence, triangles), "");
}

TEST(RemovalSequence, EveryReasonHasAName)
{
    std::map<std::string, int> names;
    for (std::size_t reason = 0; reason < kRemovalRefusals; ++reason)
        ++names[nameOf(static_cast<RemovalRefusal>(reason))];
    EXPECT_EQ(names.size(), kRemovalRefusals);
}

} // namespace
