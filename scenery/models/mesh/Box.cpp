// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/mesh/Box.h"

namespace scenery::models
{

void addBox(ModelBuilder& builder, const Box& box)
{
    // `axis` is the normal of a side; u and v span it.
    for (int axis = 0; axis < 3; ++axis)
    {
        const int u = axis == 0 ? 1 : 0;
        const int v = axis == 2 ? 1 : 2;
        for (int side = 0; side < 2; ++side)
        {
            const auto at = [&](int right, int up)
            {
                glm::dvec3 place;
                place[axis] = side == 1 ? box.high[axis] : box.low[axis];
                place[u] = right == 1 ? box.high[u] : box.low[u];
                place[v] = up == 1 ? box.high[v] : box.low[v];
                const float light = place.z > box.low.z ? 1.0F : box.bottomLight;
                return Corner{place,
                              {right == 1 ? box.uvHigh.x : box.uvLow.x, up == 1 ? box.uvHigh.y : box.uvLow.y},
                              {},
                              light};
            };
            const bool turns = (axis == 1) != (side == 1); // u × v points along +axis, except for y
            if (turns)
                builder.quad(at(0, 0), at(1, 0), at(1, 1), at(0, 1));
            else
                builder.quad(at(0, 0), at(0, 1), at(1, 1), at(1, 0));
        }
    }
}

} // namespace scenery::models
