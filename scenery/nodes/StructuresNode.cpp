// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/StructuresNode.h"

#include "scenery/nodes/FacetNodes.h"
#include "scenery/nodes/ObjectShading.h"

namespace scenery
{

osg::ref_ptr<osg::Group> makeStructuresNode(const StructureSquares& squares)
{
    const osg::ref_ptr<osg::Group> root = new osg::Group;
    setObjectShading(*root, Finish::matt);
    const auto add = [&](const StructureSquare& square, const Facets& facets, double nearM, double farM)
    {
        if (!facets.indices.empty()) addRange(*root, square.origin, nearM, farM).addChild(geometryOf(facets));
    };
    for (const auto& [number, square] : squares)
    {
        add(square, square.fine, 0.0, kStructureFineM);
        add(square, square.coarse, kStructureFineM, kStructureCoarseM);
        add(square, square.low, 0.0, kStructureLowM);
    }
    return root;
}

} // namespace scenery
