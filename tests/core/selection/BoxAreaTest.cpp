// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <gtest/gtest.h>

#include <viewlod/ScreenError.h>

#include <osgPMObjects/core/selection/BoxArea.h>
#include <osgPMObjects/core/selection/BoxOutlines.h>

#include "SelectionScenes.h"

namespace
{

using namespace osgPMObjects::core;
using testsupport::Random;

glm::dvec3 cornerOf(const OrientedBox& box, std::uint32_t corner)
{
    glm::dvec3 at = box.centre;
    for (int axis = 0; axis < 3; ++axis)
        at += box.axes[axis] * (corner >> axis & 1 ? box.halfSizes[axis] : -box.halfSizes[axis]);
    return at;
}

double twiceArea(const std::vector<glm::dvec2>& loop)
{
    double sum = 0.0;
    for (std::size_t i = 1; i + 1 < loop.size(); ++i)
    {
        const glm::dvec2 a = loop[i] - loop[0], b = loop[i + 1] - loop[0];
        sum += a.x * b.y - a.y * b.x;
    }
    return sum;
}

/// Returns the convex hull of points, by Andrew's monotone chain.
double hullArea(std::vector<glm::dvec2> points)
{
    std::sort(points.begin(), points.end(),
              [](const glm::dvec2& a, const glm::dvec2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    std::vector<glm::dvec2> hull;
    for (int side = 0; side < 2; ++side)
    {
        const std::size_t first = hull.size();
        for (const glm::dvec2& p : points)
        {
            while (hull.size() >= first + 2 && twiceArea({hull[hull.size() - 2], hull.back(), p}) <= 0.0)
                hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back();
        std::reverse(points.begin(), points.end());
    }
    return 0.5 * twiceArea(hull);
}

/// Returns the corners projected by the matrix; nothing if one is before the near plane.
std::optional<double> bruteForceArea(const viewlod::ViewState& view, const OrientedBox& box)
{
    std::vector<glm::dvec2> corners;
    for (std::uint32_t i = 0; i < 8; ++i)
    {
        const auto at = viewlod::projectPx(view, cornerOf(box, i));
        if (!at) return std::nullopt;
        corners.push_back(*at);
    }
    return hullArea(corners);
}

/// Whether an area is the hull's in many views of many boxes, and every region is met. `area(selectionView,
/// box)`.
template<class Area>
bool agreesWithHulls(const Area& area)
{
    Random random(1);
    std::array<int, kBoxRegions> met{};
    for (int i = 0; i < 20'000; ++i)
    {
        const OrientedBox box = testsupport::box(random);
        const auto view = testsupport::viewAbout(random, box.centre, i % 2 ? 5.0 : 60.0);
        const auto hull = bruteForceArea(view, box);
        const double found = area(SelectionView::from(view), box);
        ++met[regionOf(box, view.eyeWorld)];
        if (!hull ? found != kFullArea : !(std::abs(found - *hull) <= 1e-9 * (*hull + 1.0))) return false;
    }
    return std::count_if(met.begin(), met.end(), [](int n) { return n > 0; }) == 27;
}

TEST(BoxOutlines, AreSixOfFourCornersAndTwentyOfSix)
{
    std::array<int, 7> ofCount{};
    for (const BoxOutline& outline : kBoxOutlines)
        ++ofCount[outline.count];
    EXPECT_EQ(ofCount[4], 6);
    EXPECT_EQ(ofCount[6], 20);
    EXPECT_EQ(ofCount[0], 43 - 26); // the inside, and the codes that do not occur
}

TEST(BoxOutlines, OfTheTopByHand)
{ // code 32: above z; corners 4 to 7, counter-clockwise from above
    const std::array<std::uint8_t, 6> byHand = {4, 5, 7, 6};
    EXPECT_EQ(kBoxOutlines[32].corners, byHand);
    EXPECT_EQ(kBoxOutlines[32].count, 4);
}

TEST(BoxArea, OfACubeAheadByHand)
{
    // 720 pixels are 40 degrees: K = 360 / tan 20°. A front side of 2 × 2 m, 9 m away.
    const auto view = SelectionView::from(testsupport::viewTo({0, -10, 0}, {0, 0, 0}));
    const double side = 360.0 / std::tan(glm::radians(20.0)) * 2.0 / 9.0;
    EXPECT_NEAR(boxAreaPx(view, {glm::dvec3(0), glm::dmat3(1), glm::dvec3(1)}), side * side,
                1e-9 * side * side);
}

TEST(BoxArea, IsThatOfTheHullOfTheProjectedCorners)
{
    EXPECT_TRUE(agreesWithHulls(boxAreaPx));
}

TEST(BoxArea, TheHullsTellAWrongEyeAndAWrongAxisOrder)
{
    EXPECT_FALSE(agreesWithHulls(
        [](const SelectionView& view, const OrientedBox& box)
        {
            SelectionView beside = view;
            beside.eyeWorld += glm::dvec3(1e-4, 0, 0);
            return boxAreaPx(beside, box);
        }));
    EXPECT_FALSE(agreesWithHulls(
        [](const SelectionView& view, const OrientedBox& box)
        {
            OrientedBox turned = box;
            std::swap(turned.halfSizes.x, turned.halfSizes.y);
            return boxAreaPx(view, turned);
        }));
}

/// Whether an outline table has, for each region, the outline of what is seen from there.
bool isOutlineTable(const std::array<BoxOutline, kBoxRegions>& table)
{
    Random random(2);
    const OrientedBox box{glm::dvec3(0), glm::dmat3(1), {1.0, 0.7, 0.4}};
    for (int i = 0; i < 3000; ++i)
    {
        // A random region: beyond none, one or more of the sides.
        glm::dvec3 eye;
        for (int axis = 0; axis < 3; ++axis)
            eye[axis] = (random.below(3) - 1.0) * 8.0 + testsupport::between(random, -0.3, 0.3);
        if (glm::length(eye) < 2.0) continue;
        const auto view = testsupport::viewTo(eye, box.centre);
        const BoxOutline& outline = table[regionOf(box, eye)];
        std::vector<glm::dvec2> loop;
        for (std::uint32_t corner = 0; corner < outline.count; ++corner)
            loop.push_back(*viewlod::projectPx(view, cornerOf(box, outline.corners[corner])));
        const double hull = *bruteForceArea(view, box);
        if (loop.empty() || std::abs(0.5 * twiceArea(loop) - hull) > 1e-9 * hull) return false;
    }
    return true;
}

TEST(BoxOutlines, ASingleWrongCornerInAnyRegionIsFound)
{
    EXPECT_TRUE(isOutlineTable(kBoxOutlines));
    for (std::size_t region = 0; region < kBoxRegions; ++region)
    {
        if (kBoxOutlines[region].count == 0) continue;
        auto wrong = kBoxOutlines;
        wrong[region].corners[1] ^= 1;
        EXPECT_FALSE(isOutlineTable(wrong)) << region;
        wrong = kBoxOutlines;
        std::swap(wrong[region].corners[0], wrong[region].corners[2]);
        EXPECT_FALSE(isOutlineTable(wrong)) << region;
    }
}

TEST(BoxArea, IsFullWithACornerBeforeTheNearPlaneOrTheEyeInside)
{
    const OrientedBox cube{glm::dvec3(0), glm::dmat3(1), glm::dvec3(1)};
    const auto at = [&](double y) {
        return boxAreaPx(SelectionView::from(testsupport::viewTo({0, y, 0}, {0, 10, 0})), cube);
    };
    EXPECT_LT(at(-1.11), kFullArea);
    EXPECT_EQ(at(-1.09), kFullArea); // near is 0.1 m
    EXPECT_EQ(at(0.0), kFullArea);
    EXPECT_EQ(at(5.0), kFullArea); // behind the eye: the caller has not culled it
}

TEST(BoxArea, OfAFlatBoxIsThatOfItsSide)
{
    const auto view = SelectionView::from(testsupport::viewTo({0, -10, 0}, {0, 0, 0}));
    const double side = view.pixelsPerTangent * 0.2;
    EXPECT_NEAR(boxAreaPx(view, {glm::dvec3(0), glm::dmat3(1), {1, 0, 1}}), side * side, 1e-6);
    EXPECT_NEAR(boxAreaPx(view, {glm::dvec3(0), glm::dmat3(1), {0, 1, 0}}), 0.0, 1e-6);
}

} // namespace
