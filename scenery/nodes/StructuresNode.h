// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Group>

#include "scenery/structures/StructureFacets.h"

namespace scenery
{

/// Makes a node of structures: lattices and wires near by, plainer ones in their place far away.
/// Frame: the scene's. Needs the uniforms of an Atmosphere above it in the graph.
osg::ref_ptr<osg::Group> makeStructuresNode(const StructureSquares& squares);

} // namespace scenery
