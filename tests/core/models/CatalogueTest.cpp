// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/Catalogue.h"

#include <algorithm>
#include <map>
#include <set>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <osgPMObjects/core/mesh/MeshCounts.h>
#include <osgPMObjects/core/mesh/Wedge.h>

#include "scenery/models/ModelCheck.h"

namespace core = osgPMObjects::core;
using namespace scenery::models;

namespace
{

constexpr std::uint64_t kSeeds = 12;

/// The parts that are not closed bodies.
const std::set<std::string> kOpenParts{"foliage", "walls",         "windows", "doors",
                                       "dormer",  "dormer window", "stripe"};

bool isSame(const Model& a, const Model& b)
{
    return a.mesh.positions == b.mesh.positions && a.mesh.wedgePositions == b.mesh.wedgePositions &&
           a.mesh.normals == b.mesh.normals && a.mesh.texCoords == b.mesh.texCoords &&
           a.mesh.colours == b.mesh.colours && a.mesh.faces == b.mesh.faces &&
           a.mesh.materials == b.mesh.materials && a.surfaces == b.surfaces;
}

double volumeOf(const core::Mesh& mesh, const std::string& part)
{
    double volume = 0.0;
    for (const core::Face& face : mesh.faces)
        if (mesh.parts[face.part].name == part)
            volume += glm::dot(mesh.at(face, 0), glm::cross(mesh.at(face, 1), mesh.at(face, 2))) / 6.0;
    return volume;
}

bool isTree(Kind kind)
{
    return kind <= Kind::bush;
}

bool isVehicle(Kind kind)
{
    return kind >= Kind::saloon;
}

template<class Check>
void forEachModel(const Check& check)
{
    for (const KindFacts& facts : kinds())
        for (std::uint64_t seed = 0; seed < kSeeds; ++seed)
        {
            SCOPED_TRACE(std::string(facts.name) + ", seed " + std::to_string(seed));
            check(facts, generate(facts.kind, seed));
        }
}

} // namespace

TEST(Catalogue, FactsStandInTheOrderOfKinds)
{
    for (const KindFacts& facts : kinds())
        EXPECT_EQ(&factsOf(facts.kind), &facts);
}

TEST(Catalogue, EveryModelIsOne)
{
    forEachModel([](const KindFacts&, const Model& model) { EXPECT_EQ(defectOf(model), ""); });
}

TEST(Catalogue, SizesAreAsSaid)
{
    forEachModel(
        [](const KindFacts& facts, const Model& model)
        {
            EXPECT_GE(model.heightM, facts.leastHeightM);
            EXPECT_LE(model.heightM, facts.mostHeightM);
            EXPECT_LE(model.radiusM, facts.mostRadiusM);
        });
}

TEST(Catalogue, ModelsStandOnTheGround)
{
    forEachModel(
        [](const KindFacts& facts, const Model& model)
        {
            // Vehicles stand on their wheels, trees reach into the ground with their roots, houses with their
            // plinths.
            const double wanted = isVehicle(facts.kind) ? 0.0 : isTree(facts.kind) ? 0.4 : 1.0;
            EXPECT_NEAR(model.foundationM, wanted, isTree(facts.kind) ? 0.05 : 0.002);
        });
}

TEST(Catalogue, TrianglesKeepToTheirBudget)
{
    forEachModel(
        [](const KindFacts& facts, const Model& model)
        {
            const std::size_t least = facts.kind == Kind::helicopter                ? 2000
                                      : isTree(facts.kind) || isVehicle(facts.kind) ? 3000
                                                                                    : 400;
            const std::size_t most = isVehicle(facts.kind) ? 10000 : 15000;
            EXPECT_GE(model.mesh.faces.size(), least);
            EXPECT_LE(model.mesh.faces.size(), most);
            EXPECT_LE(model.mesh.materials.size(), 3U);
        });
}

TEST(Catalogue, BodiesAreClosedAndLookOutwards)
{
    forEachModel(
        [](const KindFacts&, const Model& model)
        {
            std::set<std::string> bodies;
            for (const core::Face& face : model.mesh.faces)
                if (!kOpenParts.contains(model.mesh.parts[face.part].name))
                    bodies.insert(model.mesh.parts[face.part].name);
            EXPECT_FALSE(bodies.empty());
            for (const std::string& body : bodies)
            {
                EXPECT_TRUE(isClosed(model.mesh, body)) << body;
                EXPECT_GT(volumeOf(model.mesh, body), 0.0) << body;
            }
        });
}

TEST(Catalogue, WallsMeetWithoutTJunctions)
{
    for (const Kind kind :
         {Kind::familyHouse, Kind::townHouses, Kind::barn, Kind::hall, Kind::saloon, Kind::van, Kind::bus})
        for (std::uint64_t seed = 0; seed < kSeeds; ++seed)
            EXPECT_EQ(core::countMesh(generate(kind, seed).mesh).tJunctions, 0U)
                << factsOf(kind).name << seed;
}

TEST(Catalogue, AnEdgeThatIsCutOnOneSideOnlyWouldBeFound)
{
    core::Mesh mesh = generate(Kind::barn, 1).mesh;
    // A corner moves to the middle of an edge, while the neighbour keeps the whole edge: a T-junction.
    for (std::size_t i = 0; i < 40; ++i)
    {
        core::Face& face = mesh.faces[i];
        ASSERT_EQ(mesh.parts[face.part].name, "walls");
        const auto added = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.push_back(0.5 * (mesh.at(face, 0) + mesh.at(face, 1)));
        core::Wedge middle = core::wedgeOf(mesh, face.wedges[0]);
        middle.position = added;
        face.wedges[0] = core::appendWedge(mesh, middle);
    }
    EXPECT_GT(core::countMesh(mesh).tJunctions, 0U);
}

TEST(Catalogue, ASeedIsAModelAndAnotherSeedAnother)
{
    for (const KindFacts& facts : kinds())
    {
        SCOPED_TRACE(facts.name);
        const Model once = generate(facts.kind, 7);
        EXPECT_TRUE(isSame(once, generate(facts.kind, 7)));
        EXPECT_FALSE(isSame(once, generate(facts.kind, 8)));
    }
}

TEST(Catalogue, SeedsShareTheirPictures)
{
    for (const KindFacts& facts : kinds())
    {
        SCOPED_TRACE(facts.name);
        std::set<Painting> paintings;
        for (std::uint64_t seed = 0; seed < kSeeds; ++seed)
            for (const Surface& surface : generate(facts.kind, seed).surfaces)
                paintings.insert(surface.painting);
        EXPECT_LE(paintings.size(), 4U);
    }
}
