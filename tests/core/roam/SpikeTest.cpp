// SPDX-License-Identifier: Apache-2.0
// A spike of one sample adds triangles around it only: their number grows with the depth of the bintree, not
// with the size of the field.
#include <cmath>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/heightfield/DemImport.h>
#include <osgTerrainROAM/core/roam/RoamMesh.h>

#include "RealData.h"
#include "SyntheticField.h"

namespace
{

using namespace osgTerrainROAM::core;
using testsupport::Random;

/// A spike needs the vertices whose diamonds hold it: of the two log2(n) levels, at most so many triangles in
/// each.
constexpr double kMostPerDoubling = 24.0;

double bound(int side)
{
    return kMostPerDoubling * std::log2(side - 1);
}

std::uint32_t trianglesOf(const HeightField& field, double errorM)
{
    return RoamMesh(testsupport::planarTile(field)).refine(errorM).triangles;
}

HeightField flat(int side)
{
    HeightField field = testsupport::hills(3, 3);
    field.columns = field.rows = side;
    field.heightsM.assign(static_cast<std::size_t>(side) * side, 0.0f);
    return field;
}

/// The square in a raster's south-west corner.
HeightField cornerOf(const HeightField& all, int side)
{
    HeightField field = flat(side);
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column)
            field.heightsM[static_cast<std::size_t>(row) * side + column] = all.heightM(column, row);
    return field;
}

/// Raises every sample of a square somewhere by up to `heightM`, a single one by all of it.
void roughen(HeightField& field, int cells, float heightM, Random& random)
{
    const auto room = static_cast<std::uint32_t>(field.columns - cells + 1);
    const std::uint32_t first = random.below(room), south = random.below(room);
    for (std::uint32_t row = south; row < south + static_cast<std::uint32_t>(cells); ++row)
        for (std::uint32_t column = first; column < first + static_cast<std::uint32_t>(cells); ++column)
            field.heightsM[row * static_cast<std::size_t>(field.columns) + column] +=
                cells == 1 ? heightM : heightM * static_cast<float>(random.unit());
}

/// The most triangles that roughening a square adds, over some places for it.
double mostAdded(const HeightField& field, int cells, double errorM, int places)
{
    Random random(3);
    const double without = trianglesOf(field, errorM);
    double most = 0.0;
    for (int i = 0; i < places; ++i)
    {
        HeightField rough = field;
        roughen(rough, cells, static_cast<float>(100.0 * errorM), random);
        most = std::max(most, trianglesOf(rough, errorM) - without);
    }
    return most;
}

int placesFor(int side)
{
    return side > 500 ? 2 : 8;
}

class Spike : public testing::TestWithParam<int>
{
};

TEST_P(Spike, OnAPlainAddsTrianglesByTheDepthNotByTheSize)
{
    const int side = GetParam();
    const double added = mostAdded(flat(side), 1, 1.0, placesFor(side));
    EXPECT_LE(added, bound(side));
    EXPECT_GT(added, 2.0 * std::log2(side - 1)) << "less than its own chain: there was no spike";
    RecordProperty("added", std::to_string(added));
}

TEST_P(Spike, OnHillsAddsTrianglesByTheDepthNotByTheSize)
{
    constexpr double kErrorM = 30.0; // the hills are rough by 12 m
    const int side = GetParam();
    const HeightField field = testsupport::hills(side, side);
    const double added = mostAdded(field, 1, kErrorM, placesFor(side));
    EXPECT_LE(added, bound(side));
    EXPECT_GT(added, 0.0);
    EXPECT_GT(trianglesOf(field, kErrorM), 4.0 * bound(side)) << "hardly a model that could get complicated";
}

/// The mutations: what is not of one cell, or not local, breaks the bound.
TEST_P(Spike, OfManyCellsWouldBeNoticed)
{
    const int side = GetParam();
    EXPECT_GT(mostAdded(flat(side), side / 8, 1.0, 1), bound(side));
    if (side > 500) return; // the larger the model, the plainer
    EXPECT_GT(mostAdded(flat(side), side, 1.0, 1), 20.0 * bound(side));
}

INSTANTIATE_TEST_SUITE_P(Sides, Spike, testing::Values(129, 257, 513, 1025),
                         testing::PrintToStringParamName());

TEST(SpikeRealData, AddsTrianglesByTheDepthNotByTheSize)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(file, "dem/N44W072.hgt");
    const auto all = importDem(file);
    ASSERT_TRUE(all) << all.error().message();
    constexpr double kErrorM = 10.0;
    for (const int side : {129, 257, 513, 1025})
    {
        const HeightField field = cornerOf(*all, side);
        const double added = mostAdded(field, 1, kErrorM, placesFor(side));
        EXPECT_LE(added, bound(side)) << side;
        EXPECT_GT(added, 0.0) << side;
        if (side > 500) continue;
        EXPECT_GT(mostAdded(field, side / 4, kErrorM, 1), bound(side)) << side;
    }
}

} // namespace
