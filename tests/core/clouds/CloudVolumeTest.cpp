// SPDX-License-Identifier: Apache-2.0
// Clouds cover as much of the sky as their oktas say, keep their heights, and cast shadows where the sun's
// rays lead.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "measurement/light/CloudFigures.h"
#include "scenery/clouds/CloudVolumeBytes.h"

namespace
{

using namespace scenery::clouds;
using simulation::CloudKind;

using measurement::oktasOf;

CloudVolume volumeOf(CloudKind kind, int oktas)
{
    return makeCloudVolume({kind, oktas, 1000.0, 1000.0 + (kind == CloudKind::cumulus ? 900.0 : 400.0)}, 1U);
}

} // namespace

TEST(CloudVolume, CoversAsManyEighthsAsItSays)
{
    for (const CloudKind kind :
         {CloudKind::cumulus, CloudKind::stratocumulus, CloudKind::stratus, CloudKind::cirrus})
        for (const int oktas : {1, 4, 7})
            EXPECT_NEAR(oktasOf(volumeOf(kind, oktas)), oktas, 0.5) << static_cast<int>(kind);
    EXPECT_EQ(oktasOf(volumeOf(CloudKind::cumulus, 0)), 0.0);
    EXPECT_EQ(oktasOf(volumeOf(CloudKind::stratus, 8)), 8.0);
}

TEST(CloudVolume, TheMeasureTellsOneEighthMore)
{
    EXPECT_GT(std::abs(oktasOf(volumeOf(CloudKind::cumulus, 4)) - 3.0), 0.5);
}

TEST(CloudVolume, GapsAreNoLongerThanTheWayToTheNearestCloud)
{
    const CloudVolume volume = volumeOf(CloudKind::cumulus, 2);
    std::mt19937 random(3);
    constexpr int kSide = CloudVolume::kSide;
    std::vector<glm::ivec3> cloudy;
    for (int i = 0; i < static_cast<int>(volume.form.size()); ++i)
        if (volume.form[static_cast<std::size_t>(i)] > CloudVolume::kSurface)
            cloudy.emplace_back(i % kSide, i / kSide % kSide, i / kSide / kSide);
    for (int n = 0; n < 40; ++n)
    {
        const auto i = static_cast<int>(random() % volume.form.size());
        const glm::ivec3 here(i % kSide, i / kSide % kSide, i / kSide / kSide);
        double nearest = 1e9;
        for (const glm::ivec3& there : cloudy)
        {
            const auto apart = [&](int a, int b)
            { return std::min(std::abs(a - b), kSide - std::abs(a - b)) * CloudVolume::kCellM; };
            nearest = std::min(nearest, std::hypot(apart(here.x, there.x), apart(here.y, there.y),
                                                   (here.z - there.z) * volume.sliceM()));
        }
        EXPECT_LE(volume.gap[static_cast<std::size_t>(i)] * CloudVolume::kGapStepM, nearest + 1.0);
    }
}

TEST(CloudVolume, ShadowsLieWhereTheSunsRaysLead)
{
    const CloudVolume volume = volumeOf(CloudKind::cumulus, 3);
    constexpr int kSide = CloudVolume::kSide;
    const glm::dvec3 sun = glm::dvec3(0.5, -0.3, 0.8) / std::sqrt(0.98);
    const SunInClouds light = sunInClouds(volume, glm::vec3(sun));
    double inShade = 0.0, shifted = 0.0;
    int count = 0;
    for (int row = 3; row < kSide; row += 5)
        for (int column = 3; column < kSide; column += 5)
        {
            const glm::dvec3 at((column + 0.5) * CloudVolume::kCellM, (row + 0.5) * CloudVolume::kCellM,
                                volume.baseM);
            if (opticalDepth(volume, at, sun) < 3.0) continue;
            inShade += light.below[static_cast<std::size_t>(row) * kSide + column];
            shifted += light.below[static_cast<std::size_t>(row) * kSide + (column + 20) % kSide];
            ++count;
        }
    ASSERT_GT(count, 100);
    EXPECT_LT(inShade / count, 0.25);
    EXPECT_GT(shifted / count, 0.45) << "a shadow that lies 1.6 km aside would be seen";
}

TEST(CloudVolume, TheSunLightsTopsAndNotBases)
{
    const CloudVolume volume = volumeOf(CloudKind::stratus, 8);
    const SunInClouds light = sunInClouds(volume, {0.0F, 0.0F, 1.0F});
    const auto mean = [&](int slice)
    {
        double sum = 0.0;
        constexpr std::size_t kPlan = std::size_t{CloudVolume::kSide} * CloudVolume::kSide;
        for (std::size_t i = 0; i < kPlan; ++i)
            sum += light.within[slice * kPlan + i];
        return sum / kPlan / 255.0;
    };
    EXPECT_GT(mean(CloudVolume::kSlices - 2), 0.75);
    EXPECT_LT(mean(1), 0.5);
    for (int slice = 1; slice < CloudVolume::kSlices; ++slice)
        EXPECT_GE(mean(slice) + 1e-6, mean(slice - 1));
}

TEST(CloudVolume, IsTheSameTwice)
{
    const CloudVolume one = volumeOf(CloudKind::stratocumulus, 6),
                      two = volumeOf(CloudKind::stratocumulus, 6);
    EXPECT_EQ(one.form, two.form);
    EXPECT_EQ(one.gap, two.gap);
}

TEST(CloudVolume, ComesBackFromItsBytesAndFromNoOthers)
{
    const CloudVolume made = volumeOf(CloudKind::cumulus, 4);
    const std::string bytes = bytesOf(made);
    const auto found = cloudVolumeIn(bytes);
    ASSERT_TRUE(found);
    EXPECT_EQ(bytesOf(*found), bytes);
    EXPECT_EQ(found->topM, made.topM);
    EXPECT_EQ(found->skylit, made.skylit);
    EXPECT_FALSE(cloudVolumeIn(bytes.substr(0, bytes.size() - 1))) << "cut off";
    EXPECT_FALSE(cloudVolumeIn(bytes + ' ')) << "too long";
    CloudVolume wrong = made;
    wrong.gap.pop_back();
    EXPECT_FALSE(cloudVolumeIn(bytesOf(wrong))) << "a sample is missing";
    wrong = made;
    std::swap(wrong.baseM, wrong.topM);
    EXPECT_FALSE(cloudVolumeIn(bytesOf(wrong))) << "upside down";
    wrong = made;
    wrong.extinctionPerM = std::nan("");
    EXPECT_FALSE(cloudVolumeIn(bytesOf(wrong))) << "no number";
}
