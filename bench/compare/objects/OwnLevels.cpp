// SPDX-License-Identifier: Apache-2.0
#include <osgPMObjects/core/simplify/RemoveVertices.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include "compare/objects/SimplifyTool.h"

namespace pmtool
{

namespace
{

using namespace osgPMObjects;

struct NamedPlacement
{
    const char* name;
    core::Placement placement;
};

constexpr NamedPlacement kPlacements[] = {{"subset", core::Placement::subset},
                                          {"optimal", core::Placement::optimal},
                                          {"quality", core::Placement::quality}};

std::vector<SimplifiedLevel> levelsOf(const SimplifyTask& task, core::Placement placement)
{
    core::CollapseSequence sequence;
    const core::SimplifySettings settings{
        .placement = placement, .keepSeams = task.seams, .materialColours = task.materialColours};
    const double runMs = millisecondsOf([&] { sequence = core::simplify(task.mesh, settings); });
    std::vector<SimplifiedLevel> levels;
    for (const std::size_t target : task.targets)
    {
        SimplifiedLevel& level = levels.emplace_back();
        level.ms =
            runMs +
            millisecondsOf(
                [&]
                { level.mesh = core::meshAfter(task.mesh, sequence, core::stepsToFaces(sequence, target)); });
    }
    return levels;
}

std::vector<SimplifiedLevel> removalLevels(const SimplifyTask& task)
{
    const core::Mesh& mesh = task.seams ? task.mesh : task.shape;
    core::RemovalSequence sequence;
    const double runMs = millisecondsOf([&] { sequence = core::removeVertices(mesh); });
    std::vector<SimplifiedLevel> levels;
    for (const std::size_t target : task.targets)
    {
        SimplifiedLevel& level = levels.emplace_back();
        const double levelMs = millisecondsOf(
            [&] { level.mesh = core::meshAfter(mesh, sequence, sequence.stepsToFaces(target)).mesh; });
        level.ms = runMs + levelMs;
    }
    return levels;
}

} // namespace

void addOwnTools(std::vector<SimplifyTool>& tools)
{
    for (const NamedPlacement& named : kPlacements)
        tools.push_back({named.name, true, [placement = named.placement](const SimplifyTask& task) {
                             return levelsOf(task, placement);
                         }});
    tools.push_back({"removal", true, [](const SimplifyTask& task) { return removalLevels(task); }});
}

} // namespace pmtool
