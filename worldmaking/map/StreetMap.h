// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace worldmaking
{

/// The tags of something in a map: key and value.
using Tags = std::map<std::string, std::string, std::less<>>;

/// Returns the value of a key; empty where there is none.
inline std::string_view valueOf(const Tags& tags, std::string_view key)
{
    const auto found = tags.find(key);
    return found == tags.end() ? std::string_view() : std::string_view(found->second);
}

/// A point of a map. Units: degrees (WGS84).
struct MapNode
{
    std::int64_t id = 0;
    double latitudeDeg = 0.0, longitudeDeg = 0.0;
};

/// A line of a map. Where two ways meet they have a node in common.
struct MapWay
{
    std::int64_t id = 0;
    std::vector<std::uint32_t> nodes; ///< indices into StreetMap::nodes, two or more
    Tags tags;
};

/// A turn that the map forbids, or the only one that it allows. Ids of the map.
struct TurnRule
{
    std::int64_t from = 0, via = 0, to = 0; ///< way, node, way
    bool isOnly = false;
};

/// The ways of a map that are streets (key `highway`), as plain values.
struct StreetMap
{
    std::vector<MapNode> nodes; ///< those that ways use, by id
    std::vector<MapWay> ways;   ///< by id
    std::vector<TurnRule> turnRules;
    /// Of nodes that say who waits there (`highway` with traffic_signals, crossing, stop or give_way), by
    /// index into nodes.
    std::map<std::uint32_t, Tags> nodeTags;
    std::size_t missingNodes = 0; ///< named by ways, absent in the map; the ways go on without them
    std::size_t shortWays = 0;    ///< left out: fewer than two nodes
};

} // namespace worldmaking
