// SPDX-License-Identifier: Apache-2.0
#include <cassert>

#include <osgPMObjects/core/progressive/MorphTargets.h>

namespace osgPMObjects::core
{

MorphTargets morphTargets(const ProgressiveMesh& progressive, std::uint32_t finerSteps,
                          std::uint32_t coarserSteps)
{
    assert(finerSteps <= coarserSteps && coarserSteps <= progressive.stepCount);
    const auto& positions = progressive.mesh.wedgePositions;
    MorphTargets morph;
    morph.firstWedge = progressive.wedgesAfter(coarserSteps);
    const std::uint32_t end = progressive.wedgesAfter(finerSteps);
    morph.targets.reserve(end - morph.firstWedge);
    const auto targetOf = [&](std::uint32_t wedge)
    {
        return wedge < morph.firstWedge ? MorphTargets::Target{wedge, wedge}
                                        : morph.targets[wedge - morph.firstWedge];
    };
    // The wedges of a position are consecutive, and a parent has a lower number.
    for (std::uint32_t first = morph.firstWedge; first < end;)
    {
        std::uint32_t next = first, positionWedge = first;
        for (; next < end && positions[next] == positions[first]; ++next)
            if (const std::uint32_t parent = progressive.parents[next]; parent != next)
                positionWedge = targetOf(parent).positionWedge;
        for (; first < next; ++first)
        {
            const std::uint32_t parent = progressive.parents[first];
            morph.targets.push_back(
                {positionWedge, parent == first ? first : targetOf(parent).attributeWedge});
        }
    }
    return morph;
}

} // namespace osgPMObjects::core
