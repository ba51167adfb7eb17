// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <osgPMObjects/core/progressive/LevelMesh.h>
#include <osgPMObjects/core/progressive/MeasureLevels.h>
#include <osgPMObjects/core/simplify/LevelMeter.h>

namespace osgPMObjects::core
{

namespace
{

/// Small meshes need fewer samples than LadderSettings allows: so many, and one a face.
constexpr std::size_t kLeastSamples = 3000;

/// Returns the number of faces of each level, from the finest on; leaves `level` at the finest.
std::vector<std::uint32_t> facesByLevel(const ProgressiveMesh& progressive, ProgressiveLevel& level)
{
    std::vector<std::uint32_t> faces(std::size_t{progressive.stepCount} + 1);
    for (std::uint32_t steps = progressive.stepCount + 1; steps-- > 0;)
    {
        level.moveTo(steps);
        faces[steps] = level.faceCount();
    }
    return faces;
}

/// Returns a level's positions and faces without attributes.
Mesh shapeAfter(const ProgressiveMesh& progressive, const ProgressiveLevel& level)
{
    const Mesh& full = progressive.mesh;
    Mesh mesh;
    const auto positions = static_cast<std::ptrdiff_t>(full.positions.size() - level.steps());
    mesh.positions.assign(full.positions.begin(), full.positions.begin() + positions);
    mesh.wedgePositions.assign(full.wedgePositions.begin(),
                               full.wedgePositions.begin() + static_cast<std::ptrdiff_t>(level.wedgeCount()));
    forEachDrawnFace(progressive, level,
                     [&](const Triangle& face, std::uint32_t) {
                         mesh.faces.push_back({face, 0, 0});
                     });
    return mesh;
}

} // namespace

void measureLevels(ProgressiveMesh& progressive, const LadderSettings& settings)
{
    progressive.ladder.clear();
    ProgressiveLevel level(progressive);
    const std::vector<std::uint32_t> faces = facesByLevel(progressive, level);
    const Mesh original = shapeAfter(progressive, level);
    const LevelMeter meter(original,
                           std::min<std::size_t>(settings.samples, kLeastSamples + original.faces.size()));
    for (const std::uint32_t steps : ladderSteps(faces, settings.ratio))
    {
        level.moveTo(steps);
        const MeasuredError error =
            steps == 0 ? MeasuredError{} : meter.measure(shapeAfter(progressive, level));
        if (std::isfinite(error.maximum)) progressive.ladder.push_back({steps, error});
    }
}

} // namespace osgPMObjects::core
