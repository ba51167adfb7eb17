// SPDX-License-Identifier: Apache-2.0
#include <osgMultiTriangulation/core/build/CollapseOrder.h>

#include "Simplification.h"

namespace osgMultiTriangulation::core
{

std::vector<VertexCollapse> collapseOrder(const SurfaceMesh& mesh)
{
    const MeasuredMesh input = fullMesh(mesh);
    Simplification simplification(input, {}, Filling::fan);
    simplification.run(0);
    std::vector<VertexCollapse> order;
    order.reserve(simplification.removals().size());
    for (const Removal& removal : simplification.removals())
        order.push_back({removal.vertex, removal.apex});
    return order;
}

} // namespace osgMultiTriangulation::core
