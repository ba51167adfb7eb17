// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <osgMultiTriangulation/core/check/SurfaceCheck.h>
#include <osgMultiTriangulation/core/file/BuildMtFile.h>
#include <osgMultiTriangulation/core/follow/DrawnSurfaceCheck.h>
#include <osgMultiTriangulation/core/follow/SurfaceFollower.h>
#include <osgMultiTriangulation/core/surface/GridSurface.h>
#include <osgTerrainROAM/core/heightfield/DemImport.h>

#include "RealData.h"
#include "TestFolder.h"

namespace osgMultiTriangulation::core
{

namespace
{

constexpr int kCropSide = 257;
constexpr double kCropStep = 1.0 / 4096.0;

/// A part of one of the crops on which methods are compared (cells are squares), and the tolerance of its
/// flights.
struct Crop
{
    const char* file;
    int column, row; ///< of its north-western sample
    double cellM;
};

std::ostream& operator<<(std::ostream& out, const Crop& crop)
{
    return out << crop.file;
}

class RealCrop : public testing::TestWithParam<Crop>
{
protected:
    void SetUp() override
    {
        OSGTRAINER_REAL_DATA_OR_SKIP(file, std::filesystem::path("dem") / GetParam().file);
        const auto field = osgTerrainROAM::core::importDem(file);
        ASSERT_TRUE(field) << field.error().message();
        const int south = field->rows - GetParam().row - kCropSide;
        for (int row = 0; row < kCropSide; ++row)
            for (int column = 0; column < kCropSide; ++column)
                heights.push_back(field->heightM(GetParam().column + column, south + row));
        mesh = gridSurface(kCropSide, kCropSide, heights);
        outline = outlineOf(mesh);
        ForestOptions options;
        options.treeCount = 16;
        ASSERT_TRUE(buildMtFile(mesh, {0.0, 0.0, GetParam().cellM, GetParam().cellM}, options, path));
        ZoneSettings zone;
        zone.memoryBytes = 100'000'000;
        auto opened = SurfaceFollower::open(*MtFile::open(path), zone, kCropStep);
        ASSERT_TRUE(opened);
        follower = std::move(*opened);
    }

    /// The height of a drawn surface at each sample, by rasterising its triangles; no part of the library is
    /// used.
    std::vector<double> heightsOf(const DrawnSurface& surface) const
    {
        std::vector<double> drawn(heights.size(), std::numeric_limits<double>::quiet_NaN());
        for (const Triangle& triangle : surface.triangles)
        {
            double x[3], y[3], z[3];
            for (int c = 0; c < 3; ++c)
            {
                const auto& v = surface.vertices[triangle[c]];
                x[c] = std::round(v[0] * kCropStep / GetParam().cellM);
                y[c] = std::round(v[1] * kCropStep / GetParam().cellM);
                z[c] = v[2] * kCropStep;
            }
            const double area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
            for (double row = std::min({y[0], y[1], y[2]}); row <= std::max({y[0], y[1], y[2]}); ++row)
                for (double column = std::min({x[0], x[1], x[2]}); column <= std::max({x[0], x[1], x[2]});
                     ++column)
                {
                    const double b = ((column - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (row - y[0])) / area;
                    const double c = ((x[1] - x[0]) * (row - y[0]) - (column - x[0]) * (y[1] - y[0])) / area;
                    if (b < -1e-12 || c < -1e-12 || b + c > 1.0 + 1e-12) continue;
                    drawn[static_cast<std::size_t>(row) * kCropSide + static_cast<std::size_t>(column)] =
                        z[0] + b * (z[1] - z[0]) + c * (z[2] - z[0]);
                }
        }
        return drawn;
    }

    /// The number of samples that an eye sees farther from their place than `errorPerDistance` allows, or in
    /// no triangle.
    int wrongSamples(const DrawnSurface& surface, const FollowTarget& target) const
    {
        const std::vector<double> drawn = heightsOf(surface);
        int wrong = 0;
        for (std::size_t i = 0; i < drawn.size(); ++i)
        {
            const double error = std::abs(drawn[i] - heights[i]);
            const glm::dvec3 place(GetParam().cellM * static_cast<double>(i % kCropSide),
                                   GetParam().cellM * static_cast<double>(i / kCropSide), heights[i]);
            const double distance = std::max(glm::distance(place, target.eye), target.nearest);
            wrong += !(error <= target.errorPerDistance * distance + 2.0 * kCropStep);
        }
        return wrong;
    }

    testsupport::TestFolder folder{"real-crop"};
    std::filesystem::path path = folder / "crop.mt";
    std::vector<float> heights;
    SurfaceMesh mesh;
    std::vector<OutlineSide> outline;
    std::unique_ptr<SurfaceFollower> follower;
};

/// The triangles of a mesh by their places and heights, each from its least corner on, sorted.
std::vector<std::array<std::array<double, 3>, 3>> placesOf(const SurfaceMesh& mesh)
{
    std::vector<std::array<std::array<double, 3>, 3>> all;
    for (const Triangle& triangle : mesh.triangles)
    {
        std::array<std::array<double, 3>, 3> places;
        for (int c = 0; c < 3; ++c)
        {
            const SurfacePoint& p = mesh.points[triangle[c]];
            places[c] = {double(p.x), double(p.y), p.height};
        }
        std::rotate(places.begin(), std::ranges::min_element(places), places.end());
        all.push_back(places);
    }
    std::ranges::sort(all);
    return all;
}

TEST_P(RealCrop, theDrainIsTheInput)
{
    const auto file = MtFile::open(path);
    std::vector<ReadTree> trees;
    for (std::uint32_t t = 0; t < file->info().trees.size(); ++t)
        trees.push_back(*file->read(t, t == 0 ? nullptr : &trees[file->info().trees[t].parent]));
    Extraction extraction(trees[0].tree);
    for (std::uint32_t t = 1; t < trees.size(); ++t)
        extraction.attach(t, trees[t].tree);
    extraction.refine([](const MultiTriangulation&, std::uint32_t) { return true; });
    EXPECT_EQ(placesOf(extraction.mesh()), placesOf(mesh));
    mesh.points[7].height += 1.0;
    EXPECT_NE(placesOf(extraction.mesh()), placesOf(mesh));
}

TEST_P(RealCrop, threeFlightsKeepTheToleranceAtEverySample)
{
    const double extent = GetParam().cellM * (kCropSide - 1);
    const std::size_t view = follower->addView();
    int wrongWithAThird = 0;
    for (const auto& [from, to] : std::vector<std::pair<glm::dvec2, glm::dvec2>>{
             {{0.1, 0.1}, {0.9, 0.8}}, {{0.5, 0.95}, {0.5, 0.05}}, {{-0.1, 0.4}, {1.1, 0.6}}})
        for (int frame = 0; frame < 8; ++frame)
        {
            const glm::dvec2 at = glm::mix(from, to, frame / 7.0) * extent;
            const auto nearest = [&](double along) {
                return static_cast<std::size_t>(
                    std::clamp(std::lround(along / GetParam().cellM), 0L, kCropSide - 1L));
            };
            const double ground = heights[nearest(at.y) * kCropSide + nearest(at.x)];
            FollowTarget target{{at.x, at.y, ground + 3.0 * GetParam().cellM}, 2.0 / 1100.0, 1.0};
            const auto surface = follower->settle(view, target);
            ASSERT_EQ(checkDrawn(*surface, follower->frame(), outline), std::nullopt);
            EXPECT_EQ(wrongSamples(*surface, target), 0) << frame;
            target.errorPerDistance /= 3.0;
            wrongWithAThird += wrongSamples(*surface, target);
        }
    EXPECT_GT(wrongWithAThird, 1000)
        << "an evaluation that passes with a third of the tolerance sees nothing";
}

TEST_P(RealCrop, aSampleThatIsOffIsSeen)
{
    const FollowTarget target{{0.0, 0.0, heights[0] + 100.0}, 2.0 / 1100.0, 1.0};
    const auto surface = follower->settle(follower->addView(), target);
    EXPECT_EQ(wrongSamples(*surface, target), 0);
    heights[40 * kCropSide + 50] += 200.0F;
    EXPECT_EQ(wrongSamples(*surface, target), 1);
}

INSTANTIATE_TEST_SUITE_P(Crops, RealCrop,
                         testing::Values(Crop{"N44W072.hgt", 400, 400, 90.0},
                                         Crop{"S33W071.tif", 400, 400, 90.0},
                                         Crop{"greenriver.tif", 830, 430, 1.0}));

} // namespace

} // namespace osgMultiTriangulation::core
