// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "scenery/models/Model.h"

namespace scenery::models
{

/// What keeps a model from being one: a mesh that is none (MeshCheck.h), a wedge without a unit normal, finite texture
/// coordinates or a colour, a material without its surface, a degenerate face, measures that are not those of the mesh. Empty: nothing does. Cost: linear.
std::string defectOf(const Model& model);

inline bool isModel(const Model& model)
{
    return defectOf(model).empty();
}

/// Whether the faces of all parts of a name close: every edge is passed as often one way as the other. False without such faces.
bool isClosed(const osgPMObjects::core::Mesh& mesh, const std::string& partName);

} // namespace scenery::models
