// SPDX-License-Identifier: Apache-2.0
// What intersections with a field cost, and which intersectors, trees and threads they serve.
#include <thread>

#include <gtest/gtest.h>

#include <osgDB/Registry>
#include <osgSim/HeightAboveTerrain>
#include <osgUtil/PolytopeIntersector>

#include "FieldSubjects.h"
#include "HandCull.h"

namespace
{

using namespace fieldsubjects;

/// Counts the tests of an intersector.
class CountingSegment : public Segment
{
public:
    using Segment::Segment;

    bool enter(const osg::Node& node) override
    {
        ++looks;
        return Segment::enter(node);
    }
    osgUtil::Intersector* clone(osgUtil::IntersectionVisitor& visitor) override
    {
        ++entered;
        return Segment::clone(visitor);
    }

    std::size_t looks = 0;   ///< tests of bounds
    std::size_t entered = 0; ///< transforms
};

osg::ref_ptr<CountingSegment> counted(osg::Node& node, const osg::Vec3d& from, const osg::Vec3d& to)
{
    osg::ref_ptr<CountingSegment> segment = new CountingSegment(from, to);
    osgUtil::IntersectionVisitor visitor(segment);
    node.accept(visitor);
    return segment;
}

} // namespace

TEST(FieldIntersectors, LooksOnlyAtInstancesOfTheCellsThatItCrosses)
{
    const auto of = torus();
    testsupport::Random random(3);
    std::vector<FieldInstance> placed(20000);
    for (FieldInstance& instance : placed)
        instance.position = {4000.0 * random.unit(), 4000.0 * random.unit(), 0.0};
    const auto field = fieldOf(of, placed);
    const osg::Vec3d above = placed[4711].position + osg::Vec3d(2.03, 0.07, 100.0);
    const auto down = counted(*field, above, above - osg::Vec3d(0, 0, 200));
    EXPECT_GE(down->getIntersections().size(), 2u);
    EXPECT_LT(down->looks, 700u) << "some 420 cells, and the instances of those on the line";
    EXPECT_LE(down->entered, 5u);
    const auto across = counted(*field, {0.0, 2000.1, 0.3}, {4000.0, 2000.1, 0.3});
    EXPECT_LT(across->looks, 2500u) << "a row of cells";
    EXPECT_LT(across->entered, 100u);

    for (FieldInstance& instance : placed)
        instance.position = {};
    const auto crowd = counted(*fieldOf(of, placed), {2.03, 0.07, 9.0}, {2.03, 0.07, -9.0});
    EXPECT_GT(crowd->looks, placed.size()) << "would be noticed";
    EXPECT_EQ(crowd->entered, placed.size());
}

TEST(FieldIntersectors, IsThatOfOtherIntersectorsToo)
{
    const auto of = kinds();
    const auto placed = scattered(300, of);
    const auto field = fieldOf(of, placed);
    const auto alone = plain(of, placed);
    osgSim::HeightAboveTerrain mine, theirs;
    for (const Line& line : lines(100, {}))
        for (osgSim::HeightAboveTerrain* const query : {&mine, &theirs})
            query->addPoint(line.from);
    mine.computeIntersections(field);
    theirs.computeIntersections(alone);
    std::size_t onAnInstance = 0;
    for (unsigned int i = 0; i < mine.getNumPoints(); ++i)
    {
        EXPECT_NEAR(mine.getHeightAboveTerrain(i), theirs.getHeightAboveTerrain(i), 1e-4);
        onAnInstance += mine.getHeightAboveTerrain(i) < 60.0;
    }
    EXPECT_GT(onAnInstance, 10u);

    const auto camera = handcull::cameraAt({200.0, -60.0, 60.0}, {200.0, 200.0, 0.0});
    const auto picked = [&](osg::Node& node)
    {
        const osg::ref_ptr<osgUtil::PolytopeIntersector> box =
            new osgUtil::PolytopeIntersector(osgUtil::Intersector::WINDOW, 380.0, 280.0, 420.0, 320.0);
        osgUtil::IntersectionVisitor visitor(box);
        const osg::ref_ptr<osg::Camera> eye = new osg::Camera(*camera);
        eye->addChild(&node);
        eye->accept(visitor);
        return box->getIntersections().size();
    };
    EXPECT_GT(picked(*alone), 10u);
    EXPECT_EQ(picked(*field), picked(*alone));
}

TEST(FieldIntersectors, UsesKdTreesWhereTheRegistryAsksForThem)
{
    const auto placed = scattered(400, kinds());
    const auto all = lines(100, {});
    const auto without = fieldOf(kinds(), placed);
    osgDB::Registry::instance()->setBuildKdTreesHint(osgDB::Options::BUILD_KDTREES);
    const auto with = fieldOf(kinds(), placed);
    std::size_t seen = 0;
    for (const Line& line : all)
    {
        const auto found = hits(*with, line.from, line.to), expected = hits(*without, line.from, line.to);
        ASSERT_EQ(found.size(), expected.size());
        for (auto a = found.begin(), b = expected.begin(); a != found.end(); ++a, ++b)
        {
            ++seen;
            EXPECT_TRUE(a->drawable->getShape());
            EXPECT_LT((a->getWorldIntersectPoint() - b->getWorldIntersectPoint()).length(), 1e-4);
        }
    }
    osgDB::Registry::instance()->setBuildKdTreesHint(osgDB::Options::NO_PREFERENCE);
    EXPECT_GT(seen, 20u);
}

TEST(FieldIntersectors, IsTheSameInTwoThreadsThatBeginTogether)
{
    const auto placed = scattered(400, kinds());
    const auto all = lines(100, {});
    const auto field = fieldOf(kinds(), placed);
    std::vector<std::size_t> counts[3];
    const auto ask = [&](std::size_t who)
    {
        for (const Line& line : all)
            counts[who].push_back(hits(*field, line.from, line.to).size());
    };
    std::thread one(ask, 0), other(ask, 1);
    one.join();
    other.join();
    ask(2);
    EXPECT_EQ(counts[0], counts[2]);
    EXPECT_EQ(counts[1], counts[2]);
}
