// SPDX-License-Identifier: Apache-2.0
#include <osgPMObjects/core/consolidate/Consolidate.h>
#include <osgPMObjects/core/consolidate/MergeWedges.h>
#include <osgPMObjects/core/consolidate/Weld.h>
#include <osgPMObjects/core/simplify/Simplifiable.h>

namespace osgPMObjects::core
{

void makeSimplifiable(Mesh& mesh)
{
    consolidate(mesh);
    weldPositions(mesh, 0.0);
    mergeWedges(mesh);
}

} // namespace osgPMObjects::core
