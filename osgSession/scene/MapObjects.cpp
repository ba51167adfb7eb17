// SPDX-License-Identifier: Apache-2.0
#include "MapObjects.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

#include <foundation/KeptFrom.h>
#include <foundation/PlainBytes.h>

#include <osgTerrainROAM/core/features/ShapeImport.h>

#include "scenery/models/Dice.h"

namespace trainer
{

namespace
{

using osgTerrainROAM::core::MapShape;
using osgTerrainROAM::core::ShapeSet;

constexpr double kLeastScale = 0.05, kMostScale = 20.0;

double numberIn(const MapShape& shape, std::string_view key, double otherwise)
{
    const auto found = shape.tags.find(key);
    if (found == shape.tags.end()) return otherwise;
    double number = otherwise;
    const std::string& text = found->second;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
    return failure == std::errc() && std::isfinite(number) ? number : otherwise;
}

std::string_view tagIn(const MapShape& shape, std::string_view key)
{
    const auto found = shape.tags.find(key);
    return found == shape.tags.end() ? std::string_view() : std::string_view(found->second);
}

/// The model that stands at a point: that of its `kind`, or for a tree of OpenStreetMap one of its leaves.
std::optional<scenery::models::Kind> kindOf(const MapShape& shape)
{
    const std::string_view name = tagIn(shape, "kind");
    for (const auto& facts : scenery::models::kinds())
        if (facts.name == name) return facts.kind;
    if (tagIn(shape, "natural") != "tree") return std::nullopt;
    return tagIn(shape, "leaf_type") == "needleleaved" ? scenery::models::Kind::spruce
                                                       : scenery::models::Kind::oak;
}

std::uint64_t numberOf(const MapModel& model, std::vector<MapModel>& models)
{
    const auto found = std::find(models.begin(), models.end(), model);
    const auto number = static_cast<std::uint64_t>(found - models.begin());
    if (found == models.end()) models.push_back(model);
    return number;
}

/// False: it cannot stand anywhere.
bool stand(const MapShape& shape, const foundation::HeightInPlan& ground, MapObjects& made)
{
    const auto kind = shape.isArea() ? std::nullopt : kindOf(shape);
    const auto heightM = kind ? ground(glm::dvec2(shape.point)) : std::nullopt;
    if (!heightM) return false;
    scenery::models::Dice dice(static_cast<std::uint64_t>(shape.id));
    const double bearing = numberIn(shape, "heading", dice.between(0.0, 360.0));
    const auto seed = static_cast<std::uint64_t>(std::clamp(numberIn(shape, "seed", 1.0), 0.0, 1000.0));
    made.objects.push_back({{shape.point, *heightM},
                            std::numbers::pi * (0.5 - bearing / 180.0),
                            std::clamp(numberIn(shape, "scale", 1.0), kLeastScale, kMostScale),
                            numberOf({static_cast<std::uint64_t>(*kind), seed}, made.models)});
    return true;
}

foundation::Result<MapObjects> standShapes(const std::filesystem::path& source,
                                           const osgTerrainROAM::core::RoamTile& tile,
                                           const foundation::HeightInPlan& ground)
{
    const auto shapes = osgTerrainROAM::core::importShapes(source, tile.tile);
    if (!shapes) return shapes.error();
    MapObjects made;
    made.notes = shapes->notes;
    made.objects.reserve(shapes->shapes.size());
    for (const MapShape& shape : shapes->shapes)
        if (!stand(shape, ground, made)) ++made.unused;
    return made;
}

} // namespace

std::string bytesOf(const MapObjects& objects)
{
    std::string bytes;
    foundation::appendValues(bytes, objects.models);
    foundation::appendValues(bytes, objects.objects);
    foundation::appendValue(bytes, objects.unused);
    foundation::appendTexts(bytes, objects.notes);
    return bytes;
}

std::optional<MapObjects> mapObjectsIn(std::string_view bytes)
{
    MapObjects found;
    foundation::ValueTaker taker(bytes);
    if (!taker.take(found.models) || !taker.take(found.objects) || !taker.take(found.unused) ||
        !taker.take(found.notes) || !taker.isEmpty())
        return std::nullopt;
    const auto isGenerated = [](const MapModel& model)
    { return model.kind < scenery::models::kinds().size(); };
    const auto isPlaced = [&](const MapObject& object)
    {
        const double sum = object.position.x + object.position.y + object.position.z + object.headingRad;
        return std::isfinite(sum) && object.scale >= kLeastScale && object.scale <= kMostScale &&
               object.model < found.models.size();
    };
    const bool isSound = std::all_of(found.models.begin(), found.models.end(), isGenerated) &&
                         std::all_of(found.objects.begin(), found.objects.end(), isPlaced);
    return isSound ? std::optional(std::move(found)) : std::nullopt;
}

foundation::Result<MapObjects> readMapObjects(const std::filesystem::path& source,
                                              const osgTerrainROAM::core::RoamTile& tile,
                                              const foundation::HeightInPlan& ground)
{
    return foundation::KeptFrom::ofUser(tile.mark())
        .findOrRead(
            "objects", source, {}, mapObjectsIn, [&] { return standShapes(source, tile, ground); },
            [](const MapObjects& made) { return bytesOf(made); });
}

} // namespace trainer
