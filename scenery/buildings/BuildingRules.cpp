// SPDX-License-Identifier: Apache-2.0
#include "scenery/buildings/BuildingRules.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include <foundation/TagQuantity.h>

#include "scenery/buildings/Outline.h"
#include "scenery/buildings/TagColour.h"
#include "scenery/models/Dice.h"
#include "scenery/models/houses/HouseColours.h"

namespace scenery
{

namespace
{

using models::Dice;
using models::Painting;

constexpr double kLeastWallM = 0.05; ///< of a part that begins above the ground
constexpr double kStoreyM = 3.0, kHallStoreyM = 4.5;
constexpr double kLeastAreaM2 = 3.0, kMostAreaM2 = 2e5;
constexpr double kLargeM2 = 1600.0; ///< a larger roof is flat
constexpr int kHighStoreys = 5;     ///< so is that of a higher house

std::string_view valueOf(const BuildingTags& tags, std::string_view key)
{
    const auto found = tags.find(key);
    return found == tags.end() ? std::string_view() : std::string_view(found->second);
}

std::optional<double> within(std::optional<double> number, double least, double most)
{
    return number && *number >= least && *number <= most ? number : std::nullopt;
}

/// A number of storeys.
std::optional<double> numberOf(const BuildingTags& tags, std::string_view key, double least, double most)
{
    return within(foundation::numberOfTag(valueOf(tags, key)), least, most);
}

std::optional<double> metresOf(const BuildingTags& tags, std::string_view key, double least, double most)
{
    return within(foundation::metresOfTag(valueOf(tags, key)), least, most);
}

/// The height with its roof, by the first key that tells it.
std::optional<double> heightOf(const BuildingTags& tags)
{
    for (const std::string_view key : {"height", "building:height", "est_height"})
        if (const auto heightM = metresOf(tags, key, 1.0, 900.0)) return heightM;
    return std::nullopt;
}

template<std::size_t N>
bool isOneOf(std::string_view value, const std::array<std::string_view, N>& words)
{
    return std::find(words.begin(), words.end(), value) != words.end();
}

constexpr double kOpenRoofM = 0.3; ///< of the edge of a roof without walls
constexpr std::array<std::string_view, 14> kLow{"garage", "garages", "shed",  "hut",           "carport",
                                                "roof",   "cabin",   "kiosk", "greenhouse",    "barn",
                                                "stable", "cowshed", "sty",   "farm_auxiliary"};
constexpr std::array<std::string_view, 9> kHalls{"industrial",  "warehouse",   "hangar",
                                                 "retail",      "supermarket", "commercial",
                                                 "sports_hall", "factory",     "train_station"};
constexpr std::array<std::string_view, 4> kSacred{"church", "chapel", "cathedral", "monastery"};
constexpr std::array<std::string_view, 4> kBlocks{"apartments", "hotel", "office", "hospital"};

int storeysOf(std::string_view kind, double areaM2, Dice& dice)
{
    if (isOneOf(kind, kLow)) return 1;
    if (isOneOf(kind, kBlocks)) return 4 + dice.below(3);
    if (isOneOf(kind, kHalls)) return areaM2 > 800.0 ? 2 : 1;
    if (isOneOf(kind, kSacred)) return 2;
    if (areaM2 < 35.0) return 1;
    if (areaM2 < 250.0) return dice.chance(0.3) ? 1 : 2;
    return areaM2 < 600.0 ? 3 : 4;
}

bool isHangar(std::string_view kind, const BuildingTags& tags)
{
    return kind == "hangar" || valueOf(tags, "aeroway") == "hangar";
}

std::optional<RoofForm> roofOfTag(std::string_view shape)
{
    if (shape == "flat") return RoofForm::flat;
    if (shape == "gabled" || shape == "gambrel" || shape == "saltbox" || shape == "side_hipped")
        return RoofForm::gabled;
    if (shape == "round") return RoofForm::round;
    if (shape == "hipped" || shape == "half-hipped" || shape == "mansard") return RoofForm::hipped;
    if (shape == "pyramidal" || shape == "dome" || shape == "cone" || shape == "onion")
        return RoofForm::pyramidal;
    if (shape == "skillion" || shape == "lean_to") return RoofForm::skillion;
    return std::nullopt;
}

RoofForm roofOf(const Building& building, std::string_view kind, double areaM2, Dice& dice)
{
    const PlanRectangle box = rectangleAround(building.rings.front());
    const bool isCompact = areaM2 > 0.62 * box.area() && building.rings.size() == 1;
    const double share = dice.unit();
    if (isOneOf(kind, kHalls) || kind == "roof" || kind == "garages" || kind == "carport")
        return RoofForm::flat;
    if (building.storeys > kHighStoreys || areaM2 > kLargeM2 || !isCompact) return RoofForm::flat;
    if (isOneOf(kind, kSacred)) return RoofForm::gabled;
    return share < 0.8 ? RoofForm::gabled : (share < 0.9 ? RoofForm::hipped : RoofForm::flat);
}

void setWalls(Building& building, std::string_view kind, const BuildingTags& tags, Dice& dice)
{
    building.wallTint = dice.oneOf(models::kPlasterTints);
    building.doorTint = dice.oneOf(models::kDoorTints);
    const std::string_view material = valueOf(tags, "building:material");
    const bool isWooden = material == "wood" || kind == "barn" || kind == "shed" || kind == "hut";
    if (material == "brick" || material == "stone" || isOneOf(kind, kSacred))
    {
        building.wall = Painting::bricks;
        building.wallTint = material == "brick" ? glm::vec3(1.0F) : glm::vec3(0.86F, 0.84F, 0.80F);
    }
    else if (isWooden)
    {
        building.wall = Painting::planks;
        building.wallTint = glm::vec3(0.9F);
    }
    else if (isOneOf(kind, kHalls) || material == "metal")
    {
        building.wall = Painting::sheetMetal;
        building.wallTint = dice.oneOf(models::kSheetTints);
    }
    if (const auto colour = colourOfTag(valueOf(tags, "building:colour"))) building.wallTint = *colour;
}

void setRoof(Building& building, std::string_view kind, double areaM2, const BuildingTags& tags, Dice& dice)
{
    const auto shape = roofOfTag(valueOf(tags, "roof:shape"));
    const RoofForm byRule = roofOf(building, kind, areaM2, dice);
    const bool isArched = isHangar(kind, tags) && building.rings.size() == 1;
    building.roof = shape.value_or(isArched ? RoofForm::round : byRule);
    building.isRidgeAcross = valueOf(tags, "roof:orientation") == "across";
    const double halfM = rectangleAround(building.rings.front()).halfWidthM;
    const double pitch = dice.between(0.42, 0.70); // 23° to 35°
    const double byPitch =
        building.roof == RoofForm::skillion ? 0.5 * halfM : std::clamp(pitch * halfM, 0.3, 6.0);
    const double levels = numberOf(tags, "roof:levels", 0.5, 4.0).value_or(0.0) * kStoreyM;
    const double byRules = building.roof == RoofForm::flat ? 0.0 : (levels > 0.0 ? levels : byPitch);
    building.roofM = metresOf(tags, "roof:height", 0.0, 60.0).value_or(byRules);
    building.roofTint = dice.oneOf(models::kTileTints);
    if (building.roof == RoofForm::flat || building.roof == RoofForm::round)
    {
        building.cover = Painting::roofMetal;
        building.roofTint =
            dice.chance(0.5) ? glm::vec3(0.62F, 0.61F, 0.59F) : glm::vec3(0.48F, 0.47F, 0.46F);
    }
    if (const auto colour = colourOfTag(valueOf(tags, "roof:colour"))) building.roofTint = *colour;
}

Openings openingsOf(std::string_view kind, const BuildingTags& tags)
{
    if (isHangar(kind, tags)) return Openings::hangar;
    if (valueOf(tags, "service") == "aircraft_control" || valueOf(tags, "aeroway") == "control_tower" ||
        valueOf(tags, "tower:type") == "airport_control")
        return Openings::control;
    const bool isBlind = isOneOf(kind, kLow) || kind == "transformer_tower" || kind == "silo";
    return isBlind ? Openings::none : Openings::house;
}

void setHeights(Building& building, std::string_view kind, double areaM2, const BuildingTags& tags,
                Dice& dice)
{
    const int byRule = storeysOf(kind, areaM2, dice);
    building.storeys = static_cast<int>(numberOf(tags, "building:levels", 1.0, 100.0).value_or(byRule));
    const double storeyM = isOneOf(kind, kHalls) ? kHallStoreyM : (isOneOf(kind, kLow) ? 2.6 : kStoreyM);
    building.eavesM = building.storeys * storeyM + dice.between(0.2, 0.7);
    if (isOneOf(kind, kSacred) && !numberOf(tags, "building:levels", 1.0, 100.0)) building.eavesM = 7.0;
}

/// Where a part begins above the ground: its height, or that of the storeys below it.
double lowestOf(const Building& building, const BuildingTags& tags)
{
    if (const auto lowM = metresOf(tags, "min_height", 0.0, 900.0)) return *lowM;
    for (const std::string_view key : {"building:min_level", "min_level"})
        if (const auto level = numberOf(tags, key, 0.0, 200.0))
        {
            const bool hasLevels = numberOf(tags, "building:levels", 1.0, 100.0).has_value();
            return *level * (hasLevels ? building.eavesM / building.storeys : kStoreyM);
        }
    return 0.0;
}

/// Fits the roof of a part between where the part begins and its top: a guessed roof would begin below it. A
/// part that is a roof is nothing else.
void fitAbove(Building& building, double lowM, double heightM, const BuildingTags& tags)
{
    const double mostM = heightM - lowM - kLeastWallM;
    const bool isAllRoof = valueOf(tags, "building:part") == "roof" && building.roof != RoofForm::flat &&
                           valueOf(tags, "roof:height").empty();
    building.roofM = isAllRoof ? mostM : std::min(building.roofM, mostM);
    building.eavesM = heightM - building.roofM;
}

RoomUse roomsOf(std::string_view kind)
{
    constexpr std::array<std::string_view, 8> kWork{"office", "school",   "university", "civic",
                                                    "public", "hospital", "tower",      "government"};
    if (isOneOf(kind, kLow) || isOneOf(kind, kSacred)) return RoomUse::unused;
    return isOneOf(kind, kHalls) || isOneOf(kind, kWork) ? RoomUse::work : RoomUse::dwelling;
}

} // namespace

std::optional<Building> buildingOf(const std::vector<std::vector<glm::dvec2>>& rings,
                                   const BuildingTags& tags, std::uint64_t id)
{
    Building building;
    building.rings = tidiedRings(rings);
    if (building.rings.empty()) return std::nullopt;
    const double areaM2 = areaOf(building.rings);
    if (!(areaM2 >= kLeastAreaM2 && areaM2 <= kMostAreaM2)) return std::nullopt;
    Dice dice(id + 70000);
    const std::string_view kind = valueOf(tags, "building");
    setHeights(building, kind, areaM2, tags, dice);
    setWalls(building, kind, tags, dice);
    setRoof(building, kind, areaM2, tags, dice);
    if (const auto heightM = heightOf(tags))
    {
        building.roofM = std::min(building.roofM, 0.6 * *heightM);
        building.eavesM = *heightM - building.roofM;
        const bool hasLevels = numberOf(tags, "building:levels", 1.0, 100.0).has_value();
        if (!hasLevels) building.storeys = std::max(1, static_cast<int>(building.eavesM / kStoreyM));
    }
    const double lowM = lowestOf(building, tags);
    if (const auto heightM = heightOf(tags); heightM && lowM > 0.0 && lowM < *heightM - kLeastWallM)
        fitAbove(building, lowM, *heightM, tags);
    if (lowM < building.eavesM) building.liftedM = lowM;
    building.isOnPosts = kind == "roof" || kind == "carport";
    if (building.isOnPosts && building.liftedM <= 0.0)
        building.liftedM = std::max(0.5 * building.eavesM, building.eavesM - kOpenRoofM);
    building.openings = openingsOf(kind, tags);
    building.rooms = roomsOf(kind);
    building.hasShop = kind == "retail" || kind == "supermarket" || !valueOf(tags, "shop").empty();
    return building;
}

std::optional<Building> towerOf(const glm::dvec2& place, const BuildingTags& tags, std::uint64_t id)
{
    /// Half the width and the height of what stands at a point.
    struct Tower
    {
        std::string_view kind;
        double halfM, heightM;
    };
    constexpr std::array<Tower, 8> kTowers{{{"tower", 2.0, 22.0},
                                            {"mast", 0.35, 30.0},
                                            {"communications_tower", 3.0, 60.0},
                                            {"water_tower", 4.5, 26.0},
                                            {"chimney", 1.6, 35.0},
                                            {"silo", 3.0, 14.0},
                                            {"storage_tank", 4.0, 7.0},
                                            {"lighthouse", 3.0, 25.0}}};
    const std::string_view kind = valueOf(tags, "man_made");
    const auto tower =
        std::find_if(kTowers.begin(), kTowers.end(), [&](const Tower& t) { return t.kind == kind; });
    if (tower == kTowers.end()) return std::nullopt;
    std::vector<glm::dvec2> ring;
    for (int i = 0; i < 8; ++i)
    {
        const double angle = (i + 0.5) * std::numbers::pi / 4.0;
        ring.push_back(place + tower->halfM * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    Building building;
    building.rings = {std::move(ring)};
    const double heightM = heightOf(tags).value_or(tower->heightM);
    building.roof = kind == "silo" || kind == "tower" ? RoofForm::pyramidal : RoofForm::flat;
    building.roofM = building.roof == RoofForm::flat ? 0.0 : std::min(tower->halfM, 0.5 * heightM);
    building.eavesM = heightM - building.roofM;
    building.wall = kind == "chimney" || kind == "tower" ? Painting::bricks : Painting::sheetMetal;
    building.cover = Painting::roofMetal;
    building.roofTint = glm::vec3(0.62F);
    building.wallTint = glm::vec3(static_cast<float>(Dice(id).between(0.75, 0.95)));
    building.openings = Openings::none;
    return building;
}

} // namespace scenery
