// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <osgPMObjects/core/mesh/Mesh.h>
#include <osgPMObjects/core/simplify/CollapseSequence.h>

namespace osgPMObjects::core
{

/// The faces of a mesh after some steps: those that are left, with their wedges.
struct FacesAfter
{
    std::vector<std::uint32_t> wedges; ///< by wedge: its replacement, for faces that are left
    std::vector<bool> isLeft;          ///< by face

    FacesAfter(const Mesh& mesh, const CollapseSequence& sequence, std::size_t steps);
};

} // namespace osgPMObjects::core
