// SPDX-License-Identifier: Apache-2.0
#include "surroundings/Surroundings.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include <osgTerrainROAM/RoamTerrain>

#include "SyntheticField.h"
#include "material/LandMap.h"
#include "material/NormalMap.h"
#include "surroundings/OuterMesh.h"

namespace
{

using namespace osgTerrainROAM;

/// A tile with its land map, the ground around it, and the axes of the mesh, 100 km beyond.
struct Around
{
    core::PlacedTile tile;
    osg::ref_ptr<osg::Image> land;
    OuterGround ground;
    OuterAxis columns, rows;

    explicit Around(core::HeightField field)
        : tile(std::move(field), core::Placement::planar),
          land(landMap(tile, MapGrid(tile), {}, *normalMap(tile, MapGrid(tile)))),
          ground(tile, *land, 100000.0),
          columns(ground.columns()),
          rows(ground.rows())
    {
    }
};

core::HeightField sea(int columns, int rows)
{
    core::HeightField field = testsupport::hills(columns, rows, 30.0);
    std::fill(field.heightsM.begin(), field.heightsM.end(), 0.0f);
    return field;
}

using Point = std::tuple<int, int, int>;

/// Counts the samples on the border of a tile at whose position the mesh has no vertex.
int missingBorderSamples(const core::PlacedTile& tile, const OuterMesh& mesh)
{
    const auto pointOf = [](const glm::ivec3& p) { return Point(p.x, p.y, p.z); };
    std::set<Point> vertices;
    for (const core::MeshVertex& vertex : mesh.packet.vertices)
        vertices.insert(pointOf(vertex.position));
    int missing = 0;
    const int lastColumn = tile.grid().dataColumns() - 1, lastRow = tile.grid().dataRows() - 1;
    for (int row = 0; row <= lastRow; ++row)
        for (int column = 0; column <= lastColumn; ++column)
        {
            if (column != 0 && row != 0 && column != lastColumn && row != lastRow) continue;
            const glm::ivec3 at(glm::round(tile.position(column, row) / OuterMesh::kStepM));
            missing += vertices.count(pointOf(at)) == 0 ? 1 : 0;
        }
    return missing;
}

/// Twice the area of a triangle seen from above, in square metres; positive where it is counter-clockwise.
double doubleArea(const OuterMesh& mesh, const core::LeafTriangle& triangle)
{
    glm::dvec2 p[3];
    for (int i = 0; i < 3; ++i)
        p[i] = glm::dvec2(core::positionOf(mesh.packet.vertices[triangle.vertices[i]], OuterMesh::kStepM));
    const glm::dvec2 a = p[1] - p[0], b = p[2] - p[0];
    return a.x * b.y - a.y * b.x;
}

} // namespace

TEST(OuterAxis, DividesTheDataEvenlyAndReachesTheHorizon)
{
    const OuterAxis axis(1200.0, 3300.0);
    EXPECT_DOUBLE_EQ(axis.gridAt(OuterAxis::kOutside), 0.0);
    EXPECT_DOUBLE_EQ(axis.gridAt(OuterAxis::kOutside + OuterAxis::kInside), 1200.0);
    EXPECT_NEAR(axis.gridAt(0), -3300.0, 1.0);
    EXPECT_NEAR(axis.gridAt(OuterAxis::kTexels - 1), 4500.0, 1.0);
    for (int texel = 1; texel < OuterAxis::kTexels; ++texel)
        EXPECT_GT(axis.gridAt(texel), axis.gridAt(texel - 1));
}

TEST(OuterGround, StartsAtTheBordersHeightsAndContinuesItsSlope)
{
    core::HeightField field = testsupport::hills(65, 65, 30.0);
    for (int row = 0; row < 65; ++row)
        for (int column = 0; column < 65; ++column)
            field.heightsM[static_cast<std::size_t>(row) * 65 + column] = 500.0f + 3.0f * column;
    const Around around(std::move(field));
    EXPECT_DOUBLE_EQ(around.ground.at({64.0, 20.0}).heightM, 692.0);
    EXPECT_NEAR(around.ground.at({65.0, 20.0}).heightM, 695.0, 1.5);
    EXPECT_NEAR(around.ground.at({-1.0, 20.0}).heightM, 500.0, 1e-6); // not below the lowest of the data
    for (double beyond = 0.0; beyond < 4000.0; beyond = 1.3 * beyond + 0.5)
        EXPECT_LT(std::abs(around.ground.at({64.0 + beyond, 20.0}).heightM - 692.0), 400.0) << beyond;
}

TEST(OuterGround, SeaStaysSea)
{
    const Around around(sea(65, 49));
    for (const glm::dvec2 grid : {glm::dvec2(-1, 5), {-900, -700}, {66, 20}, {30, 60}, {3000, 2000}})
    {
        EXPECT_NEAR(around.ground.at(grid).heightM, 0.0, 1e-6);
        EXPECT_GT(around.ground.at(grid).water, 0.99);
    }
    const Around land(testsupport::hills(65, 49, 30.0));
    EXPECT_LT(land.ground.at({-900, -700}).water, 0.01);
}

/// Half of the data is sea. Beyond them the coast winds: from place to place it does not go on in one
/// direction.
TEST(OuterGround, CoastsWindBeyondTheData)
{
    core::HeightField field = testsupport::hills(257, 257, 90.0);
    for (int row = 0; row < 257; ++row)
        for (int column = 0; column < 257; ++column)
            field.heightsM[static_cast<std::size_t>(row) * 257 + column] = column < 128 ? 0.0f : 40.0f;
    const Around around(std::move(field));
    const auto coastAt = [&](double row) // the middle of all changes between water and land in a row
    {
        double sum = 0.0;
        int changes = 0;
        for (double column = 0.0; column < 256.0; column += 0.5)
        {
            const bool was = around.ground.at({column, row}).water >= 0.5;
            const bool is = around.ground.at({column + 0.5, row}).water >= 0.5;
            if (was != is) sum += column, ++changes;
        }
        return changes > 0 ? sum / changes : -1.0;
    };
    EXPECT_NEAR(coastAt(257.5), 128.0, 3.0); // at the data it goes on
    double bends = 0.0;
    for (double row = 270.0; row < 450.0; row += 6.0)
        bends = std::max(bends, std::abs(coastAt(row + 6.0) - 2.0 * coastAt(row) + coastAt(row - 6.0)));
    EXPECT_GT(bends, 2.0); // 1 where the nearest part of the border counts
}

/// Returns the mean difference of the heights of neighbouring rows beside the data, so many texels beyond the
/// eastern border.
double roughnessAlong(const Around& around, int texel)
{
    double sum = 0.0;
    const double x = around.columns.gridAt(OuterAxis::kOutside + OuterAxis::kInside + texel);
    const auto heightAt = [&](int row) {
        return around.ground.at({x, around.rows.gridAt(OuterAxis::kOutside + row)}).heightM;
    };
    for (int row = 0; row < OuterAxis::kInside; ++row)
        sum += std::abs(heightAt(row + 1) - heightAt(row));
    return sum / OuterAxis::kInside;
}

/// Beside a narrow raster the rows of the surroundings are a few metres apart, the columns soon hundreds:
/// hills that no column can show would be streaks that run straight away from the border.
TEST(OuterGround, HasNoStreaksWhereItsTexelsAreLong)
{
    const Around around(testsupport::hills(512, 256, 1.0));
    const double near = roughnessAlong(around, 24), far = roughnessAlong(around, 100);
    ASSERT_GT(around.columns.spacingAt(around.columns.gridAt(OuterAxis::kOutside + OuterAxis::kInside + 100)),
              100.0);
    EXPECT_GT(near, 0.01); // there are hills
    EXPECT_LT(far, 0.1 * near);
}

TEST(OuterRelief, IsTheMeanOfItsCellsAtCoarserLevels)
{
    std::vector<float> heights;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            heights.push_back((x + y) % 2 == 0 ? 1.0f : -1.0f);
    const OuterRelief relief(64, 64, heights);
    EXPECT_NEAR(relief.deviationM(), 1.0, 0.05);
    EXPECT_NEAR(std::abs(relief.at(32.5 / 64.0, 20.5 / 64.0, 1.0)), 1.0, 0.05); // the middle of a cell
    EXPECT_NEAR(relief.at(33.0 / 64.0, 21.0 / 64.0, 2.0), 0.0, 0.05);
    EXPECT_NEAR(relief.at(0.3, 0.7, 1e9), 0.0, 0.05);
}

TEST(OuterMesh, MeetsEverySampleOfTheBorder)
{
    for (const auto& [columns, rows] : {std::pair{65, 49}, {200, 180}, {5, 643}})
    {
        const Around around(testsupport::hills(columns, rows, 30.0));
        const OuterMesh mesh = outerMesh(around.ground, around.columns, around.rows);
        EXPECT_EQ(missingBorderSamples(around.tile, mesh), 0) << columns;
        // A border that is elsewhere is noticed.
        core::HeightField raised = testsupport::hills(columns, rows, 30.0);
        raised.heightsM.front() += 1.0f;
        EXPECT_EQ(missingBorderSamples(core::PlacedTile(raised, core::Placement::planar), mesh), 1);
    }
}

TEST(OuterMesh, CoversThePlaneAroundTheDataOnce)
{
    const Around around(testsupport::hills(200, 180, 30.0));
    const OuterMesh mesh = outerMesh(around.ground, around.columns, around.rows);
    double area = 0.0;
    for (const core::LeafTriangle& triangle : mesh.packet.triangles)
    {
        const double twice = doubleArea(mesh, triangle);
        EXPECT_GT(twice, -1.0); // walls have none
        area += 0.5 * twice;
    }
    const double width = 30.0 * (around.columns.gridAt(OuterAxis::kTexels - 1) - around.columns.gridAt(0));
    const double depth = 30.0 * (around.rows.gridAt(OuterAxis::kTexels - 1) - around.rows.gridAt(0));
    EXPECT_NEAR(area / (width * depth - 30.0 * 199 * 30.0 * 179), 1.0, 1e-6);
    std::uint32_t inBlocks = 0;
    for (const OuterMesh::Block& block : mesh.blocks)
        inBlocks += block.triangles.count;
    EXPECT_EQ(inBlocks, mesh.packet.triangleCount);
}

TEST(Surroundings, CanBeShownAndHiddenAndHaveNoBounds)
{
    const auto tile = testsupport::planarTile(testsupport::hills(65, 65, 30.0));
    const osg::ref_ptr<TerrainMaterial> material = new TerrainMaterial(tile->tile, climateOf(tile->tile, {}));
    const osg::ref_ptr<RoamTerrain> terrain = new RoamTerrain(tile, material);
    const osg::BoundingSphere bound = terrain->getBound();
    EXPECT_FALSE(terrain->showsSurroundings());
    terrain->showSurroundings(true);
    ASSERT_TRUE(terrain->showsSurroundings());
    EXPECT_EQ(terrain->getNumChildren(), 2u);
    EXPECT_EQ(terrain->getBound(), bound);
    EXPECT_FALSE(terrain->getCullingActive());
    const osg::ref_ptr<RoamTerrain> copy = new RoamTerrain(*terrain);
    EXPECT_TRUE(copy->showsSurroundings());
    terrain->showSurroundings(false);
    EXPECT_EQ(terrain->getNumChildren(), 1u);
    EXPECT_TRUE(terrain->getCullingActive());
}
