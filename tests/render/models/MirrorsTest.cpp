// SPDX-License-Identifier: Apache-2.0
// What mirrors of a car show, and from where they are seen.
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "InteriorStudio.h"
#include "scenery/nodes/MirrorCamera.h"

namespace
{

using namespace scenery;
using models::EntityKind;
using seat::interiorOf;
using seat::kEyeOfCar;

/// In normalised device coordinates: -1 to 1 within the mirror.
glm::dvec3 inMirror(const MirrorView& view, const glm::dvec3& world)
{
    const glm::dvec4 clip = view.projection * view.view * glm::dvec4(world, 1.0);
    return glm::dvec3(clip) / clip.w;
}

TEST(Mirrors, ShowWhatTheirNormalReflects)
{
    const auto interior = interiorOf(EntityKind::car, kEyeOfCar);
    ASSERT_EQ(interior.mirrors.size(), 3U);
    // Turned and moved somewhere: mirrors go with the vehicle.
    Pose vehicle{{1000.0, -2000.0, 30.0}, glm::dmat3({0.6, 0.8, 0.0}, {-0.8, 0.6, 0.0}, {0.0, 0.0, 1.0})};
    const glm::dvec3 eye = vehicle.worldFromBodyPoint(kEyeOfCar);
    for (const models::InteriorMirror& mirror : interior.mirrors)
    {
        const MirrorView view = mirrorView(mirror, vehicle, eye, 1e4);
        ASSERT_TRUE(view.isSeen) << mirror.name;
        const glm::dvec3 low = vehicle.worldFromBodyPoint(mirror.lowLeft),
                         right = vehicle.worldFromBodyPoint(mirror.lowRight) - low,
                         up = vehicle.worldFromBodyPoint(mirror.topLeft) - low;
        const glm::dvec3 normal = glm::normalize(glm::cross(right, up));
        for (const auto& [u, v] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {0.5, 0.5}, {0.2, 0.9}, {1.0, 1.0}})
        {
            const glm::dvec3 at = low + u * right + v * up;
            const glm::dvec3 seen = at + 50.0 * glm::reflect(glm::normalize(at - eye), normal);
            const glm::dvec3 shown = inMirror(view, seen);
            EXPECT_NEAR(shown.x, 1.0 - 2.0 * u, 1e-9) << mirror.name;
            EXPECT_NEAR(shown.y, 2.0 * v - 1.0, 1e-9) << mirror.name;
            EXPECT_LT(shown.z, 1.0);
        }
    }
    // From behind it shows nothing.
    EXPECT_FALSE(
        mirrorView(interior.mirrors.front(), vehicle, vehicle.worldFromBodyPoint({9.0, 0.0, 1.0}), 1e4)
            .isSeen);
}

TEST(Mirrors, AreInThePictureOfAnEyeThatLooksTheirWay)
{
    const auto interior = interiorOf(EntityKind::car, kEyeOfCar);
    const auto seen = [&](double leftDeg)
    {
        const double angle = leftDeg * 3.14159265358979 / 180.0;
        const glm::dvec3 ahead(std::cos(angle), std::sin(angle), 0.0), left(-ahead.y, ahead.x, 0.0);
        const glm::dmat4 view = viewFromWorld({kEyeOfCar, glm::dmat3(ahead, left, {0.0, 0.0, 1.0})});
        std::string names;
        for (const models::InteriorMirror& mirror : interior.mirrors)
            if (isInPicture(mirror, {}, glm::perspective(0.96, 16.0 / 9.0, 0.05, 60.0) * view))
                names += mirror.name + ' ';
        return names;
    };
    const std::string left = interior.mirrors[0].name + ' ', right = interior.mirrors[1].name + ' ',
                      inner = interior.mirrors[2].name + ' ';
    EXPECT_EQ(seen(0.0), left + inner);
    EXPECT_EQ(seen(70.0), left);
    EXPECT_EQ(seen(-50.0), right + inner);
    EXPECT_EQ(seen(180.0), "");
}

TEST(Mirrors, OfACarShowTheRoadBehindIt)
{
    const auto interior = interiorOf(EntityKind::car, kEyeOfCar);
    const Pose vehicle;
    // A car 30 m behind in the same lane, in the inner mirror; one that overtakes on the left, in the left
    // one; on the right, in the right one.
    const std::pair<std::size_t, glm::dvec3> cars[] = {
        {2, {-30.0, 0.0, 0.8}}, {0, {-15.0, 3.5, 0.8}}, {1, {-15.0, -3.5, 0.8}}};
    for (const auto& [mirror, car] : cars)
    {
        const glm::dvec3 shown = inMirror(mirrorView(interior.mirrors[mirror], vehicle, kEyeOfCar, 1e4), car);
        EXPECT_LT(std::abs(shown.x), 1.0) << interior.mirrors[mirror].name;
        EXPECT_LT(std::abs(shown.y), 1.0) << interior.mirrors[mirror].name;
    }
}

} // namespace
