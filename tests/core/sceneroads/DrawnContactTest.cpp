// SPDX-License-Identifier: Apache-2.0
// Wheels and whatever stands on a road touch the surface that is drawn: within 1 cm near the eye, within a
// pixel farther away. OSGTRAINER_EVERY_FRAME=1 checks every frame of more drives, which takes a minute.
#include <cstdlib>
#include <fstream>
#include <iostream>

#include <gtest/gtest.h>

#include "ContactDrive.h"
#include "RealData.h"
#include "simulation/parser/ParseScenario.h"

namespace
{

constexpr int kSomeFrames = 60;
constexpr int kEnoughFrames = 6; ///< to meet a road that is drawn too coarsely

bool takesEveryFrame()
{
    return std::getenv("OSGTRAINER_EVERY_FRAME") != nullptr;
}

void expectKept(const RoadScene& scene, const simulation::Scenario& drive)
{
    const ContactReport report =
        contactsOf(scene, drive, {.everyFrames = takesEveryFrame() ? 1 : kSomeFrames});
    std::cout << report.text() << '\n';
    EXPECT_GT(report.points, 8 * report.frames);
    EXPECT_EQ(report.undrawn, 0u);
    EXPECT_EQ(report.broken, 0u);
}

/// The mutations that the check must see: something 2 cm too high, and roads coarser than chosen.
void expectSeen(const RoadScene& scene, const simulation::Scenario& drive, std::uint32_t coarser)
{
    EXPECT_GT(contactsOf(scene, drive, {.everyFrames = kSomeFrames, .raisedM = 0.02}).broken, 0u);
    EXPECT_GT(contactsOf(scene, drive, {.everyFrames = kEnoughFrames, .coarser = coarser}).broken, 0u);
}

/// Hills of New Hampshire, 90 m a sample, with a flat network laid on their slopes.
std::filesystem::path networkOnHills(const std::filesystem::path& dem, const std::filesystem::path& network)
{
    const auto file = std::filesystem::path(testing::TempDir()) / "roads-on-hills.roam";
    std::ofstream(file) << "dem = " << dem.string() << "\nroads = " << network.string()
                        << "\nroads_origin = 44.35 -71.53\nroads_heights = ground\n";
    return file;
}

} // namespace

TEST(DrawnContact, HoldsOnANetworkWithoutTerrain)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(file, "openscenario/esmini/xodr/fabriksgatan.xodr");
    const RoadScene scene = sceneOf(file);
    expectKept(scene, driveOver(scene, 20.0));
}

TEST(DrawnContact, HoldsInBendsThatClimbAndFailsWhenItShould)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(file, "openscenario/esmini/xodr/curves_elevation.xodr");
    const RoadScene scene = sceneOf(file);
    const simulation::Scenario drive = driveOver(scene, 20.0);
    expectKept(scene, drive);
    expectSeen(scene, drive, 2);
}

TEST(DrawnContact, HoldsOnTheDefaultDrive)
{
    if (!takesEveryFrame())
        GTEST_SKIP() << "the default terrain takes seconds to load: set OSGTRAINER_EVERY_FRAME";
    const std::filesystem::path course = OSGTRAINER_DEFAULT_COURSE;
    const RoadScene scene = sceneOf(course.parent_path() / "default.roam");
    const auto drive = simulation::readScenario(OSGTRAINER_SOURCE_DIR "/data/scenarios/drive.xosc");
    ASSERT_TRUE(drive);
    expectKept(scene, drive->scenario);
}

TEST(DrawnContact, HoldsOnARealNetworkInRealHillsAndFailsWhenItShould)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(dem, "dem/N44W072.hgt");
    OSGTRAINER_REAL_DATA_OR_SKIP(network, "openscenario/esmini/xodr/soderleden.xodr");
    const RoadScene scene = sceneOf(networkOnHills(dem, network));
    const simulation::Scenario drive = driveOver(scene, 20.0);
    expectKept(scene, drive);
    expectSeen(scene, drive, 1);
}

TEST(DrawnContact, HoldsOnBanksBridgesAndInJunctions)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(folder, "openscenario/esmini/xodr");
    if (!takesEveryFrame()) GTEST_SKIP() << "takes a minute: set OSGTRAINER_EVERY_FRAME";
    for (const char* name : {"velodrome", "tunnels", "soderleden", "multi_intersections", "e6mini",
                             "crest-curve", "two_plus_one", "straight_500m_signs"})
    {
        SCOPED_TRACE(name);
        std::cout << name << ": ";
        const RoadScene scene = sceneOf(folder / (std::string(name) + ".xodr"));
        expectKept(scene, driveOver(scene, 20.0));
    }
}
