// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include <osgPMObjects/core/mesh/SurfaceChange.h>
#include <osgPMObjects/core/simplify/Simplify.h>
#include <osgPMObjects/core/simplify/ToleranceSearch.h>

#include "SimplifyMeshes.h"

namespace
{

using namespace osgPMObjects::core;

/// A flat grid of 10 × 10, `height` above 0.
Mesh sheet(std::uint32_t cells, double height)
{
    Mesh mesh = testsupport::grid(cells, cells);
    for (glm::dvec3& p : mesh.positions)
        p = {p.x * 10.0 / cells, p.y * 10.0 / cells, height};
    return mesh;
}

/// A wavy sheet with a small triangle `away` above it.
Mesh wavesWithSpeck(double away)
{
    const Mesh speck = testsupport::meshOf({{0, 0, 0}, {0.02, 0, 0}, {0, 0.02, 0}}, {{0, 1, 2}});
    Mesh mesh = testsupport::together(testsupport::waves(20, 20), speck, {10.0, 10.0, away});
    for (Face& face : mesh.faces)
        face.material = 0; // the last face of a material would stay long
    return mesh;
}

TEST(LevelMeter, MeasuresTheDistanceOfParallelSheets)
{
    const Mesh low = sheet(8, 0.0), high = sheet(3, 0.25);
    const LevelMeter meter(low);
    EXPECT_NEAR(meter.measure(high).maximum, 0.25, 1e-6);
    EXPECT_NEAR(meter.measure(high).rootMeanSquare, 0.25, 1e-6);
    EXPECT_LT(meter.measure(low).maximum, 1e-9);
    EXPECT_TRUE(std::isinf(meter.measure(Mesh{}).maximum));
}

TEST(LevelMeter, MeasuresBothDirections)
{
    const Mesh whole = testsupport::together(sheet(8, 0.0), sheet(2, 0.0), {0.0, 0.0, 3.0});
    const Mesh half = sheet(8, 0.0);
    const MeasuredError gone = LevelMeter(whole).measure(half), added = LevelMeter(half).measure(whole);
    EXPECT_NEAR(gone.maximum, 3.0, 1e-6) << "the original is not covered";
    EXPECT_NEAR(added.maximum, 3.0, 1e-6) << "the level sticks out";
    EXPECT_NEAR(gone.rootMeanSquare, 3.0 * std::sqrt(0.5), 0.05);
    EXPECT_EQ(gone, added);
}

TEST(LevelMeter, SeesASpeckThatIsGoneUnlessSpecksDoNotCount)
{
    const Mesh original = wavesWithSpeck(4.0), level = testsupport::waves(20, 20);
    const MeasuredError all = LevelMeter(original).measure(level);
    EXPECT_NEAR(all.maximum, 4.0, 0.8);
    const LevelMeter lenient(original, LadderSettings{}.samples, 0.05);
    EXPECT_LT(lenient.measure(level).maximum, 1e-6);
    EXPECT_EQ(lenient.countVanished(level, 0.5), 1u);
    EXPECT_EQ(lenient.countVanished(original, 0.5), 0u);
    EXPECT_NEAR(LevelMeter(original, 1000, 0.02).measure(level).maximum, 4.0, 0.8)
        << "it is larger than that";
}

TEST(ToleranceSearch, KeepsEveryToleranceByAnotherMeasure)
{
    const Mesh mesh = wavesWithSpeck(4.0);
    for (const Placement placement : {Placement::subset, Placement::optimal})
    {
        const CollapseSequence sequence = simplify(mesh, {.placement = placement});
        const LevelMeter meter(mesh);
        ToleranceSearch search(mesh, sequence, meter);
        std::size_t last = sequence.steps.size() + 1;
        for (const double tolerance : {2.0, 0.5, 0.1, 0.02, 0.0})
        {
            const std::size_t steps = search.coarsestWithin(tolerance);
            EXPECT_LE(surfaceChange(mesh, meshAfter(mesh, sequence, steps)).largest, tolerance + 1e-9);
            EXPECT_LE(steps, last);
            last = steps;
        }
    }
}

TEST(ToleranceSearch, CountsASpeckAsFarAsItIsFromTheRest)
{
    const Mesh mesh = wavesWithSpeck(4.0);
    const CollapseSequence sequence = simplify(mesh);
    const double tolerance = 0.5;
    // The mutation: by the estimates the speck vanishes at the cost of its own size.
    const Mesh estimated = meshAfter(mesh, sequence, stepsToDistance(sequence, tolerance));
    EXPECT_GT(surfaceChange(mesh, estimated).largest, 3.0);
    const LevelMeter strict(mesh), lenient(mesh, LadderSettings{}.samples, 0.05);
    const std::size_t all = ToleranceSearch(mesh, sequence, strict).coarsestWithin(tolerance);
    const std::size_t without = ToleranceSearch(mesh, sequence, lenient).coarsestWithin(tolerance);
    EXPECT_LT(all, without);
    EXPECT_LE(surfaceChange(mesh, meshAfter(mesh, sequence, all)).largest, tolerance);
    const Mesh level = meshAfter(mesh, sequence, without);
    EXPECT_GT(surfaceChange(mesh, level).largest, 3.0);
    EXPECT_LE(lenient.measure(level).maximum, tolerance);
    EXPECT_EQ(lenient.countVanished(level, tolerance), 1u);
}

} // namespace
