// SPDX-License-Identifier: Apache-2.0
#include <foundation/Angle.h>
#include <gtest/gtest.h>

#include <osgPMObjects/core/bake/BakeMaps.h>

#include "MadeMeshes.h"
#include "RoundMeshes.h"
#include "core/bake/TexelOwners.h"

namespace
{

using namespace osgPMObjects::core;
using testsupport::meshOf;

constexpr double kDegrees = foundation::degreesOf(1.0);

Atlas atlasOf(const Mesh& mesh, int sizePx)
{
    auto atlas = packCharts(mesh, makeCharts(mesh), {.sizePx = sizePx});
    EXPECT_TRUE(atlas) << atlas.error().message();
    return atlas ? *atlas : Atlas();
}

ColourAt one(const glm::vec4& colour)
{
    return [colour](std::uint32_t, const glm::dvec3&, std::uint32_t) { return colour; };
}

/// Calls `look` for every texel with its centre in a face: with the face, and with the centre's position on
/// it.
template<class Look>
void forEachCovered(const Mesh& mesh, const Atlas& atlas, const Look& look)
{
    const TexelOwners owners = texelOwners(mesh, atlas);
    std::size_t covered = 0;
    for (std::size_t i = 0; i < owners.faces.size(); ++i)
    {
        if (owners.faces[i] == TexelOwners::kNone) continue;
        const auto size = static_cast<std::size_t>(atlas.sizePx);
        const glm::dvec2 centre(static_cast<double>(i % size) + 0.5, static_cast<double>(i / size) + 0.5);
        const std::uint32_t f = owners.faces[i];
        const glm::dvec3 w = weightsAt(inAtlas(mesh, atlas, f), centre);
        const Face& face = mesh.faces[f];
        const glm::dvec3 p = w.x * mesh.at(face, 0) + w.y * mesh.at(face, 1) + w.z * mesh.at(face, 2);
        if (glm::length(atlas.texelOf(f, p) - centre) > 1e-4) continue; // beside it
        ++covered;
        look(i, f, p);
    }
    EXPECT_NEAR(static_cast<double>(covered), static_cast<double>(owners.covered), 4.0); // on a border
}

/// The sphere with eight columns and four rows: 48 triangles, without normals of its own.
Mesh coarseBall()
{
    Mesh mesh = testsupport::roundMesh(8, 4, testsupport::onSphere);
    mesh.normals.clear();
    mesh.materials[0].attributes = Material::texCoord0;
    return mesh;
}

/// Returns the largest angle between a baked normal and the sphere's, in degrees.
double worstNormal(const Mesh& full, const Mesh& simplified)
{
    const Atlas atlas = atlasOf(simplified, 256);
    const BakedMaps maps = bakeMaps(full, simplified, atlas, one(glm::vec4(1.0f)));
    double worst = 0.0;
    forEachCovered(simplified, atlas,
                   [&](std::size_t i, std::uint32_t f, const glm::dvec3& p)
                   {
                       const Face& face = simplified.faces[f];
                       const glm::dvec3 n =
                           glm::normalize(glm::cross(simplified.at(face, 1) - simplified.at(face, 0),
                                                     simplified.at(face, 2) - simplified.at(face, 0)));
                       // The intersection of the face's normal with the unit sphere.
                       const double b = glm::dot(p, n), t = -b + std::sqrt(b * b + 1.0 - glm::dot(p, p));
                       const Rgb& c = maps.normals[i];
                       const glm::dvec3 baked = glm::normalize(glm::dvec3(c[0], c[1], c[2]) / 127.5 - 1.0);
                       worst =
                           std::max(worst, kDegrees * std::acos(std::min(1.0, glm::dot(baked, p + t * n))));
                   });
    return worst;
}

TEST(BakeMaps, NormalsOfASphereStandOnACoarseOne)
{
    // Half a degree of it is by eight bits, the rest by the texel's extent and the facets of the full sphere.
    EXPECT_LT(worstNormal(testsupport::roundMesh(96, 48, testsupport::onSphere), coarseBall()), 2.0);
}

TEST(BakeMapsMutation, NormalsOfAnotherSurfaceAreSeen)
{
    const auto squeezed = [](double u, double v)
    { return testsupport::onSphere(u, v) * glm::dvec3(1.0, 1.0, 0.8); };
    EXPECT_GT(worstNormal(testsupport::roundMesh(96, 48, squeezed), coarseBall()), 5.0);
}

/// Squares of side 1 in the plane, black and white.
float checker(const glm::dvec3& p)
{
    return (static_cast<int>(std::floor(p.x)) + static_cast<int>(std::floor(p.y))) % 2 == 0 ? 0.0f : 1.0f;
}

/// Returns the number of texels, farther than one from a border of squares, that do not have the colour of
/// their square.
std::size_t wrongSquares(const glm::dvec3& shift)
{
    const Mesh full = testsupport::grid(16, 16);
    const Mesh simplified = meshOf({{0.0, 0.0, 0.0}, {16.0, 0.0, 0.0}, {16.0, 16.0, 0.0}, {0.0, 16.0, 0.0}},
                                   {{0, 1, 2}, {0, 2, 3}});
    const Atlas atlas = atlasOf(simplified, 256);
    const BakedMaps maps = bakeMaps(full, simplified, atlas,
                                    [&](std::uint32_t f, const glm::dvec3& w, std::uint32_t)
                                    {
                                        const Face& face = full.faces[f];
                                        const glm::dvec3 p = w.x * full.at(face, 0) + w.y * full.at(face, 1) +
                                                             w.z * full.at(face, 2);
                                        return glm::vec4(glm::vec3(checker(p + shift)), 1.0f);
                                    });
    std::size_t wrong = 0, looked = 0;
    forEachCovered(simplified, atlas,
                   [&](std::size_t i, std::uint32_t, const glm::dvec3& p)
                   {
                       const glm::dvec2 toBorder = glm::abs(glm::dvec2(p) - glm::round(glm::dvec2(p)));
                       if (std::min(toBorder.x, toBorder.y) * atlas.texelsPerUnit < 1.0) return;
                       ++looked;
                       if (maps.colours[i][0] != (checker(p) > 0.5f ? 255 : 0)) ++wrong;
                   });
    EXPECT_GT(looked, 20000u);
    EXPECT_EQ(maps.unmatchedTexels, 0u);
    return wrong;
}

TEST(BakeMaps, ColoursStandWhereTheyAreOnTheFullModel)
{
    EXPECT_EQ(wrongSquares({0.0, 0.0, 0.0}), 0u);
}

TEST(BakeMapsMutation, ColoursElsewhereAreSeen)
{
    EXPECT_GT(wrongSquares({0.2, 0.0, 0.0}), 1000u);
}

/// A square plate of side 1 whose sides are 0.01 apart, faces 0 and 1 up, 2 and 3 down.
Mesh plate(double height)
{
    std::vector<glm::dvec3> corners;
    for (const double z : {height + 0.01, height})
        for (const auto& [x, y] : {std::pair(0.0, 0.0), {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}})
            corners.emplace_back(x, y, z);
    return meshOf(corners, {{0, 1, 2}, {0, 2, 3}, {4, 6, 5}, {4, 7, 6}});
}

/// Returns the number of texels of the upper side that show the lower one, or the reverse. The upper side is
/// red.
std::size_t wrongSides(const Mesh& simplified, double reach = 0.0)
{
    const Mesh full = plate(0.0);
    const Atlas atlas = atlasOf(simplified, 128);
    const BakedMaps maps = bakeMaps(full, simplified, atlas,
                                    [](std::uint32_t f, const glm::dvec3&, std::uint32_t)
                                    { return f < 2 ? glm::vec4(1, 0, 0, 1) : glm::vec4(0, 1, 0, 1); },
                                    {.reach = reach});
    std::size_t wrong = 0;
    forEachCovered(
        simplified, atlas,
        [&](std::size_t i, std::uint32_t f, const glm::dvec3&) {
            wrong += maps.colours[i] != (f < 2 ? Rgba{255, 0, 0, 255} : Rgba{0, 255, 0, 255}) ? 1 : 0;
        });
    return wrong;
}

TEST(BakeMaps, AThinWallDoesNotShowItsOtherSide)
{
    EXPECT_EQ(wrongSides(plate(0.0)), 0u);
    EXPECT_EQ(wrongSides(plate(0.008)), 0u) << "the lower side lies where the upper one was";
}

TEST(BakeMapsMutation, AWallTurnedInsideOutShowsItsOtherSide)
{
    Mesh turned = plate(0.0);
    for (Face& face : turned.faces)
        std::swap(face.wedges[1], face.wedges[2]);
    EXPECT_GT(wrongSides(turned, 0.1), 1000u);
}

/// Returns the number of texels of a plate's map that show a sign in front of it, a part of its own.
std::size_t texelsOfSign(bool isSignThere)
{
    Mesh full = testsupport::grid(1, 1);
    full.parts.push_back({"sign"});
    const auto first = static_cast<std::uint32_t>(full.positions.size());
    for (const glm::dvec3& p : {glm::dvec3(0.2, 0.2, 0.01), {0.8, 0.2, 0.01}, {0.2, 0.8, 0.01}})
    {
        full.wedgePositions.push_back(static_cast<std::uint32_t>(full.positions.size()));
        full.positions.push_back(p);
    }
    Mesh simplified = full;
    full.faces.push_back({{first, first + 1, first + 2}, 0, 1});
    simplified.faces.push_back(full.faces.back());
    for (std::uint32_t i = 0; i < first; ++i) // the plate moves to the position of the sign
        simplified.positions[i].z = 0.009;
    if (!isSignThere) simplified.faces.pop_back();
    const Atlas atlas = atlasOf(simplified, 128);
    const BakedMaps maps = bakeMaps(full, simplified, atlas,
                                    [](std::uint32_t f, const glm::dvec3&, std::uint32_t)
                                    { return f < 2 ? glm::vec4(0, 0, 0, 1) : glm::vec4(1); });
    std::size_t texels = 0;
    forEachCovered(simplified, atlas,
                   [&](std::size_t i, std::uint32_t f, const glm::dvec3&)
                   { texels += f < 2 && maps.colours[i][0] == 255 ? 1 : 0; });
    return texels;
}

TEST(BakeMaps, APartThatIsStillThereIsNotPaintedOnOthers)
{
    EXPECT_EQ(texelsOfSign(true), 0u);
}

TEST(BakeMaps, APartThatIsGoneIsPaintedWhereItWas)
{
    EXPECT_GT(texelsOfSign(false), 500u);
}

/// Returns the number of texels that mipmap level `levels` reads for a covered texel and that do not have its
/// colour.
std::size_t bleeding(int gutterPx, int levels)
{
    const Mesh mesh = testsupport::cube();
    auto atlas = packCharts(mesh, makeCharts(mesh), {.sizePx = 128, .gutterPx = gutterPx});
    EXPECT_TRUE(atlas);
    const BakedMaps maps = bakeMaps(mesh, mesh, *atlas,
                                    [](std::uint32_t f, const glm::dvec3&, std::uint32_t)
                                    { return glm::vec4(static_cast<float>(f / 2 + 1) / 8.0f, 0, 0, 1); });
    std::size_t wrong = 0;
    const std::size_t block = std::size_t(1) << levels;
    forEachCovered(mesh, *atlas,
                   [&](std::size_t i, std::uint32_t, const glm::dvec3&)
                   {
                       const std::size_t x = i % 128 / block * block, y = i / 128 / block * block;
                       for (std::size_t v = y; v < y + block; ++v)
                           for (std::size_t u = x; u < x + block; ++u)
                               wrong += maps.colours[v * 128 + u] != maps.colours[i] ? 1 : 0;
                   });
    return wrong;
}

TEST(BakeMaps, SmallerCopiesDoNotBleedAsFarAsTheGutterReaches)
{
    EXPECT_EQ(bleeding(1, 1), 0u);
    EXPECT_EQ(bleeding(2, 2), 0u);
    EXPECT_EQ(bleeding(4, 3), 0u);
}

TEST(BakeMapsMutation, ANarrowGutterBleeds)
{
    EXPECT_GT(bleeding(1, 4), 0u);
}

TEST(BakeMaps, AreTheSameEveryTime)
{
    const Mesh full = testsupport::roundMesh(48, 24, testsupport::onBumps);
    const Mesh simplified = testsupport::roundMesh(12, 6, testsupport::onBumps);
    const Atlas atlas = atlasOf(simplified, 128);
    const BakedMaps a = bakeMaps(full, simplified, atlas, one(glm::vec4(0.5f)));
    const BakedMaps b = bakeMaps(full, simplified, atlas, one(glm::vec4(0.5f)));
    EXPECT_EQ(a.colours, b.colours);
    EXPECT_EQ(a.normals, b.normals);
}

} // namespace
