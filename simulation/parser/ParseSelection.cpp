// SPDX-License-Identifier: Apache-2.0
#include "simulation/parser/ElementParsers.h"

namespace simulation
{
namespace
{

bool isOfSelectedType(const ScenarioObject& object, const std::string& type)
{
    if (type == "vehicle") return std::holds_alternative<Vehicle>(object.object);
    if (type == "pedestrian") return std::holds_alternative<Pedestrian>(object.object);
    return type == "miscellaneous" && std::holds_alternative<MiscObject>(object.object);
}

} // namespace

/// Members are entities by name, or all of a type. (1.0 calls the type `type`.)
std::vector<std::string> parseSelection(ElementReader reader, const std::vector<ScenarioObject>& objects)
{
    reader.allowChildren({"Members"});
    ElementReader members = reader.child("Members");
    members.allowChildren({"EntityRef", "ByType", "ByObjectType"});
    std::vector<std::string> names;
    for (pugi::xml_node node : members.node.children("EntityRef"))
        for (const std::string& name : parseEntityRefs({reader.context, node}))
            names.push_back(name);
    for (const char* element : {"ByType", "ByObjectType"})
        for (pugi::xml_node node : members.node.children(element))
        {
            ElementReader type(reader.context, node);
            const std::string word = type.has("objectType") ? type.text("objectType") : type.text("type");
            for (const ScenarioObject& object : objects)
                if (isOfSelectedType(object, word)) names.push_back(object.name);
        }
    if (names.empty())
        reader.context.invalid(reader.node, "the EntitySelection has no members",
                               "name entities of the scenario");
    return names;
}

} // namespace simulation
