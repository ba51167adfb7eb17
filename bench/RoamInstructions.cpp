// SPDX-License-Identifier: Apache-2.0
// Runs RoamMesh::refine() frame by frame, so that Valgrind's Callgrind can count its instructions.
// scripts/count-instructions runs it.
//   roam_instructions SCENE TOLERANCE_PX whole|centre [SLICE_US]
// Prints a line for each frame: triangles, changed diamonds, vertices tested, and 1 if the slice ended the
// work early. Without Callgrind it does the same, and nothing is counted.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string_view>

#include <osgTerrainROAM/core/heightfield/DemImport.h>
#include <osgTerrainROAM/core/roam/RoamMesh.h>

#include "SyntheticField.h"
#include "measurement/flights/BenchmarkFlight.h"
#include "measurement/flights/RandomWalk.h"
#include "measurement/flights/RasterCrop.h"

#if __has_include(<valgrind/callgrind.h>)
#include <valgrind/callgrind.h>
#else
#define CALLGRIND_START_INSTRUMENTATION
#define CALLGRIND_TOGGLE_COLLECT
#define CALLGRIND_DUMP_STATS
#endif

namespace
{

using namespace osgTerrainROAM::core;
using measurement::BenchmarkFlight;

struct Scene
{
    std::string_view name;
    const measurement::RasterCrop& crop;
    std::optional<measurement::Path> path; ///< absent: a random walk
};

constexpr Scene kScenes[] = {
    {"drive", measurement::kGreenRiver, measurement::Path::drive},
    {"flight", measurement::kWhiteMountains, measurement::Path::flight},
    {"still", measurement::kWhiteMountains, measurement::Path::still},
    {"walk", measurement::kWhiteMountains, std::nullopt},
    {"drivewalk", measurement::kGreenRiver, std::nullopt},
};

const Scene* sceneOf(std::string_view name)
{
    for (const Scene& scene : kScenes)
        if (scene.name == name) return &scene;
    return nullptr;
}

std::optional<HeightField> fieldOf(const measurement::RasterCrop& crop)
{
    const char* folder = std::getenv("OSGTRAINER_REAL_DATA");
    if (!folder) return std::nullopt;
    const auto imported = importDem(std::filesystem::path(folder) / crop.file);
    if (!imported) return std::nullopt;
    return crop.of(*imported);
}

/// Counts one frame, as one dump of Callgrind. The first dump of a run is the frame that builds the mesh.
void countFrame(RoamMesh& mesh, const viewlod::ViewState& view, const viewlod::Budget& budget)
{
    CALLGRIND_TOGGLE_COLLECT;
    const RefineResult result = mesh.refine(view, budget);
    CALLGRIND_TOGGLE_COLLECT;
    CALLGRIND_DUMP_STATS;
    std::printf("%u %g %u %d\n", result.leaves, 0.5 * (result.splits + result.merges), result.checks,
                result.sliceBound ? 1 : 0);
}

void run(const Scene& scene, const RoamTile& tile, RoamMesh& mesh, const viewlod::Budget& budget, bool centre)
{
    measurement::RandomWalk restless(tile.tile);
    const int frames = scene.path ? BenchmarkFlight::kFrames : measurement::RandomWalk::kFrames;
    CALLGRIND_START_INSTRUMENTATION;
    for (int frame = 0; frame < frames; ++frame)
    {
        viewlod::ViewState view =
            scene.path ? BenchmarkFlight::along(*scene.path).view(tile.tile, frame) : restless.next();
        if (centre) view.cornerStretch = 1.0;
        countFrame(mesh, view, budget);
    }
}

} // namespace

int main(int argc, char** argv)
{
    const Scene* scene = argc >= 4 ? sceneOf(argv[1]) : nullptr;
    viewlod::Budget budget;
    if (scene) budget.errorTolerancePx = std::strtod(argv[2], nullptr);
    if (!scene || !(budget.errorTolerancePx > 0.0))
    {
        std::fprintf(stderr, "usage: roam_instructions drive|flight|still|walk|drivewalk TOLERANCE_PX "
                             "whole|centre [SLICE_US]\n");
        return 2;
    }
    auto field = fieldOf(scene->crop);
    if (!field)
    {
        std::fprintf(stderr,
                     "roam_instructions: no %s: set OSGTRAINER_REAL_DATA to the folder of the real data\n",
                     scene->crop.file);
        return 1;
    }
    if (argc > 4)
    {
        budget.maxTimeUs = std::strtod(argv[4], nullptr);
        budget.clock = viewlod::Budget::Clock::modelled;
    }
    const auto tile = testsupport::planarTile(std::move(*field));
    RoamMesh mesh(tile);
    run(*scene, *tile, mesh, budget, std::string_view(argv[3]) == "centre");
}
