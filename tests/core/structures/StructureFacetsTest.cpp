// SPDX-License-Identifier: Apache-2.0
#include "scenery/structures/StructureFacets.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "scenery/structures/Beams.h"
#include "scenery/structures/RailTube.h"

using scenery::Facets;
using scenery::Structure;
using scenery::StructureKind;
using scenery::structureOf;

namespace
{

std::optional<double> slope(const glm::dvec2& plan)
{
    if (std::abs(plan.x) > 5000.0) return std::nullopt;
    return 200.0 + 0.1 * plan.x - 0.05 * plan.y;
}

/// Six times the volume that triangles enclose, by their turn: positive where they look outwards.
double turnedVolume(const Facets& facets)
{
    double sum = 0.0;
    for (std::size_t i = 0; i + 2 < facets.indices.size(); i += 3)
    {
        const glm::dvec3 a(facets.positions[facets.indices[i]]), b(facets.positions[facets.indices[i + 1]]),
            c(facets.positions[facets.indices[i + 2]]);
        sum += glm::dot(a, glm::cross(b, c));
    }
    return sum;
}

std::size_t trianglesOf(const scenery::StructureSquares& squares)
{
    std::size_t count = 0;
    for (const auto& [number, square] : squares)
        count += (square.fine.indices.size() + square.coarse.indices.size() + square.low.indices.size()) / 3;
    return count;
}

/// The highest and lowest point above the ground.
std::pair<double, double> heightsOf(const scenery::StructureSquares& squares)
{
    double low = 1e9, high = -1e9;
    for (const auto& [number, square] : squares)
        for (const Facets* facets : {&square.fine, &square.coarse, &square.low})
            for (const glm::vec3& position : facets->positions)
            {
                const glm::dvec3 place = square.origin + glm::dvec3(position);
                low = std::min(low, place.z - *slope(glm::dvec2(place)));
                high = std::max(high, place.z - *slope(glm::dvec2(place)));
            }
    return {low, high};
}

} // namespace

TEST(Structures, TagsSayWhatStands)
{
    const std::vector<glm::dvec2> line{{0, 0}, {100, 0}};
    EXPECT_EQ(structureOf(line, {{"barrier", "wall"}}, 1)->kind, StructureKind::wall);
    EXPECT_EQ(structureOf(line, {{"barrier", "wall"}, {"height", "2.5"}}, 1)->heightM, 2.5);
    EXPECT_EQ(structureOf(line, {{"barrier", "fence"}}, 1)->kind, StructureKind::fence);
    EXPECT_EQ(structureOf(line, {{"power", "line"}, {"voltage", "380000"}}, 1)->heightM, 48.0);
    EXPECT_EQ(structureOf(line, {{"power", "minor_line"}}, 1)->kind, StructureKind::poleLine);
    EXPECT_TRUE(structureOf(line, {{"railway", "rail"}, {"bridge", "yes"}, {"layer", "1"}}, 1)->isBridge);
    EXPECT_EQ(structureOf({{5, 5}}, {{"generator:source", "wind"}}, 1)->kind, StructureKind::windTurbine);
    EXPECT_FALSE(structureOf(line, {{"railway", "rail"}, {"tunnel", "yes"}}, 1));
    EXPECT_FALSE(structureOf(line, {{"power", "cable"}, {"location", "underground"}}, 1));
    EXPECT_FALSE(structureOf(line, {{"railway", "abandoned"}}, 1));
    EXPECT_FALSE(structureOf(line, {{"barrier", "hedge"}}, 1)) << "hedges are plants";
    EXPECT_FALSE(structureOf({{5, 5}}, {{"power", "tower"}}, 1));
}

TEST(Structures, BoxesLookOutwards)
{
    Facets facets;
    scenery::Beams beams(facets, {0, 0, 0});
    beams.box({0, 0, 5}, {0.6, 0.8}, {2.0, 1.0, 0.5});
    // Without its bottom: the other sides, seen from a point of the bottom, enclose all of it.
    for (glm::vec3& position : facets.positions)
        position.z -= 4.5F;
    EXPECT_NEAR(turnedVolume(facets), 6.0 * 4.0 * 2.0 * 1.0, 1e-3);
    for (std::size_t i = 0; i + 2 < facets.indices.size(); i += 3)
        std::swap(facets.indices[i], facets.indices[i + 1]);
    EXPECT_LT(turnedVolume(facets), 0.0);
}

TEST(Structures, AWallStandsInTheGroundAndAsHighAsItIs)
{
    Structure wall;
    wall.line = {{0, 0}, {90, 30}, {120, -40}};
    wall.heightM = 2.0;
    std::size_t beyond = 0;
    const auto [low, high] = heightsOf(scenery::structureFacets({&wall, 1}, slope, beyond));
    EXPECT_EQ(beyond, 0u);
    EXPECT_NEAR(high, 2.0, 0.1);
    EXPECT_NEAR(low, -0.4, 0.1);
}

TEST(Structures, EveryKindIsBuiltAndThoseBeyondTheGroundAreCounted)
{
    for (const StructureKind kind :
         {StructureKind::wall, StructureKind::fence, StructureKind::powerLine, StructureKind::poleLine,
          StructureKind::railway, StructureKind::windTurbine})
    {
        Structure made;
        made.kind = kind;
        made.heightM = kind == StructureKind::windTurbine ? 95.0 : 10.0;
        made.hasWire = true;
        made.line = {{0, 0}, {130, 0}};
        if (kind == StructureKind::windTurbine) made.line.resize(1);
        std::size_t beyond = 0;
        const auto squares = scenery::structureFacets({&made, 1}, slope, beyond);
        EXPECT_GT(trianglesOf(squares), 20u) << static_cast<int>(kind);
        EXPECT_EQ(beyond, 0u);
        EXPECT_GT(heightsOf(squares).first, -3.0) << "nothing lies deep in the ground";
        for (glm::dvec2& place : made.line)
            place.x += 9000.0;
        EXPECT_EQ(trianglesOf(scenery::structureFacets({&made, 1}, slope, beyond)), 0u);
        EXPECT_EQ(beyond, 1u);
    }
}

TEST(Structures, ARailwayWithHeightsLiesOnThem)
{
    const auto made = structureOf({{0, 0}, {50, 0}, {100, 0}},
                                  {{"railway", "rail"}, {"heights", "210.00;212.50;215.00"}}, 1);
    ASSERT_TRUE(made);
    ASSERT_EQ(made->heightsM.size(), 3u);
    std::size_t beyond = 0;
    const auto level = [](const glm::dvec2&) { return std::optional(200.0); };
    double low = 1e9, high = -1e9;
    for (const auto& [number, square] : scenery::structureFacets({&*made, 1}, level, beyond))
        for (const glm::vec3& position : square.low.positions)
        {
            low = std::min(low, square.origin.z + position.z);
            high = std::max(high, square.origin.z + position.z);
        }
    EXPECT_NEAR(low, 209.7, 0.01); // a bed of 0.3 m below the formation
    EXPECT_NEAR(high, 215.55, 0.05);
    for (const char* wrong : {"210;212", "210;212;215;216", "210;up;215", "210,212,215"})
        EXPECT_TRUE(structureOf({{0, 0}, {50, 0}, {100, 0}}, {{"railway", "rail"}, {"heights", wrong}}, 1)
                        ->heightsM.empty())
            << wrong;
}

TEST(Structures, ATunnelOfARailwayHasATubeWithPortalsThatTakesTheGround)
{
    const scenery::StructureTags tags{
        {"railway", "rail"}, {"tunnel", "yes"}, {"heights", "190;190;190"}, {"portals", "start"}};
    const auto made = structureOf({{0, 0}, {50, 0}, {100, 0}}, tags, 1);
    ASSERT_TRUE(made);
    EXPECT_TRUE(made->isTunnel && made->isPortalAtStart);
    EXPECT_FALSE(made->isPortalAtEnd);
    std::size_t beyond = 0;
    const auto level = [](const glm::dvec2&) { return std::optional(200.0); };
    double high = -1e9, front = 1e9, left = -1e9, right = 1e9;
    for (const auto& [number, square] : scenery::structureFacets({&*made, 1}, level, beyond))
        for (const Facets* part : {&square.low})
            for (const glm::vec3& position : part->positions)
            {
                high = std::max(high, square.origin.z + position.z);
                front = std::min(front, square.origin.x + position.x);
                left = std::max(left, square.origin.y + position.y);
                right = std::min(right, square.origin.y + position.y);
            }
    EXPECT_NEAR(high, 198.0, 0.5) << "a portal";
    EXPECT_NEAR(left, 4.6, 0.01) << "as wide on both sides";
    EXPECT_NEAR(right, -4.6, 0.01);
    EXPECT_NEAR(front, -0.8, 0.01) << "before the first point";
    const auto openings = scenery::railOpenings({&*made, 1});
    ASSERT_EQ(openings.size(), 1u);
    EXPECT_EQ(openings[0].line.size(), 4u);
    EXPECT_GT(openings[0].roofM(0.0), 6.0) << "room for a wire";
    auto open = tags;
    open["tunnel"] = "no";
    const auto onGround = structureOf({{0, 0}, {50, 0}, {100, 0}}, open, 1);
    EXPECT_TRUE(scenery::railOpenings({&*onGround, 1}).empty());
}

TEST(Structures, AFootbridgeHasADeckRailingsAndPiersAndARampIsSolid)
{
    const auto bridge =
        structureOf({{0, 0}, {20, 0}},
                    {{"kind", "footbridge"}, {"width", "3"}, {"heights", "205;205"}, {"piers", "10"}}, 1);
    const auto ramp =
        structureOf({{0, 0}, {20, 0}}, {{"kind", "footramp"}, {"width", "3"}, {"heights", "205;205"}}, 1);
    ASSERT_TRUE(bridge && ramp);
    EXPECT_EQ(bridge->piersM, std::vector{10.0});
    const auto level = [](const glm::dvec2&) { return std::optional(200.0); };
    const auto span = [&](const Structure& made, double eastM)
    {
        std::size_t beyond = 0;
        double low = 1e9, high = -1e9;
        for (const auto& [number, square] : scenery::structureFacets({&made, 1}, level, beyond))
            for (const glm::vec3& position : square.low.positions)
                if (std::fabs(square.origin.x + position.x - eastM) < 1.0)
                {
                    low = std::min(low, square.origin.z + position.z);
                    high = std::max(high, square.origin.z + position.z);
                }
        return std::pair(low, high);
    };
    EXPECT_NEAR(span(*bridge, 0.0).first, 204.5, 0.01) << "a deck";
    EXPECT_NEAR(span(*bridge, 0.0).second, 206.13, 0.02) << "the bar of a railing";
    EXPECT_LT(span(*bridge, 10.0).first, 199.5) << "a pier";
    EXPECT_LT(span(*ramp, 0.0).first, 199.5);
    EXPECT_FALSE(structureOf({{0, 0}, {20, 0}}, {{"kind", "footbridge"}, {"heights", "205"}}, 1));
}

TEST(Structures, StairsHaveTreadsDownTheirWay)
{
    const auto heightsOf = [](const char* treads)
    {
        const auto made =
            structureOf({{0, 0}, {3, 0}, {3, 3}},
                        {{"kind", "footramp"}, {"heights", "202;201;200"}, {"treads", treads}}, 1);
        std::set<int> levelsCm; ///< of level faces above the ground
        std::size_t beyond = 0;
        const auto level = [](const glm::dvec2&) { return std::optional(200.0); };
        for (const auto& [number, square] : scenery::structureFacets({&*made, 1}, level, beyond))
            for (std::size_t i = 0; i < square.low.positions.size(); ++i)
                if (square.low.normals[i].z > 0.99F && square.low.positions[i].z + square.origin.z < 202.5)
                    levelsCm.insert(
                        static_cast<int>(std::lround(100.0 * (square.low.positions[i].z + square.origin.z))));
        return levelsCm;
    };
    EXPECT_EQ(heightsOf("8"), (std::set<int>{20000, 20025, 20050, 20075, 20100, 20125, 20150, 20175}));
    EXPECT_TRUE(heightsOf("0").empty()) << "a ramp";
    EXPECT_TRUE(heightsOf("-8").empty());
    EXPECT_TRUE(heightsOf("1e9").empty());
}

TEST(Structures, RailsInAStreetHaveNeitherBedNorSleepers)
{
    const scenery::StructureTags tags{{"railway", "tram"}, {"heights", "200;200"}};
    auto embedded = tags;
    embedded["embedded"] = "yes";
    std::size_t beyond = 0;
    const auto level = [](const glm::dvec2&) { return std::optional(200.5); };
    const auto count = [&](const scenery::StructureTags& of)
    {
        const auto made = structureOf({{0, 0}, {20, 0}}, of, 1);
        return trianglesOf(scenery::structureFacets({&*made, 1}, level, beyond));
    };
    EXPECT_EQ(count(embedded), 20u) << "two rails";
    EXPECT_GT(count(tags), 200u);
}

TEST(Structures, ARailwayBridgeIsStraight)
{
    Structure bridge;
    bridge.kind = StructureKind::railway;
    bridge.isBridge = true;
    bridge.line = {{0, 0}, {100, 0}};
    const auto gorge = [](const glm::dvec2& plan) -> std::optional<double>
    { return 200.0 - 0.02 * plan.x * (100.0 - plan.x); };
    std::size_t beyond = 0;
    double low = 1e9;
    for (const auto& [number, square] : scenery::structureFacets({&bridge, 1}, gorge, beyond))
        for (const glm::vec3& position : square.low.positions)
            low = std::min(low, square.origin.z + position.z);
    EXPECT_NEAR(low, 199.1, 0.01);
}
