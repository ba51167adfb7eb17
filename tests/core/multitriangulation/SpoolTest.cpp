// SPDX-License-Identifier: Apache-2.0
// Builds within a limit of memory, from files.
#include <algorithm>
#include <fstream>
#include <map>

#include <gtest/gtest.h>

#include <osgMultiTriangulation/core/check/StructureCheck.h>
#include <osgMultiTriangulation/core/file/BuildMtFile.h>
#include <osgMultiTriangulation/core/file/MtFile.h>
#include <osgMultiTriangulation/core/input/Delaunay.h>
#include <osgMultiTriangulation/core/input/PointDistribution.h>
#include <osgMultiTriangulation/core/input/StripDelaunay.h>
#include <osgMultiTriangulation/core/input/TinFile.h>
#include <osgMultiTriangulation/core/spool/GridSpool.h>
#include <osgMultiTriangulation/core/spool/InputSpool.h>

#include "CheckedForest.h"
#include "HillSurface.h"
#include "Random.h"
#include "TestFolder.h"

namespace osgMultiTriangulation::core
{

namespace
{

SurfaceMesh meshOf(const SurfaceSpool& spool)
{
    SurfaceMesh mesh;
    spool.points().scan([&](std::span<const SurfacePoint> run)
                        { mesh.points.insert(mesh.points.end(), run.begin(), run.end()); });
    spool.triangles().scan([&](std::span<const Triangle> run)
                           { mesh.triangles.insert(mesh.triangles.end(), run.begin(), run.end()); });
    return mesh;
}

SurfaceSpool spoolOf(const SurfaceMesh& mesh, const std::filesystem::path& folder)
{
    SurfaceSpool spool = std::move(*SurfaceSpool::create(folder));
    for (const SurfacePoint& point : mesh.points)
        spool.addPoint(point);
    for (const Triangle& triangle : mesh.triangles)
        spool.addTriangle(triangle);
    EXPECT_TRUE(spool.finish());
    return spool;
}

using testsupport::bytesOf;

Forest forestIn(const std::filesystem::path& path)
{
    const auto file = MtFile::open(path);
    EXPECT_TRUE(file);
    std::vector<ReadTree> trees;
    for (std::uint32_t t = 0; t < file->info().trees.size(); ++t)
    {
        const std::uint32_t parent = file->info().trees[t].parent;
        trees.push_back(*file->read(t, parent == kNone ? nullptr : &trees[parent]));
    }
    Forest forest;
    for (ReadTree& tree : trees)
        forest.trees.push_back(std::move(tree.tree));
    return forest;
}

/// What is wrong with extractions of a file, at several tolerances.
std::optional<std::string> faultOf(const std::filesystem::path& path, const SurfaceMesh& mesh,
                                   float shrunk = 1.0f)
{
    Forest forest = forestIn(path);
    for (ForestTree& tree : forest.trees)
        for (float& error : tree.part.errors)
            error *= shrunk;
    if (shrunk == 1.0f)
        if (auto fault = checkStructure(forest)) return fault;
    const testsupport::CheckedSurface checked(mesh);
    Extraction extraction(forest.trees[0]);
    for (std::uint32_t t = 1; t < forest.trees.size(); ++t)
        extraction.attach(t, forest.trees[t]);
    for (const float tolerance : {40.0f, 10.0f, 3.0f, 0.0f})
    {
        extraction.update([&](const MultiTriangulation& tree, std::uint32_t at)
                          { return tree.errors[at] > tolerance; });
        if (auto fault = checked.fault(extraction)) return fault;
    }
    return std::nullopt;
}

ForestOptions inRectangles(std::uint32_t count, unsigned jobs = 1)
{
    ForestOptions options;
    options.treeCount = count;
    options.jobs = jobs;
    return options;
}

constexpr double kMuchMb = 500.0;

TEST(Spool, aPartWithRoomForAllItsPointsHasTheBytesOfABuildInMemory)
{
    const testsupport::TestFolder folder("mt-spool");
    const SurfaceMesh mesh = testsupport::hillSurface(60, 50);
    ASSERT_TRUE(buildMtFile(mesh, {}, inRectangles(3), folder / "memory.mt"));
    const SurfaceSpool spool = spoolOf(mesh, folder / "");
    ASSERT_TRUE(buildMtFile(spool, {}, inRectangles(3), kMuchMb, folder / "files.mt"));
    EXPECT_EQ(bytesOf(folder / "files.mt"), bytesOf(folder / "memory.mt"));
}

TEST(Spool, fitsItsBordersAsABuildInMemoryDoes)
{
    const testsupport::TestFolder folder("mt-spool");
    const SurfaceMesh mesh = testsupport::hillSurface(900, 9); // borders are short: more rectangles
    const auto built = buildMtFile(mesh, {}, {}, folder / "memory.mt");
    const SurfaceSpool spool = spoolOf(mesh, folder / "");
    ASSERT_TRUE(buildMtFile(spool, {}, {}, kMuchMb, folder / "files.mt"));
    EXPECT_EQ(bytesOf(folder / "files.mt"), bytesOf(folder / "memory.mt"));
    EXPECT_FALSE(std::filesystem::exists(folder / "border-fit"));
    ASSERT_TRUE(buildMtFile(mesh, {}, inRectangles(balancedTreeCount(8100.0)), folder / "plain.mt"));
    EXPECT_NE(bytesOf(folder / "plain.mt"), bytesOf(folder / "memory.mt")) << "the fit changed nothing";
    EXPECT_TRUE(built);
}

TEST(Spool, boundsHoldWherePartsHadOnlySomeOfTheirPoints)
{
    const testsupport::TestFolder folder("mt-spool");
    const SurfaceMesh mesh = testsupport::hillSurface(150, 130);
    const SurfaceSpool spool = spoolOf(mesh, folder / "");
    ASSERT_TRUE(buildMtFile(mesh, {}, inRectangles(60), folder / "memory.mt"));
    ASSERT_TRUE(buildMtFile(spool, {}, inRectangles(60), kMuchMb, folder / "files.mt"));
    EXPECT_NE(bytesOf(folder / "files.mt"), bytesOf(folder / "memory.mt")) << "no part was thinned out";
    EXPECT_EQ(faultOf(folder / "files.mt", mesh), std::nullopt);
    EXPECT_NE(faultOf(folder / "files.mt", mesh, 0.9f), std::nullopt) << "smaller bounds do not hold";
}

TEST(Spool, threadsAndKillsDoNotChangeTheBytes)
{
    const testsupport::TestFolder folder("mt-spool");
    const SurfaceMesh mesh = testsupport::hillSurface(120, 110);
    const SurfaceSpool spool = spoolOf(mesh, folder / "");
    ASSERT_TRUE(buildMtFile(spool, {}, inRectangles(40), kMuchMb, folder / "one.mt"));
    ASSERT_TRUE(buildMtFile(spool, {}, inRectangles(40, 4), kMuchMb, folder / "four.mt"));
    EXPECT_EQ(bytesOf(folder / "four.mt"), bytesOf(folder / "one.mt"));
    ForestOptions stopped = inRectangles(40);
    for (const std::uint32_t last : {5u, 33u, 60u, 61u, 62u})
    {
        stopped.progress = [last](std::uint32_t done, std::uint32_t) { return done < last; };
        EXPECT_FALSE(buildMtFile(spool, {}, stopped, kMuchMb, folder / "stopped.mt")) << last;
    }
    ASSERT_TRUE(buildMtFile(spool, {}, inRectangles(40), kMuchMb, folder / "stopped.mt"));
    EXPECT_EQ(bytesOf(folder / "stopped.mt"), bytesOf(folder / "one.mt"));
}

TEST(Spool, aDamagedFileOfPointsIsMadeAnew)
{
    const testsupport::TestFolder folder("mt-spool");
    const SurfaceMesh mesh = testsupport::hillSurface(120, 110);
    const SurfaceSpool spool = spoolOf(mesh, folder / "");
    ASSERT_TRUE(buildMtFile(spool, {}, inRectangles(40), kMuchMb, folder / "one.mt"));
    ForestOptions stopped = inRectangles(40);
    stopped.progress = [](std::uint32_t done, std::uint32_t) { return done < 60; };
    ASSERT_FALSE(buildMtFile(spool, {}, stopped, kMuchMb, folder / "two.mt"));
    int damaged = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder / "two.mt.parts"))
        if (entry.path().extension() == ".hidden")
        {
            std::fstream stream(entry.path(), std::ios::in | std::ios::out | std::ios::binary);
            stream.seekp(100);
            stream.put('x');
            ++damaged;
        }
    ASSERT_GT(damaged, 0);
    ASSERT_TRUE(buildMtFile(spool, {}, inRectangles(40), kMuchMb, folder / "two.mt"));
    EXPECT_EQ(bytesOf(folder / "two.mt"), bytesOf(folder / "one.mt"));
}

TEST(Spool, aLimitThatIsTooSmallTellsTheLeastThatWouldDo)
{
    const testsupport::TestFolder folder("mt-spool");
    const SurfaceSpool spool = spoolOf(testsupport::hillSurface(60, 60), folder / "");
    const auto failed = buildMtFile(spool, {}, {}, 10.0, folder / "a.mt");
    ASSERT_FALSE(failed);
    const std::string message = failed.error().message();
    const double least = std::stod(message.substr(message.find("need ") + 5));
    EXPECT_FALSE(buildMtFile(spool, {}, {}, least - 1.0, folder / "a.mt"));
    EXPECT_TRUE(buildMtFile(spool, {}, {}, least, folder / "a.mt"));
}

TEST(Spool, aGridByRowsIsTheGrid)
{
    const testsupport::TestFolder folder("mt-spool");
    const SurfaceMesh mesh = testsupport::hillSurface(37, 29);
    SurfaceSpool spool = std::move(*SurfaceSpool::create(folder / ""));
    GridSpool grid(spool, 37);
    std::vector<float> row;
    for (const SurfacePoint& point : mesh.points)
    {
        row.push_back(static_cast<float>(point.height));
        if (row.size() < 37) continue;
        grid.addRow(row);
        row.clear();
    }
    grid.finish();
    ASSERT_TRUE(spool.finish());
    const SurfaceMesh found = meshOf(spool);
    EXPECT_EQ(found.points, mesh.points);
    EXPECT_EQ(found.triangles, mesh.triangles);
}

TEST(Spool, cellsAreCutByTheRule) // by hand
{
    using osgPMObjects::core::DiagonalRule;
    const auto rises = [](DiagonalRule rule, float sw, float se, float nw, float ne) {
        return isCutRising(sw, se, nw, ne, {rule, 2.0, 2.0});
    };
    // Rising: ends differ by 6, falling: by 1.
    EXPECT_FALSE(rises(DiagonalRule::nearestHeights, 0, 0, 1, 6));
    EXPECT_TRUE(rises(DiagonalRule::largestHeightDifference, 0, 0, 1, 6));
    // One corner is raised by 5: cut at it the triangles meet at 82°, across it at 74°.
    EXPECT_TRUE(rises(DiagonalRule::largestNormalAngle, 5, 0, 0, 0));
    EXPECT_FALSE(rises(DiagonalRule::largestNormalAngle, 0, 5, 0, 0));
    // Cut at the raised corner both triangles lean alike; across it one lies level.
    EXPECT_TRUE(rises(DiagonalRule::nearestAreas, 0, 0, 0, 6));
    EXPECT_FALSE(rises(DiagonalRule::nearestAreas, 0, 0, 6, 0));
    for (const DiagonalRule rule : {DiagonalRule::nearestHeights, DiagonalRule::largestHeightDifference,
                                    DiagonalRule::largestNormalAngle, DiagonalRule::nearestAreas})
        EXPECT_TRUE(rises(rule, 3, 3, 3, 3)) << "alike to the rule";
}

TEST(Spool, aGridByRowsIsCutAsTheGrid)
{
    const testsupport::TestFolder folder("mt-spool");
    const SurfaceMesh hills = testsupport::hillSurface(37, 29);
    std::vector<float> heights;
    for (const SurfacePoint& point : hills.points)
        heights.push_back(static_cast<float>(point.height));
    const CellCut cut{osgPMObjects::core::DiagonalRule::largestHeightDifference, 30.0, 20.0};
    SurfaceSpool spool = std::move(*SurfaceSpool::create(folder / ""));
    GridSpool grid(spool, 37, cut);
    for (std::size_t row = 0; row < 29; ++row)
        grid.addRow(std::span(heights).subspan(37 * row, 37));
    grid.finish();
    ASSERT_TRUE(spool.finish());
    const SurfaceMesh mesh = gridSurface(37, 29, heights, cut);
    EXPECT_EQ(meshOf(spool).triangles, mesh.triangles);
    EXPECT_NE(mesh.triangles, hills.triangles) << "the control";
}

TEST(Spool, voidsOfAGridAreHoles) // by hand: the triangle below the diagonal next to the void
{
    const testsupport::TestFolder folder("mt-spool");
    SurfaceSpool spool = std::move(*SurfaceSpool::create(folder / ""));
    GridSpool grid(spool, 2);
    grid.addRow(std::vector<float>{1.0f, 2.0f});
    grid.addRow(std::vector<float>{3.0f, std::numeric_limits<float>::quiet_NaN()});
    grid.finish();
    ASSERT_TRUE(spool.finish());
    EXPECT_EQ(grid.holes(), 1u);
    const SurfaceMesh found = meshOf(spool);
    EXPECT_EQ(found.points, (std::vector<SurfacePoint>{{0, 0, 1.0}, {1, 0, 2.0}, {0, 1, 3.0}}));
    EXPECT_EQ(found.triangles, (std::vector<Triangle>{{0, 1, 2}}));
}

/// Triangulates points strip by strip.
SurfaceMesh inStrips(std::vector<SurfacePoint> points, std::uint32_t axis, std::size_t strip)
{
    const auto along = [axis](const SurfacePoint& p) { return axis == 0 ? p.x : p.y; };
    std::ranges::stable_sort(points, {}, along);
    std::array<std::int32_t, 2> high{0, 0};
    for (const SurfacePoint& p : points)
        high = {std::max(high[0], p.x), std::max(high[1], p.y)};
    SurfaceMesh mesh{points, {}};
    StripDelaunay delaunay([&](const Triangle& t) { mesh.triangles.push_back(t); }, axis, high);
    for (std::size_t first = 0; first < points.size(); first += strip)
    {
        const std::size_t count = std::min(strip, points.size() - first);
        delaunay.add(std::span(points).subspan(first, count));
        EXPECT_TRUE(first + count < points.size() ? delaunay.advance(along(points[first + count]))
                                                  : delaunay.finish());
    }
    return mesh;
}

/// The triangles by their places.
std::vector<std::array<std::int32_t, 6>> planPlaces(const SurfaceMesh& mesh)
{
    std::vector<std::array<std::int32_t, 6>> all;
    for (Triangle t : mesh.triangles)
    {
        const auto place = [&](std::uint32_t p) { return std::pair(mesh.points[p].x, mesh.points[p].y); };
        std::rotate(t.begin(), std::ranges::min_element(t, {}, place), t.end());
        all.push_back({place(t[0]).first, place(t[0]).second, place(t[1]).first, place(t[1]).second,
                       place(t[2]).first, place(t[2]).second});
    }
    std::ranges::sort(all);
    return all;
}

TEST(StripDelaunay, isTheTriangulationOfAllPoints)
{
    for (const PointDistribution distribution : {PointDistribution::uniform, PointDistribution::normal,
                                                 PointDistribution::laplace, PointDistribution::clustered})
        for (const std::uint32_t axis : {0u, 1u})
            for (const std::size_t strip : {7u, 100u, 999u})
            {
                std::vector<SurfacePoint> points = madeUpPoints(distribution, 3000, 5);
                EXPECT_EQ(planPlaces(inStrips(points, axis, strip)), planPlaces(delaunay(points)))
                    << static_cast<int>(distribution) << ' ' << axis << ' ' << strip;
            }
}

TEST(StripDelaunay, coversAGridWhereAllCirclesHaveFourPoints)
{
    std::vector<SurfacePoint> points = testsupport::hillSurface(40, 30).points;
    const SurfaceMesh mesh = inStrips(points, 0, 50);
    EXPECT_EQ(mesh.triangles.size(), 2u * 39 * 29);
    EXPECT_EQ(checkSurface(mesh, outlineOf(delaunay(points))), std::nullopt);
    SurfaceMesh less = mesh;
    less.triangles.pop_back();
    EXPECT_NE(checkSurface(less, outlineOf(delaunay(points))), std::nullopt);
}

TEST(InputSpool, aTinIsThatOfAReaderInMemory)
{
    const testsupport::TestFolder folder("mt-spool");
    const std::string text =
        "v 5 5 9\nv 0 0 1\nv 10 0 2\nv 10 10 3\nv 0 0 1\nv 0 10 4\nv 70 70 7\n"
        "f 2 3 4\nf 5 6 4\n"; // one point twice, two in no triangle, one triangle clockwise
    std::ofstream(folder / "tin.obj") << text;
    SurfaceSpool spool = std::move(*SurfaceSpool::create(folder / ""));
    const auto input = spoolTinFile(folder / "tin.obj", spool);
    ASSERT_TRUE(input);
    ASSERT_TRUE(spool.finish());
    const auto placed = placeTin(*readTinFile(folder / "tin.obj"), "tin");
    ASSERT_TRUE(placed);
    EXPECT_EQ(meshOf(spool).points, placed->mesh.points);
    EXPECT_EQ(meshOf(spool).triangles, placed->mesh.triangles);
    EXPECT_EQ(input->frame, placed->frame);
}

TEST(InputSpool, wallsAreTold)
{
    const testsupport::TestFolder folder("mt-spool");
    SurfaceSpool spool = std::move(*SurfaceSpool::create(folder / ""));
    std::ofstream(folder / "wall.obj") << "v 0 0 1\nv 1 0 1\nv 0 0 5\nv 0 1 1\nf 1 2 4\n";
    const auto wall = spoolTinFile(folder / "wall.obj", spool);
    ASSERT_FALSE(wall);
    EXPECT_NE(wall.error().message().find("two heights"), std::string::npos);
    std::ofstream(folder / "flat.obj") << "v 0 0 1\nv 1 0 1\nv 2 0 5\nv 0 1 1\nf 1 2 4\nf 1 2 3\n";
    SurfaceSpool other = std::move(*SurfaceSpool::create(folder / ""));
    const auto flat = spoolTinFile(folder / "flat.obj", other);
    ASSERT_FALSE(flat);
    EXPECT_NE(flat.error().message().find("triangle 1 at"), std::string::npos) << flat.error().message();
}

TEST(InputSpool, aSideThatThreeTrianglesHaveIsTold)
{
    const testsupport::TestFolder folder("mt-spool");
    SurfaceMesh mesh = testsupport::hillSurface(30, 30);
    mesh.triangles.push_back(mesh.triangles[500]);
    const SurfaceSpool spool = spoolOf(mesh, folder / "");
    const auto built = buildMtFile(spool, {}, inRectangles(8), kMuchMb, folder / "a.mt");
    ASSERT_FALSE(built);
    EXPECT_NE(built.error().message().find("same side"), std::string::npos) << built.error().message();
}

TEST(InputSpool, pointsOfAFileAreThatOfAReaderInMemory)
{
    const testsupport::TestFolder folder("mt-spool");
    std::ofstream stream(folder / "points.csv");
    stream << "x,y,z\n";
    testsupport::Random random(8);
    for (int i = 0; i < 40000; ++i)
        stream << random.below(4000) * 0.25 << ',' << random.below(3000) * 0.5 << ',' << i % 17 << '\n';
    stream.close();
    SurfaceSpool spool = std::move(*SurfaceSpool::create(folder / ""));
    const std::vector<std::filesystem::path> files{folder / "points.csv"};
    const auto input = spoolPointFiles(files, spool);
    ASSERT_TRUE(input);
    ASSERT_TRUE(spool.finish());
    const PlacedPoints placed = placeOnLattice(*readPointFile(files[0]));
    EXPECT_EQ(input->frame, placed.frame);
    EXPECT_EQ(input->repeated, placed.repeated);
    const SurfaceMesh mesh = meshOf(spool);
    EXPECT_EQ(checkSurface(mesh, outlineOf(delaunay(placed.points))), std::nullopt);
    std::map<std::pair<int, int>, double> heights;
    for (const SurfacePoint& p : placed.points)
        heights[{p.x, p.y}] = p.height;
    ASSERT_EQ(mesh.points.size(), heights.size());
    for (const SurfacePoint& p : mesh.points)
        EXPECT_EQ((heights[{p.x, p.y}]), p.height);
}

} // namespace

} // namespace osgMultiTriangulation::core
