// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cassert>
#include <cstddef>
#include <span>
#include <utility>

#include <osgPMObjects/core/simplify/CollapsesOfRemovals.h>

#include "../star/StarMesh.h"

namespace osgPMObjects::core
{

namespace
{

/// Plays removals as collapses and writes them down.
class CollapseWriter
{
public:
    explicit CollapseWriter(const Mesh& mesh) : _stars(mesh)
    {
        _sequence.facesBefore = _faces = _stars.faceCount();
    }

    void write(const RemovalStep& step)
    {
        if (!_stars.hasFaces(step.position)) return; // the last positions of a part
        assert(step.isOfPart || step.apex != RemovalStep::kNoApex);
        const std::uint32_t to = step.isOfPart ? neighbourOf(step.position) : step.apex;
        CollapseStep collapse;
        collapse.from = step.position;
        collapse.to = to;
        collapse.firstWedge = static_cast<std::uint32_t>(_sequence.wedges.size());
        replaceWedges(step.position, to);
        _faces -=
            _stars.collapse(step.position, to, std::span(_sequence.wedges).subspan(collapse.firstWedge));
        collapse.facesAfter = _faces;
        collapse.error.distance = static_cast<float>(step.error);
        _sequence.steps.push_back(collapse);
    }

    CollapseSequence take() { return std::move(_sequence); }

private:
    std::uint32_t neighbourOf(std::uint32_t position) const
    {
        std::uint32_t neighbour = position;
        _stars.visitStar(position, [&](std::uint32_t face, int corner)
                         { neighbour = _stars.positions(face)[(corner + 1) % 3]; });
        return neighbour;
    }

    /// Gives each wedge of `from` the wedge of `to` in a face with both; else any wedge of `to`.
    void replaceWedges(std::uint32_t from, std::uint32_t to)
    {
        const std::size_t first = _sequence.wedges.size();
        const auto replacementOf = [&](std::uint32_t wedge)
        {
            return std::find_if(_sequence.wedges.begin() + static_cast<std::ptrdiff_t>(first),
                                _sequence.wedges.end(),
                                [&](const WedgeCollapse& w) { return w.from == wedge; });
        };
        std::uint32_t any = 0;
        _stars.visitStar(from,
                         [&](std::uint32_t face, int corner)
                         {
                             const Triangle &corners = _stars.positions(face), &wedges = _stars.wedges(face);
                             const auto at = std::find(corners.begin(), corners.end(), to) - corners.begin();
                             if (at == 3) return;
                             any = wedges[at];
                             if (replacementOf(wedges[corner]) == _sequence.wedges.end())
                                 _sequence.wedges.push_back({wedges[corner], any});
                         });
        _stars.visitStar(from,
                         [&](std::uint32_t face, int corner)
                         {
                             const std::uint32_t wedge = _stars.wedges(face)[corner];
                             if (replacementOf(wedge) == _sequence.wedges.end())
                                 _sequence.wedges.push_back({wedge, any});
                         });
    }

    StarMesh _stars;
    CollapseSequence _sequence;
    std::uint32_t _faces = 0;
};

} // namespace

CollapseSequence collapsesOf(const Mesh& mesh, const RemovalSequence& removals)
{
    CollapseWriter writer(mesh);
    for (const RemovalStep& step : removals.steps)
        writer.write(step);
    return writer.take();
}

} // namespace osgPMObjects::core
