// SPDX-License-Identifier: Apache-2.0
// Measures view-dependent progressive meshes beside ROAM in one run: preparation, memory, triangles at equal
// error, and what adapting costs from frame to frame. Times are of the thread's processor time. The crops are
// those on which methods are compared.
//   OSGTRAINER_REAL_DATA=… build/bin/vdpm_bench [SIDE]      SIDE: of the part of each crop, samples (the
//                                                             whole crop)
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <viewlod/Slice.h>

#include <osgTerrainROAM/core/heightfield/DemImport.h>
#include <osgTerrainROAM/core/roam/RoamMesh.h>
#include <osgTerrainROAM/core/vdpm/HeightFieldForest.h>
#include <osgTerrainROAM/core/vdpm/VdpmMesh.h>

#include "SyntheticField.h"
#include "measurement/Percentile.h"
#include "measurement/flights/BenchmarkFlight.h"
#include "measurement/flights/RasterCrop.h"

namespace
{

using namespace osgTerrainROAM::core;
using measurement::BenchmarkFlight;
using measurement::Path;

double now()
{
    return viewlod::Slice::threadUs();
}

/// What one mesh does along a flight.
struct Flight
{
    std::vector<double> us;
    double triangles = 0.0, changed = 0.0, checks = 0.0;

    void fly(TerrainMesh& mesh, const RoamTile& tile, Path path, double tolerancePx, bool inSight = false)
    {
        const BenchmarkFlight flight = BenchmarkFlight::along(path);
        for (int frame = 0; frame < BenchmarkFlight::kFrames; ++frame)
        {
            const viewlod::ViewState view = flight.view(tile.tile, frame);
            viewlod::Sight sight;
            if (inSight) sight.add(view, 0.0);
            mesh.setSight(sight);
            const double start = now();
            const RefineResult result = mesh.refine(view, {.errorTolerancePx = tolerancePx});
            const double took = now() - start;
            if (frame == 0) continue;
            us.push_back(took);
            triangles += result.triangles;
            changed += result.splits + result.merges;
            checks += result.checks;
        }
    }

    void print(const std::string& name)
    {
        const double frames = BenchmarkFlight::kFrames - 1;
        std::cout << "    " << name << ": " << triangles / frames << " triangles, "
                  << measurement::percentile(us, 0.5) << " us, p99 " << measurement::percentile(us, 0.99)
                  << ", worst " << measurement::percentile(us, 1.0) << ", " << 100.0 * changed / triangles
                  << " % changed, " << checks / frames << " checks\n";
    }
};

void compare(const measurement::RasterCrop& crop, const std::filesystem::path& folder, int side,
             const std::vector<double>& errorsM)
{
    const auto imported = importDem(folder / crop.file);
    if (!imported)
    {
        std::cout << imported.error().message() << '\n';
        return;
    }
    measurement::RasterCrop part = crop;
    if (side > 0) part.side = side;
    const auto tile = testsupport::planarTile(part.of(*imported), Storage::exact);
    const double start = now();
    auto prepared = heightFieldForest(tile->tile);
    const double samples = static_cast<double>(part.side) * part.side;
    std::cout << crop.file << ' ' << part.side << "²: prepared in " << (now() - start) / samples
              << " us a sample";
    const auto forest = std::make_shared<const BoundedForest>(std::move(*prepared));
    VdpmMesh mesh(tile, forest);
    std::cout << ", " << static_cast<double>(forest->memoryBytes()) / samples << " B a sample, a mesh "
              << static_cast<double>(mesh.memoryBytes()) / samples << " B more\n";
    for (const double errorM : errorsM)
        std::cout << "    " << errorM << " m: " << mesh.refine(errorM).triangles << " triangles\n";
    for (const Path path : {crop.cellM > 10.0 ? Path::flight : Path::drive, Path::turn, Path::jump})
        for (const double tolerancePx : {2.0, 1.0})
        {
            std::cout << "  " << pathName(path) << ", " << tolerancePx << " px\n";
            Flight vdpm, moving, seen, wheel, walk;
            VdpmMesh morphing(tile, forest);
            morphing.setMorphing(true);
            VdpmMesh inSight(tile, forest);
            RoamMesh byWheel(tile), byWalk(tile, Driver::walk);
            vdpm.fly(mesh, *tile, path, tolerancePx);
            moving.fly(morphing, *tile, path, tolerancePx);
            seen.fly(inSight, *tile, path, tolerancePx, true);
            wheel.fly(byWheel, *tile, path, tolerancePx);
            walk.fly(byWalk, *tile, path, tolerancePx);
            vdpm.print("vdpm");
            moving.print("vdpm morphing");
            std::cout << "      splits done at once: " << morphing.driver().jumps() << '\n';
            seen.print("vdpm in sight");
            wheel.print("roam wheel");
            walk.print("roam walk");
        }
    std::cout << "  bytes of the mesh of the last frame beyond the forest: " << mesh.memoryBytes() << '\n';
}

} // namespace

int main(int argc, char** argv)
{
    const char* folder = std::getenv("OSGTRAINER_REAL_DATA");
    if (!folder)
    {
        std::cerr << "OSGTRAINER_REAL_DATA: is not set; set it to the folder of the real data\n";
        return 2;
    }
    const int side = argc > 1 ? std::atoi(argv[1]) : 0;
    compare(measurement::kGreenRiver, folder, side, {1.0, 0.5, 0.25, 0.1});
    compare(measurement::kWhiteMountains, folder, side, {20.0, 10.0, 5.0});
    compare(measurement::kAconcagua, folder, side, {50.0, 20.0});
    return 0;
}
