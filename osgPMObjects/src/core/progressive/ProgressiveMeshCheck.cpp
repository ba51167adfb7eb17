// SPDX-License-Identifier: Apache-2.0
#include "ProgressiveMeshCheck.h"

#include <algorithm>
#include <cmath>

#include <osgPMObjects/core/progressive/ProgressiveLevel.h>

#include "RecordCheck.h"

namespace osgPMObjects::core
{

namespace
{

bool risesToItsEnd(const std::vector<std::uint32_t>& wedgePositions, std::size_t positions)
{
    // Every position has wedges, and its wedges are consecutive.
    std::uint32_t expected = 0;
    for (const std::uint32_t position : wedgePositions)
    {
        if (position != expected && position != expected - 1) return false;
        if (position == expected) ++expected;
    }
    return expected == positions;
}

bool areParents(const ProgressiveMesh& p)
{
    const std::size_t left = p.mesh.positions.size() - p.stepCount;
    for (std::uint32_t wedge = 0; wedge < p.parents.size(); ++wedge)
    {
        const bool stays = p.mesh.wedgePositions[wedge] < left;
        if (p.parents[wedge] > wedge || (stays && p.parents[wedge] != wedge)) return false;
        if (p.parents[wedge] != wedge &&
            p.mesh.wedgePositions[p.parents[wedge]] == p.mesh.wedgePositions[wedge])
            return false;
    }
    return p.parents.size() == p.mesh.wedgeCount();
}

bool areGroupsAndBlocks(const ProgressiveMesh& p)
{
    for (std::uint32_t g = 0; g < p.groups.size(); ++g)
    {
        if (p.groups[g].material >= p.mesh.materials.size()) return false;
        if (g == 0 ? p.groups[g].firstBlock != 0 : p.groups[g].firstBlock <= p.groups[g - 1].firstBlock)
            return false;
        if (p.groups[g].firstBlock >= p.blocks.size()) return false;
    }
    if (p.groups.empty() != p.blocks.empty()) return false;
    std::size_t drawn = 0;
    for (std::uint32_t b = 0; b < p.blocks.size(); ++b)
    {
        if (b == 0 && p.blocks[b].firstSlot != 0) return false;
        if (p.blocks[b].firstSlot >= p.slotCount || p.endSlot(b) <= p.blocks[b].firstSlot) return false;
        if (p.blocks[b].extent > p.endSlot(b) - p.blocks[b].firstSlot) return false;
        drawn += p.blocks[b].extent;
    }
    return drawn == p.base.size();
}

bool isBase(const ProgressiveMesh& p)
{
    const std::size_t left = p.mesh.positions.size() - p.stepCount;
    return std::all_of(p.base.begin(), p.base.end(),
                       [&](const Triangle& t)
                       {
                           return repeatsCorner(t) ||
                                  std::all_of(t.begin(), t.end(),
                                              [&](std::uint32_t wedge) {
                                                  return wedge < p.mesh.wedgeCount() &&
                                                         p.mesh.wedgePositions[wedge] < left;
                                              });
                       });
}

template<class Vector>
bool areFinite(const std::vector<Vector>& values)
{
    return std::all_of(values.begin(), values.end(),
                       [](const Vector& v)
                       {
                           for (int i = 0; i < Vector::length(); ++i)
                               if (!std::isfinite(v[i])) return false;
                           return true;
                       });
}

bool areVerticesFinite(const Mesh& mesh)
{
    return areFinite(mesh.positions) && areFinite(mesh.normals) && areFinite(mesh.texCoords[0]) &&
           areFinite(mesh.texCoords[1]) && areFinite(mesh.colours);
}

bool areErrors(const ProgressiveMesh& p)
{
    const std::size_t kept =
        (std::size_t{p.stepCount} + ProgressiveMesh::kErrorStride - 1) / ProgressiveMesh::kErrorStride;
    const auto falls = [](const LevelError& a, const LevelError& b)
    {
        return !(a.distance <= b.distance && a.normal <= b.normal && a.texCoord <= b.texCoord &&
                 a.colour <= b.colour);
    };
    const auto isFinite = [](const LevelError& e)
    { return std::isfinite(e.distance + e.normal + e.texCoord + e.colour); };
    return areMeasured(p.ladder) && (p.ladder.empty() || p.ladder.back().steps <= p.stepCount) &&
           p.errors.size() == kept && std::all_of(p.errors.begin(), p.errors.end(), isFinite) &&
           isFinite(p.finestError) && (p.errors.empty() || !falls(p.finestError, p.errors.front())) &&
           std::adjacent_find(p.errors.begin(), p.errors.end(), falls) == p.errors.end();
}

bool isArray(std::size_t size, const ProgressiveMesh& p)
{
    return size == 0 || size == p.mesh.wedgeCount();
}

} // namespace

std::optional<PlayerNeeds> needsOf(const ProgressiveMesh& p)
{
    const bool isSound = p.stepCount <= p.mesh.positions.size() && p.records.size() >= kRecordPadding &&
                         p.slotBytes >= 1 && p.slotBytes <= 4 && p.wedgeBytes >= 1 && p.wedgeBytes <= 4 &&
                         p.slotCount <= (1u << 30) && p.mesh.faces.empty() &&
                         isArray(p.mesh.normals.size(), p) && isArray(p.mesh.texCoords[0].size(), p) &&
                         isArray(p.mesh.texCoords[1].size(), p) && isArray(p.mesh.colours.size(), p) &&
                         risesToItsEnd(p.mesh.wedgePositions, p.mesh.positions.size()) && areParents(p) &&
                         areGroupsAndBlocks(p) && isBase(p) && areErrors(p) && areVerticesFinite(p.mesh);
    return isSound ? RecordCheck(p).needs() : std::nullopt;
}

bool isValid(const ProgressiveMesh& progressive)
{
    const auto needs = needsOf(progressive);
    if (!needs || needs->slotsOfStep > progressive.mostSlotsOfStep ||
        needs->rearrangements > progressive.mostRearrangements ||
        needs->slotsMoved > progressive.mostSlotsMoved)
        return false;
    // Each record can be undone; if playing all of them forth and back restores the base, they fit together.
    ProgressiveLevel level(progressive);
    const auto drawn = [&]
    {
        std::vector<Triangle> faces;
        std::vector<SlotRange> ranges;
        for (std::uint32_t group = 0; group < progressive.groups.size(); ++group)
            level.appendRanges(group, ranges);
        for (const SlotRange& range : ranges)
            for (std::uint32_t slot = range.first; slot < range.first + range.count; ++slot)
                faces.push_back(level.face(slot));
        return faces;
    };
    const std::vector<Triangle> base = drawn();
    level.moveTo(0);
    const std::uint32_t faces = level.faceCount();
    level.moveTo(progressive.stepCount);
    return base == drawn() && faces <= progressive.slotCount;
}

} // namespace osgPMObjects::core
