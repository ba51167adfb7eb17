// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/map/JoinLand.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <string>
#include <unordered_set>
#include <utility>

#include "worldmaking/map/PlaceKey.h"

namespace worldmaking
{

namespace
{

/// All that makes two shapes the same, as bytes.
std::string bytesOf(const LandShape& shape)
{
    std::string bytes(1, static_cast<char>(shape.form));
    for (const auto& path : shape.paths)
    {
        bytes.append(reinterpret_cast<const char*>(path.data()), path.size() * sizeof(glm::dvec2));
        bytes += '/';
    }
    for (const auto& [key, value] : shape.tags)
        bytes += key + '=' + value + '\0';
    return bytes;
}

} // namespace

std::size_t joinLand(LandMap& map, LandMap other)
{
    std::unordered_set<std::string> known;
    for (const LandShape& shape : map.shapes)
        known.insert(bytesOf(shape));
    const std::size_t before = other.shapes.size();
    std::erase_if(other.shapes, [&](const LandShape& shape) { return known.contains(bytesOf(shape)); });
    const std::size_t left = other.shapes.size();
    std::move(other.shapes.begin(), other.shapes.end(), std::back_inserter(map.shapes));
    map.unusable += other.unusable;
    std::move(other.notes.begin(), other.notes.end(), std::back_inserter(map.notes));
    return before - left;
}

void joinStreets(StreetMap& map, StreetMap other)
{
    if (map.ways.empty())
    {
        map = std::move(other);
        return;
    }
    const auto placeOf = [](const MapNode& node) {
        return placeKeyOf({node.longitudeDeg, node.latitudeDeg});
    };
    std::map<PlaceKey, std::uint32_t> places;
    std::int64_t lastNode = 0, lastWay = 0;
    for (std::uint32_t i = 0; i < map.nodes.size(); ++i)
    {
        places.emplace(placeOf(map.nodes[i]), i);
        lastNode = std::max(lastNode, map.nodes[i].id);
    }
    for (const MapWay& way : map.ways)
        lastWay = std::max(lastWay, way.id);
    std::vector<std::uint32_t> renumbered;
    for (MapNode& node : other.nodes)
    {
        const auto [found, isNew] =
            places.try_emplace(placeOf(node), static_cast<std::uint32_t>(map.nodes.size()));
        renumbered.push_back(found->second);
        if (!isNew) continue;
        node.id = ++lastNode;
        map.nodes.push_back(node);
    }
    for (MapWay& way : other.ways)
    {
        way.id = ++lastWay;
        for (std::uint32_t& node : way.nodes)
            node = renumbered[node];
        way.nodes.erase(std::unique(way.nodes.begin(), way.nodes.end()), way.nodes.end());
        if (way.nodes.size() < 2)
            ++map.shortWays;
        else
            map.ways.push_back(std::move(way));
    }
    map.missingNodes += other.missingNodes;
    map.shortWays += other.shortWays;
}

} // namespace worldmaking
