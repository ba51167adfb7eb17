// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// What keeps a mesh from being one: an index that points nowhere, an attribute array of another length than the wedges,
/// a coordinate or attribute that is no finite number, a position or wedge of which there are more than 2^32 - 2. Empty:
/// nothing does. Says nothing about shape: degenerate faces and open edges are allowed.
/// Cost: linear.
std::string defectOf(const Mesh& mesh);

inline bool isValid(const Mesh& mesh)
{
    return defectOf(mesh).empty();
}

} // namespace osgPMObjects::core
