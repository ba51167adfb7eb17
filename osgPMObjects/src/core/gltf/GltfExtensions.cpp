// SPDX-License-Identifier: Apache-2.0
#include "GltfExtensions.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string_view>

#include <nlohmann/json.hpp>

#include "GltfMeshopt.h"

namespace osgPMObjects::core
{

namespace
{

using nlohmann::json;

enum class Reading
{
    whole,       ///< all of the extension is read
    approximate, ///< the surface is the same without it, only its look differs
    none,
};

Reading readingOf(std::string_view extension)
{
    constexpr std::array kWhole{std::string_view("KHR_mesh_quantization"),
                                std::string_view("KHR_texture_transform"), kMeshoptExtensions[0],
                                kMeshoptExtensions[1]};
    if (std::find(kWhole.begin(), kWhole.end(), extension) != kWhole.end()) return Reading::whole;
    if (extension.starts_with("KHR_materials_") || extension == "KHR_lights_punctual")
        return Reading::approximate;
    return Reading::none;
}

/// Where the JSON of a file stands: all of a .gltf, the first chunk of a .glb.
struct JsonPlace
{
    std::size_t offset = 0, length = 0;
    bool isBinary = false;
};

std::uint32_t numberAt(const std::string& bytes, std::size_t offset)
{
    std::uint32_t number = 0; // little endian, as all that we run on
    std::memcpy(&number, bytes.data() + offset, sizeof number);
    return number;
}

std::optional<JsonPlace> jsonPlaceOf(const std::string& bytes)
{
    if (!bytes.starts_with("glTF")) return JsonPlace{0, bytes.size(), false};
    if (bytes.size() < 20) return {};
    const JsonPlace place{20, numberAt(bytes, 12), true};
    if (place.length > bytes.size() - place.offset) return {};
    return place;
}

/// Puts another JSON in; the sizes of a .glb follow.
void replaceJson(std::string& bytes, const JsonPlace& place, std::string text)
{
    if (place.isBinary) text.resize((text.size() + 3) / 4 * 4, ' ');
    bytes.replace(place.offset, place.length, text);
    if (!place.isBinary) return;
    const auto all = static_cast<std::uint32_t>(bytes.size()),
               chunk = static_cast<std::uint32_t>(text.size());
    std::memcpy(bytes.data() + 8, &all, sizeof all);
    std::memcpy(bytes.data() + 12, &chunk, sizeof chunk);
}

const json* memberOf(const json& object, const char* name)
{
    const auto found = object.is_object() ? object.find(name) : object.end();
    return object.is_object() && found != object.end() ? &*found : nullptr;
}

json* arrayOf(json& object, const char* name)
{
    const auto found = object.find(name);
    return found != object.end() && found->is_array() ? &*found : nullptr;
}

std::vector<std::string> namesIn(const json& model, const char* list)
{
    std::vector<std::string> names;
    if (const json* const entries = memberOf(model, list); entries && entries->is_array())
        for (const json& entry : *entries)
            if (entry.is_string()) names.push_back(entry.get<std::string>());
    return names;
}

foundation::Outcome checkNames(const json& model, const std::string& name, GltfReport& report)
{
    for (const std::string& extension : namesIn(model, "extensionsRequired"))
        if (readingOf(extension) == Reading::none)
            return foundation::Error{name, "requires the extension " + extension + ", which is not read",
                                     "export the model again without it"};
    for (const std::string& extension : namesIn(model, "extensionsUsed"))
        if (readingOf(extension) != Reading::whole) report.leftOutExtensions.push_back(extension);
    return foundation::success();
}

/// The first number of "2.0"; 0: there is none.
int majorOf(const json* version)
{
    if (!version || !version->is_string()) return 0;
    return std::atoi(version->get_ref<const std::string&>().c_str());
}

/// Errors: the file says that it is of another version, or that its reader must know more than 2.0.
foundation::Outcome checkVersion(const json& model, const std::string& name)
{
    const json* const asset = memberOf(model, "asset");
    if (!asset) return foundation::success();
    const json* const version = memberOf(*asset, "version");
    if (version && majorOf(version) != 2)
        return foundation::Error{name, "is glTF of version " + version->dump() + ", not 2",
                                 "export the model again as glTF 2"};
    const json* const least = memberOf(*asset, "minVersion");
    if (least && *least != "2.0")
        return foundation::Error{name, "requires a reader of glTF " + least->dump() + "; 2.0 is read",
                                 "export the model again as glTF 2.0"};
    return foundation::success();
}

/// Errors: a primitive has its vertices in the data of an extension alone that is not read, though the file
/// does not say that it requires it.
foundation::Outcome checkData(const json& model, const std::string& name)
{
    const json* const accessors = memberOf(model, "accessors");
    const auto hasData = [&](const json& index)
    {
        if (!accessors || !index.is_number_unsigned() || index >= accessors->size())
            return true; // told elsewhere
        const json& accessor = (*accessors)[index.get<std::size_t>()];
        return memberOf(accessor, "bufferView") || memberOf(accessor, "sparse");
    };
    const json none = json::array();
    const auto listIn = [&](const json& object, const char* member) -> const json&
    {
        const json* const list = memberOf(object, member);
        return list && list->is_array() ? *list : none;
    };
    for (const json& mesh : listIn(model, "meshes"))
        for (const json& primitive : listIn(mesh, "primitives"))
        {
            const json* const extensions = memberOf(primitive, "extensions");
            const json* const attributes = memberOf(primitive, "attributes");
            const json* const position = attributes ? memberOf(*attributes, "POSITION") : nullptr;
            const json* const indices = memberOf(primitive, "indices");
            if (!extensions || !extensions->is_object() || !position) continue;
            if (hasData(*position) && (!indices || hasData(*indices))) continue;
            for (const auto& [extension, data] : extensions->items())
                if (readingOf(extension) == Reading::none)
                    return foundation::Error{
                        name, "has a mesh in the extension " + extension + ", which is not read",
                        "export the model again without it"};
        }
    return foundation::success();
}

/// The data of such a buffer are those that its views decompress.
bool isStandIn(const json& buffer)
{
    const json* const extensions = memberOf(buffer, "extensions");
    if (!extensions || memberOf(buffer, "uri")) return false;
    return std::any_of(kMeshoptExtensions.begin(), kMeshoptExtensions.end(),
                       [&](std::string_view extension)
                       { return memberOf(*extensions, std::string(extension).c_str()) != nullptr; });
}

bool fillStandIns(json& model)
{
    bool isChanged = false;
    if (json* const buffers = arrayOf(model, "buffers"))
        for (json& buffer : *buffers)
            if (isStandIn(buffer))
            {
                buffer["uri"] = "data:application/octet-stream;base64,AA==";
                buffer["byteLength"] = 1;
                isChanged = true;
            }
    return isChanged;
}

/// Gives accessors that are indices, sparse and without a view one of no bytes.
bool giveViews(json& model)
{
    json* const accessors = arrayOf(model, "accessors");
    json* const meshes = arrayOf(model, "meshes");
    if (!accessors || !meshes) return false;
    bool isChanged = false;
    for (const json& mesh : *meshes)
        if (const json* const primitives = memberOf(mesh, "primitives"); primitives && primitives->is_array())
            for (const json& primitive : *primitives)
            {
                const json* const indices = memberOf(primitive, "indices");
                if (!indices || !indices->is_number_unsigned() || *indices >= accessors->size()) continue;
                json& accessor = (*accessors)[indices->get<std::size_t>()];
                if (!memberOf(accessor, "sparse") || memberOf(accessor, "bufferView")) continue;
                json& views = model["bufferViews"];
                if (!views.is_null() && !views.is_array()) continue;
                accessor["bufferView"] = views.size();
                views.push_back({{"buffer", 0}, {"byteLength", 0}});
                isChanged = true;
            }
    return isChanged;
}

/// Refuses sizes and places below 0, which the parser takes for 0.
foundation::Outcome checkSigns(std::string_view text, const std::string& name)
{
    constexpr const char* kBlanks = " \t\r\n";
    for (const std::string_view key : {"\"byteOffset\"", "\"byteLength\"", "\"byteStride\"", "\"count\""})
        for (std::size_t at = text.find(key); at != text.npos; at = text.find(key, at + 1))
        {
            const std::size_t colon = text.find_first_not_of(kBlanks, at + key.size());
            if (colon == text.npos || text[colon] != ':') continue;
            const std::size_t value = text.find_first_not_of(kBlanks, colon + 1);
            if (value != text.npos && text[value] == '-')
                return foundation::Error{name,
                                         "has a " + std::string(key.substr(1, key.size() - 2)) + " below 0",
                                         "export the model again"};
        }
    return foundation::success();
}

} // namespace

foundation::Outcome prepareExtensions(std::string& bytes, const std::string& name, GltfReport& report)
{
    const auto place = jsonPlaceOf(bytes);
    if (!place) return foundation::success();
    const std::string_view text = std::string_view(bytes).substr(place->offset, place->length);
    if (const auto checked = checkSigns(text, name); !checked) return checked;
    const auto has = [&](const char* word) { return text.find(word) != text.npos; };
    if (!has("\"extensions") && !has("\"sparse\"") && !has("\"minVersion\"") && has("\"2.0\""))
        return foundation::success(); // needs no look
    constexpr int kDeepest = 512;     // the library writes by recursion
    bool isTooDeep = false;
    const auto watch = [&](int depth, json::parse_event_t, json&)
    {
        isTooDeep = isTooDeep || depth > kDeepest;
        return !isTooDeep;
    };
    json model = json::parse(text.begin(), text.end(), watch, false);
    if (!model.is_object() || isTooDeep) return foundation::success();
    if (const auto checked = checkVersion(model, name); !checked) return checked;
    if (const auto checked = checkNames(model, name, report); !checked) return checked;
    if (const auto checked = checkData(model, name); !checked) return checked;
    const bool hasStandIns = fillStandIns(model), hasViews = giveViews(model);
    if (hasStandIns || hasViews)
        replaceJson(bytes, *place, model.dump(-1, ' ', false, json::error_handler_t::replace));
    return foundation::success();
}

} // namespace osgPMObjects::core
