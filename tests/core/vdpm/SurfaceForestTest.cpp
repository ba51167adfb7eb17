// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <osgPMObjects/core/mesh/EdgeTable.h>
#include <osgPMObjects/core/mesh/TriangleDistance.h>
#include <osgTerrainROAM/core/vdpm/FrontDriver.h>
#include <osgTerrainROAM/core/vdpm/SurfaceForest.h>

#include "ClosedMeshes.h"
#include "SurfaceError.h"

namespace osgTerrainROAM::core
{

namespace
{

using osgPMObjects::core::Mesh;
constexpr std::uint32_t kAnyFaces = std::numeric_limits<std::uint32_t>::max();

/// A closed rock of about 10 m: a ball with bumps of several sizes.
Mesh rock()
{
    Mesh mesh = testsupport::ball(40, 60);
    for (glm::dvec3& p : mesh.positions)
    {
        const glm::dvec3 d = glm::normalize(p);
        p = d * (10.0 + 0.8 * std::sin(5.0 * d.x + 1.0) * std::cos(4.0 * d.y) +
                 0.25 * std::sin(17.0 * d.z) * std::cos(13.0 * d.x));
    }
    return mesh;
}

viewlod::ViewState viewFrom(const glm::dvec3& eye, const glm::dvec3& target)
{
    return viewlod::ViewState::fromMatrices(glm::lookAt(eye, target, glm::dvec3(0.1, 0.2, 1.0)),
                                            glm::perspective(0.8, 1.25, 0.1, 500.0), 640, 512);
}

/// A sample, and the normals of the faces at it.
struct Sample
{
    glm::dvec3 place;
    std::vector<glm::dvec3> normals;
};

std::vector<Sample> samplesOf(const Mesh& mesh)
{
    std::vector<Sample> samples;
    for (const glm::dvec3& p : mesh.positions)
        samples.push_back({p, {}});
    for (const Triangle& t : osgPMObjects::core::positionTriangles(mesh))
    {
        const glm::dvec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
        const glm::dvec3 normal = glm::cross(b - a, c - a);
        for (const std::uint32_t v : t)
            samples[v].normals.push_back(normal);
        samples.push_back({(a + b + c) / 3.0, {normal}});
    }
    return samples;
}

bool showsSide(const Sample& sample, const glm::dvec3& eye, VisibleSides sides)
{
    if (sides == VisibleSides::both) return true;
    const double sign = sides == VisibleSides::front ? 1.0 : -1.0;
    return std::ranges::any_of(sample.normals, [&](const glm::dvec3& normal)
                               { return sign * glm::dot(normal, eye - sample.place) > 0.0; });
}

class Rock : public testing::Test
{
protected:
    void SetUp() override
    {
        auto made = surfaceForest(mesh);
        ASSERT_TRUE(made);
        forest = std::move(*made);
        driver = std::make_unique<FrontDriver>(forest);
    }

    std::uint32_t look(const viewlod::ViewState& view, double tolerancePx, SeenPart seen)
    {
        viewlod::Slice unlimited({});
        RefineResult result;
        const SplitCriterion criterion(view, tolerancePx, std::move(seen));
        EXPECT_TRUE(driver->refine(criterion, kAnyFaces, unlimited, result));
        return driver->front().faceCount();
    }

    std::vector<std::array<glm::dvec3, 3>> drawn() const
    {
        std::vector<std::array<glm::dvec3, 3>> triangles;
        const ActiveFront& front = driver->front();
        for (std::uint32_t slot = 0; slot < front.faceCount(); ++slot)
        {
            const auto& c = front.faceAt(slot).corners;
            const auto at = [&](int i) { return forest.positions[front.vertexAt(c[i])]; };
            triangles.push_back({at(0), at(1), at(2)});
        }
        return triangles;
    }

    /// The largest distance in the picture of a sample that is seen from the nearest point that is drawn.
    double worstPx(const viewlod::ViewState& view, VisibleSides sides) const
    {
        const auto triangles = drawn();
        double worst = 0.0;
        for (const Sample& sample : samples)
        {
            if (!showsSide(sample, view.eyeWorld, sides)) continue;
            double least = std::numeric_limits<double>::infinity();
            for (const auto& t : triangles)
                least = std::min(least, testsupport::errorPxOf(view, sample.place,
                                                               osgPMObjects::core::nearestPoint(
                                                                   sample.place, t[0], t[1], t[2])));
            worst = std::max(worst, least);
        }
        return worst;
    }

    /// The share of the drawn triangles whose middles lie on the side of a direction.
    double shareTowards(const glm::dvec3& direction) const
    {
        const auto triangles = drawn();
        const auto count = std::ranges::count_if(triangles, [&](const auto& t)
                                                 { return glm::dot(t[0] + t[1] + t[2], direction) > 0.0; });
        return static_cast<double>(count) / static_cast<double>(triangles.size());
    }

    Mesh mesh = rock();
    std::vector<Sample> samples = samplesOf(mesh);
    BoundedForest forest;
    std::unique_ptr<FrontDriver> driver;
};

TEST(NormalCone, JoinsToOneThatContainsBoth)
{
    testsupport::Random random(4);
    for (int i = 0; i < 2000; ++i)
    {
        const auto direction = [&]
        { return glm::dvec3(random.unit() - 0.5, random.unit() - 0.5, random.unit() - 0.5); };
        const glm::dvec3 a = direction(), b = direction(), c = direction();
        const NormalCone ab = NormalCone::of(a).joined(NormalCone::of(b)), abc = ab.joined(NormalCone::of(c));
        EXPECT_TRUE(abc.contains(ab));
        for (const glm::dvec3& normal : {a, b, c})
            EXPECT_LE(NormalCone::between(abc.axis, glm::vec3(glm::normalize(normal))), abc.angle);
        // What is turned away shows no normal to the eye.
        const glm::dvec3 eye = 5.0 * direction();
        for (const double sign : {1.0, -1.0})
            if (isTurnedAway(abc, {}, 0.3, eye, sign > 0 ? VisibleSides::front : VisibleSides::back))
            {
                for (const glm::dvec3& normal : {a, b, c})
                    EXPECT_LT(sign * glm::dot(normal, eye - 0.3 * glm::normalize(direction())), 0.0);
            }
    }
}

TEST_F(Rock, BaseIsSmallAndBoundsAndConesNest)
{
    EXPECT_LE(forest.forest.rootFaces.size(), 32u);
    EXPECT_TRUE(areBoundsNested(forest));
    BoundedForest damaged = forest;
    const auto finder = std::ranges::find_if(damaged.finder, [](std::uint32_t f) { return f != kNone; });
    damaged.cones[*finder].angle = 0.0f;
    EXPECT_FALSE(areBoundsNested(damaged));
}

TEST_F(Rock, NoSampleIsFartherFromTheSurfaceThanAskedWhateverTheError)
{
    viewlod::Slice unlimited({});
    for (const double errorM : {1.0, 0.2, 0.05})
    {
        RefineResult result;
        driver->refine(SplitCriterion(errorM), kAnyFaces, unlimited, result);
        const auto triangles = drawn();
        EXPECT_LT(triangles.size(), mesh.faces.size());
        for (const Sample& sample : samples)
        {
            double least = std::numeric_limits<double>::infinity();
            for (const auto& t : triangles)
                least = std::min(least, glm::distance(sample.place, osgPMObjects::core::nearestPoint(
                                                                        sample.place, t[0], t[1], t[2])));
            ASSERT_LE(least, errorM * (1.0 + 1e-6));
        }
    }
}

TEST_F(Rock, RefinesTheSideThatIsLookedAtFromOutside)
{
    const SeenPart front{.inFrustum = true, .sides = VisibleSides::front};
    for (int step = 0; step < 12; ++step)
    {
        const double turn = 0.5 * step;
        const glm::dvec3 eye =
            (16.0 + 2.0 * (step % 5)) * glm::normalize(glm::dvec3(std::cos(turn), std::sin(turn), 0.3));
        const viewlod::ViewState view = viewFrom(eye, {});
        const std::uint32_t both = look(view, 2.0, {.inFrustum = true});
        EXPECT_LE(worstPx(view, VisibleSides::both), 2.0 + 1e-3);
        const std::uint32_t seen = look(view, 2.0, front);
        EXPECT_LT(seen, both * 85 / 100);
        EXPECT_GT(shareTowards(eye), 0.6);
        EXPECT_LE(worstPx(view, VisibleSides::front), 2.0 + 1e-3) << step;
        EXPECT_EQ(driver->front().defect(), "");
        EXPECT_TRUE(driver->keepsDependencies());
    }
}

TEST_F(Rock, RefinesTheSideThatIsLookedAtFromInside)
{
    const SeenPart back{.inFrustum = true, .sides = VisibleSides::back};
    for (const glm::dvec3& ahead : {glm::dvec3(1, 0, 0), glm::dvec3(-1, 0.4, 0), glm::dvec3(0, 0.3, -1)})
    {
        const glm::dvec3 eye = -3.0 * ahead;
        const viewlod::ViewState view = viewFrom(eye, eye + ahead);
        const std::uint32_t seen = look(view, 2.0, back);
        EXPECT_GT(shareTowards(ahead), 0.7);
        EXPECT_LE(worstPx(view, VisibleSides::back), 2.0 + 1e-3);
        EXPECT_EQ(driver->front().defect(), "");
        // With back faces culled there is nothing to see: little is left besides what the eye is too near to.
        EXPECT_LT(look(view, 2.0, {.inFrustum = true, .sides = VisibleSides::front}), seen / 2);
    }
}

TEST_F(Rock, ATooSmallErrorOrConeIsFound)
{
    const viewlod::ViewState view = viewFrom({17.0, 4.0, 3.0}, {});
    const SeenPart front{.inFrustum = true, .sides = VisibleSides::front};
    const BoundedForest sound = forest;
    for (SplitBound& bound : forest.bounds)
        bound.errorM *= 0.3f;
    driver = std::make_unique<FrontDriver>(forest);
    look(view, 2.0, front);
    EXPECT_GT(worstPx(view, VisibleSides::front), 2.0);
    forest = sound;
    for (NormalCone& cone : forest.cones)
        cone = {-cone.axis, 0.1f};
    driver = std::make_unique<FrontDriver>(forest);
    look(view, 2.0, front);
    EXPECT_GT(worstPx(view, VisibleSides::front), 2.0);
}

TEST(SurfaceForest, RefusesWhatIsNoManifold)
{
    const Mesh fan = testsupport::meshOf({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}},
                                         {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}});
    const auto made = surfaceForest(fan);
    ASSERT_FALSE(made);
    EXPECT_NE(made.error().message().find("edge"), std::string::npos);
    EXPECT_FALSE(surfaceForest(Mesh{}));
}

} // namespace

} // namespace osgTerrainROAM::core
