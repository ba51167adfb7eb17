// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include <osgDB/Registry>
#include <osgSim/HeightAboveTerrain>
#include <osgSim/LineOfSight>
#include <osgTerrain/GeometryTechnique>
#include <osgUtil/IntersectionVisitor>
#include <osgUtil/LineSegmentIntersector>
#include <osgUtil/Statistics>

#include <osgTerrainROAM/RoamTechnique>

#include "HandCull.h"
#include "SyntheticField.h"
#include "TechniqueScene.h"

namespace
{

using namespace techniquescene;
using osgTerrainROAM::RoamTechnique;

osg::ref_ptr<osgTerrain::Terrain> ours(const TileSpec& spec = {})
{
    const auto terrain = terrainOf(2, spec);
    terrain->setTerrainTechniquePrototype(new RoamTechnique);
    return terrain;
}

/// What stock osgTerrain draws and answers with.
osg::ref_ptr<osgTerrain::Terrain> stock(const TileSpec& spec = {})
{
    const auto terrain = terrainOf(2, spec);
    terrain->setTerrainTechniquePrototype(new osgTerrain::GeometryTechnique);
    return terrain;
}

/// Places in the four tiles of 65² samples; one in three is a sample's.
std::vector<osg::Vec3d> places()
{
    testsupport::Random random(5);
    std::vector<osg::Vec3d> all;
    for (int i = 0; i < 60; ++i)
    {
        const double cells = i % 3 == 0 ? std::floor(random.unit() * 126.0) + 1.0 : random.unit() * 127.0;
        const double cellsNorth =
            i % 3 == 0 ? std::floor(random.unit() * 126.0) + 1.0 : random.unit() * 127.0;
        all.emplace_back(30.0 * cells + 1e-7, 30.0 * cellsNorth + 2e-7, 2000.0);
    }
    return all;
}

std::vector<double> heightsAbove(osg::Node& terrain, const std::vector<osg::Vec3d>& points)
{
    osgSim::HeightAboveTerrain query;
    for (const osg::Vec3d& point : points)
        query.addPoint(point);
    query.computeIntersections(&terrain);
    std::vector<double> heights;
    for (unsigned int i = 0; i < query.getNumPoints(); ++i)
        heights.push_back(query.getHeightAboveTerrain(i));
    return heights;
}

unsigned int hits(osg::Node& node, const osg::Vec3d& from, const osg::Vec3d& to)
{
    const osg::ref_ptr<osgUtil::LineSegmentIntersector> segment =
        new osgUtil::LineSegmentIntersector(from, to);
    osgUtil::IntersectionVisitor visitor(segment);
    node.accept(visitor);
    return static_cast<unsigned int>(segment->getIntersections().size());
}

/// Cells are cut along one diagonal by us and along either by osgTerrain: between samples both are right to
/// this.
constexpr double kTwistM = 5.0;

} // namespace

TEST(TechniqueIntersection, HeightAboveTerrainIsThatOfStockOsgTerrain)
{
    const auto points = places();
    const auto mine = heightsAbove(*ours(), points), theirs = heightsAbove(*stock(), points);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        EXPECT_NEAR(mine[i], theirs[i], i % 3 == 0 ? 2e-3 : kTwistM) << i;
        if (i % 3 != 0) continue;
        EXPECT_NEAR(points[i].z() - mine[i], hillAt(points[i].x(), points[i].y()), 0.02) << i;
    }
}

TEST(TechniqueIntersection, AnswersDoNotDependOnWhatIsDrawn)
{
    const auto terrain = ours();
    const auto points = places();
    const auto before = heightsAbove(*terrain, points);
    ASSERT_TRUE(
        static_cast<RoamTechnique*>(terrain->getTerrainTechniquePrototype())->setErrorTolerancePx(50.0));
    const auto camera = handcull::cameraAt({-50000, -50000, 9000}, {1900, 1900, 0});
    handcull::cull(*terrain, *camera, 1);
    EXPECT_EQ(heightsAbove(*terrain, points), before);
}

TEST(TechniqueIntersection, ARaisedGroundWouldShow)
{
    // The mutation: 20 m more.
    const auto raised = ours();
    for (unsigned int i = 0; i < raised->getNumChildren(); ++i)
    {
        auto& tile = static_cast<osgTerrain::TerrainTile&>(*raised->getChild(i));
        for (float& height : static_cast<osgTerrain::HeightFieldLayer*>(tile.getElevationLayer())
                                 ->getHeightField()
                                 ->getHeightList())
            height += 20.0f;
    }
    const auto points = places();
    const auto mine = heightsAbove(*raised, points), theirs = heightsAbove(*stock(), points);
    for (std::size_t i = 0; i < points.size(); ++i)
        EXPECT_GT(std::abs(mine[i] - theirs[i]), 2.0 * kTwistM) << i;
}

TEST(TechniqueIntersection, HeightAboveTerrainOnTheEarthIsThatOfStockOsgTerrain)
{
    const TileSpec spec{.type = osgTerrain::Locator::GEOCENTRIC};
    const osg::ref_ptr<osgTerrain::Terrain> terrains[2] = {ours(spec), stock(spec)};
    std::vector<osg::Vec3d> points;
    for (int i = 0; i < 20; ++i)
    {
        osg::Vec3d point;
        locatorOf(spec)->convertLocalToModel(osg::Vec3d(0.0513 + 0.0907 * i, 0.1011 + 0.0403 * i, 3000.0),
                                             point);
        points.push_back(point);
    }
    for (const auto& terrain : terrains)
        terrain->setEllipsoidModel(new osg::EllipsoidModel);
    const auto mine = heightsAbove(*terrains[0], points), theirs = heightsAbove(*terrains[1], points);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        EXPECT_NEAR(mine[i], theirs[i], kTwistM) << i;
        EXPECT_LT(mine[i], 3000.0);
    }
}

TEST(TechniqueIntersection, LineOfSightIsThatOfStockOsgTerrain)
{
    const auto mine = ours(), theirs = stock();
    testsupport::Random random(9);
    unsigned int blocked = 0, same = 0;
    constexpr unsigned int kLines = 40;
    for (unsigned int i = 0; i < kLines; ++i)
    {
        const osg::Vec3d from(3800 * random.unit(), 3800 * random.unit(), 450.0);
        const osg::Vec3d to(3800 * random.unit(), 3800 * random.unit(), 250.0 + 200.0 * random.unit());
        osgSim::LineOfSight sight[2];
        for (auto& each : sight)
            each.addLOS(from, to);
        sight[0].computeIntersections(mine);
        sight[1].computeIntersections(theirs);
        const auto& a = sight[0].getIntersections(0);
        const auto& b = sight[1].getIntersections(0);
        same += a.size() == b.size();
        if (a.empty() || b.empty()) continue;
        ++blocked;
        EXPECT_LT((a.front() - b.front()).length(), 60.0) << i << ": hits a slope at a flat angle";
    }
    EXPECT_GT(blocked, 10u);
    EXPECT_LT(blocked, kLines);
    EXPECT_GE(same, kLines - 2) << "a line may graze a cell's diagonal";
}

TEST(TechniqueIntersection, VoidsAreNotHit)
{
    const auto terrain = ours();
    auto& tile = static_cast<osgTerrain::TerrainTile&>(*terrain->getChild(0));
    auto& layer = static_cast<osgTerrain::HeightFieldLayer&>(*tile.getElevationLayer());
    layer.setValidDataOperator(new osgTerrain::NoDataValue(-1.0f));
    for (unsigned row = 20; row < 30; ++row)
        for (unsigned column = 20; column < 30; ++column)
            layer.getHeightField()->setHeight(column, row, -1.0f);
    EXPECT_EQ(hits(*terrain, {751, 752, 2000}, {751, 752, -100}), 0u);
    EXPECT_EQ(hits(*terrain, {1351, 752, 2000}, {1351, 752, -100}), 1u);
}

TEST(TechniqueIntersection, UsesAKdTreeWhereTheRegistryAsksForThem)
{
    osgDB::Registry::instance()->setBuildKdTreesHint(osgDB::Options::BUILD_KDTREES);
    const auto terrain = ours();
    const auto points = places();
    const auto found = heightsAbove(*terrain, points);
    osgDB::Registry::instance()->setBuildKdTreesHint(osgDB::Options::NO_PREFERENCE);
    const auto expected = heightsAbove(*ours(), points);
    for (std::size_t i = 0; i < points.size(); ++i)
        EXPECT_NEAR(found[i], expected[i], 2e-3);
}

TEST(TechniqueIntersection, StatisticsSeeWhatIsDrawn)
{
    const auto terrain = ours();
    osgUtil::StatsVisitor visitor;
    terrain->accept(visitor);
    visitor.totalUpStats();
    const auto found = visitor._uniqueStats.getPrimitiveCountMap();
    std::uint64_t triangles = 0;
    for (const auto& [mode, count] : found)
        triangles += count;
    EXPECT_EQ(visitor._drawableSet.size(), 4u);
    EXPECT_GT(triangles, 100u);
}
