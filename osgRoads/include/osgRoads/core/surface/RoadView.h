// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include <viewlod/ViewState.h>

#include <osgRoads/core/surface/RoadMesh.h>

namespace osgRoads::core
{

/// Which levels a view gets. Units: metres, pixels.
struct RoadViewSettings
{
    double tolerancePx = 0.5;  ///< together with the lift less than a pixel
    double farthestM = 2500.0; ///< chunks beyond are not drawn; the ground's own paint shows the road there
    double liftPx = 0.6;       ///< by how much the road is lifted far away, above ground that errs by a pixel
    double liftFromM = 20.0;   ///< nearer than this nothing is lifted: there wheels are looked at
    double nearErrorM = 0.008; ///< of levels there, whatever the pixels
    double liftFullM = 120.0;  ///< from here on by all of liftPx

    /// Returns the distance from which on the surface fades out; the fragment shader has the same share.
    double fadeFromM() const { return 0.85 * farthestM; }

    bool operator==(const RoadViewSettings&) const = default;
};

/// The chosen level of a visible chunk.
struct ChunkChoice
{
    std::uint32_t chunk = 0, level = 0;

    bool operator==(const ChunkChoice&) const = default;
};

/// Returns the coarsest level of each chunk in the frustum whose error stays within the tolerance anywhere in
/// the image. It looks at every chunk; for each frame of a large network take the one of ChunkTree.h. Frame:
/// `view` in the scene's.
std::vector<ChunkChoice> chooseLevels(const RoadMesh& mesh, const viewlod::ViewState& view,
                                      const RoadViewSettings& settings);

/// Returns by how much the surface is lifted at a distance from the eye; the vertex shader does the same.
double liftAt(double distanceM, const viewlod::ViewState& view, const RoadViewSettings& settings);

/// Returns the height at which a view draws the surface at a point of the plan view, lift included: the
/// highest that is not above `below`. Nothing: no road is drawn there.
std::optional<double> drawnHeight(const RoadMesh& mesh, const std::vector<ChunkChoice>& choices,
                                  const viewlod::ViewState& view, const RoadViewSettings& settings,
                                  glm::dvec2 at, double below = 1e9);

} // namespace osgRoads::core
