// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/vdpm/ActiveFront.h>

#include "ClosedMeshes.h"
#include "MadeForest.h"

namespace osgTerrainROAM::core
{

namespace
{

/// The faces of a front by vertices of the mesh that was prepared, each from its lowest corner on.
std::set<Triangle> facesOf(const ActiveFront& front)
{
    std::set<Triangle> faces;
    for (std::uint32_t slot = 0; slot < front.faceCount(); ++slot)
    {
        Triangle t;
        for (int c = 0; c < 3; ++c)
            t[c] = front.forest().original[front.vertexAt(front.faceAt(slot).corners[c])];
        std::rotate(t.begin(), std::ranges::min_element(t), t.end());
        faces.insert(t);
    }
    return faces;
}

std::set<Triangle> facesOf(std::vector<Triangle> triangles)
{
    for (Triangle& t : triangles)
        std::rotate(t.begin(), std::ranges::min_element(t), t.end());
    return {triangles.begin(), triangles.end()};
}

/// A square of four corners and its middle, which merges into corner 0.
VertexForest square()
{
    const std::vector<Triangle> triangles{{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
    const EdgeCollapse collapse{4, 0};
    return buildForest(triangles, 5, std::span(&collapse, 1));
}

/// Does random legal operations: half of them vsplits, forced or not.
template<class AfterEach>
void wander(ActiveFront& front, int operations, std::uint64_t seed, const AfterEach& afterEach)
{
    testsupport::Random random(seed);
    for (int done = 0; done < operations;)
    {
        const std::uint32_t w = random.below(front.forest().splitCount());
        const bool coarsens = random.below(2) != 0; // long runs in one direction come by chance
        if (coarsens && front.isDone(w) && front.isEcolLegal(w))
            front.ecol(w);
        else if (!coarsens && !front.isDone(w) && front.isVsplitLegal(w))
            front.vsplit(w);
        else if (!coarsens && !front.isDone(w) && random.below(50) == 0)
            front.forceVsplit(w);
        else
            continue;
        ++done;
        if (!afterEach(w)) return;
    }
}

TEST(ActiveFront, SplitsTheSmallestExampleAsByHand)
{
    const VertexForest forest = square();
    ASSERT_EQ(forest.splitCount(), 1u);
    ActiveFront front(forest);
    EXPECT_EQ(facesOf(front), (std::set<Triangle>{{0, 1, 2}, {0, 2, 3}}));
    ASSERT_TRUE(front.isVsplitLegal(0));
    EXPECT_FALSE(front.isEcolLegal(0));
    front.vsplit(0);
    EXPECT_EQ(facesOf(front), (std::set<Triangle>{{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {0, 4, 3}}));
    EXPECT_EQ(front.defect(), "");
    ASSERT_TRUE(front.isEcolLegal(0));
    EXPECT_FALSE(front.isVsplitLegal(0));
    front.ecol(0);
    EXPECT_EQ(facesOf(front), (std::set<Triangle>{{0, 1, 2}, {0, 2, 3}}));
    EXPECT_EQ(front.defect(), "");
}

class Forests : public testing::TestWithParam<int>
{
protected:
    testsupport::MadeForest made = GetParam() == 0   ? testsupport::groundForest(11)
                                   : GetParam() == 1 ? testsupport::closedForest(testsupport::ball(9, 12))
                                                     : testsupport::closedForest(testsupport::torus(14, 8));
};

INSTANTIATE_TEST_SUITE_P(Kinds, Forests, testing::Range(0, 3));

TEST_P(Forests, IsConformingAfterEachOfManyRandomOperations)
{
    ActiveFront front(made.forest);
    ASSERT_GT(made.forest.splitCount(), 80u);
    ASSERT_LE(made.forest.rootVertices, 24u);
    std::uint32_t most = 0, least = ~0u;
    wander(front, 10'000, 7 + GetParam(),
           [&](std::uint32_t split)
           {
               most = std::max(most, front.vertexCount());
               least = std::min(least, front.vertexCount());
               const std::string defect = front.defect();
               EXPECT_EQ(defect, "") << "split " << split;
               return defect.empty();
           });
    EXPECT_LT(least, made.forest.rootVertices + made.forest.splitCount() / 4);
    EXPECT_GT(most, made.forest.vertexCount() * 3 / 4);
}

TEST_P(Forests, UndoesEachOperation)
{
    ActiveFront front(made.forest);
    std::set<Triangle> before = facesOf(front);
    wander(front, 1'000, 3,
           [&](std::uint32_t w)
           {
               const std::set<Triangle> after = facesOf(front);
               if (front.isEcolLegal(w) && front.isDone(w))
               {
                   front.ecol(w);
                   EXPECT_TRUE(front.isVsplitLegal(w));
                   front.vsplit(w);
               }
               else if (!front.isDone(w))
               {
                   front.vsplit(w);
                   EXPECT_TRUE(front.isEcolLegal(w));
                   front.ecol(w);
               }
               EXPECT_EQ(facesOf(front), after);
               return !testing::Test::HasFailure();
           });
}

TEST_P(Forests, RefinesToTheMeshInAnyOrderAndBackToItsBase)
{
    for (const std::uint64_t seed : {1, 2, 3})
    {
        ActiveFront front(made.forest);
        const std::set<Triangle> base = facesOf(front);
        testsupport::Random random(seed);
        std::vector<std::uint32_t> order(made.forest.splitCount());
        for (std::uint32_t w = 0; w < order.size(); ++w)
            std::swap(order[w] = w, order[random.below(w + 1)]);
        for (const std::uint32_t w : order)
            front.forceVsplit(w);
        EXPECT_EQ(front.defect(), "");
        EXPECT_EQ(facesOf(front), facesOf(made.triangles));
        for (bool any = true; any;)
        {
            any = false;
            for (const std::uint32_t w : order)
                if (front.isDone(w) && front.isEcolLegal(w)) front.ecol(w), any = true;
        }
        EXPECT_EQ(front.defect(), "");
        EXPECT_EQ(facesOf(front), base);
    }
}

TEST_P(Forests, DependsOnlyOnWhatHasBeenSplit)
{
    ActiveFront front(made.forest);
    wander(front, 3'000, 11, [](std::uint32_t) { return true; });
    ActiveFront again(made.forest);
    for (std::uint32_t w = 0; w < made.forest.splitCount(); ++w)
        if (front.isDone(w)) again.vsplit(w);
    EXPECT_EQ(again.defect(), "");
    EXPECT_EQ(facesOf(again), facesOf(front));
}

/// Every triangle of a mesh whose splits all have their dependencies was seen when the forest was built.
TEST_P(Forests, ShowsOnlyKnownTrianglesWhereDependenciesAreKept)
{
    // A front that does the splits in their order passes through all triangles that there were.
    std::set<Triangle> known;
    ActiveFront ordered(made.forest);
    known.merge(facesOf(ordered));
    for (std::uint32_t w = 0; w < made.forest.splitCount(); ++w)
    {
        ordered.vsplit(w);
        known.merge(facesOf(ordered));
    }
    const auto unknown = [&](bool keepsDependencies)
    {
        ActiveFront front(made.forest);
        testsupport::Random random(5);
        std::size_t count = 0;
        for (int i = 0; i < 4'000; ++i)
        {
            const std::uint32_t w = random.below(made.forest.splitCount());
            const auto isDone = [&](std::uint32_t needed) { return front.isDone(needed); };
            if (front.isDone(w) || !front.isVsplitLegal(w)) continue;
            if (keepsDependencies && !std::ranges::all_of(made.forest.dependenciesOf(w), isDone)) continue;
            front.vsplit(w);
            if (front.vertexCount() > made.forest.vertexCount() / 2) front = ActiveFront(made.forest);
            for (const Triangle& t : facesOf(front))
                count += !known.contains(t);
        }
        return count;
    };
    EXPECT_EQ(unknown(true), 0u);
    EXPECT_GT(unknown(false), 0u); // Hoppe's legality alone lets others appear
}

/// Tries operations that one condition forbids, and tells how many of the meshes are found unsound.
template<class IsForbiddenByOne, class Operation>
int unsoundAfter(const VertexForest& forest, const IsForbiddenByOne& forbidden, const Operation& operation)
{
    int unsound = 0;
    ActiveFront front(forest);
    wander(front, 10'000, 13,
           [&](std::uint32_t)
           {
               for (std::uint32_t w = 0; w < forest.splitCount(); ++w)
                   if (forbidden(front, w))
                   {
                       ActiveFront broken = front;
                       operation(broken, w);
                       unsound += !broken.isConforming();
                       break;
                   }
               return true;
           });
    return unsound;
}

bool areBesidePresent(const ActiveFront& front, std::uint32_t w)
{
    return std::ranges::all_of(front.forest().splits[w].f,
                               [&](std::uint32_t f) { return f == kNone || front.isPresent(f); });
}

bool isDone(const ActiveFront& front, std::uint32_t split)
{
    return split != kNone && front.isDone(split);
}

/// Whether f0 and f3 still lie beside fL and fR: then only f1 or f2 may be elsewhere.
bool keepsFan(const ActiveFront& front, std::uint32_t w)
{
    const VertexSplit& s = front.forest().splits[w];
    if (!s.hasLeft() || !s.hasRight()) return false;
    const auto across = [&](std::uint32_t face, int side)
    { return front.faceAt(front.slotOfFace(face)).across[side]; };
    return across(front.forest().fL(w), 1) == s.f[0] && across(front.forest().fR(w), 2) == s.f[3];
}

TEST(ActiveFront, IsUnsoundWithoutTheConditionThatTheNodeIsActive)
{
    const testsupport::MadeForest made = testsupport::groundForest(11);
    EXPECT_GT(unsoundAfter(
                  made.forest,
                  [](const ActiveFront& front, std::uint32_t w)
                  {
                      return !front.isDone(w) && front.isActive(front.forest().splits[w].v1) &&
                             areBesidePresent(front, w) && !front.isVsplitLegal(w);
                  },
                  [](ActiveFront& front, std::uint32_t w) { front.vsplit(w); }),
              0);
}

TEST(ActiveFront, IsUnsoundWithoutTheConditionThatTheNeighboursOfBothFacesAreTheRightOnes)
{
    const testsupport::MadeForest made = testsupport::groundForest(11);
    EXPECT_GT(unsoundAfter(
                  made.forest,
                  [](const ActiveFront& front, std::uint32_t w)
                  {
                      return front.isDone(w) &&
                             !isDone(front, front.forest().firstSplit[front.forest().v0(w)]) &&
                             !isDone(front, front.forest().nextSplit[w]) && areBesidePresent(front, w) &&
                             keepsFan(front, w) && !front.isEcolLegal(w);
                  },
                  [](ActiveFront& front, std::uint32_t w) { front.ecol(w); }),
              0);
}

TEST_P(Forests, IsUnsoundWhenTheFacesBesideASplitNeedNotBeThere)
{
    // A face of the base mesh in the place of f1 is always there: the condition on f1 is left out.
    VertexForest careless = made.forest;
    for (VertexSplit& s : careless.splits)
        if (s.f[1] != kNone && careless.makerOfFace(s.f[1]) != kNone) s.f[1] = 0;
    ActiveFront front(careless);
    bool isFound = false;
    for (std::uint32_t w = 0; w < careless.splitCount() && !isFound; ++w)
        if (front.isVsplitLegal(w))
        {
            front.vsplit(w);
            isFound = !front.isConforming();
        }
    EXPECT_TRUE(isFound);
}

} // namespace

} // namespace osgTerrainROAM::core
