// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/roam/LeafOrder.h>
#include <osgTerrainROAM/core/roam/RoamMesh.h>

#include "SyntheticField.h"
#include "TreeWalks.h"
#include "measurement/flights/BenchmarkFlight.h"

namespace
{

using namespace osgTerrainROAM::core;
using testsupport::Random;

/// Two triangles a cell, row by row.
std::vector<LeafTriangle> gridRows(std::uint32_t columns, std::uint32_t rows)
{
    std::vector<LeafTriangle> triangles;
    for (std::uint32_t row = 0; row < rows; ++row)
        for (std::uint32_t column = 0; column < columns; ++column)
        {
            const std::uint32_t v = row * (columns + 1) + column, above = v + columns + 1;
            triangles.push_back({{v, v + 1, above}});
            triangles.push_back({{above, v + 1, above + 1}});
        }
    return triangles;
}

LeafOrder orderOf(const std::vector<LeafTriangle>& triangles)
{
    std::uint32_t vertices = 0;
    for (const LeafTriangle& t : triangles)
        vertices = std::max({vertices, t.vertices[0] + 1, t.vertices[1] + 1, t.vertices[2] + 1});
    LeafOrderMeter meter(vertices);
    meter.draw(triangles);
    return meter.result();
}

TEST(LeafOrder, OfOneStripSendsAVertexATriangle)
{
    const LeafOrder order = orderOf(gridRows(100, 1));
    EXPECT_DOUBLE_EQ(order.stripLength, 200.0);
    EXPECT_DOUBLE_EQ(order.stripVertices, 202.0 / 200.0);
    EXPECT_DOUBLE_EQ(order.missesFifo16, 202.0 / 200.0);
    EXPECT_DOUBLE_EQ(order.missesFifo32, 202.0 / 200.0);
    EXPECT_DOUBLE_EQ(order.missesBatch32,
                     (6.0 * 34.0 + 10.0) / 200.0); // six batches of 32 triangles, one of 8
}

TEST(LeafOrder, OfAFanTurnsToTheSameSide)
{
    std::vector<LeafTriangle> fan;
    for (std::uint32_t i = 1; i <= 30; ++i)
        fan.push_back({{0, i, i + 1}});
    const LeafOrder order = orderOf(fan);
    EXPECT_DOUBLE_EQ(order.stripLength, 30.0);
    EXPECT_DOUBLE_EQ(order.stripVertices,
                     (32.0 + 27.0) / 30.0); // the first three triangles can be laid either way
    EXPECT_DOUBLE_EQ(order.missesFifo32, 32.0 / 30.0);
    EXPECT_DOUBLE_EQ(order.missesFifo16, 33.0 / 30.0); // the hub leaves the queue once
}

TEST(LeafOrder, OfGridRowsMissesARowBelowThatTheCacheHasLost)
{
    // 8 columns: the 9 vertices between two rows are still there; 40 columns: they are not.
    EXPECT_LT(orderOf(gridRows(8, 40)).missesFifo32, 0.65);
    EXPECT_NEAR(orderOf(gridRows(40, 40)).missesFifo32, 1.0, 0.05);
    EXPECT_DOUBLE_EQ(orderOf(gridRows(40, 40)).stripLength, 80.0); // none goes on from row to row
}

TEST(LeafOrder, OfScatteredTrianglesIsThreeVerticesEach)
{
    std::vector<LeafTriangle> triangles = gridRows(100, 100);
    Random random(5);
    for (std::size_t i = triangles.size() - 1; i > 0; --i)
        std::swap(triangles[i], triangles[random.below(static_cast<std::uint32_t>(i + 1))]);
    const LeafOrder order = orderOf(triangles);
    EXPECT_NEAR(order.stripLength, 1.0, 0.01);
    EXPECT_GT(order.missesFifo32, 2.95);
    EXPECT_GT(order.missesBatch32, 2.95);
}

TEST(LeafOrder, OfSeveralDrawCallsRemembersNothing)
{
    const std::vector<LeafTriangle> triangles = gridRows(10, 1);
    LeafOrderMeter meter(22);
    meter.draw(triangles);
    meter.draw(triangles);
    EXPECT_DOUBLE_EQ(meter.result().missesFifo32, 44.0 / 40.0);
    EXPECT_DOUBLE_EQ(meter.result().stripLength, 20.0);
}

TEST(LeafOrder, GapsBreakNoStripAndSendOneVertex)
{
    std::vector<LeafTriangle> triangles = gridRows(10, 1);
    for (std::size_t i = 0; i < 5; ++i)
        triangles.insert(triangles.begin() + static_cast<std::ptrdiff_t>(3 * i), LeafTriangle{{0, 0, 0}});
    const LeafOrder order = orderOf(triangles);
    EXPECT_DOUBLE_EQ(order.stripLength, 20.0);
    EXPECT_DOUBLE_EQ(order.missesFifo32, 22.0 / 20.0);
    EXPECT_DOUBLE_EQ(order.gaps, 5.0 / 20.0);
}

/// The leaves below a triangle that is a region or part of one, in the order of the bintree.
void collect(const DiamondTree& tree, TriangleId t, std::vector<TriangleId>& leaves)
{
    if (tree.isLeaf(t)) return leaves.push_back(t);
    auto [earlier, later] = tree.children(t);
    if (tree.isAgainstOrder(t)) std::swap(earlier, later);
    collect(tree, earlier, leaves);
    collect(tree, later, leaves);
}

void expectInOrder(const DiamondTree& tree, int regionLevel)
{
    std::vector<TriangleId> open(std::begin(DiamondTree::kRoots), std::end(DiamondTree::kRoots));
    while (!open.empty())
    {
        const TriangleId t = open.back();
        open.pop_back();
        if (tree.level(t) < regionLevel)
        {
            if (tree.isLeaf(t)) continue;
            for (const TriangleId half : tree.children(t))
                open.push_back(half);
            continue;
        }
        std::vector<TriangleId> expected, drawn;
        collect(tree, t, expected);
        std::vector<TriangleRange> ranges;
        tree.leaves().appendRanges(tree.regionOf(t), ranges);
        for (const TriangleRange& range : ranges)
            for (std::uint32_t slot = range.first; slot < range.first + range.count; ++slot)
                if (tree.leaves().leaf(slot).exists()) drawn.push_back(tree.leaves().leaf(slot));
        ASSERT_EQ(drawn, expected);
    }
}

TEST(LeafOrder, OfEveryRegionIsTheBintreesThroughRandomChanges)
{
    const auto tile = testsupport::planarTile(testsupport::hills(65, 65));
    DiamondTree tree(tile);
    Random random(17);
    for (int i = 0; i < 20000; ++i)
    {
        if (random.below(100) < (i / 4000 % 2 == 0 ? 97u : 88u))
        {
            if (const TriangleId t = testsupport::randomDescent(tree, random); tree.canSplit(t))
                tree.forceSplit(t);
        }
        else if (const VertexSlot v = testsupport::randomVertex(tree, random, 12); v != kNone)
            tree.enhMerge(v);
        tree.clearChanges();
        if (i % 500 == 0) expectInOrder(tree, tile->regions.level());
    }
    EXPECT_TRUE(tree.isConforming());
}

TEST(LeafOrder, OfAFlownMeshIsMadeOfLongStrips)
{
    const auto tile = testsupport::planarTile(testsupport::hills(257, 257, 90.0));
    RoamMesh inOrder(tile), nearby(tile, Driver::wheel, LeafPlacement::nearby);
    for (int frame = 0; frame < measurement::BenchmarkFlight::kFrames; frame += 3)
    {
        const auto view = measurement::BenchmarkFlight{}.view(tile->tile, frame);
        inOrder.refine(view, {.errorTolerancePx = 2.0});
        nearby.refine(view, {.errorTolerancePx = 2.0});
    }
    ASSERT_TRUE(inOrder.isConforming());
    ASSERT_TRUE(nearby.isConforming());
    ASSERT_EQ(testsupport::leafSet(inOrder.tree()), testsupport::leafSet(nearby.tree()));
    const LeafOrder good = osgTerrainROAM::core::orderOf(inOrder),
                    poor = osgTerrainROAM::core::orderOf(nearby);
    EXPECT_GT(good.stripLength, 10.0);
    EXPECT_LT(good.missesFifo32, 1.0);
    EXPECT_LT(good.missesBatch32, 1.1);
    EXPECT_LT(poor.stripLength, 2.0); // the mutation
}

} // namespace
