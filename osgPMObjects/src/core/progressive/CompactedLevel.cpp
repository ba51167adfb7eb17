// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <numeric>

#include <osgPMObjects/core/progressive/CompactedLevel.h>
#include <osgPMObjects/core/progressive/LevelMesh.h>

namespace osgPMObjects::core
{

CompactedLevel::CompactedLevel(const ProgressiveMesh& progressive)
    : _progressive(progressive), _groupEnds(progressive.groups.size())
{
    ProgressiveLevel finest(progressive);
    finest.moveTo(0);
    _fullEnds.resize(progressive.groups.size(), 0);
    forEachDrawnFace(progressive, finest,
                     [this](const Triangle& face, std::uint32_t group)
                     {
                         _full.push_back(face);
                         ++_fullEnds[group];
                     });
    std::partial_sum(_fullEnds.begin(), _fullEnds.end(), _fullEnds.begin());
    _triangles.resize(_full.size());
    for (std::uint32_t wedge = 0; wedge < progressive.mesh.wedgeCount(); ++wedge)
        _become.push_back({wedge, progressive.mesh.wedgePositions[wedge]});
    moveTo(0);
}

SlotRange CompactedLevel::rangeOf(std::uint32_t group) const
{
    const std::uint32_t first = group == 0 ? 0 : _groupEnds[group - 1];
    return {first, _groupEnds[group] - first};
}

void CompactedLevel::findWedges(std::uint32_t wedgesLeft)
{
    const auto& positions = _progressive.mesh.wedgePositions;
    for (std::uint32_t wedge = 0; wedge < wedgesLeft; ++wedge)
        _become[wedge] = {wedge, positions[wedge]};
    for (std::uint32_t wedge = wedgesLeft; wedge < _become.size(); ++wedge)
    {
        const std::uint32_t parent = _progressive.parents[wedge];
        _become[wedge] = parent == wedge ? Become{wedge, positions[wedge]} : _become[parent];
    }
}

void CompactedLevel::moveTo(std::uint32_t steps)
{
    const std::uint32_t wedgesLeft = _progressive.wedgesAfter(steps);
    findWedges(wedgesLeft);
    std::uint32_t live = 0, slot = 0;
    for (std::uint32_t group = 0; group < _progressive.groups.size(); ++group)
    {
        for (; slot < _fullEnds[group]; ++slot)
        {
            const Become a = _become[_full[slot][0]], b = _become[_full[slot][1]],
                         c = _become[_full[slot][2]];
            _triangles[live] = {a.wedge, b.wedge, c.wedge};
            const unsigned isHere{std::max({a.wedge, b.wedge, c.wedge}) < wedgesLeft};
            const unsigned ab{a.position != b.position}, bc{b.position != c.position},
                ca{c.position != a.position};
            live += isHere & ab & bc & ca; // without a branch: it would be a coin's
        }
        _groupEnds[group] = live;
    }
    _live = live;
}

} // namespace osgPMObjects::core
