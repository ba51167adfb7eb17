// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/map/ReadOsm.h"

#include <algorithm>
#include <array>
#include <exception>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include <foundation/ReadableFile.h>
#include <osmium/handler.hpp>
#include <osmium/io/gzip_compression.hpp>
#include <osmium/io/pbf_input.hpp>
#include <osmium/io/reader.hpp>
#include <osmium/io/xml_input.hpp>
#include <osmium/visitor.hpp>

#include "worldmaking/map/ConvertedXml.h"

namespace worldmaking
{

namespace
{

constexpr std::uint32_t kNoNode = std::numeric_limits<std::uint32_t>::max();

/// A way as the file has it: the ids of its nodes.
struct RawWay
{
    std::int64_t id;
    std::vector<std::int64_t> nodeIds;
    Tags tags;
};

/// Collects ways with the key `highway`, and the turns that relations forbid or prescribe.
class WayHandler : public osmium::handler::Handler
{
public:
    void way(const osmium::Way& way)
    {
        if (!way.visible() || !way.tags().has_key("highway")) return;
        RawWay raw{way.id(), {}, {}};
        for (const osmium::NodeRef& node : way.nodes())
            raw.nodeIds.push_back(node.ref());
        for (const osmium::Tag& tag : way.tags())
            raw.tags.emplace(tag.key(), tag.value());
        ways.push_back(std::move(raw));
    }

    void relation(const osmium::Relation& relation)
    {
        if (!relation.visible()) return;
        const std::string_view kind = relation.tags().get_value_by_key("restriction", "");
        if (!kind.starts_with("no_") && !kind.starts_with("only_")) return;
        TurnRule rule{0, 0, 0, kind.starts_with("only_")};
        for (const osmium::RelationMember& member : relation.members())
        {
            const std::string_view role = member.role();
            if (role == "from" && member.type() == osmium::item_type::way) rule.from = member.ref();
            if (role == "to" && member.type() == osmium::item_type::way) rule.to = member.ref();
            if (role == "via" && member.type() == osmium::item_type::node) rule.via = member.ref();
        }
        if (rule.from != 0 && rule.via != 0 && rule.to != 0) turnRules.push_back(rule);
    }

    std::vector<RawWay> ways;
    std::vector<TurnRule> turnRules;
};

/// Whether a node says who waits there.
bool saysWhoWaits(const osmium::TagList& tags)
{
    const std::string_view value = tags.get_value_by_key("highway", "");
    constexpr std::array<std::string_view, 4> kWords{"traffic_signals", "crossing", "stop", "give_way"};
    return std::any_of(kWords.begin(), kWords.end(),
                       [&](std::string_view word) { return value.find(word) != std::string_view::npos; });
}

/// Fills in the positions of nodes, and the tags of those that say who waits. `nodes`: by id.
class NodeHandler : public osmium::handler::Handler
{
public:
    explicit NodeHandler(std::vector<MapNode>& nodes) : _nodes(nodes), isFound(nodes.size(), 0) {}

    void node(const osmium::Node& node)
    {
        const auto found = std::lower_bound(_nodes.begin(), _nodes.end(), node.id(),
                                            [](const MapNode& a, std::int64_t id) { return a.id < id; });
        if (found == _nodes.end() || found->id != node.id() || !node.visible() || !node.location().valid())
            return;
        found->latitudeDeg = node.location().lat();
        found->longitudeDeg = node.location().lon();
        const auto index = static_cast<std::size_t>(found - _nodes.begin());
        isFound[index] = 1;
        if (!saysWhoWaits(node.tags())) return;
        Tags& kept = tags[static_cast<std::uint32_t>(index)];
        for (const osmium::Tag& tag : node.tags())
            kept.emplace(tag.key(), tag.value());
    }

private:
    std::vector<MapNode>& _nodes;

public:
    std::vector<char> isFound;
    std::map<std::uint32_t, Tags> tags; ///< by index
};

template<class Handler>
void readInto(const osmium::io::File& file, osmium::osm_entity_bits::type kinds, Handler& handler)
{
    osmium::io::Reader reader(file, kinds);
    osmium::apply(reader, handler);
    reader.close();
}

std::vector<MapNode> nodesOf(const std::vector<RawWay>& ways)
{
    std::vector<MapNode> nodes;
    for (const RawWay& way : ways)
        for (const std::int64_t id : way.nodeIds)
            nodes.push_back({id, 0.0, 0.0});
    const auto byId = [](const MapNode& a, const MapNode& b) { return a.id < b.id; };
    std::sort(nodes.begin(), nodes.end(), byId);
    const auto isSame = [](const MapNode& a, const MapNode& b) { return a.id == b.id; };
    nodes.erase(std::unique(nodes.begin(), nodes.end(), isSame), nodes.end());
    return nodes;
}

/// Keeps the nodes that were found, and returns for each old index the new one.
std::vector<std::uint32_t> keepFound(std::vector<MapNode>& nodes, const std::vector<char>& isFound)
{
    std::vector<std::uint32_t> places(nodes.size(), kNoNode);
    std::uint32_t kept = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i)
    {
        if (isFound[i] == 0) continue;
        nodes[kept] = nodes[i];
        places[i] = kept++;
    }
    nodes.resize(kept);
    return places;
}

void addWay(RawWay raw, const std::vector<std::int64_t>& ids, const std::vector<std::uint32_t>& places,
            StreetMap& map)
{
    MapWay way{raw.id, {}, std::move(raw.tags)};
    for (const std::int64_t id : raw.nodeIds)
    {
        const auto at = static_cast<std::size_t>(std::lower_bound(ids.begin(), ids.end(), id) - ids.begin());
        const std::uint32_t place = places[at];
        if (place == kNoNode)
            ++map.missingNodes;
        else if (way.nodes.empty() || way.nodes.back() != place)
            way.nodes.push_back(place);
    }
    if (way.nodes.size() < 2)
        ++map.shortWays;
    else
        map.ways.push_back(std::move(way));
}

StreetMap read(const osmium::io::File& file)
{
    WayHandler ways;
    readInto(file, osmium::osm_entity_bits::way | osmium::osm_entity_bits::relation, ways);
    std::stable_sort(ways.ways.begin(), ways.ways.end(),
                     [](const RawWay& a, const RawWay& b) { return a.id < b.id; });
    StreetMap map;
    map.turnRules = std::move(ways.turnRules);
    map.nodes = nodesOf(ways.ways);
    std::vector<std::int64_t> ids;
    for (const MapNode& node : map.nodes)
        ids.push_back(node.id);
    NodeHandler nodes(map.nodes);
    readInto(file, osmium::osm_entity_bits::node, nodes);
    const auto places = keepFound(map.nodes, nodes.isFound);
    for (auto& [index, tags] : nodes.tags)
        map.nodeTags.emplace(places[index], std::move(tags));
    for (RawWay& way : ways.ways)
        addWay(std::move(way), ids, places, map);
    return map;
}

/// `open`: gives the file, or throws where its name tells no format.
template<class Open>
foundation::Result<StreetMap> readOr(const std::string& name, const Open& open)
{
    try
    {
        StreetMap map = read(open());
        if (map.ways.empty() && map.shortWays > 0)
            return foundation::Error{name, "its streets have no nodes",
                                     "extract the map with the nodes of its ways"};
        return map;
    }
    catch (const std::bad_alloc&)
    {
        throw;
    }
    catch (const std::exception& failed)
    {
        return foundation::Error{name, std::string("cannot be read as OpenStreetMap data: ") + failed.what(),
                                 "give an .osm, .osm.gz or .osm.pbf file, and check that it is complete"};
    }
}

} // namespace

foundation::Result<StreetMap> readOsm(const std::filesystem::path& file)
{
    if (const auto readable = foundation::checkReadable(file); !readable) return readable.error();
    const auto converted = convertedXml(file);
    if (!converted) return converted.error();
    if (*converted) return parseOsm(**converted, "osm", file.string());
    return readOr(file.string(), [&] { return osmium::io::File(file.string()); });
}

foundation::Result<StreetMap> parseOsm(std::string_view bytes, const std::string& format,
                                       const std::string& name)
{
    return readOr(name, [&] { return osmium::io::File(bytes.data(), bytes.size(), format); });
}

} // namespace worldmaking
