// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/land/HouseFile.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "scenery/buildings/StandBuildings.h"
#include "worldmaking/land/MapFile.h"

namespace worldmaking
{

namespace
{

std::string metres(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.2f", value);
    return text;
}

std::string hexOf(const glm::vec3& colour)
{
    const auto part = [](float share) { return static_cast<unsigned>(std::lround(255.0F * share)); };
    char text[16];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", part(std::min(colour.r, 1.0F)),
                  part(std::min(colour.g, 1.0F)), part(std::min(colour.b, 1.0F)));
    return text;
}

const char* nameOf(scenery::RoofForm roof)
{
    switch (roof)
    {
    case scenery::RoofForm::flat:
        return "flat";
    case scenery::RoofForm::gabled:
        return "gabled";
    case scenery::RoofForm::hipped:
        return "hipped";
    case scenery::RoofForm::pyramidal:
        return "pyramidal";
    case scenery::RoofForm::skillion:
        return "skillion";
    case scenery::RoofForm::round:
        return "round";
    }
    return "flat";
}

Tags tagsOf(const House& house)
{
    Tags tags = house.shape.tags;
    const auto& building = house.building;
    tags.insert_or_assign("osm_id", std::to_string(house.shape.id));
    tags.insert_or_assign("height", metres(building.eavesM + building.roofM));
    tags.insert_or_assign("building:levels", std::to_string(building.storeys));
    tags.insert_or_assign("roof:shape", nameOf(building.roof));
    tags.insert_or_assign("roof:height", metres(building.roofM));
    tags.insert_or_assign("building:colour", hexOf(building.wallTint));
    tags.insert_or_assign("roof:colour", hexOf(building.roofTint));
    if (building.liftedM > 0.0) tags.insert_or_assign("min_height", metres(building.liftedM));
    if (house.whole != 0) tags.insert_or_assign(std::string(scenery::kWholeTag), std::to_string(house.whole));
    return tags;
}

} // namespace

foundation::Outcome writeHouses(std::span<const House> houses, const std::filesystem::path& file)
{
    MapFile map(file);
    std::vector<std::string> keys{"osm_id",      "building",          "name",
                                  "height",      "building:levels",   "roof:shape",
                                  "roof:height", "roof:orientation",  "building:colour",
                                  "roof:colour", "building:material", "shop",
                                  "aeroway",     "service",           "tower:type"};
    if (std::any_of(houses.begin(), houses.end(),
                    [](const House& house) { return house.building.liftedM > 0.0; }))
        keys.emplace_back("min_height");
    if (std::any_of(houses.begin(), houses.end(), [](const House& house) { return house.whole != 0; }))
        keys.emplace_back(scenery::kWholeTag);
    map.beginLayer("buildings", ShapeForm::area, keys);
    for (const House& house : houses)
        if (house.shape.form == ShapeForm::area) map.add(house.shape.paths, tagsOf(house));
    map.beginLayer("towers", ShapeForm::point, {"osm_id", "man_made", "name", "height"});
    for (const House& house : houses)
        if (house.shape.form == ShapeForm::point)
        {
            Tags tags = house.shape.tags;
            tags.insert_or_assign("osm_id", std::to_string(house.shape.id));
            tags.insert_or_assign("height", metres(house.building.eavesM + house.building.roofM));
            map.add(house.shape.paths, tags);
        }
    return map.finish();
}

} // namespace worldmaking
