// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

namespace osgTerrainROAM::core
{

/// The driver that adapts a mesh from eye to eye. In error-target mode all drivers end in the same mesh.
enum class Driver
{
    wheel, ///< checks only vertices that the eye's travel may have changed (WheelDriver.h)
    walk,  ///< visits the whole tree of the last frame (WalkDriver.h)
    queue, ///< Duchaineau's: two queues by priority, kept from frame to frame (QueueDriver.h)
};

inline constexpr Driver kDrivers[] = {Driver::wheel, Driver::walk, Driver::queue};

constexpr std::string_view driverName(Driver driver)
{
    return driver == Driver::wheel ? "wheel" : driver == Driver::walk ? "walk" : "queue";
}

/// The result of one refinement.
struct RefineResult
{
    std::uint32_t triangles = 0; ///< drawn leaves: those that overlap the data
    std::uint32_t leaves = 0; ///< all leaves, those beyond the data's edge included; the ceiling counts these
    std::uint32_t splits = 0; ///< triangles split, forced ones included
    std::uint32_t merges = 0; ///< triangles merged back
    std::uint32_t checks = 0; ///< vertices checked
    double tolerancePx = 0.0; ///< τ reached: the target, or what the triangle ceiling allowed (0: none asked)
    double errorBoundPx =
        0.0; ///< no sample is off by more: τ reached, or more while a slice's work is left over; infinite
             ///< while vertices that may have become active wait to be looked at
    bool ceilingBound = false; ///< the ceiling raised τ
    bool sliceBound = false;   ///< the time slice ended before the work; the next frame continues
};

} // namespace osgTerrainROAM::core
