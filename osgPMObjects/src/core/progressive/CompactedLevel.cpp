// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <numeric>

#include <osgPMObjects/core/progressive/CompactedLevel.h>

namespace osgPMObjects::core
{

CompactedLevel::CompactedLevel(const ProgressiveMesh& progressive)
    : _progressive(progressive),
      _wedges(progressive.mesh.wedgeCount()),
      _triangles(progressive.mesh.faces.size()),
      _groupEnds(progressive.groups.size())
{
    std::iota(_wedges.begin(), _wedges.end(), 0u);
    moveTo(0);
}

SlotRange CompactedLevel::rangeOf(std::uint32_t group) const
{
    const std::uint32_t first = group == 0 ? 0 : _groupEnds[group - 1];
    return {first, _groupEnds[group] - first};
}

void CompactedLevel::findWedges(std::uint32_t wedgesLeft)
{
    std::iota(_wedges.begin(), _wedges.begin() + wedgesLeft, 0u);
    for (std::size_t wedge = wedgesLeft; wedge < _wedges.size(); ++wedge)
    {
        const std::uint32_t parent = _progressive.parents[wedge];
        _wedges[wedge] = parent == wedge ? parent : _wedges[parent];
    }
}

void CompactedLevel::moveTo(std::uint32_t steps)
{
    const auto& positions = _progressive.mesh.wedgePositions; // rise with the wedges
    const auto positionsLeft = static_cast<std::uint32_t>(_progressive.mesh.positions.size()) - steps;
    const auto wedgesLeft = static_cast<std::uint32_t>(
        std::lower_bound(positions.begin(), positions.end(), positionsLeft) - positions.begin());
    findWedges(wedgesLeft);
    std::uint32_t live = 0, slot = 0;
    for (std::uint32_t group = 0; group < _progressive.groups.size(); ++group)
    {
        const bool isLast = group + 1 == _progressive.groups.size();
        const std::uint32_t end =
            isLast ? static_cast<std::uint32_t>(_triangles.size())
                   : _progressive.blocks[_progressive.groups[group + 1].firstBlock].firstSlot;
        for (; slot < end; ++slot)
        {
            const auto& wedges = _progressive.mesh.faces[slot].wedges;
            const Triangle triangle{_wedges[wedges[0]], _wedges[wedges[1]], _wedges[wedges[2]]};
            const bool isHere = std::max({triangle[0], triangle[1], triangle[2]}) < wedgesLeft;
            const std::uint32_t a = positions[triangle[0]], b = positions[triangle[1]],
                                c = positions[triangle[2]];
            _triangles[live] = triangle;
            live += isHere & (a != b) & (b != c) & (c != a); // without a branch: it would be a coin's
        }
        _groupEnds[group] = live;
    }
    _live = live;
}

} // namespace osgPMObjects::core
