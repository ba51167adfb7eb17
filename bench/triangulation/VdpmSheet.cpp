// SPDX-License-Identifier: Apache-2.0
// vdpm_sheet DEM FOLDER: draws triangles of view-dependent progressive meshes. FOLDER/vdpm.png, in rows: the
// ground from an eye by VDPM, and by ROAM at the same tolerance; a rock as it is refined for an eye outside
// that draws its front faces, and the same mesh from behind; the rock refined for an eye inside that draws
// its back faces, and the same mesh from outside, on the side that this eye looks at and on the other. Prints
// counts of triangles.
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>

#include <osgPMObjects/core/mesh/Mesh.h>
#include <osgTerrainROAM/core/heightfield/DemImport.h>
#include <osgTerrainROAM/core/roam/RoamMesh.h>
#include <osgTerrainROAM/core/vdpm/HeightFieldForest.h>
#include <osgTerrainROAM/core/vdpm/SurfaceForest.h>
#include <osgTerrainROAM/core/vdpm/VdpmMesh.h>

#include <osgOffscreen/PngFile>

#include "SheetPictures.h"
#include "measurement/view/ContactSheet.h"

namespace
{

using namespace osgTerrainROAM::core;

constexpr int kWidthPx = 800, kHeightPx = 600;
constexpr double kHeightRad = 0.8, kNearM = 0.1, kFarM = 300000.0, kTolerancePx = 2.0;

/// An eye and the point that it looks at.
struct Look
{
    glm::dvec3 eye, at;

    viewlod::ViewState view() const
    {
        return viewlod::ViewState::fromMatrices(
            glm::lookAt(eye, at, glm::dvec3(0, 0, 1)),
            glm::perspective(kHeightRad, double(kWidthPx) / kHeightPx, kNearM, kFarM), kWidthPx, kHeightPx);
    }
};

osg::Vec3d toOsg(const glm::dvec3& v)
{
    return {v.x, v.y, v.z};
}

/// Draws a soup as an eye sees it; `nearM`: what is nearer is cut away.
osg::ref_ptr<osg::Image> pictureOf(const sheet::Soup& soup, const Look& look, double nearM)
{
    const auto viewer = sheet::viewerOn(measurement::drawnTriangles(soup), kWidthPx, kHeightPx);
    viewer->camera().setProjectionMatrixAsPerspective(kHeightRad * 180.0 / 3.14159265358979,
                                                      double(kWidthPx) / kHeightPx, nearM, 4000.0 * nearM);
    viewer->camera().setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    viewer->camera().setViewMatrixAsLookAt(toOsg(look.eye), toOsg(look.at), {0.0, 0.0, 1.0});
    return viewer->picture();
}

sheet::Soup soupOf(const DrawnMesh& mesh)
{
    sheet::Soup soup;
    for (const LeafTriangle& t : mesh.triangles)
        soup.addLit(toOsg(mesh.position(t.vertices[0])), toOsg(mesh.position(t.vertices[1])),
                    toOsg(mesh.position(t.vertices[2])));
    return soup;
}

sheet::Soup soupOf(const BoundedForest& forest, const ActiveFront& front)
{
    sheet::Soup soup;
    for (std::uint32_t slot = 0; slot < front.faceCount(); ++slot)
    {
        const auto& corners = front.faceAt(slot).corners;
        const auto at = [&](int i) { return toOsg(forest.positions[front.vertexAt(corners[i])]); };
        soup.addLit(at(0), at(1), at(2));
    }
    return soup;
}

using Files = std::vector<std::filesystem::path>;

void drawGround(const std::string& dem, const std::filesystem::path& folder, Files& files)
{
    auto field = importDem(dem);
    if (!field) sheet::endWith(field.error().message());
    const auto tile = std::make_shared<const RoamTile>(PlacedTile(std::move(*field), Placement::planar));
    auto forest = heightFieldForest(tile->tile);
    if (!forest) sheet::endWith(forest.error().message());
    const PlacedTile& placed = tile->tile;
    const int column = placed.field().columns * 3 / 10, row = placed.field().rows * 3 / 10;
    const glm::dvec3 ground = placed.position(column, row);
    const double cell = placed.field().spacingEastM;
    const Look look{ground + glm::dvec3(0, 0, 8.0 * cell),
                    ground + glm::dvec3(60.0 * cell, 60.0 * cell, -6.0 * cell)};
    VdpmMesh vdpm(tile, std::make_shared<const BoundedForest>(std::move(*forest)));
    RoamMesh roam(tile);
    for (TerrainMesh* const mesh : {static_cast<TerrainMesh*>(&vdpm), static_cast<TerrainMesh*>(&roam)})
    {
        const char* const name = mesh == &vdpm ? "ground-vdpm" : "ground-roam";
        std::printf("%s: %u triangles\n", name,
                    mesh->refine(look.view(), {.errorTolerancePx = kTolerancePx}).triangles);
        sheet::write(*pictureOf(soupOf(mesh->drawn()), look, 0.2 * cell),
                     folder / (std::string(name) + ".png"), files);
    }
}

/// A closed rock of about 20 m with bumps of several sizes: an octahedron whose faces are cut into grids, on
/// a ball.
osgPMObjects::core::Mesh rock()
{
    constexpr int kColumns = 160, kRows = 80;
    osgPMObjects::core::Mesh mesh;
    const auto place = [](double turn, double height)
    {
        const glm::dvec3 d(std::cos(height) * std::cos(turn), std::cos(height) * std::sin(turn),
                           std::sin(height));
        return d *
               (10.0 + 1.1 * std::sin(4.0 * d.x + 1.0) * std::cos(5.0 * d.y) +
                0.3 * std::sin(17.0 * d.z) * std::cos(13.0 * d.x) + 0.1 * std::sin(41.0 * d.y + 9.0 * d.z));
    };
    for (int row = 1; row < kRows; ++row)
        for (int column = 0; column < kColumns; ++column)
            mesh.positions.push_back(place(6.283185307179586 * column / kColumns,
                                           3.141592653589793 * (double(row) / kRows - 0.5)));
    const auto south = static_cast<std::uint32_t>(mesh.positions.size()), north = south + 1;
    mesh.positions.push_back(place(0.0, -1.5707963267948966));
    mesh.positions.push_back(place(0.0, 1.5707963267948966));
    const auto at = [](int row, int column)
    { return static_cast<std::uint32_t>((row - 1) * kColumns + column % kColumns); };
    for (std::uint32_t v = 0; v < mesh.positions.size(); ++v)
        mesh.wedgePositions.push_back(v);
    const auto face = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        mesh.faces.push_back({{a, b, c}, 0, 0});
    };
    mesh.materials.resize(1);
    mesh.parts.resize(1);
    for (int column = 0; column < kColumns; ++column)
    {
        face(south, at(1, column + 1), at(1, column));
        face(north, at(kRows - 1, column), at(kRows - 1, column + 1));
        for (int row = 1; row + 1 < kRows; ++row)
        {
            face(at(row, column), at(row, column + 1), at(row + 1, column + 1));
            face(at(row, column), at(row + 1, column + 1), at(row + 1, column));
        }
    }
    return mesh;
}

void drawRock(const std::filesystem::path& folder, Files& files)
{
    auto forest = surfaceForest(rock());
    if (!forest) sheet::endWith(forest.error().message());
    FrontDriver driver(*forest);
    const auto refine = [&](const Look& look, VisibleSides sides, const char* name)
    {
        viewlod::Slice unlimited({});
        RefineResult result;
        driver.refine(SplitCriterion(look.view(), kTolerancePx, {.inFrustum = true, .sides = sides}), ~0u,
                      unlimited, result);
        std::printf("%s: %u of %zu triangles\n", name, driver.front().faceCount(), rock().faces.size());
    };
    const auto draw = [&](const Look& look, const char* name)
    { sheet::write(*pictureOf(soupOf(*forest, driver.front()), look, kNearM), folder / name, files); };
    const Look outside{{28.0, -8.0, 9.0}, {}};
    refine(outside, VisibleSides::front, "rock from outside");
    draw(outside, "outside.png");
    draw({-outside.eye, {}}, "outside-from-behind.png");
    const Look inside{{-4.0, 0.0, 0.0}, {10.0, 0.0, 0.0}};
    refine(inside, VisibleSides::back, "rock from inside");
    draw(inside, "inside.png");
    draw({{26.0, -12.0, 6.0}, {}}, "inside-from-outside.png");
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 3)
    {
        std::fprintf(stderr, "usage: vdpm_sheet DEM FOLDER\n");
        return 2;
    }
    const std::filesystem::path folder = argv[2];
    std::filesystem::create_directories(folder);
    Files files;
    drawGround(argv[1], folder, files);
    drawRock(folder, files);
    const auto made = measurement::makeContactSheet(files, {2, 3, 1600, 4});
    if (!made || !osgOffscreen::writePng(**made, folder / "vdpm.png")) sheet::endWith("no sheet");
    return 0;
}
