// SPDX-License-Identifier: Apache-2.0
#include <glm/geometric.hpp>

#include <osgPMObjects/core/progressive/LevelMesh.h>
#include <osgPMObjects/core/progressive/ProgressiveLevel.h>
#include <osgPMObjects/core/selection/LevelTable.h>

namespace osgPMObjects::core
{

LevelTable LevelTable::of(const ProgressiveMesh& progressive)
{
    LevelTable table;
    table.positions = static_cast<std::uint32_t>(progressive.mesh.positions.size());
    table.faces.resize(std::size_t{progressive.stepCount} + 1);
    ProgressiveLevel level(progressive);
    for (std::uint32_t steps = progressive.stepCount + 1; steps-- > 0;)
    {
        level.moveTo(steps);
        table.faces[steps] = level.faceCount();
    }
    while (table.faces.size() > 1 && table.faces.back() == 0)
        table.faces.pop_back();
    for (std::uint32_t steps = 0; steps < table.faces.size(); ++steps)
        table.errors.push_back(core::errorAfter(progressive, steps));
    std::vector<MeasuredLevel> measured = progressive.ladder;
    std::erase_if(measured, [&](const MeasuredLevel& l) { return l.steps >= table.faces.size(); });
    table.measured = ErrorLadder(std::move(measured));
    const auto at = [&](std::uint32_t wedge)
    { return progressive.mesh.positions[progressive.mesh.wedgePositions[wedge]]; };
    forEachDrawnFace(progressive, level,
                     [&](const Triangle& t, std::uint32_t)
                     {
                         const glm::dvec3 a = at(t[0]);
                         table.area += 0.5 * glm::length(glm::cross(at(t[1]) - a, at(t[2]) - a));
                     });
    return table;
}

} // namespace osgPMObjects::core
