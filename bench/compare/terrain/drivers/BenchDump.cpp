// SPDX-License-Identifier: Apache-2.0
#include "compare/terrain/drivers/BenchDump.h"

#include <bit>
#include <sstream>

#include <foundation/WholeFile.h>
#include <glm/gtc/type_ptr.hpp>

namespace terraintool
{

namespace
{

using osgTerrainROAM::core::DrawnMesh;

static_assert(std::endian::native == std::endian::little, "the file's bytes are written as they lie");

std::string cornersOf(const DrawnMesh& mesh)
{
    std::string bytes;
    bytes.reserve(mesh.triangles.size() * 15 * sizeof(double));
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t slot : triangle.vertices)
        {
            const glm::dvec3 p = mesh.position(slot);
            const double corner[5] = {p.x, p.y, p.z, static_cast<double>(mesh.grid[slot].column),
                                      static_cast<double>(mesh.grid[slot].row)};
            bytes.append(reinterpret_cast<const char*>(corner), sizeof(corner));
        }
    return bytes;
}

} // namespace

FrameSink dumpTo(const std::filesystem::path& folder, const BenchRun& run)
{
    return
        [folder, run](int frame, const viewlod::ViewState& view, const DrawnMesh& mesh) -> foundation::Outcome
    {
        std::ostringstream name;
        name << std::filesystem::path(run.dem).stem().string() << '-' << run.driverName() << '-'
             << measurement::pathName(run.path) << '-' << run.tolerancePx << "px-" << frame;
        nlohmann::ordered_json json;
        json["dem"] = run.dem;
        json["driver"] = run.driverName();
        json["path"] = measurement::pathName(run.path);
        json["frame"] = frame;
        json["tolerancePx"] = run.tolerancePx;
        json["centrePixels"] = run.centrePixels;
        json["eye"] = {view.eyeWorld.x, view.eyeWorld.y, view.eyeWorld.z};
        const double* matrix = glm::value_ptr(view.clipFromWorld);
        json["matrix"] = std::vector<double>(matrix, matrix + 16);
        json["widthPx"] = view.widthPx;
        json["heightPx"] = view.heightPx;
        json["nearM"] = view.nearM;
        json["triangles"] = mesh.triangles.size();
        json["corners"] = name.str() + ".bin";
        const auto base = folder / name.str();
        if (const auto written = foundation::writeWholeFile(base.string() + ".bin", cornersOf(mesh));
            !written)
            return written.error();
        return foundation::writeWholeFile(base.string() + ".json", json.dump(2) + "\n");
    };
}

} // namespace terraintool
