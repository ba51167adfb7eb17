// SPDX-License-Identifier: Apache-2.0
#include <numbers>

#include <gtest/gtest.h>

#include <viewlod/ScreenError.h>

#include <osgPMObjects/core/selection/EllipsoidArea.h>
#include <osgPMObjects/core/selection/SphereArea.h>

#include "SelectionScenes.h"

namespace
{

using namespace osgPMObjects::core;
using testsupport::Random;

/// Returns the area of the outline, whose points are where planes through the eye touch the ellipsoid. In the
/// frame in which the ellipsoid is the unit sphere, they are a circle about the direction to the eye.
double sampledArea(const viewlod::ViewState& view, const Ellipsoid& ellipsoid)
{
    const glm::dvec3 eye = glm::inverse(ellipsoid.halfAxes) * (view.eyeWorld - ellipsoid.centre);
    const double distance = glm::length(eye);
    const glm::dvec3 z = eye / distance;
    const glm::dvec3 x =
        glm::normalize(glm::cross(z, std::abs(z.x) > 0.5 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0)));
    const glm::dvec3 y = glm::cross(z, x);
    const double height = 1.0 / distance, radius = std::sqrt(1.0 - height * height);
    constexpr int kSamples = 20'000;
    double twice = 0.0;
    glm::dvec2 first{}, last{};
    for (int i = 0; i <= kSamples; ++i)
    {
        const double angle = 2.0 * std::numbers::pi * i / kSamples;
        const glm::dvec3 on = height * z + radius * (std::cos(angle) * x + std::sin(angle) * y);
        const glm::dvec2 at = *viewlod::projectPx(view, ellipsoid.centre + ellipsoid.halfAxes * on);
        if (i == 0) first = at;
        const glm::dvec2 a = last - first, b = at - first;
        if (i > 1) twice += a.x * b.y - a.y * b.x;
        last = at;
    }
    return std::abs(0.5 * twice);
}

/// Whether an area is that of the projected points in many views. `area(selectionView, ellipsoid)`.
template<class Area>
bool agreesWithSamples(const Area& area)
{
    Random random(3);
    int compared = 0;
    for (int i = 0; i < 300; ++i)
    {
        const Ellipsoid ellipsoid = Ellipsoid::within(testsupport::box(random));
        const auto view = testsupport::viewAbout(random, ellipsoid.centre, i % 2 ? 8.0 : 60.0);
        const double found = area(SelectionView::from(view), ellipsoid);
        if (found == kFullArea) continue;
        ++compared;
        if (!(std::abs(found / sampledArea(view, ellipsoid) - 1.0) < 1e-6)) return false;
    }
    return compared > 200;
}

TEST(EllipsoidArea, IsThatOfTheProjectedOutline)
{
    EXPECT_TRUE(agreesWithSamples(ellipsoidAreaPx));
}

TEST(EllipsoidArea, TheOutlineTellsTheOrthographicOne)
{ // the area that would be right from far away
    EXPECT_FALSE(agreesWithSamples(
        [](const SelectionView& view, const Ellipsoid& e)
        {
            const glm::dvec3 c = e.centre - view.eyeWorld;
            const double d = glm::length(c);
            const glm::dvec3 adjugate{glm::dot(glm::cross(e.halfAxes[1], e.halfAxes[2]), c),
                                      glm::dot(glm::cross(e.halfAxes[2], e.halfAxes[0]), c),
                                      glm::dot(glm::cross(e.halfAxes[0], e.halfAxes[1]), c)};
            return ellipsoidAreaPx(view, e) == kFullArea
                       ? kFullArea
                       : std::numbers::pi * view.pixelsPerTangentArea * glm::length(adjugate) / (d * d * d);
        }));
}

TEST(EllipsoidArea, ContainsMonteCarloPointsAsTheyFall)
{
    // Points of the picture whose ray meets the ellipsoid, by the quadratic equation of the ray.
    Random random(4);
    const Ellipsoid e{{0, 0, 0}, {{2, 0, 0}, {0, 0.5, 0}, {0.0, 0.0, 1.0}}};
    const auto view = testsupport::viewTo({4, -6, 3}, {0.5, 0, 0});
    const glm::dmat4 worldFromClip = glm::inverse(view.clipFromWorld);
    constexpr int kPoints = 200'000;
    int hits = 0;
    for (int i = 0; i < kPoints; ++i)
    {
        const glm::dvec4 p = worldFromClip * glm::dvec4(testsupport::between(random, -1, 1),
                                                        testsupport::between(random, -1, 1), 0.5, 1);
        const glm::dvec3 o = glm::inverse(e.halfAxes) * view.eyeWorld;
        const glm::dvec3 d = glm::inverse(e.halfAxes) * (glm::dvec3(p) / p.w - view.eyeWorld);
        const double b = glm::dot(o, d);
        hits += b * b >= glm::dot(d, d) * (glm::dot(o, o) - 1.0);
    }
    const double sampled = 1280.0 * 720.0 * hits / kPoints;
    EXPECT_NEAR(ellipsoidAreaPx(SelectionView::from(view), e) / sampled, 1.0, 0.02);
}

TEST(EllipsoidArea, OfAFlatOneIsThatOfItsDisc)
{
    const auto view = SelectionView::from(testsupport::viewTo({0, -10, 0}, {0, 0, 0}));
    const double k = view.pixelsPerTangent * 0.1;
    EXPECT_NEAR(ellipsoidAreaPx(view, {{0, 0, 0}, {{1, 0, 0}, {0, 0, 0}, {0, 0, 2}}}),
                std::numbers::pi * k * k * 2, 1e-6);
}

TEST(SphereArea, IsTheEllipsoidsOfEqualHalfAxes)
{
    Random random(5);
    for (int i = 0; i < 1000; ++i)
    {
        const glm::dvec3 centre = 30.0 * testsupport::direction(random);
        const double r = testsupport::between(random, 0.1, 4.0);
        const auto view = SelectionView::from(testsupport::viewAbout(random, centre, 40.0));
        const double sphere = sphereAreaPx(view, {centre, r});
        const double ellipsoid = ellipsoidAreaPx(view, {centre, testsupport::rotation(random) * r});
        if (sphere == kFullArea || ellipsoid == kFullArea)
            EXPECT_EQ(sphere, ellipsoid);
        else
            EXPECT_NEAR(sphere / ellipsoid, 1.0, 1e-9);
    }
}

TEST(SphereArea, GoesToThatOfADiscFarAheadAndGrowsTowardsThePicturesEdge)
{
    const auto view = SelectionView::from(testsupport::viewTo({0, 0, 0}, {0, 1, 0}, 80.0));
    const double k = view.pixelsPerTangent;
    const double ahead = sphereAreaPx(view, {{0, 1000, 0}, 1.0});
    EXPECT_NEAR(ahead, std::numbers::pi * k * k * 1e-6, 1e-5 * ahead);
    const double atEdge = sphereAreaPx(view, {{800, 600, 0}, 1.0}); // as far away
    EXPECT_NEAR(atEdge / ahead, 1.0 / (0.6 * 0.6 * 0.6), 1e-4);
    EXPECT_EQ(sphereAreaPx(view, {{0, 1.05, 0}, 1.0}), kFullArea);
}

} // namespace
