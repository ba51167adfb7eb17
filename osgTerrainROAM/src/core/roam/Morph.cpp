// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <osgTerrainROAM/core/roam/Morph.h>
#include <osgTerrainROAM/core/roam/Refinement.h>

namespace osgTerrainROAM::core
{

void Morph::update(DiamondTree& tree, const viewlod::ViewState& view, double tolerance0Px)
{
    tree.startDisplacing();
    const double perPx = 1.0 / (tolerance0Px * (kSpan - 1.0));
    for (VertexSlot v = DiamondTree::kCorners; v < tree.vertexSlots(); ++v)
    {
        if (tree.place(v).isFree()) continue;
        const double priority = priorityPx(view, tree.bound(v));
        const double weight = std::clamp((priority - tolerance0Px) * perPx, 0.0, 1.0);
        if (weight < 1.0)
            _moving[static_cast<std::size_t>(tree.place(v).level)].push_back({v, static_cast<float>(weight)});
        else
            tree.displace(v, glm::vec3(0.0f)); // and everything that it hangs on is in its place, too
    }
    for (std::vector<Moving>& ofLevel : _moving)
    {
        for (const Moving& moving : ofLevel)
        {
            const auto [a, b] = tree.baseEnds(moving.vertex);
            const glm::dvec3 delta =
                tree.samplePosition(moving.vertex) - 0.5 * (tree.samplePosition(a) + tree.samplePosition(b));
            const glm::vec3 ends = 0.5f * (tree.displacement(a) + tree.displacement(b));
            tree.displace(moving.vertex, ends - (1.0f - moving.weight) * glm::vec3(delta));
        }
        ofLevel.clear();
    }
}

} // namespace osgTerrainROAM::core
