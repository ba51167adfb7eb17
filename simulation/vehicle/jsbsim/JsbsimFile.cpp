// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/jsbsim/JsbsimFile.h"

#include <algorithm>

#include <foundation/XmlSource.h>

#include "simulation/vehicle/VehicleFileReader.h"
#include "simulation/vehicle/flight/FlightInputs.h"

namespace simulation
{
namespace
{

constexpr std::size_t kMostFileBytes = 1U << 20U;
constexpr std::string_view kRoot = "jsbsim_aircraft";
constexpr std::size_t kMostInputs = 40;

/// A word of JSBSim's own orders, which blanks and line ends would break.
bool isWord(std::string_view text, std::string_view others)
{
    return !text.empty() && std::all_of(text.begin(), text.end(),
                                        [&](char c)
                                        {
                                            return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                                                   (c >= '0' && c <= '9') ||
                                                   others.find(c) != std::string_view::npos;
                                        });
}

void readInputs(VehicleFileReader& reader, pugi::xml_node root, JsbsimData& data)
{
    std::vector<std::string> names(kFlightInputNames.begin(), kFlightInputNames.end());
    for (const pugi::xml_node node : root.children())
    {
        if (node.type() != pugi::node_element) continue;
        if (std::string_view(node.name()) != "input")
            reader.fail(node, std::string("<") + node.name() + "> is unknown",
                        "remove it; only <input> stands here");
        reader.onlyAttributes(node, "property");
        JsbsimInput input{reader.name(node), node.attribute("property").value()};
        if (!isWord(input.name, "_"))
            reader.fail(node, "the input '" + input.name + "' is no word", "write letters, digits and _");
        if (!isWord(input.property, "_-./[]"))
            reader.fail(node, "'" + input.property + "' is no property",
                        "write it as JSBSim does: ap/heading_hold");
        if (std::find(names.begin(), names.end(), input.name) != names.end())
            reader.fail(node, "the input '" + input.name + "' is there already", "give it another name");
        names.push_back(input.name);
        data.inputs.push_back(std::move(input));
    }
    if (data.inputs.size() > kMostInputs)
        reader.fail(root, "has more than 40 inputs", "name those that are used");
}

foundation::Result<JsbsimData> readSource(const foundation::XmlSource& source)
{
    VehicleFileReader reader(source, "docs/reference/aircraft-file.md");
    const pugi::xml_node root = source.root();
    JsbsimData data;
    if (std::string_view(root.name()) != kRoot || std::string_view(root.attribute("version").value()) != "1")
        reader.fail(root, "is no <jsbsim_aircraft version=\"1\">", "give such a data file of this version");
    reader.onlyAttributes(root, "version aircraft root program answersWithinS");
    data.name = reader.name(root);
    data.aircraft = root.attribute("aircraft").value();
    if (!isWord(data.aircraft, "_-."))
        reader.fail(root, "names no aircraft of JSBSim",
                    "write aircraft=\"NAME\", a folder of ROOT/aircraft");
    data.root = root.attribute("root").value();
    if (root.attribute("program")) data.program = root.attribute("program").value();
    if (data.program.empty()) reader.fail(root, "names an empty program", "leave it out, or name JSBSim");
    if (root.attribute("answersWithinS"))
        data.answersWithinS = reader.number(root, "answersWithinS", 0.01, 600.0);
    if (!reader.error()) readInputs(reader, root, data);
    if (reader.error()) return *reader.error();
    return data;
}

} // namespace

bool isJsbsimFile(const std::filesystem::path& file)
{
    const auto source = foundation::XmlSource::read(file, kMostFileBytes);
    return source && std::string_view((*source)->root().name()) == kRoot;
}

foundation::Result<JsbsimData> readJsbsimAircraft(const std::filesystem::path& file)
{
    const auto source = foundation::XmlSource::read(file, kMostFileBytes);
    if (!source) return source.error();
    auto data = readSource(**source);
    if (data && !data->root.empty() && data->root.is_relative()) data->root = file.parent_path() / data->root;
    return data;
}

foundation::Result<JsbsimData> parseJsbsimAircraft(std::string_view text, const std::string& name)
{
    const auto source = foundation::XmlSource::parse(text, name);
    return source ? readSource(**source) : source.error();
}

} // namespace simulation
