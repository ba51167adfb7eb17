// SPDX-License-Identifier: Apache-2.0
#include <iostream>
#include <map>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/roam/DrawnGround.h>
#include <osgTerrainROAM/core/roam/DrawnMeshCheck.h>
#include <osgTerrainROAM/core/roam/RoamMesh.h>

#include "SyntheticField.h"
#include "measurement/flights/BenchmarkFlight.h"

namespace
{

using namespace osgTerrainROAM::core;
using measurement::BenchmarkFlight;

const std::shared_ptr<const RoamTile>& tile()
{
    static const auto placed = testsupport::planarTile(testsupport::hills(257, 257, 90.0));
    return placed;
}

viewlod::ViewState viewAt(double frame)
{
    auto view = BenchmarkFlight{}.view(tile()->tile, static_cast<int>(frame));
    view.eyeWorld += glm::dvec3(36.0, 27.0, 0.0) * (frame - std::floor(frame));
    return view;
}

TEST(Morph, KeepsTheBoundForWhatIsDrawn)
{
    RoamMesh mesh(tile());
    mesh.setMorphing(true);
    double worst = 0.0, largestMove = 0.0;
    for (int frame = 0; frame < BenchmarkFlight::kFrames; frame += 16)
    {
        const auto view = viewAt(frame);
        const RefineResult result = mesh.refine(view, {.errorTolerancePx = 3.0});
        EXPECT_DOUBLE_EQ(result.tolerancePx, 3.0);
        const auto report = checkDrawnMesh(*tile(), mesh.drawn(), &view);
        EXPECT_EQ(report.tJunctions + report.cracks, 0u);
        ASSERT_LE(report.maxErrorPx, 3.0) << frame;
        worst = std::max(worst, report.maxErrorPx);
        for (VertexSlot v = 0; v < mesh.vertexSlots(); ++v)
            largestMove = std::max<double>(largestMove, glm::length(mesh.tree().displacement(v)));
    }
    EXPECT_GT(worst, 1.0) << "a check that always sees 0 would pass, too";
    EXPECT_GT(largestMove, 5.0) << "nothing was ever on its way";
}

/// The largest change of the drawn height at fixed places from one small step of the eye to the next, in
/// pixels.
double largestJumpPx(bool morphing)
{
    RoamMesh mesh(tile());
    mesh.setMorphing(morphing);
    testsupport::Random random(4);
    std::vector<glm::dvec2> places;
    for (int i = 0; i < 3000; ++i)
        places.emplace_back(random.unit() * 256 * 90.0, random.unit() * 256 * 90.0);
    std::vector<std::optional<DrawnGround>> before(places.size()), now(places.size());
    double largest = 0.0;
    for (int step = 0; step < 150; ++step)
    {
        const auto view = viewAt(30.0 + step / 60.0); // 0.75 m a step
        mesh.refine(view, {.errorTolerancePx = 3.0});
        drawnGroundAt(mesh.tree(), places, now);
        for (std::size_t i = 0; i < places.size() && step > 0; ++i)
        {
            const double distance = std::max(glm::distance(now[i]->position, view.eyeWorld), view.nearM);
            const double jumpM = std::abs(now[i]->position.z - before[i]->position.z);
            largest = std::max(largest, view.pixelsPerTangent * jumpM / distance);
        }
        std::swap(before, now);
    }
    return largest;
}

TEST(Morph, LeavesNoJumps)
{
    const double with = largestJumpPx(true), without = largestJumpPx(false);
    EXPECT_GT(without, 0.5) << "nothing ever jumps: nothing was checked";
    EXPECT_LT(with, 0.05 * without);
    std::cout << "largest jump of the drawn ground: " << with << " px with morphing, " << without
              << " px without\n";
}

TEST(Morph, IsAFunctionOfTheEye)
{
    RoamMesh travelled(tile()), fresh(tile());
    travelled.setMorphing(true);
    fresh.setMorphing(true);
    for (int frame = 0; frame <= 200; frame += 20)
        travelled.refine(viewAt(frame), {.errorTolerancePx = 3.0});
    fresh.refine(viewAt(200), {.errorTolerancePx = 3.0});
    const auto placesOf = [](const RoamMesh& mesh)
    {
        std::map<std::pair<int, int>, std::array<float, 3>> places;
        for (VertexSlot v = 0; v < mesh.vertexSlots(); ++v)
            if (const DiamondPlace& place = mesh.tree().place(v); !place.isFree())
            {
                const glm::vec3 moved = mesh.tree().displacement(v);
                places[{place.column, place.row}] = {moved.x, moved.y, moved.z};
            }
        return places;
    };
    EXPECT_EQ(placesOf(travelled), placesOf(fresh));
}

TEST(Morph, ReportsWhatMovesAndPutsItBack)
{
    RoamMesh mesh(tile());
    mesh.setMorphing(true);
    std::vector<MeshVertex> mirror; // what a graphics card would hold that was sent the changes alone
    for (int frame = 0; frame < 60; ++frame)
    {
        if (frame == 40) mesh.setMorphing(false);
        mesh.refine(viewAt(frame * 0.5), {.errorTolerancePx = 3.0});
        if (frame == 0) mirror = mesh.drawn().vertices; // the first time all is sent
        mirror.resize(mesh.vertexSlots());
        for (const VertexSlot v : mesh.changes().vertices)
            mirror[v] = mesh.vertex(v);
        for (VertexSlot v = 0; v < mesh.vertexSlots(); ++v)
        {
            if (mesh.tree().place(v).isFree()) continue;
            const MeshVertex wanted = mesh.vertex(v);
            ASSERT_EQ(mirror[v], wanted);
            ASSERT_TRUE(frame < 40 || mesh.tree().displacement(v) == glm::vec3(0.0f));
        }
    }
}

} // namespace
