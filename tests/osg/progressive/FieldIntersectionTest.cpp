// SPDX-License-Identifier: Apache-2.0
// Intersections with a field, compared with those of its objects as separate nodes.
#include <cmath>
#include <thread>

#include <gtest/gtest.h>

#include <osg/MatrixTransform>
#include <osgDB/Registry>
#include <osgSim/HeightAboveTerrain>
#include <osgUtil/IntersectionVisitor>
#include <osgUtil/LineSegmentIntersector>
#include <osgUtil/PolytopeIntersector>
#include <osgUtil/Statistics>

#include <osgPMObjects/MakeProgressive>
#include <osgPMObjects/ProgressiveField>

#include "HandCull.h"
#include "ProgressiveSubject.h"
#include "Random.h"

namespace
{

using namespace progressive;
using Segment = osgUtil::LineSegmentIntersector;

FieldKind kindOf(const Subject& subject)
{
    FieldKind kind;
    kind.shape = subject.shape;
    return kind;
}

std::vector<FieldKind> torus(std::uint32_t around = 30)
{
    return {kindOf(subjectOf(testsupport::torus(around, 20)))};
}

/// Makes instances of the first kind at positions, without rotation or scale.
std::vector<FieldInstance> standingAt(std::initializer_list<osg::Vec3d> places)
{
    std::vector<FieldInstance> made;
    for (const osg::Vec3d& place : places)
        made.emplace_back().position = place;
    return made;
}

/// Two kinds: a torus beside a sheet, and a shape whose origin lies some 30 km from it.
std::vector<FieldKind> kinds()
{
    static const Subject near = torusAndSheet();
    static const Subject away = []
    {
        core::Mesh mesh = testsupport::torus(30, 20);
        for (glm::dvec3& p : mesh.positions)
            p += glm::dvec3(2e4, -1e4, 2e4);
        return subjectOf(std::move(mesh));
    }();
    EXPECT_NE(away.shape->origin(), osg::Vec3d());
    return {kindOf(near), kindOf(away)};
}

osg::Quat turn(testsupport::Random& random)
{
    osg::Quat attitude;
    attitude.makeRotate(6.0 * random.unit(), osg::Vec3d(random.unit(), random.unit(), 1.0));
    return attitude;
}

/// Scatters all kinds in turn over a square with sides of 400; what is visible of each instance lies about its position.
std::vector<FieldInstance> scattered(std::size_t count, const std::vector<FieldKind>& of)
{
    testsupport::Random random(17);
    std::vector<FieldInstance> made(count);
    for (std::size_t i = 0; i < count; ++i)
    {
        FieldInstance& instance = made[i];
        instance.kind = static_cast<std::uint32_t>(i % of.size());
        instance.attitude = turn(random);
        instance.scale = 0.5 + random.unit();
        const osg::Vec3d at(400.0 * random.unit(), 400.0 * random.unit(), 20.0 * random.unit());
        instance.position = at - instance.attitude * (of[instance.kind].shape->origin() * instance.scale);
    }
    return made;
}

osg::ref_ptr<ProgressiveField> fieldOf(const std::vector<FieldKind>& of,
                                       const std::vector<FieldInstance>& placed)
{
    osg::ref_ptr<ProgressiveField> field = new ProgressiveField;
    const auto outcome = field->setContents(of, placed);
    EXPECT_TRUE(outcome) << (outcome ? "" : outcome.error().message());
    return field;
}

/// The same instances as plain geometry; the names of the transforms are the instances' numbers.
osg::ref_ptr<osg::Group> plain(const std::vector<FieldKind>& of, const std::vector<FieldInstance>& placed)
{
    osg::ref_ptr<osg::Group> root = new osg::Group;
    for (std::size_t i = 0; i < placed.size(); ++i)
    {
        const FieldInstance& instance = placed[i];
        const osg::ref_ptr<osg::MatrixTransform> transform = new osg::MatrixTransform(
            osg::Matrixd::scale(instance.scale, instance.scale, instance.scale) *
            osg::Matrixd::rotate(instance.attitude) * osg::Matrixd::translate(instance.position));
        transform->setName(std::to_string(i));
        transform->addChild(bakeLevel(*of[instance.kind].shape, 0));
        root->addChild(transform);
    }
    return root;
}

/// The node below a transform that rotates, moves and scales.
osg::ref_ptr<osg::MatrixTransform> below(osg::Node& node)
{
    osg::ref_ptr<osg::MatrixTransform> root = new osg::MatrixTransform(
        osg::Matrixd::scale(2.0, 2.0, 2.0) * osg::Matrixd::rotate(0.7, osg::Vec3d(1.0, 2.0, 3.0)) *
        osg::Matrixd::translate(-50.0, 900.0, 30.0));
    root->addChild(&node);
    return root;
}

Segment::Intersections hits(osg::Node& node, const osg::Vec3d& from, const osg::Vec3d& to)
{
    const osg::ref_ptr<Segment> segment = new Segment(from, to);
    osgUtil::IntersectionVisitor visitor(segment);
    node.accept(visitor);
    return segment->getIntersections();
}

struct Line
{
    osg::Vec3d from, to;
};

/// Lines through the square, across and down, in the frame above below()'s transform.
std::vector<Line> lines(std::size_t count, const osg::Matrixd& place)
{
    testsupport::Random random(5);
    std::vector<Line> made;
    for (std::size_t i = 0; i < count; ++i)
    {
        const osg::Vec3d from(400.0 * random.unit(), 400.0 * random.unit(), 60.0);
        const osg::Vec3d to = i % 2 == 0 ? from + osg::Vec3d(random.unit(), random.unit(), -100.0)
                                         : osg::Vec3d(400.0 * random.unit(), 400.0 * random.unit(), -20.0);
        made.push_back({from * place, to * place});
    }
    return made;
}

/// The largest difference of two sets of hits on one line, in metres and in normals; no value if their numbers differ.
struct Difference
{
    std::size_t hits = 0, unequalCounts = 0, otherInstances = 0;
    double pointsM = 0.0, normals = 0.0;
};

void compare(const Segment::Intersections& found, const Segment::Intersections& expected, Difference& worst)
{
    if (found.size() != expected.size())
    {
        ++worst.unequalCounts;
        return;
    }
    worst.hits += found.size();
    auto other = expected.begin();
    for (const Segment::Intersection& hit : found)
    {
        const Segment::Intersection& of = *other++;
        worst.pointsM =
            std::max(worst.pointsM, (hit.getWorldIntersectPoint() - of.getWorldIntersectPoint()).length());
        worst.normals = std::max<double>(
            worst.normals, (hit.getWorldIntersectNormal() - of.getWorldIntersectNormal()).length());
        const auto number = ProgressiveField::instanceOf(hit.nodePath);
        const bool isSame =
            number && of.nodePath.size() > 2 && of.nodePath[2]->getName() == std::to_string(*number);
        worst.otherInstances += isSame ? 0 : 1;
    }
}

Difference differenceOf(const std::vector<FieldInstance>& inField,
                        const std::vector<FieldInstance>& onTheirOwn)
{
    const auto of = kinds();
    const auto mine = below(*fieldOf(of, inField)), theirs = below(*plain(of, onTheirOwn));
    Difference worst;
    for (const Line& line : lines(400, mine->getMatrix()))
        compare(hits(*mine, line.from, line.to), hits(*theirs, line.from, line.to), worst);
    return worst;
}

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

TEST(FieldIntersection, HitsLieWhereThoseOfEveryObjectOnItsOwnDo)
{
    const auto placed = scattered(300, kinds());
    const Difference worst = differenceOf(placed, placed);
    EXPECT_GT(worst.hits, 150u);
    EXPECT_EQ(worst.unequalCounts, 0u);
    EXPECT_EQ(worst.otherInstances, 0u);
    EXPECT_LT(worst.pointsM, 2e-5);
    EXPECT_LT(worst.normals, 1e-5);
}

TEST(FieldIntersection, AForgottenMatrixWouldShow)
{
    // The mutations: no scale, no attitude, another instance's number.
    const auto of = kinds();
    const auto placed = scattered(300, of);
    auto unscaled = placed, unturned = placed, reversed = placed;
    for (FieldInstance& instance : unscaled)
        instance.scale = 1.0;
    for (FieldInstance& instance : unturned)
        instance.attitude = {};
    EXPECT_GT(differenceOf(unscaled, placed).unequalCounts, 50u);
    EXPECT_GT(differenceOf(unturned, placed).unequalCounts, 50u);
    std::reverse(reversed.begin(), reversed.end());
    EXPECT_GT(differenceOf(reversed, placed).otherInstances, 150u);
}

TEST(FieldIntersection, PathsOfHitsLeadThroughTheFieldToItsInstance)
{
    const auto of = kinds();
    const auto placed = scattered(300, of);
    const auto field = fieldOf(of, placed);
    const auto root = below(*field);
    std::size_t seen = 0;
    for (const Line& line : lines(60, root->getMatrix()))
        for (const Segment::Intersection& hit : hits(*root, line.from, line.to))
        {
            ++seen;
            EXPECT_EQ(hit.nodePath[1], field);
            EXPECT_EQ(hit.nodePath.back(), hit.drawable);
            ASSERT_TRUE(hit.matrix);
            const osg::Matrixd matrix = osg::computeLocalToWorld(hit.nodePath);
            EXPECT_LT((hit.localIntersectionPoint * matrix - hit.getWorldIntersectPoint()).length(), 1e-9);
            EXPECT_GT((hit.localIntersectionPoint - hit.getWorldIntersectPoint()).length(), 100.0);
            const auto number = ProgressiveField::instanceOf(hit.nodePath);
            ASSERT_TRUE(number);
            EXPECT_EQ(hit.indexList.size(), 3u) << "what textures are looked up by";
            const auto groups = of[placed[*number].kind].shape->groups();
            EXPECT_TRUE(std::any_of(groups.begin(), groups.end(),
                                    [&](const auto& group)
                                    { return group.state == hit.drawable->getStateSet(); }));
        }
    EXPECT_GT(seen, 20u);
    EXPECT_FALSE(ProgressiveField::instanceOf({root.get(), field.get()}));
}

TEST(FieldIntersection, NothingIsHitBesideInstancesAndInTheirHoles)
{
    const auto of = torus();
    const auto field = fieldOf(of, standingAt({{0.0, 0.0, 0.0}, {20.0, 0.0, 0.0}}));
    EXPECT_EQ(hits(*field, {2.03, 0.07, 50.0}, {2.03, 0.07, -50.0}).size(), 2u);
    EXPECT_EQ(hits(*field, {20.03, 0.07, 50.0}, {20.03, 0.07, -50.0}).size(), 0u) << "the hole";
    EXPECT_EQ(hits(*field, {10.03, 0.07, 50.0}, {10.03, 0.07, -50.0}).size(), 0u) << "between them";
    EXPECT_EQ(hits(*field, {2.03, 0.07, 50.0}, {2.03, 0.07, 40.0}).size(), 0u) << "above";
    EXPECT_TRUE(hits(*new ProgressiveField, {0, 0, 1}, {0, 0, -1}).empty());
}

TEST(FieldIntersection, WhatIsDrawnDoesNotMatter)
{
    const auto placed = scattered(200, kinds());
    const auto field = fieldOf(kinds(), placed);
    std::vector<Segment::Intersections> before, after;
    const auto all = lines(60, {});
    for (const Line& line : all)
        before.push_back(hits(*field, line.from, line.to));
    handcull::cull(*field, *handcull::cameraAt({200.0, -9000.0, 900.0}, {200.0, 200.0, 0.0}), 1);
    ASSERT_GT(field->statistics().at(0).visible, 0u);
    for (const Line& line : all)
        after.push_back(hits(*field, line.from, line.to));
    for (std::size_t i = 0; i < all.size(); ++i)
        EXPECT_TRUE(std::equal(before[i].begin(), before[i].end(), after[i].begin(), after[i].end(),
                               [](const auto& a, const auto& b)
                               { return a.getWorldIntersectPoint() == b.getWorldIntersectPoint(); }));
}

/// At coordinates where floats have a step of 6 cm: spheres are floats, and an edge may lie beyond them.
TEST(FieldIntersection, EdgesAreHitFarFromTheOrigin)
{
    const osg::Vec3d far(1e6 + 0.03, -1e6 + 0.03, 0.0);
    const auto of = torus(64);
    const auto field = fieldOf(of, standingAt({far}));
    const auto groups = of.front().shape->groups();
    ASSERT_EQ(groups.size(), 1u);
    std::size_t found = 0, asked = 0;
    for (const osg::Vec3& vertex : of.front().shape->vertices())
    {
        if (osg::Vec2d(vertex.x(), vertex.y()).length() < 2.99) continue;
        ++asked;
        const osg::Vec3d at = far + osg::Vec3d(vertex) * (1.0 - 1e-4);
        found += !hits(*field, at + osg::Vec3d(0, 0, 5), at - osg::Vec3d(0, 0, 5)).empty();
    }
    EXPECT_GT(asked, 30u);
    EXPECT_EQ(found, asked);
}

TEST(FieldIntersection, LooksOnlyAtInstancesOfTheCellsThatItCrosses)
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

TEST(FieldIntersection, IsThatOfOtherIntersectorsToo)
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

TEST(FieldIntersection, UsesKdTreesWhereTheRegistryAsksForThem)
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

TEST(FieldIntersection, IsTheSameInTwoThreadsThatBeginTogether)
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

TEST(FieldIntersection, GoesWithTheContents)
{
    const auto of = torus();
    const auto field = fieldOf(of, standingAt({{0.0, 0.0, 0.0}}));
    EXPECT_EQ(hits(*field, {2.03, 0.07, 9.0}, {2.03, 0.07, -9.0}).size(), 2u);
    const osg::ref_ptr<ProgressiveField> copy = new ProgressiveField(*field);
    ASSERT_TRUE(field->setContents(of, standingAt({{100.0, 0.0, 0.0}})));
    EXPECT_EQ(hits(*field, {2.03, 0.07, 9.0}, {2.03, 0.07, -9.0}).size(), 0u);
    EXPECT_EQ(hits(*field, {102.03, 0.07, 9.0}, {102.03, 0.07, -9.0}).size(), 2u);
    EXPECT_EQ(hits(*copy, {2.03, 0.07, 9.0}, {2.03, 0.07, -9.0}).size(), 2u);
}

TEST(FieldIntersection, OtherVisitorsSeeNoFaces)
{
    const auto field = fieldOf(kinds(), scattered(50, kinds()));
    hits(*field, {200.0, 200.0, 60.0}, {200.0, 200.0, -60.0});
    osgUtil::StatsVisitor statistics;
    field->accept(statistics);
    EXPECT_TRUE(statistics._drawableSet.empty());
    EXPECT_TRUE(statistics._transformSet.empty());
}
