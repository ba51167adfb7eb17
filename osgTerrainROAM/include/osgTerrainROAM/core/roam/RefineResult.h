// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

namespace osgTerrainROAM::core
{

/// Which of the drivers takes a mesh from eye to eye. In error-target mode all end in the same mesh.
enum class Driver
{
    wheel, ///< looks only at what the eye's travel may have changed (WheelDriver.h)
    walk,  ///< the paper's: visits the whole tree of the last frame
    queue, ///< Duchaineau's: two queues by priority, all priorities computed anew in each frame
};

inline constexpr Driver kDrivers[] = {Driver::wheel, Driver::walk, Driver::queue};

constexpr std::string_view driverName(Driver driver)
{
    return driver == Driver::wheel ? "wheel" : driver == Driver::walk ? "walk" : "queue";
}

/// What one refinement did.
struct RefineResult
{
    std::uint32_t triangles = 0; ///< leaves that overlap the data: what is there to draw
    std::uint32_t leaves = 0; ///< all leaves, those beyond the data's edge included: what the ceiling counts
    std::uint32_t splits = 0; ///< triangles split, forced ones included
    std::uint32_t merges = 0; ///< triangles merged back
    std::uint32_t checks = 0; ///< vertices looked at
    double tolerancePx = 0.0; ///< τ reached: the target, or what the triangle ceiling allowed (0: none asked)
    double errorBoundPx =
        0.0; ///< no sample is off by more: τ reached, or more while a slice's work is left over; infinite
             ///< while vertices that may have become active wait to be looked at
    bool ceilingBound = false; ///< the ceiling raised τ
    bool sliceBound = false;   ///< the time slice ended before the work: the next frame goes on
};

} // namespace osgTerrainROAM::core
