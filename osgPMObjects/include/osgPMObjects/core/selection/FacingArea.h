// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <osgPMObjects/core/mesh/Mesh.h>
#include <osgPMObjects/core/selection/BoundingVolumes.h>
#include <osgPMObjects/core/selection/SelectionView.h>

namespace osgPMObjects::core
{

/// A surface's area by the way it faces: each face's area times its normal is added to the bin of 26 directions (the steps
/// to the neighbours of a cube among cubes) that is nearest its normal.
/// Frame: the axes that it was made with. Units: the mesh's squared. Memory: 312 B a model, shared by its instances.
struct FacingBins
{
    static constexpr std::size_t kBins = 26;
    std::array<glm::vec3, kBins> areas{};
};

/// `axes`: the directions that shall be x, y and z of the bins (those of an oriented box), unit vectors at right angles,
/// in the mesh. Cost: linear in the faces.
FacingBins facingBinsOf(const Mesh& mesh, const glm::dmat3& axes = glm::dmat3(1.0));

/// r = Σ a (n · v) / d² over the faces that are turned to the eye: what they would cover of the picture if none hid
/// another and all lay at the centre, v being the direction from there to the eye. It is for objects whose box says little
/// of what is seen: signs, walls and fences that show their edge, roofs seen from the side, and for choosing by the
/// surface that is drawn instead of its hull. Never more than the sum over single faces, and less only where a bin's
/// normals face to and away from the eye at once: of a ball up to a tenth, of boxes nothing.
/// kFullArea with the eye inside the sphere. Units: pixels squared. Cost: some 40 ns.
/// Source: paper 004, section 2.3.3 (Coorg & Teller 1997), for one face. Differs: a sum, in 26 bins; times the pixels of a
/// unit of tangent squared, so that it compares with the other areas.
/// `axes`: the bins' in the world; `metresPerUnit`: of the mesh's units.
double facingAreaPx(const SelectionView& view, const BoundingSphere& sphere, const FacingBins& bins,
                    const glm::dmat3& axes, double metresPerUnit);

} // namespace osgPMObjects::core
