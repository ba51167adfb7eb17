// SPDX-License-Identifier: Apache-2.0
#include <osgPMObjects/core/simplify/RemoveVertices.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include "compare/objects/SimplifyTool.h"

namespace pmtool
{

namespace
{

using namespace osgPMObjects;

struct NamedCost
{
    const char* name;
    core::Placement placement;
    core::Quadrics quadrics = core::Quadrics::memoryless;
};

constexpr NamedCost kCosts[] = {
    {"subset", core::Placement::subset},
    {"optimal", core::Placement::optimal},
    {"quality", core::Placement::quality},
    {"subset-accumulated", core::Placement::subset, core::Quadrics::accumulated},
    {"optimal-accumulated", core::Placement::optimal, core::Quadrics::accumulated}};

std::vector<SimplifiedLevel> levelsOf(const SimplifyTask& task, const NamedCost& cost)
{
    core::CollapseSequence sequence;
    const core::SimplifySettings settings{.placement = cost.placement,
                                          .quadrics = cost.quadrics,
                                          .keepSeams = task.seams,
                                          .materialColours = task.materialColours};
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
    for (const NamedCost& cost : kCosts)
        tools.push_back(
            {cost.name, true, [&cost](const SimplifyTask& task) { return levelsOf(task, cost); }});
    tools.push_back({"removal", true, [](const SimplifyTask& task) { return removalLevels(task); }});
}

} // namespace pmtool
