// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/looks/VehicleLookFile.h"

#include <array>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "scenery/json/JsonFields.h"
#include "scenery/json/ParseJson.h"
#include "scenery/models/looks/BuiltInLooks.h"
#include "scenery/models/looks/ReadLookPaint.h"
#include "scenery/models/looks/ReadLookShape.h"

namespace scenery::models
{

namespace
{

using nlohmann::json;

constexpr double kFarM = 20.0;
constexpr std::size_t kMostColours = 64;

/// Adds to an object the members that it lacks; an object in both gets those that it lacks, too.
void fillFrom(json& object, const json& other, int deep)
{
    for (const auto& [name, value] : other.items())
    {
        const auto own = object.find(name);
        if (own == object.end())
            object[name] = value;
        else if (deep > 1 && own->is_object() && value.is_object())
            fillFrom(*own, value, deep - 1);
    }
}

/// Fills what is missing from the built-in look that `like` names, and from that one's.
void fillFromLike(json& root, Complaint& complaint)
{
    constexpr int kDeep = 2; // the members of the root, and theirs
    for (json like = root.is_object() ? root.value("like", json()) : json(); !like.is_null();)
    {
        const std::string_view text = like.is_string() ? builtInLookText(like.get<std::string>()) : "";
        std::string names;
        for (const std::string_view name : builtInLookNames())
            names += (names.empty() ? "" : ", ") + std::string(name);
        if (text.empty()) return complaint.say("/like", "names no built-in look", "one of " + names);
        const auto other = parseJson(text, like.get<std::string>());
        if (!other) return complaint.say("/like", other.error().message(), "give another");
        like = other->value("like", json());
        fillFrom(root, *other, kDeep);
    }
}

void readLamp(JsonFields& fields, LookLamp& lamp)
{
    readNeeded(fields, "yM", lamp.at.x, 0.0, 2.0);
    readNeeded(fields, "zM", lamp.at.y, 0.05, 5.0);
    readNeeded(fields, "widthM", lamp.sizeM.x, 0.02, 1.0);
    readNeeded(fields, "heightM", lamp.sizeM.y, 0.02, 1.0);
}

void readLookPlace(JsonFields& fields, const char* name, glm::dvec3& place)
{
    std::vector<double> numbers;
    if (!fields.numbers(name, numbers, -kFarM, kFarM)) return sayMissing(fields, name);
    if (numbers.size() != 3) return fields.complaint().say(fields.at(name), "is no place", "write [x, y, z]");
    place = {numbers[0], numbers[1], numbers[2]};
}

void readMirrors(JsonFields& fields, LookMirror& mirrors)
{
    readLookPlace(fields, "foot", mirrors.foot);
    readLookPlace(fields, "head", mirrors.head);
    readNeeded(fields, "radiusM", mirrors.radiusM, 0.02, 0.5);
    readNeeded(fields, "lengthM", mirrors.lengthM, 0.05, 1.0);
    fields.flag("isWide", mirrors.isWide);
    if (glm::distance(mirrors.foot, mirrors.head) < 0.02)
        fields.complaint().say(fields.at("head"), "is where the foot is", "give the arm some length");
}

void readEye(JsonFields& fields, LookEye& eye)
{
    fields.number("alongShare", eye.alongShare, 0.0, 1.0);
    fields.number("alongM", eye.alongM, -kFarM, kFarM);
    fields.number("leftShare", eye.leftShare, -0.5, 0.5);
    fields.number("upShare", eye.upShare, 0.0, 1.0);
    fields.number("upM", eye.upM, 0.0, 5.0);
}

void readColours(JsonFields& root, std::vector<glm::vec3>& colours)
{
    const json* const list = root.list("colours");
    if (!list || list->empty() || list->size() > kMostColours)
        return root.complaint().say(root.at("colours"), "there are none, or more than 64",
                                    "give a list of [red, green, blue]");
    for (std::size_t i = 0; i < list->size(); ++i)
        readColour((*list)[i], root.at("colours") + "/" + std::to_string(i), root.complaint(),
                   colours.emplace_back());
}

VehicleLook readLook(const json& object, Complaint& complaint)
{
    VehicleLook look;
    JsonFields root(object, "", complaint);
    std::string like;
    root.text("like", like);
    if (!root.text("name", look.name) || look.name.empty())
        complaint.say("/name", "is missing or empty", "give the look a name");
    static constexpr std::array kKinds{"car", "van", "bus"};
    if (!root.choice("kind", look.kind, kKinds)) sayMissing(root, "kind");
    root.whole("seed", look.seed, 0.0, 9e15);
    readLookShape(root, look);
    readColours(root, look.colours);
    readPart(root, "headLamps", [&](JsonFields& fields) { readLamp(fields, look.headLamps); });
    readPart(root, "tailLamps", [&](JsonFields& fields) { readLamp(fields, look.tailLamps); });
    readPart(root, "mirrors", [&](JsonFields& fields) { readMirrors(fields, look.mirrors); });
    readPart(root, "eye", [&](JsonFields& fields) { readEye(fields, look.eye); });
    readLookPaint(root, look);
    return look;
}

} // namespace

foundation::Result<VehicleLook> parseVehicleLook(std::string_view text, const std::string& name)
{
    auto root = parseJson(text, name);
    if (!root) return root.error();
    Complaint complaint{name, {}};
    fillFromLike(*root, complaint);
    VehicleLook look = readLook(*root, complaint);
    if (complaint.error) return *complaint.error;
    look.mark = foundation::ContentMark().add(text);
    return look;
}

foundation::Result<VehicleLook> readVehicleLook(const std::filesystem::path& file)
{
    const auto text = readJsonText(file, "the JSON file of a vehicle's look");
    return text ? parseVehicleLook(*text, file.string()) : text.error();
}

} // namespace scenery::models
