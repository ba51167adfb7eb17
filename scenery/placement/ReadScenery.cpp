// SPDX-License-Identifier: Apache-2.0
#include "scenery/placement/ReadScenery.h"

#include <algorithm>
#include <set>

#include "scenery/json/ParseJson.h"
#include "scenery/placement/ReadField.h"
#include "scenery/placement/ReadSelection.h"

namespace scenery
{

namespace
{

using nlohmann::json;

constexpr std::size_t kMostFields = 1000;

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
    const auto root = parseJson(text, name.string());
    if (!root) return root.error();
    Complaint complaint{name.string(), {}};
    SceneryDescription description = describe(*root, name.parent_path(), complaint);
    if (complaint.error) return *complaint.error;
    return description;
}

foundation::Result<SceneryDescription> readScenery(const std::filesystem::path& file)
{
    const auto text = readJsonText(file, "a scenery's JSON file");
    return text ? parseScenery(*text, file) : text.error();
}

} // namespace scenery
