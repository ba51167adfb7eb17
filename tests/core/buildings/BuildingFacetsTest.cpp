// SPDX-License-Identifier: Apache-2.0
// The walls and roofs of buildings enclose their volume: what is missing or stands off changes it.
#include "scenery/buildings/BuildingFacets.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "scenery/buildings/Outline.h"
#include "scenery/buildings/RoofPlanes.h"

namespace
{

using namespace scenery;

constexpr double kFloorM = 103.0, kFootM = 101.5;
const glm::dvec3 kOrigin(1000.0, 2000.0, kFootM); ///< the open underside lies in z = 0, so it adds no volume

std::vector<PlanRing> moved(std::vector<PlanRing> rings)
{
    for (PlanRing& ring : rings)
        for (glm::dvec2& corner : ring)
            corner += glm::dvec2(kOrigin);
    return tidiedRings(rings);
}

StandingBuilding house(std::vector<PlanRing> rings, RoofForm roof)
{
    StandingBuilding standing;
    standing.building.rings = moved(std::move(rings));
    standing.building.roof = roof;
    standing.building.eavesM = 6.0;
    standing.building.roofM = roof == RoofForm::flat ? 0.0 : 3.0;
    standing.floorM = kFloorM;
    standing.footM = kFootM;
    return standing;
}

const std::vector<PlanRing> kSquare{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}};
const std::vector<PlanRing> kHook{{{0, 0}, {20, 0}, {20, 6}, {8, 6}, {8, 14}, {0, 14}}};
const std::vector<PlanRing> kCourt{{{0, 0}, {30, 0}, {30, 20}, {0, 20}},
                                   {{10, 6}, {20, 6}, {20, 14}, {10, 14}}};

BuildingFacets facetsOf(const StandingBuilding& standing)
{
    BuildingFacets facets;
    addShell(standing, kOrigin, facets);
    addOpenings(standing, kOrigin, facets);
    return facets;
}

double volumeOf(const Facets& facets)
{
    double volume = 0.0;
    for (std::size_t i = 0; i < facets.indices.size(); i += 3)
    {
        const glm::dvec3 a(facets.positions[facets.indices[i]]), b(facets.positions[facets.indices[i + 1]]),
            c(facets.positions[facets.indices[i + 2]]);
        volume += glm::dot(a, glm::cross(b, c)) / 6.0;
    }
    return volume;
}

double volumeOf(const BuildingFacets& facets)
{
    double volume = 0.0;
    for (const auto& [painting, shell] : facets.shell)
        volume += volumeOf(shell);
    return volume;
}

/// The volume by columns of 10 cm below the roof's planes.
double expectedVolume(const StandingBuilding& standing)
{
    constexpr double kStepM = 0.1;
    const RoofPlanes roof(standing.building);
    double volume = 0.0;
    for (double x = 0.5 * kStepM; x < 32.0; x += kStepM)
        for (double y = 0.5 * kStepM; y < 32.0; y += kStepM)
        {
            const glm::dvec2 place = glm::dvec2(kOrigin) + glm::dvec2(x, y);
            if (!isWithin(standing.building.rings, place)) continue;
            const double topM = kFloorM + standing.building.eavesM + roof.heightM(place);
            volume += kStepM * kStepM * (topM - kFootM);
        }
    return volume;
}

TEST(BuildingFacets, EncloseWhatLiesBelowTheRoof)
{
    for (const RoofForm roof : {RoofForm::flat, RoofForm::gabled, RoofForm::hipped, RoofForm::pyramidal,
                                RoofForm::skillion, RoofForm::round})
        for (const auto* rings :
             {&kHook, &kCourt}) // outlines that are not convex have no eaves, which would add to the volume
        {
            if (rings == &kCourt && roof != RoofForm::flat) continue;
            const StandingBuilding standing = house(*rings, roof);
            const double expected = expectedVolume(standing);
            EXPECT_NEAR(volumeOf(facetsOf(standing)), expected, 0.01 * expected) << static_cast<int>(roof);
        }
}

TEST(BuildingFacets, APartOverAPassageIsClosedFromBelowAndLeavesThePassage)
{
    StandingBuilding standing = house(kHook, RoofForm::flat);
    standing.building.liftedM = 4.5;
    const BuildingFacets facets = facetsOf(standing);
    const double lowM = kFloorM + 4.5 - kFootM;
    EXPECT_NEAR(volumeOf(facets), areaOf(standing.building.rings) * 1.5, 0.5);
    for (const auto& [painting, shell] : facets.shell)
        for (const glm::vec3& place : shell.positions)
            EXPECT_GE(place.z, lowM - 1e-3);
    for (const glm::vec3& place : facets.openings.positions) // neither doors nor windows below it
        EXPECT_GE(place.z, lowM - 1e-3);
}

/// The area of upright facets below a height.
double uprightBelow(const BuildingFacets& facets, double heightM)
{
    double area = 0.0;
    for (const auto& painted : facets.shell)
    {
        const Facets& shell = painted.second;
        for (std::size_t i = 0; i < shell.indices.size(); i += 3)
        {
            const auto at = [&](std::size_t k) { return glm::dvec3(shell.positions[shell.indices[i + k]]); };
            const glm::dvec3 turned = glm::cross(at(1) - at(0), at(2) - at(0));
            const double highestM = std::max({at(0).z, at(1).z, at(2).z});
            if (highestM < heightM + 1e-3 && std::abs(turned.z) < 1e-6) area += 0.5 * glm::length(turned);
        }
    }
    return area;
}

TEST(BuildingFacets, ARoofOnPostsHasNoWalls)
{
    StandingBuilding standing = house(kSquare, RoofForm::flat);
    standing.building.liftedM = 5.7;
    standing.building.openings = Openings::none;
    const double undersideM = kFloorM + 5.7 - kFootM;
    EXPECT_EQ(uprightBelow(facetsOf(standing), undersideM), 0.0) << "the control: it floats";
    standing.building.isOnPosts = true;
    const BuildingFacets facets = facetsOf(standing);
    // Two spans a side: eight posts, 20 cm on each of four sides, from 30 cm below the ground.
    EXPECT_NEAR(uprightBelow(facets, undersideM), 8 * 4 * 0.2 * (5.7 + 0.3), 0.01);
    EXPECT_TRUE(facets.openings.positions.empty());
}

TEST(BuildingFacets, AMissingWallOrARaisedRoofIsSeen)
{
    const StandingBuilding standing = house(kHook, RoofForm::gabled);
    const double expected = expectedVolume(standing);
    BuildingFacets open = facetsOf(standing);
    Facets& walls = open.shell.at(standing.building.wall);
    walls.indices.erase(walls.indices.begin() + 18,
                        walls.indices.begin() + 24); // the eastern one, above its plinth
    EXPECT_GT(std::abs(volumeOf(open) - expected), 0.01 * expected);
    BuildingFacets raised = facetsOf(standing);
    for (glm::vec3& position : raised.shell.at(standing.building.cover).positions)
        position.z += 0.3F;
    EXPECT_GT(std::abs(volumeOf(raised) - expected), 0.01 * expected);
}

/// The least and the most that the walls see of the sky.
std::pair<float, float> skiesOf(const StandingBuilding& standing)
{
    const BuildingFacets facets = facetsOf(standing);
    const std::vector<float>& skies = facets.shell.at(standing.building.wall).skies;
    const auto [least, most] = std::minmax_element(skies.begin(), skies.end());
    return {*least, *most};
}

TEST(BuildingFacets, EavesHideTheSkyFromTheWallBelowThem)
{
    const StandingBuilding standing = house(kSquare, RoofForm::gabled);
    EXPECT_EQ(skiesOf(standing), std::pair(0.35F, 1.0F));
    EXPECT_EQ(skiesOf(house(kSquare, RoofForm::flat)), std::pair(1.0F, 1.0F)) << "without eaves";
    EXPECT_EQ(skiesOf(house(kHook, RoofForm::gabled)), std::pair(1.0F, 1.0F)) << "without eaves";
    const Facets walls = facetsOf(standing).shell.at(standing.building.wall);
    for (std::size_t i = 0; i < walls.skies.size(); ++i)
        EXPECT_TRUE(walls.skies[i] == 1.0F || walls.positions[i].z > 6.0F) << "far below the eaves";
}

TEST(BuildingFacets, AGableRoofHasItsRidgeInTheMiddleAndEavesBeyondTheWalls)
{
    const StandingBuilding standing = house(kSquare, RoofForm::gabled);
    const BuildingFacets facets = facetsOf(standing);
    const Facets& roof = facets.shell.at(standing.building.cover);
    float highest = 0.0F, east = 0.0F;
    for (const glm::vec3& position : roof.positions)
    {
        highest = std::max(highest, position.z);
        east = std::max(east, position.x);
    }
    EXPECT_NEAR(highest, kFloorM - kFootM + 9.0, 1e-3);
    EXPECT_NEAR(east, 10.45, 1e-3);
}

TEST(BuildingFacets, EachStoreyHasWindowsAndOneHouseOneDoor)
{
    StandingBuilding standing = house(kSquare, RoofForm::flat);
    standing.building.storeys = 2;
    // 10 m of wall have three axes: four walls, two storeys.
    EXPECT_EQ(facetsOf(standing).openings.indices.size(), 6u * 24u);
    standing.building.openings = scenery::Openings::none;
    EXPECT_TRUE(facetsOf(standing).openings.indices.empty());
}

TEST(BuildingFacets, AHangarHasAGateInEachGableAndAControlTowerGlassAllAround)
{
    StandingBuilding hangar = house({{{0, 0}, {30, 0}, {30, 20}, {0, 20}}}, RoofForm::round);
    hangar.building.openings = scenery::Openings::hangar;
    const auto gates = facetsOf(hangar).openings;
    ASSERT_EQ(gates.positions.size(), 8u);
    for (const glm::vec3& corner : gates.positions) // the ridge runs along the longer side
        EXPECT_NEAR(std::abs(corner.x - 15.0F), 15.04F, 1e-3F);
    // Too wide to be a shaft with a cab: one part.
    StandingBuilding tower = house({{{0, 0}, {30, 0}, {30, 20}, {0, 20}}}, RoofForm::flat);
    tower.building.storeys = 4;
    tower.building.openings = scenery::Openings::control;
    const double glassFromM = kFloorM + 0.75 * tower.building.eavesM;
    std::size_t panes = 0;
    for (const glm::vec3& corner : facetsOf(tower).openings.positions)
        panes += corner.z + kFootM > glassFromM;
    EXPECT_EQ(panes, 2u * (17u + 11u) * 4u) << "a pane for each 1.8 m";
}

TEST(BuildingFacets, ASlenderControlTowerHasACabThatIsWiderThanItsShaft)
{
    StandingBuilding tower = house({{{0, 0}, {7, 0}, {7, 7}, {0, 7}}}, RoofForm::flat);
    tower.building.eavesM = 17.0;
    tower.building.storeys = 5;
    tower.building.openings = scenery::Openings::control;
    const BuildingFacets facets = facetsOf(tower);
    const double cabM = kFloorM - kFootM + 0.8 * tower.building.eavesM;
    double shaftM = 0.0, aboveM = 0.0, topM = 0.0;
    for (const auto& [painting, shell] : facets.shell)
        for (const glm::vec3& corner : shell.positions)
        {
            const double awayM = std::max(std::abs(corner.x - 3.5), std::abs(corner.y - 3.5));
            (corner.z < cabM - 0.5 ? shaftM : aboveM) =
                std::max(corner.z < cabM - 0.5 ? shaftM : aboveM, awayM);
            topM = std::max<double>(topM, corner.z);
        }
    EXPECT_LT(shaftM, 2.7);
    EXPECT_GT(aboveM, 4.3) << "the gallery";
    EXPECT_NEAR(topM, kFloorM - kFootM + 17.35, 0.01);
    std::size_t glass = 0;
    bool isFlat = true; // each pane stands upright on the octagon
    for (const glm::vec3& corner : facets.openings.positions)
        if (corner.z > cabM)
        {
            ++glass;
            isFlat = isFlat && std::max(std::abs(corner.x - 3.5), std::abs(corner.y - 3.5)) < 3.6;
        }
    EXPECT_EQ(glass, 8u * 2u * 4u) << "two panes on each of eight sides";
    EXPECT_TRUE(isFlat);
}

TEST(RoofPlanes, OfARoundRoofTouchAnArc)
{
    const StandingBuilding standing = house({{{0, 0}, {30, 0}, {30, 20}, {0, 20}}}, RoofForm::round);
    const RoofPlanes roof(standing.building);
    const double top = standing.building.roofM, radius = 0.5 * (100.0 / top + top);
    for (double side = -9.5; side <= 9.5; side += 0.5)
    {
        const double arc = std::sqrt(radius * radius - side * side) - (radius - top);
        const double height = roof.heightM(glm::dvec2(kOrigin) + glm::dvec2(15.0, 10.0 + side));
        EXPECT_GE(height, arc - 1e-9) << side;
        EXPECT_LE(height, arc + 0.08) << side;
    }
}

TEST(RoofPlanes, OfAHipRoofFallToAllFourSides)
{
    const StandingBuilding standing = house({{{0, 0}, {20, 0}, {20, 10}, {0, 10}}}, RoofForm::hipped);
    const RoofPlanes roof(standing.building);
    const glm::dvec2 corner(kOrigin);
    EXPECT_NEAR(roof.heightM(corner + glm::dvec2(10, 5)), 3.0, 1e-9);
    EXPECT_NEAR(roof.heightM(corner + glm::dvec2(5, 5)), 3.0, 1e-9);
    EXPECT_NEAR(roof.heightM(corner + glm::dvec2(2.5, 5)), 1.5, 1e-9);
    EXPECT_NEAR(roof.heightM(corner + glm::dvec2(0, 5)), 0.0, 1e-9);
    EXPECT_NEAR(roof.heightM(corner + glm::dvec2(10, 0)), 0.0, 1e-9);
    const auto breaks = roof.breaksOn(corner + glm::dvec2(0, 5), corner + glm::dvec2(20, 5));
    ASSERT_FALSE(breaks.empty());
    EXPECT_NEAR(breaks.front(), 0.25, 1e-9);
}

} // namespace
