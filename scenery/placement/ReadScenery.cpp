// SPDX-License-Identifier: Apache-2.0
#include "scenery/placement/ReadScenery.h"

#include <fstream>
#include <set>

#include "scenery/placement/ReadField.h"
#include "scenery/placement/ReadSelection.h"

namespace scenery
{

namespace
{

using nlohmann::json;

constexpr std::size_t kMostBytes = 4u << 20u, kMostFields = 1000;

void checkNeighbours(const SceneryDescription& description, Complaint& complaint)
{
    for (std::size_t i = 0; i < description.fields.size(); ++i)
    {
        const SceneryField& field = description.fields[i];
        if (field.arrangement != Arrangement::parked) continue;
        const auto isIt = [&](const SceneryField& other)
        { return other.arrangement == Arrangement::settlement && other.name == field.beside; };
        if (std::none_of(description.fields.begin(), description.fields.end(), isIt))
            complaint.say("/fields/" + std::to_string(i) + "/beside", "names no settlement",
                          "give the name of a field that is one");
    }
}

SceneryDescription describe(const json& root, const std::filesystem::path& folder, Complaint& complaint)
{
    SceneryDescription description;
    JsonFields fields(root, "", complaint);
    fields.whole("seed", description.seed, 0.0, 9e15);
    readBudget(fields, description.budget);
    const json* const list = fields.list("fields");
    if (!list || list->size() > kMostFields)
        complaint.say("/fields", "there are none, or too many", "give up to " + std::to_string(kMostFields));
    std::set<std::string> names;
    for (std::size_t i = 0; list && i < list->size() && !complaint.error; ++i)
    {
        const std::string pointer = "/fields/" + std::to_string(i);
        description.fields.push_back(readField((*list)[i], pointer, folder, complaint));
        if (!names.insert(description.fields.back().name).second)
            complaint.say(pointer + "/name", "another field has this name", "give each one of its own");
    }
    checkNeighbours(description, complaint);
    return description;
}

} // namespace

foundation::Result<SceneryDescription> parseScenery(std::string_view text, const std::filesystem::path& name)
{
    if (text.size() > kMostBytes)
        return foundation::Error{name.string(), "is larger than 4 MB", "give a description of the scenery"};
    json root;
    try
    {
        root = json::parse(text, nullptr, true, true);
    }
    catch (const json::exception& failure) // the library's way to say so; it ends here
    {
        const auto* const parsing = dynamic_cast<const json::parse_error*>(&failure);
        const std::size_t byte = parsing ? std::min(parsing->byte, text.size()) : 0;
        const auto line =
            1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(byte), '\n');
        return foundation::Error{name.string() + ":" + std::to_string(line), "is no JSON",
                                 "look for a comma or a bracket before this place"};
    }
    Complaint complaint{name.string(), {}};
    SceneryDescription description = describe(root, name.parent_path(), complaint);
    if (complaint.error) return *complaint.error;
    return description;
}

foundation::Result<SceneryDescription> readScenery(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    std::string text(kMostBytes + 1, '\0');
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(std::max<std::streamsize>(stream.gcount(), 0)));
    if (text.empty())
        return foundation::Error{file.string(), "cannot be read or is empty", "give a scenery's JSON file"};
    return parseScenery(text, file);
}

} // namespace scenery
