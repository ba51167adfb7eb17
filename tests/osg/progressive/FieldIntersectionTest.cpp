// SPDX-License-Identifier: Apache-2.0
// Where a field is hit, compared with its objects as separate nodes.
#include <algorithm>

#include <gtest/gtest.h>

#include <osgUtil/Statistics>

#include "FieldSubjects.h"
#include "HandCull.h"

namespace
{

using namespace fieldsubjects;

/// The largest difference of two sets of hits on one line, in metres and in normals; no value if their
/// numbers differ.
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
    const osg::ref_ptr<ProgressiveField> nothing = new ProgressiveField;
    EXPECT_TRUE(hits(*nothing, {0, 0, 1}, {0, 0, -1}).empty());
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
