// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <osgPMObjects/core/selection/SelectionStatistics.h>

namespace osgPMObjects::core
{

/// An instance as the vertex shader is given it (osgPMObjects/ObjectShader).
struct ShownInstance
{
    std::array<float, 4> place{}; ///< of the vertex buffer's 0, from the eye, along the field's axes; scale
    std::array<float, 4> turn{};  ///< quaternion x, y, z, w
    std::array<float, 4> shown{}; ///< door's lower and upper edge, morph, first vertex that morphs
};

/// With what shader, and when in the frame, instances are drawn.
enum class FieldPass : std::uint8_t
{
    settled,   ///< as they are
    switching, ///< behind a screen door, or with vertices on their way
    blended,   ///< with alpha, after all that is opaque
};

inline constexpr std::uint32_t kFieldPasses = 3;

/// Instances on one rung of their model's ladder.
struct FieldRun
{
    std::uint32_t rung = 0;
    std::uint32_t first = 0, count = 0; ///< of the picture's instances
};

/// The runs of one model in one pass, and the box about their instances' spheres. Frame: the field's.
struct FieldBatch
{
    std::uint32_t model = 0;
    FieldPass pass = FieldPass::settled;
    std::uint32_t firstRun = 0, endRun = 0;
    std::array<double, 3> low{}, high{};
};

/// What of a field is to be drawn in one view.
struct FieldPicture
{
    std::vector<ShownInstance> instances; ///< run by run
    std::vector<FieldRun> runs;
    std::vector<FieldBatch> batches;

    SelectionStatistics selection;
    std::uint32_t visible = 0;   ///< objects whose spheres are in sight
    std::uint32_t drawn = 0;     ///< of those, not faded away
    std::uint32_t switching = 0; ///< of those, on their way between two levels
    std::uint64_t triangles = 0; ///< in all passes; what is blended counts once
};

} // namespace osgPMObjects::core
