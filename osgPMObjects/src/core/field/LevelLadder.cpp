// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <osgPMObjects/core/field/LevelLadder.h>
#include <osgPMObjects/core/order/FaceOrder.h>
#include <osgPMObjects/core/progressive/LevelMesh.h>
#include <osgPMObjects/core/selection/DrawableRows.h>

namespace osgPMObjects::core
{

namespace
{

/// Returns the levels of the rungs: the first level with each wanted number of faces, and the coarsest level.
std::vector<std::uint32_t> stepsOfRungs(const LevelTable& table, double ratio)
{
    std::vector<std::uint32_t> steps;
    for (double wanted = table.faces.front(); wanted >= table.faces.back() && wanted >= 1.0; wanted *= ratio)
    {
        const auto level = std::partition_point(table.faces.begin(), table.faces.end(),
                                                [&](std::uint32_t faces) { return faces > wanted; });
        const auto at = static_cast<std::uint32_t>(level - table.faces.begin());
        if (steps.empty() || at > steps.back()) steps.push_back(at);
    }
    if (steps.empty() || steps.back() != table.mostSteps()) steps.push_back(table.mostSteps());
    return steps;
}

/// Appends a level's faces, group by group, as meshAfter() has them.
void append(LevelLadder& ladder, const Mesh& level, const std::vector<FaceGroup>& groups)
{
    auto face = level.faces.begin();
    for (const FaceGroup& group : groups)
    {
        for (; face != level.faces.end() && face->material == group.material; ++face)
            ladder.faces.push_back(face->wedges);
        ladder.ends.push_back(static_cast<std::uint32_t>(ladder.faces.size()));
    }
}

} // namespace

LevelLadder LevelLadder::of(const ProgressiveMesh& progressive, const LevelTable& table, double ratio)
{
    LevelLadder ladder;
    ladder.steps = stepsOfRungs(table, ratio);
    ladder.groups = static_cast<std::uint32_t>(progressive.groups.size());
    for (const std::uint32_t steps : ladder.steps)
    {
        Mesh level = meshAfter(progressive, steps);
        orderFaces(level, FaceOrder::locality);
        append(ladder, level, progressive.groups);
        ladder.rungs.push_back({steps, static_cast<std::uint32_t>(level.faces.size()),
                                static_cast<std::uint32_t>(level.wedgeCount())});
    }
    return ladder;
}

std::uint32_t LevelLadder::rungOf(std::uint32_t levelSteps) const
{
    return drawableRowOf(steps, levelSteps);
}

SlotRange LevelLadder::facesOf(std::uint32_t rung, std::uint32_t group) const
{
    const std::size_t at = std::size_t{rung} * groups + group;
    const std::uint32_t first = at == 0 ? 0 : ends[at - 1];
    return {first, ends[at] - first};
}

bool isLadder(const LevelLadder& ladder)
{
    const std::size_t rungs = ladder.rungs.size();
    if (rungs == 0 || ladder.steps.size() != rungs || ladder.ends.size() != rungs * ladder.groups)
        return false;
    if (ladder.rungs.front().steps != 0 || !std::is_sorted(ladder.ends.begin(), ladder.ends.end()))
        return false;
    if (!ladder.ends.empty() && ladder.ends.back() != ladder.faces.size()) return false;
    for (std::uint32_t rung = 0; rung < rungs; ++rung)
    {
        const LevelLadder::Rung& r = ladder.rungs[rung];
        if (r.steps != ladder.steps[rung]) return false;
        if (rung > 0 && (r.steps <= ladder.rungs[rung - 1].steps || r.faces > ladder.rungs[rung - 1].faces))
            return false;
        std::uint32_t faces = 0;
        for (std::uint32_t group = 0; group < ladder.groups; ++group)
        {
            const SlotRange range = ladder.facesOf(rung, group);
            faces += range.count;
            for (std::uint32_t f = range.first; f < range.first + range.count; ++f)
                for (const std::uint32_t wedge : ladder.faces[f])
                    if (wedge >= r.wedges) return false;
        }
        if (faces != r.faces) return false;
    }
    return true;
}

} // namespace osgPMObjects::core
