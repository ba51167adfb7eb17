// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include <foundation/Earth.h>
#include <gtest/gtest.h>

#include <osgMultiTriangulation/core/check/SurfaceCheck.h>
#include <osgMultiTriangulation/core/file/BuildMtFile.h>
#include <osgMultiTriangulation/core/input/TinFile.h>
#include <osgMultiTriangulation/core/output/QuantizedMeshTile.h>
#include <osgMultiTriangulation/core/output/WriteTin.h>
#include <osgMultiTriangulation/core/structure/ErrorCode.h>
#include <osgMultiTriangulation/core/zone/ExtractFromFile.h>

#include "HillSurface.h"
#include "TestFolder.h"

namespace osgMultiTriangulation::core
{

namespace
{

/// Hills of 80 × 60 points at 10 m, whose south-west corner lies at (500, -200).
struct PlacedHills
{
    testsupport::TestFolder folder{"extract"};
    SurfaceMesh mesh = testsupport::hillSurface(80, 60);
    PlanFrame frame{500.0, -200.0, 10.0, 10.0};
    std::filesystem::path path = folder / "hills.mt";

    PlacedHills()
    {
        ForestOptions options;
        options.treeCount = 8;
        EXPECT_TRUE(buildMtFile(mesh, frame, options, path));
    }

    ExtractedSurface extractAt(double errorM) const
    {
        ExtractRequest request;
        request.errorM = errorM;
        return extract(request);
    }

    ExtractedSurface extract(const ExtractRequest& request) const
    {
        const auto surface = extractFrom(*MtFile::open(path), request);
        EXPECT_TRUE(surface) << surface.error().message();
        return *surface;
    }
};

/// The greatest vertical distance of the points of a surface from another, of those in a rectangle of the
/// lattice.
double worstError(const SurfaceMesh& input, const SurfaceMesh& taken, int west, int south, int east,
                  int north)
{
    double worst = 0.0;
    for (const SurfacePoint& p : input.points)
    {
        if (p.x < west || p.x > east || p.y < south || p.y > north) continue;
        double error = 1e9;
        for (const Triangle& t : taken.triangles)
        {
            const SurfacePoint &a = taken.points[t[0]], &b = taken.points[t[1]], &c = taken.points[t[2]];
            const double u = twiceArea(b, c, p), v = twiceArea(c, a, p), w = twiceArea(a, b, p);
            if (u < 0.0 || v < 0.0 || w < 0.0) continue;
            const double height = (u * a.height + v * b.height + w * c.height) / (u + v + w);
            error = std::min(error, std::abs(height - p.height));
        }
        worst = std::max(worst, error);
    }
    return worst;
}

using Places = std::set<std::tuple<int, int, double>>;

Places pointSetOf(const SurfaceMesh& mesh)
{
    Places places;
    for (const SurfacePoint& p : mesh.points)
        places.emplace(p.x, p.y, p.height);
    return places;
}

TEST(ExtractFromFile, withoutErrorItIsTheInput)
{
    const PlacedHills here;
    const ExtractedSurface all = here.extract({});
    EXPECT_EQ(pointSetOf(all.mesh), pointSetOf(here.mesh));
    EXPECT_EQ(all.mesh.triangles.size(), here.mesh.triangles.size());
    EXPECT_EQ(checkSurface(all.mesh, outlineOf(here.mesh)), std::nullopt);
}

TEST(ExtractFromFile, keepsTheErrorByBruteForce)
{
    const PlacedHills here;
    std::size_t before = here.mesh.triangles.size();
    for (const double error : {0.25, 1.0, 3.0})
    {
        const ExtractedSurface taken = here.extractAt(error);
        EXPECT_EQ(checkSurface(taken.mesh, outlineOf(here.mesh)), std::nullopt);
        EXPECT_LE(worstError(here.mesh, taken.mesh, 0, 0, 79, 59), error);
        EXPECT_GT(worstError(here.mesh, taken.mesh, 0, 0, 79, 59), 0.3 * error) << "it could be coarser";
        EXPECT_LT(taken.mesh.triangles.size(), before);
        before = taken.mesh.triangles.size();
    }
}

TEST(ExtractFromFile, takesTheLeastErrorWithSoManyTriangles)
{
    const PlacedHills here;
    for (const std::size_t most : {200u, 1000u, 4000u})
    {
        ExtractRequest request;
        request.mostTriangles = most;
        const ExtractedSurface taken = here.extract(request);
        EXPECT_LE(taken.mesh.triangles.size(), most);
        const auto code = codeOfError(static_cast<float>(taken.errorM));
        const ExtractedSurface finer = here.extractAt(errorOfCode(static_cast<std::uint16_t>(code - 1)));
        EXPECT_GT(finer.mesh.triangles.size(), most);
    }
    ExtractRequest none;
    none.mostTriangles = 1;
    EXPECT_FALSE(extractFrom(*MtFile::open(here.path), none));
}

TEST(ExtractFromFile, aRegionIsFineAndTheRestCoarse)
{
    const PlacedHills here;
    ExtractRequest request{0.25, 1u << 30, PlanRegion{520.0, -180.0, 650.0, -100.0}}; // 2 … 15, 2 … 10
    const ExtractedSurface part = here.extract(request), all = here.extractAt(0.25);
    EXPECT_EQ(checkSurface(part.mesh, outlineOf(here.mesh)), std::nullopt);
    EXPECT_LE(worstError(here.mesh, part.mesh, 2, 2, 15, 10), 0.25);
    EXPECT_GT(worstError(here.mesh, part.mesh, 0, 0, 79, 59), 2.0) << "elsewhere it is coarse";
    EXPECT_LT(3 * part.mesh.triangles.size(), all.mesh.triangles.size());
    EXPECT_LT(part.trees, all.trees);
}

TEST(ExtractFromFile, aRegionIsInUnitsOfTheReferenceSystem)
{
    PlacedHills here;
    const ExtractRequest inPlan{0.25, 1u << 30, PlanRegion{520.0, -180.0, 650.0, -100.0}}; // 2 … 15, 2 … 10
    const ExtractedSurface wanted = here.extract(inPlan);
    here.frame.reference = PlanReference{"GEOGCS[\"WGS 84\"]", -72.0, 44.0, 0.001, 0.002};
    ForestOptions options;
    options.treeCount = 8;
    ASSERT_TRUE(buildMtFile(here.mesh, here.frame, options, here.path));
    const ExtractRequest inDegrees{0.25, 1u << 30, PlanRegion{-71.998, 44.004, -71.985, 44.02}};
    EXPECT_EQ(here.extract(inDegrees).mesh.triangles, wanted.mesh.triangles);
    EXPECT_NE(here.extract(inPlan).mesh.triangles, wanted.mesh.triangles) << "the control: metres";
}

TEST(ExtractFromFile, filesOfTrianglesTellWhereTheyLie)
{
    const PlacedHills here;
    const SurfaceMesh mesh = here.extractAt(3.0).mesh;
    EXPECT_TRUE(placeLines(here.frame).empty());
    PlanFrame frame = here.frame;
    frame.reference = PlanReference{"GEOGCS[\"WGS 84\",\nX]", -72.0, 44.0, 0.0625, 0.125};
    // By hand: x = 500 at the first point of the lattice, and 10 a step.
    EXPECT_EQ(placeLines(frame),
              (std::vector<std::string>{"reference system: WGS 84",
                                        "place in it: -75.125 + 0.00625 x, 46.5 + 0.0125 y",
                                        "GEOGCS[\"WGS 84\", X]"}));
    for (const char* name : {"t.obj", "t.ply"})
    {
        ASSERT_TRUE(writeTin(here.folder / name, mesh, inReference(frame)));
        EXPECT_NE(testsupport::bytesOf(here.folder / name).find("place in it: 0 + 1 x, 0 + 1 y\n"),
                  std::string::npos)
            << name;
        const auto read = readTinFile(here.folder / name);
        ASSERT_TRUE(read) << read.error().message();
        EXPECT_EQ(read->triangles, mesh.triangles);
        EXPECT_EQ(read->points[0][0], -72.0 + 0.0625 * mesh.points[0].x);
        EXPECT_EQ(read->points[0][1], 44.0 + 0.125 * mesh.points[0].y);
    }
}

TEST(QuantizedMeshTile, isReadBackWithItsPlacesAndHeights)
{
    const PlacedHills here;
    PlanFrame frame = here.frame;
    frame.reference = PlanReference{"GEOGCS[\"WGS 84\",X]", 7.01, 46.01, 0.001, 0.001};
    const SurfaceMesh mesh = here.extractAt(1.0).mesh;
    const auto tile = earthTileOf("10/1064/773"); // 7.03 to 7.21 east, 45.88 to 46.05 north
    ASSERT_TRUE(tile);
    const auto bytes = quantizedMeshOf(mesh, frame, *tile, "hills.mt");
    ASSERT_TRUE(bytes) << bytes.error().message();
    const auto read = parseQuantizedMesh(*bytes, "tile.terrain");
    ASSERT_TRUE(read) << read.error().message();
    const auto placed = placeTin(*read, "tile.terrain");
    ASSERT_TRUE(placed) << placed.error().message();
    EXPECT_EQ(checkInput(placed->mesh), std::nullopt);
    // The readers' plan is metres about the middle of the tile: back to the lattice of the hills.
    const double metresOfDegree = foundation::kWgs84RadiusM * std::numbers::pi / 180.0;
    const double south = tile->south(), west = tile->west(), half = tile->side() / 2.0;
    const double shrinks = std::cos((south + half) * std::numbers::pi / 180.0);
    std::size_t known = 0;
    for (const MeasuredPoint& point : read->points)
    {
        const double column = (west + half + point[0] / (metresOfDegree * shrinks) - 7.01) / 0.001;
        const double row = (south + half + point[1] / metresOfDegree - 46.01) / 0.001;
        const auto at =
            std::ranges::find_if(mesh.points, [&](const SurfacePoint& p)
                                 { return std::abs(p.x - column) < 0.01 && std::abs(p.y - row) < 0.01; });
        if (at == mesh.points.end()) continue; // on a side of the tile
        EXPECT_NEAR(point[2], at->height, 0.01);
        ++known;
    }
    EXPECT_GT(known, 200u);
    EXPECT_LT(known, mesh.points.size()) << "the tile has only a part";
}

TEST(QuantizedMeshTile, fitsTheTileBesideIt)
{
    const PlacedHills here;
    PlanFrame frame = here.frame;
    frame.reference = PlanReference{"GEOGCRS[\"WGS 84\",X]", 7.01, 46.01, 0.001, 0.001};
    const SurfaceMesh mesh = here.extractAt(1.0).mesh;
    std::vector<std::vector<std::array<double, 2>>> sides; // by tile: north and height along the common side
    for (const auto& [name, sign] : {std::pair{"11/2127/1547", 1.0}, {"11/2128/1547", -1.0}})
    {
        const auto tile = earthTileOf(name);
        ASSERT_TRUE(tile) << name;
        const auto bytes = quantizedMeshOf(mesh, frame, *tile, "hills.mt");
        ASSERT_TRUE(bytes) << bytes.error().message();
        const auto read = parseQuantizedMesh(*bytes, name);
        ASSERT_TRUE(read) << read.error().message();
        double farthest = 0.0;
        for (const MeasuredPoint& point : read->points)
            farthest = std::max(farthest, sign * point[0]);
        auto& side = sides.emplace_back();
        for (const MeasuredPoint& point : read->points)
            if (sign * point[0] == farthest) side.push_back({point[1], point[2]});
        std::ranges::sort(side);
    }
    ASSERT_EQ(sides[0].size(), sides[1].size());
    EXPECT_GT(sides[0].size(), 8u);
    for (std::size_t i = 0; i < sides[0].size(); ++i)
    {
        EXPECT_EQ(sides[0][i][0], sides[1][i][0]);
        EXPECT_NEAR(sides[0][i][1], sides[1][i][1], 0.01) << "the rounding of heights";
    }
}

TEST(QuantizedMeshTile, whatIsNoTileOrHasNoGroundIsTold)
{
    for (const char* name : {"", "9", "9/1/2/3", "9/-1/2", "2/1/1", "23/1/1", "9/1024/0", "9/0/512"})
        EXPECT_FALSE(earthTileOf(name)) << name;
    EXPECT_TRUE(earthTileOf("9/1023/511"));
    const PlacedHills here;
    PlanFrame frame = here.frame;
    const auto fails = [&](const char* tile, const char* with)
    {
        const auto bytes = quantizedMeshOf(here.mesh, frame, *earthTileOf(tile), "hills.mt");
        return !bytes && bytes.error().message().find(with) != std::string::npos;
    };
    EXPECT_TRUE(fails("10/1064/773", "degrees")) << "no reference";
    frame.reference = PlanReference{"GEOGCS[\"WGS 84\",X]", 7.01, 46.01, 1e-6, 1e-6};
    EXPECT_TRUE(fails("10/1063/772", "no ground"));
    EXPECT_TRUE(fails("3/8/6", "tell from each other")) << "a tile of 22.5 degrees";
}

TEST(ExtractFromFile, filesOfTrianglesReadBackAlike)
{
    const PlacedHills here;
    PlanFrame frame = here.frame;
    frame.stepX = 0.1;
    const ExtractedSurface taken = here.extractAt(1.0);
    for (const char* name : {"t.obj", "t.ply"})
    {
        ASSERT_TRUE(writeTin(here.folder / name, taken.mesh, frame));
        const auto read = readTinFile(here.folder / name);
        ASSERT_TRUE(read) << read.error().message();
        EXPECT_EQ(read->triangles, taken.mesh.triangles);
        ASSERT_EQ(read->points.size(), taken.mesh.points.size());
        for (std::size_t p = 0; p < read->points.size(); ++p)
        {
            EXPECT_EQ(read->points[p][0], frame.originX + frame.stepX * taken.mesh.points[p].x);
            EXPECT_EQ(read->points[p][1], frame.originY + frame.stepY * taken.mesh.points[p].y);
            EXPECT_EQ(read->points[p][2], taken.mesh.points[p].height);
        }
    }
}

} // namespace

} // namespace osgMultiTriangulation::core
