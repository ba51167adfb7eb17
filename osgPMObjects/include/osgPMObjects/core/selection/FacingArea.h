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

/// The area of a surface by the direction that it faces. Each face's area times its normal is added to the
/// bin whose direction is nearest its normal; the 26 directions lead from the centre of a cube to its faces,
/// edges and corners.
/// Frame: the axes given to facingBinsOf(). Units: the mesh's squared. Memory: 312 B a model, shared by its
/// instances.
struct FacingBins
{
    static constexpr std::size_t kBins = 26;
    std::array<glm::vec3, kBins> areas{};
};

/// Computes the bins of a mesh. Cost: linear in the faces.
/// `axes`: columns, orthogonal unit vectors in the mesh's frame (those of an oriented box) that become x, y
/// and z of the bins.
FacingBins facingBinsOf(const Mesh& mesh, const glm::dmat3& axes = glm::dmat3(1.0));

/// Computes the area of the faces that are turned to the eye, projected onto the image plane:
///     r = Σ a (n · v) / d²,
/// v being the direction from the centre to the eye; it takes no face to hide another and all of them to lie
/// at the centre.
/// It suits objects whose box tells little of the visible surface: signs, walls and fences seen from their
/// edge, roofs seen from the side. It is never more than the sum over single faces. It is less only if a
/// bin's normals face to and away from the eye at once: by up to a tenth for a ball, by nothing for boxes.
/// kFullArea with the eye inside the sphere. Units: pixels squared. Cost: some 40 ns.
/// `axes`: of the bins, in the world; `metresPerUnit`: of the mesh's units.
/// Source: Sadykov & Zakharov, *Choosing the level of detail in continuous simplification of polygonal
/// objects* (2002), section 2.3.3, after Coorg & Teller (1997), for one face. Differs: a sum over 26 bins; in
/// pixels, as the other areas.
double facingAreaPx(const SelectionView& view, const BoundingSphere& sphere, const FacingBins& bins,
                    const glm::dmat3& axes, double metresPerUnit);

} // namespace osgPMObjects::core
