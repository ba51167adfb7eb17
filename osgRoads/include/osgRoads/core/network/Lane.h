// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <osgRoads/core/geometry/Cubic.h>
#include <osgRoads/core/network/LaneType.h>
#include <osgRoads/core/network/RoadMark.h>

namespace osgRoads::core
{

/// The heights of both borders of a lane above the road; between entries they change linearly.
struct LaneHeight
{
    double s = 0.0; ///< sOffset
    double inner = 0.0, outer = 0.0;
};

/// A speed limit of a lane or of a road. No value: no limit, or not told.
struct SpeedLimit
{
    double s = 0.0;
    std::optional<double> metresPerSecond;
};

/// Who may use a lane, or what it is made of, from an offset on.
struct LaneRule
{
    double s = 0.0;
    std::string rule;        ///< access: allow or deny; otherwise empty
    std::string restriction; ///< access: the traffic; rule: the text; material: the surface
    double friction = 0.0, roughness = 0.0;
};

enum class LaneDirection
{
    standard, ///< as the side of the road has it
    reversed,
    both,
};

inline constexpr Keywords<LaneDirection, 3> kLaneDirections = {{{"standard", LaneDirection::standard},
                                                                {"reversed", LaneDirection::reversed},
                                                                {"both", LaneDirection::both}}};

/// A lane of one lane section. Ids: 0 in the centre, 1, 2 … to the left, -1, -2 … to the right.
/// Frame: s offsets from the start of the section; widths and heights in metres.
/// Source: ASAM OpenDRIVE 1.8, 11.
struct Lane
{
    int id = 0;
    LaneType type = LaneType::none;
    bool isLevel = false; ///< without superelevation, crossfall and shape
    bool isByBorder = false;
    CubicProfile width; ///< or, with isByBorder, the t of its outer border without lane offset
    std::vector<int> predecessors, successors; ///< lane ids in the neighbouring section or road
    std::vector<RoadMark> marks;
    std::vector<LaneHeight> heights;
    std::vector<SpeedLimit> speeds;
    std::vector<LaneRule> access, rules, materials;
    LaneDirection direction = LaneDirection::standard;
    int line = 0; ///< in the file
};

/// A part of a road with a fixed number of lanes.
struct LaneSection
{
    double s = 0.0;   ///< start, metres along the road
    double end = 0.0; ///< start of the next section, or length of the road
    bool isSingleSide = false;
    std::vector<Lane> left;  ///< ids 1, 2, …
    std::vector<Lane> right; ///< ids -1, -2, …
    Lane centre;
    int line = 0;

    /// Returns the lane of that id, or nullptr.
    const Lane* lane(int id) const
    {
        if (id == 0) return &centre;
        const std::vector<Lane>& side = id > 0 ? left : right;
        const auto index = static_cast<std::size_t>(id > 0 ? id : -static_cast<long>(id)) - 1;
        return index < side.size() ? &side[index] : nullptr;
    }
};

} // namespace osgRoads::core
