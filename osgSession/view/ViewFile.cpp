// SPDX-License-Identifier: Apache-2.0
#include "view/ViewFile.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <foundation/NearestWord.h>
#include <pugixml.hpp>

#include "simulation/parser/Expression.h"
#include "simulation/parser/XmlSource.h"

namespace trainer
{

using foundation::Error;
using foundation::Result;

namespace
{

constexpr std::size_t kMostBytes = 1 << 20;
constexpr std::size_t kMostChannels = 16;
constexpr int kMostPixels = 16384;

struct Range
{
    double least, most;
};
constexpr Range kAngles{-180.0, 180.0};
constexpr Range kEdges{-89.0, 89.0};
constexpr Range kFields{1.0, 170.0};
constexpr Range kOffsets{-1000.0, 1000.0};
constexpr Range kDistances{0.01, 1e7};

/// Reads attributes and keeps the first thing wrong.
class ViewReader
{
public:
    explicit ViewReader(const simulation::XmlSource& source) : _source(source) {}

    Result<ViewSetup> read();

private:
    void fail(pugi::xml_node node, const std::string& what, const std::string& remedy);
    void allow(pugi::xml_node node, std::initializer_list<std::string_view> attributes,
               std::initializer_list<std::string_view> children);
    double number(pugi::xml_node node, const char* attribute, const Range& range,
                  std::optional<double> fallback = {});
    int pixels(pugi::xml_node node, const char* attribute);
    Channel channel(pugi::xml_node node);
    FrustumAngles frustum(pugi::xml_node node, const Channel& channel);
    FrustumAngles offAxis(pugi::xml_node node);
    void noteRadians(pugi::xml_node node, const char* attribute);
    void checkChannels(pugi::xml_node root, const ViewSetup& setup);

    const simulation::XmlSource& _source;
    std::optional<Error> _error;
    std::vector<std::string> _notes;
};

void ViewReader::fail(pugi::xml_node node, const std::string& what, const std::string& remedy)
{
    if (!_error) _error = Error{_source.name() + ":" + std::to_string(_source.lineOf(node)), what, remedy};
}

void ViewReader::allow(pugi::xml_node node, std::initializer_list<std::string_view> attributes,
                       std::initializer_list<std::string_view> children)
{
    const std::string element = node.name();
    for (const pugi::xml_attribute attribute : node.attributes())
        if (std::find(attributes.begin(), attributes.end(), attribute.name()) == attributes.end())
            fail(node, element + " has no attribute '" + attribute.name() + "'",
                 foundation::didYouMean(attribute.name(), attributes, "remove it"));
    for (const pugi::xml_node child : node.children())
        if (child.type() == pugi::node_element &&
            std::find(children.begin(), children.end(), child.name()) == children.end())
            fail(child, element + " has no element '" + child.name() + "'",
                 foundation::didYouMean(child.name(), children, "remove it"));
}

double ViewReader::number(pugi::xml_node node, const char* attribute, const Range& range,
                          std::optional<double> fallback)
{
    const pugi::xml_attribute found = node.attribute(attribute);
    if (!found && fallback) return *fallback;
    const std::string rangeText =
        simulation::formatNumber(range.least) + " to " + simulation::formatNumber(range.most);
    if (!found)
        fail(node, std::string(node.name()) + " has no " + attribute, "give a number from " + rangeText);
    else if (const std::optional<double> value = simulation::parseNumber(found.value());
             value && *value >= range.least && *value <= range.most)
        return *value;
    else
        fail(node, std::string(attribute) + " is '" + found.value() + "'", "give a number from " + rangeText);
    return range.least;
}

int ViewReader::pixels(pugi::xml_node node, const char* attribute)
{
    const double value = number(node, attribute, {16.0, kMostPixels});
    if (value != static_cast<int>(value))
        fail(node, std::string(attribute) + " is not whole", "give whole pixels");
    return static_cast<int>(value);
}

FrustumAngles ViewReader::offAxis(pugi::xml_node node)
{
    allow(node, {"leftDeg", "rightDeg", "bottomDeg", "topDeg"}, {});
    const FrustumAngles angles{number(node, "leftDeg", kEdges), number(node, "rightDeg", kEdges),
                               number(node, "bottomDeg", kEdges), number(node, "topDeg", kEdges)};
    if (!_error && angles.leftDeg >= angles.rightDeg)
        fail(node, "leftDeg is not less than rightDeg", "swap them");
    if (!_error && angles.bottomDeg >= angles.topDeg)
        fail(node, "bottomDeg is not less than topDeg", "swap them");
    return angles;
}

/// A field of few degrees is rare, and as many radians are a usual one.
void ViewReader::noteRadians(pugi::xml_node node, const char* attribute)
{
    constexpr double kMostRadians = 3.0, kDegPerRad = 57.29577951308232;
    if (!node.attribute(attribute)) return;
    const double value = number(node, attribute, kFields);
    if (_error || value > kMostRadians) return;
    _notes.push_back(_source.name() + ":" + std::to_string(_source.lineOf(node)) + ": " + attribute + " is " +
                     simulation::formatNumber(value) +
                     " degrees, a very small field; in radians it would be " +
                     simulation::formatNumber(std::round(10.0 * kDegPerRad * value) / 10.0) + " degrees");
}

FrustumAngles ViewReader::frustum(pugi::xml_node node, const Channel& channel)
{
    const pugi::xml_node edges = node.child("Frustum");
    const int given =
        (edges ? 1 : 0) + (node.attribute("fovXDeg") ? 1 : 0) + (node.attribute("fovYDeg") ? 1 : 0);
    if (given != 1 || edges.next_sibling("Frustum"))
        fail(node,
             "channel '" + channel.name + "' has " + (given == 0 ? "no" : "more than one") + " field of view",
             "give one of fovXDeg, fovYDeg and Frustum");
    if (_error) return {};
    if (edges) return offAxis(edges);
    for (const char* field : {"fovXDeg", "fovYDeg"})
        noteRadians(node, field);
    if (node.attribute("fovXDeg"))
        return symmetricFrustumX(number(node, "fovXDeg", kFields), channel.widthPx, channel.heightPx);
    return symmetricFrustumY(number(node, "fovYDeg", kFields), channel.widthPx, channel.heightPx);
}

Channel ViewReader::channel(pugi::xml_node node)
{
    allow(node,
          {"name", "widthPx", "heightPx", "yawDeg", "pitchDeg", "rollDeg", "xM", "yM", "zM", "fovXDeg",
           "fovYDeg"},
          {"Frustum"});
    Channel channel;
    channel.name = node.attribute("name").value();
    const auto isPlain = [](char c)
    {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
               c == '_';
    };
    if (channel.name.empty() || !std::all_of(channel.name.begin(), channel.name.end(), isPlain))
        fail(node, "the channel's name is '" + channel.name + "'",
             "use letters, digits, - and _: it names a folder");
    channel.widthPx = pixels(node, "widthPx");
    channel.heightPx = pixels(node, "heightPx");
    channel.yawDeg = number(node, "yawDeg", kAngles, 0.0);
    channel.pitchDeg = number(node, "pitchDeg", kAngles, 0.0);
    channel.rollDeg = number(node, "rollDeg", kAngles, 0.0);
    channel.positionM = {number(node, "xM", kOffsets, 0.0), number(node, "yM", kOffsets, 0.0),
                         number(node, "zM", kOffsets, 0.0)};
    channel.frustum = frustum(node, channel);
    return channel;
}

void ViewReader::checkChannels(pugi::xml_node root, const ViewSetup& setup)
{
    const std::size_t count = setup.channels.size();
    if (count == 0 || count > kMostChannels)
        return fail(root, std::to_string(count) + " channels",
                    "give 1 to " + std::to_string(kMostChannels) + " Channel elements");
    std::set<std::string> names;
    int width = 0;
    for (const Channel& channel : setup.channels)
    {
        if (!names.insert(channel.name).second)
            fail(root, "two channels are named '" + channel.name + "'", "give each its own name");
        if (setup.layout == ViewSetup::Layout::tiled && channel.heightPx != setup.channels.front().heightPx)
            fail(root, "channel '" + channel.name + "' has another height than the one left of it",
                 "give tiled channels the same heightPx");
        width += channel.widthPx;
    }
    if (setup.layout == ViewSetup::Layout::tiled && width > kMostPixels)
        fail(root, "the channels are " + std::to_string(width) + " pixels wide together",
             "keep within " + std::to_string(kMostPixels) + ", or use layout separate");
}

Result<ViewSetup> ViewReader::read()
{
    const pugi::xml_node root = _source.root();
    if (std::string_view(root.name()) != "View")
        return Error{_source.name() + ":" + std::to_string(_source.lineOf(root)),
                     std::string("the root element is '") + root.name() + "'",
                     "a view file has a View element"};
    allow(root, {"layout", "nearM", "farM"}, {"Channel"});
    ViewSetup setup;
    const std::string layout = root.attribute("layout").as_string("separate");
    setup.layout = layout == "tiled" ? ViewSetup::Layout::tiled : ViewSetup::Layout::separate;
    if (layout != "tiled" && layout != "separate")
        fail(root, "layout is '" + layout + "'", "use separate or tiled");
    setup.nearM = number(root, "nearM", kDistances, setup.nearM);
    setup.farM = number(root, "farM", kDistances, setup.farM);
    if (setup.nearM >= setup.farM) fail(root, "nearM is not less than farM", "give a greater farM");
    for (const pugi::xml_node node : root.children("Channel"))
        setup.channels.push_back(channel(node));
    checkChannels(root, setup);
    setup.notes = std::move(_notes);
    if (_error) return *_error;
    return setup;
}

Result<ViewSetup> setupOf(const Result<std::unique_ptr<simulation::XmlSource>>& source)
{
    if (!source) return source.error();
    return ViewReader(**source).read();
}

} // namespace

Result<ViewSetup> readView(const std::filesystem::path& file)
{
    return setupOf(simulation::XmlSource::read(file, kMostBytes));
}

Result<ViewSetup> parseView(std::string_view text, const std::string& name)
{
    return setupOf(simulation::XmlSource::parse(text, name));
}

} // namespace trainer
