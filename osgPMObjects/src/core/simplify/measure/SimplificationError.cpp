// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <vector>

#include <osgPMObjects/core/mesh/MeshCounts.h>
#include <osgPMObjects/core/mesh/SurfaceChange.h>
#include <osgPMObjects/core/simplify/SimplificationError.h>

namespace osgPMObjects::core
{

namespace
{

std::vector<bool> materialsWithFaces(const Mesh& mesh, std::size_t count)
{
    std::vector<bool> isUsed(count, false);
    for (const Face& face : mesh.faces)
        if (face.material < count) isUsed[face.material] = true;
    return isUsed;
}

} // namespace

SimplificationMeter::SimplificationMeter(const Mesh& original, std::size_t spread)
    : _spread(spread),
      _box(extentOfFaces(original)),
      _original(original, spread),
      _drift(_original),
      _smear(_original)
{
}

SimplificationError SimplificationMeter::measure(const Mesh& level) const
{
    const MeasuredSurface surface(level, _spread);
    const SurfaceChange change = surfaceChange(_original, surface);
    const double diagonal = _box.diagonal(), percent = diagonal > 0.0 ? 100.0 / diagonal : 0.0;
    std::optional<TextureSmear> smear = _smear.measure(surface, change.largest);
    if (smear) smear->mean *= percent, smear->ofNinetyNine *= percent;
    return {percent * change.mean, percent * change.largest, percent * boxExcess(level),
            _drift.measure(surface), smear};
}

double SimplificationMeter::boxExcess(const Mesh& level) const
{
    double largest = 0.0;
    for (const Face& face : level.faces)
        for (int corner = 0; corner < 3; ++corner)
        {
            const glm::dvec3& p = level.at(face, corner);
            const glm::dvec3 outside = glm::max(glm::max(_box.low - p, p - _box.high), glm::dvec3(0.0));
            largest = std::max(largest, glm::length(outside));
        }
    return largest;
}

std::size_t countMissingMaterials(const Mesh& original, const Mesh& level)
{
    const std::vector<bool> before = materialsWithFaces(original, original.materials.size());
    const std::vector<bool> after = materialsWithFaces(level, original.materials.size());
    std::size_t missing = 0;
    for (std::size_t m = 0; m < before.size(); ++m)
        missing += before[m] && !after[m];
    return missing;
}

} // namespace osgPMObjects::core
