// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <glm/glm.hpp>

#include <osgPMObjects/core/selection/LevelTable.h>

namespace osgPMObjects::core
{

namespace
{

/// Returns a table with positions, area and level 0.
LevelTable fullMeshOnly(const Mesh& mesh, std::uint32_t faces)
{
    LevelTable table;
    std::vector<bool> isUsed(mesh.positions.size(), false);
    for (const Face& face : mesh.faces)
    {
        table.area += 0.5 * glm::length(glm::cross(mesh.at(face, 1) - mesh.at(face, 0),
                                                   mesh.at(face, 2) - mesh.at(face, 0)));
        for (int corner = 0; corner < 3; ++corner)
            isUsed[mesh.positionOf(face, corner)] = true;
    }
    table.positions = static_cast<std::uint32_t>(std::count(isUsed.begin(), isUsed.end(), true));
    table.faces.push_back(faces);
    table.errors.emplace_back();
    return table;
}

} // namespace

LevelTable LevelTable::of(const Mesh& mesh, const CollapseSequence& sequence)
{
    LevelTable table = fullMeshOnly(mesh, sequence.facesBefore);
    for (const CollapseStep& step : sequence.steps)
    {
        if (step.facesAfter == 0) break;
        table.faces.push_back(step.facesAfter);
        table.errors.push_back(step.error);
    }
    return table;
}

std::uint32_t LevelTable::coarsestWith(std::uint32_t leastFaces) const
{
    const auto fewer =
        std::partition_point(faces.begin(), faces.end(), [=](std::uint32_t f) { return f >= leastFaces; });
    return fewer == faces.begin() ? 0 : static_cast<std::uint32_t>(fewer - faces.begin()) - 1;
}

LevelError LevelTable::errorAfter(std::uint32_t steps, ErrorKind kind) const
{
    LevelError error = errors[steps];
    if (!measured.isEmpty()) error.distance = measured.errorAfter(steps, kind);
    return error;
}

bool isLevelTable(const LevelTable& table)
{
    if (!areMeasured(table.measured.levels())) return false;
    if (!table.measured.isEmpty() && table.measured.levels().back().steps >= table.faces.size()) return false;
    if (table.faces.empty() || table.faces.size() != table.errors.size()) return false;
    if (table.errors.front() != LevelError{}) return false;
    const auto falls = [](const LevelError& a, const LevelError& b) {
        return b.distance < a.distance || b.normal < a.normal || b.texCoord < a.texCoord ||
               b.colour < a.colour;
    };
    return std::is_sorted(table.faces.rbegin(), table.faces.rend()) &&
           std::adjacent_find(table.errors.begin(), table.errors.end(), falls) == table.errors.end();
}

} // namespace osgPMObjects::core
