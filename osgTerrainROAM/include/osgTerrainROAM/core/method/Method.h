// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include <foundation/Result.h>

namespace osgTerrainROAM::core
{

class RoamTile;

/// The methods of continuous level of detail that can draw a terrain.
/// Source: *Methods of continuous level of detail for terrain* (Graphicon 2002), sections 3 to 5.
enum class Method
{
    roam,              ///< a bintree of right triangles that follows the eye (RoamMesh)
    vdpm,              ///< a view-dependent progressive mesh of the raster (VdpmMesh)
    regularDecimation, ///< blocks that drop rows and columns (DecimatedMesh)
    vipmLocked,        ///< blocks of progressive meshes whose borders are never simplified (VipmMesh)
    vipmOverlapping,   ///< blocks of progressive meshes that overlap at their borders (VipmMesh)
    roamWalk,          ///< roam, adapted by the paper's own loop over the last frame's tree (WalkDriver)
    roamQueue,         ///< roam, adapted by Duchaineau's two queues (QueueDriver)
};

/// What a method can do besides following an eye to a tolerance within a ceiling of triangles.
struct MethodTraits
{
    Method method;
    std::string_view name; ///< in files and command lines
    bool hasPatches;       ///< leaves may carry patches
    bool morphs;           ///< detail may come and go without a jump
    bool stopsInTime;      ///< keeps a limit of time, and continues in the next frame
    bool followsEdits;     ///< meshes follow edits of the tile
    bool hasFineSamples;   ///< takes samples between those of the raster: roads, dense parts
    bool hasHoles;         ///< takes tiles with holes
    bool refinesInSight;   ///< can leave coarse what cameras do not see
};

/// In the order of the enumeration.
inline constexpr std::array kMethods{
    MethodTraits{Method::roam, "roam", true, true, true, true, true, true, true},
    MethodTraits{Method::vdpm, "vdpm", false, true, true, false, false, false, true},
    MethodTraits{Method::regularDecimation, "regular-decimation", false, true, false, true, true, false,
                 false},
    MethodTraits{Method::vipmLocked, "vipm-locked", false, false, false, true, false, false, false},
    MethodTraits{Method::vipmOverlapping, "vipm-overlapping", false, false, false, true, false, false, false},
    MethodTraits{Method::roamWalk, "roam-walk", true, true, true, true, true, true, true},
    MethodTraits{Method::roamQueue, "roam-queue", true, true, true, true, true, true, true},
};

constexpr const MethodTraits& traitsOf(Method method)
{
    return kMethods[static_cast<std::size_t>(method)];
}

constexpr std::string_view methodName(Method method)
{
    return traitsOf(method).name;
}

/// The method of that name; nothing if there is none.
std::optional<Method> methodNamed(std::string_view name);

/// All of them, for command lines.
std::map<std::string, Method> methodsByName();

/// All names, separated by commas.
std::string methodNames();

/// A method, and what is asked of it that not every method can do.
struct MethodRequest
{
    Method method = Method::roam;
    int patchExponent = 0; ///< 2^k triangles for each leaf
    bool morphing = false;
    bool limitsTime = false;
    bool inSight = false; ///< what cameras do not see may be coarse
};

/// Checks that a method can do what is asked of it. Errors name the first thing that it cannot; the place is
/// "`owner`.method".
foundation::Outcome checkMethod(const MethodRequest& request, const std::string& owner);

/// Checks that a method can draw a tile. Errors: the tile has holes, or samples between those of its raster.
/// Threads: with a shared lock of the tile, if it is edited.
foundation::Outcome checkMethod(Method method, const RoamTile& tile, const std::string& owner);

} // namespace osgTerrainROAM::core
