// SPDX-License-Identifier: Apache-2.0
// Source: ASAM OpenDRIVE 1.8, 6 (file structure), 8.5 (georeferencing).
#include <algorithm>
#include <cstring>
#include <utility>

#include <osgRoads/core/read/ReadNetwork.h>

#include "ElementReaders.h"

namespace osgRoads::core
{

namespace
{

using Source = std::unique_ptr<foundation::XmlSource>;

std::string trimmed(std::string_view text)
{
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos) return {};
    return std::string(text.substr(begin, text.find_last_not_of(" \t\r\n") - begin + 1));
}

NetworkHeader readHeader(NodeReader& element)
{
    NetworkHeader header;
    header.revMajor = element.integer("revMajor", 1);
    header.revMinor = element.integer("revMinor", 4);
    header.name = element.text("name");
    header.version = element.text("version");
    header.date = element.text("date");
    header.vendor = element.text("vendor");
    for (const char* bound : {"north", "south", "east", "west"})
        element.has(bound); // computed from the roads instead
    element.each("geoReference",
                 [&](NodeReader& reference) { header.geoReference = trimmed(reference.node.text().get()); });
    element.each("offset",
                 [&](NodeReader& offset)
                 {
                     header.offsetX = offset.number("x");
                     header.offsetY = offset.number("y");
                     header.offsetZ = offset.numberOr("z", 0.0);
                     header.offsetHeadingRad = offset.numberOr("hdg", 0.0);
                 });
    if (header.revMajor == 1 && (header.revMinor < 4 || header.revMinor > 8))
        element.mistake("version 1." + std::to_string(header.revMinor) + " of OpenDRIVE",
                        "1.4 to 1.8 are understood; what differs is told");
    return header;
}

/// Files with and without a namespace are read.
bool isOpenDrive(pugi::xml_node root)
{
    return std::strcmp(root.name(), "OpenDRIVE") == 0;
}

void readRoot(NodeReader& root, RoadNetwork& network)
{
    root.has("xmlns");
    bool hasHeader = false;
    root.each("header",
              [&](NodeReader& header)
              {
                  network.header = readHeader(header);
                  hasHeader = true;
              });
    if (!hasHeader) root.mistake("there is no header", "add one; version 1.4 is assumed");
    root.each("road", [&](NodeReader& road) { network.roads.push_back(readRoad(road)); });
    root.each("junction", [&](NodeReader& junction) { network.junctions.push_back(readJunction(junction)); });
    root.each("controller",
              [&](NodeReader& controller) { network.controllers.push_back(readController(controller)); });
    root.reportRest();
}

foundation::Result<ReadNetwork> readSource(const foundation::Result<Source>& read)
{
    if (!read) return read.error();
    const foundation::XmlSource& source = **read;
    const auto at = [&](pugi::xml_node node)
    { return source.name() + ":" + std::to_string(source.lineOf(node)); };
    if (!isOpenDrive(source.root()))
        return foundation::Error{
            at(source.root()), std::string("the root element is ") + source.root().name() + ", not OpenDRIVE",
            "name an OpenDRIVE file"};
    ReadNetwork result;
    ReadContext context(source);
    if (!source.note().empty())
        context.mistake(source.noteLine(), source.note(),
                        "name the encoding in the first line, or save it as UTF-8");
    NodeReader root(context, source.root());
    readRoot(root, result.network);
    if (result.network.header.revMajor != 1)
        return foundation::Error{at(source.root().child("header")),
                                 "version " + std::to_string(result.network.header.revMajor) +
                                     " of OpenDRIVE",
                                 "convert it to 1.4 to 1.8"};
    const std::vector<Road>& roads = result.network.roads;
    resolveLinks(result.network, context);
    context.moveTo(result);
    if (std::none_of(roads.begin(), roads.end(), [](const Road& road) { return road.isUsable; }))
    {
        if (roads.empty()) return foundation::Error{at(source.root()), "there is no road", "add one"};
        const auto reason = std::find_if(result.problems.begin(), result.problems.end(),
                                         [](const Problem& p) { return p.what.starts_with("road "); });
        return foundation::Error{
            source.name() + ":" + std::to_string(reason == result.problems.end() ? 0 : reason->line),
            "no road can be used: " + (reason == result.problems.end() ? "" : reason->what),
            reason == result.problems.end() ? "" : reason->remedy};
    }
    return result;
}

} // namespace

foundation::Result<ReadNetwork> readNetwork(const std::filesystem::path& file, const ReadOptions& options)
{
    return readSource(foundation::XmlSource::read(file, options.maximumBytes));
}

foundation::Result<ReadNetwork> parseNetwork(std::string_view text, const std::string& name)
{
    return readSource(foundation::XmlSource::parse(text, name));
}

} // namespace osgRoads::core
