// SPDX-License-Identifier: Apache-2.0
#include <set>

#include <osgTerrainROAM/core/bisection/BisectionFile.h>

#include "../RoamEntry.h"

namespace osgTerrainROAM::core
{

namespace
{

using foundation::Outcome;

constexpr const char* kBisectionKeys = "mesh, dem, levels, radius, relief, tin";

Outcome assignRelief(BisectionFile& file, const RoamEntry& entry)
{
    const auto found = numbers(entry, 2, 2);
    if (!found) return found.error();
    if ((*found)[0] < 0.0 || (*found)[1] <= 0.0)
        return entry.error("relief = " + std::string(entry.value) + " is none",
                           "give the height, and the size of the largest bumps, above 0");
    file.relief = (*found)[0];
    file.reliefSize = (*found)[1];
    return foundation::success();
}

Outcome assignBisectionEntry(BisectionFile& file, const RoamEntry& entry)
{
    if (entry.key == "mesh") return assignPath(file.mesh, entry);
    if (entry.key == "dem") return assignPath(file.dem, entry);
    if (entry.key == "radius") return assignNumber(file.radius, entry, 1e-3, 1e7);
    if (entry.key == "relief") return assignRelief(file, entry);
    if (entry.key == "tin") return assignPath(file.tins.emplace_back(), entry);
    if (entry.key != "levels")
        return entry.error("unknown key '" + std::string(entry.key) + "'",
                           std::string("the keys are ") + kBisectionKeys);
    const auto number = numberWithin(entry, 1.0, 24.0);
    if (!number) return number.error();
    file.levels = static_cast<int>(*number);
    return foundation::success();
}

} // namespace

foundation::Result<BisectionFile> parseBisectionFile(std::string_view text, const std::filesystem::path& name)
{
    BisectionFile file;
    std::set<std::string, std::less<>> seen;
    const Outcome read =
        visitEntries(text, name, kBisectionKeys,
                     [&](const RoamEntry& entry) -> Outcome
                     {
                         if (!seen.emplace(entry.key).second && entry.key != "tin")
                             return entry.error("'" + std::string(entry.key) + "' stands here a second time",
                                                "keep one of them");
                         return assignBisectionEntry(file, entry);
                     });
    if (!read) return read.error();
    if (!file.mesh.empty() && !file.dem.empty())
        return foundation::Error{name.string(), "names a mesh and a dem", "keep one of them"};
    if (file.radius > 0.0 && (!file.dem.empty() || !file.tins.empty()))
        return foundation::Error{name.string(), "has a radius beside a dem or a tin",
                                 "leave out the radius: both need ground that is seen from above"};
    return file;
}

} // namespace osgTerrainROAM::core
