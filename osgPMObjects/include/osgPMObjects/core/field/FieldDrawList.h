// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <osgPMObjects/core/selection/SelectionStatistics.h>

namespace osgPMObjects::core
{

/// The vertex attributes of one drawn instance, as the shader reads them (osgPMObjects/ObjectShader).
struct InstanceAttributes
{
    /// x, y, z of the vertex buffer's 0 relative to the eye, along the field's axes; scale
    std::array<float, 4> positionAndScale{};
    std::array<float, 4> rotation{}; ///< unit quaternion x, y, z, w
    std::array<float, 4>
        transition{}; ///< screen door's lower and upper threshold, morph 0 … 1, first vertex that morphs
};

/// The pass that draws an instance: it decides the shader and the time in the frame.
enum class FieldPass : std::uint8_t
{
    settled,   ///< the instance does not switch
    switching, ///< the instance is drawn through a screen door, or its vertices morph
    blended,   ///< the instance is drawn with alpha, after everything opaque
};

inline constexpr std::uint32_t kFieldPasses = 3;

/// A run of instances on one rung of their model's ladder.
struct FieldRun
{
    std::uint32_t rung = 0;
    std::uint32_t first = 0, count = 0; ///< range of FieldDrawList::instances
};

/// The runs of one model in one pass, with the bounding box of their instances' spheres. Frame: the field's.
struct FieldBatch
{
    std::uint32_t model = 0;
    FieldPass pass = FieldPass::settled;
    std::uint32_t firstRun = 0, endRun = 0;
    std::array<double, 3> low{}, high{};
};

/// The instances of a field to draw in one view.
struct FieldDrawList
{
    std::vector<InstanceAttributes> instances; ///< sorted by run
    std::vector<FieldRun> runs;
    std::vector<FieldBatch> batches;

    SelectionStatistics selection;
    std::uint32_t visible = 0;   ///< objects whose spheres are in the view
    std::uint32_t drawn = 0;     ///< visible objects that have not faded out
    std::uint32_t switching = 0; ///< drawn objects that change between two levels
    std::uint64_t triangles = 0; ///< in all passes; a blended object counts once
};

} // namespace osgPMObjects::core
