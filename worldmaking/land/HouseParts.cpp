// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/land/HouseParts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <ogr_geometry.h>

#include "scenery/buildings/BuildingRules.h"
#include "scenery/buildings/Outline.h"
#include "worldmaking/land/Houses.h"
#include "worldmaking/map/GdalScope.h"
#include "worldmaking/map/OgrPieces.h"
#include "worldmaking/map/OgrPolygon.h"
#include "worldmaking/plan/PlanGrid.h"

namespace worldmaking
{

namespace
{

constexpr double kLeastWithin = 0.5; ///< of a part, in the building that it belongs to
constexpr double kMostLeft = 0.1;    ///< of a building, that its parts leave and nothing stands on
constexpr double kLeastLeftM2 = 4.0;

bool isThere(const LandShape& shape, std::string_view key)
{
    const std::string_view value = valueOf(shape.tags, key);
    return shape.form == ShapeForm::area && !value.empty() && value != "no";
}

/// A building or a part with its outline in the plane.
struct Outlined
{
    const LandShape* shape = nullptr;
    PlanRings rings;
    std::vector<std::size_t> parts{}; ///< of a building
};

/// Tags of a part that its building tells. Heights go together.
Tags inherited(const Tags& part, const Tags& whole)
{
    constexpr std::array<std::string_view, 5> kPlain{"building", "building:colour", "roof:colour",
                                                     "building:material", "name"};
    constexpr std::array<std::string_view, 4> kHeights{"height", "building:height", "est_height",
                                                       "building:levels"};
    Tags tags = part;
    const auto take = [&](std::string_view key)
    {
        if (const std::string_view value = valueOf(whole, key); !value.empty())
            tags.try_emplace(std::string(key), value);
    };
    for (const std::string_view key : kPlain)
        take(key);
    const bool hasHeight = std::any_of(kHeights.begin(), kHeights.end(),
                                       [&](std::string_view key) { return !valueOf(part, key).empty(); });
    if (!hasHeight)
        for (const std::string_view key : kHeights)
            take(key);
    if (!hasHeight && valueOf(part, "roof:shape").empty()) tags.try_emplace("roof:shape", "flat");
    tags.try_emplace("building", "yes");
    return tags;
}

/// What parts leave of a building; nothing: they take all of it.
std::vector<LandShape> leftOf(const Outlined& whole, const std::vector<Outlined>& parts,
                              const MapPlane& plane)
{
    const GdalScope quiet;
    std::unique_ptr<OGRGeometry> left = polygonOf(whole.rings);
    for (const std::size_t part : whole.parts)
        if (left)
        {
            const auto taken = polygonOf(parts[part].rings);
            std::unique_ptr<OGRGeometry> rest(left->Difference(taken.get()));
            if (rest) left = std::move(rest);
        }
    std::vector<LandShape> pieces, kept;
    if (left) addPieces(*left, *whole.shape, pieces);
    double leftM2 = 0.0;
    std::erase_if(pieces, [](const LandShape& piece) { return scenery::areaOf(piece.paths) < kLeastLeftM2; });
    for (const LandShape& piece : pieces)
        leftM2 += scenery::areaOf(piece.paths);
    if (leftM2 < kMostLeft * scenery::areaOf(whole.rings)) return kept;
    for (LandShape& piece : pieces)
        if (auto degrees = plane.toDegrees(piece.paths))
        {
            piece.paths = std::move(*degrees);
            kept.push_back(std::move(piece));
        }
    return kept;
}

/// A part as it is built. Units: metres above the floor.
struct BuiltPart
{
    LandShape shape; ///< with the tags that it inherits
    PlanRings rings;
    double lowM = 0.0, topM = 0.0;

    /// Whether another part is seen in place of this one where both are.
    bool isHiddenBy(const BuiltPart& other, bool isEarlier) const
    {
        if (other.lowM > lowM || other.topM < topM) return false;
        return other.lowM < lowM || other.topM > topM || isEarlier;
    }
};

/// The parts of one building. Where one stands within a higher one, the lower one ends.
std::vector<HouseShape> partsOf(std::vector<BuiltPart> parts, std::int64_t whole, const MapPlane& plane)
{
    const GdalScope quiet;
    std::vector<HouseShape> shapes;
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
        std::unique_ptr<OGRGeometry> left;
        for (std::size_t j = 0; j < parts.size(); ++j)
        {
            if (j == i || !parts[i].isHiddenBy(parts[j], j < i) ||
                commonAreaOf(parts[i].rings, parts[j].rings) < kMostOverlapM2)
                continue;
            if (!left) left = polygonOf(parts[i].rings);
            std::unique_ptr<OGRGeometry> rest(left->Difference(polygonOf(parts[j].rings).get()));
            if (rest) left = std::move(rest);
        }
        if (!left)
        {
            shapes.push_back({parts[i].shape, whole});
            continue;
        }
        std::vector<LandShape> pieces;
        addPieces(*left, parts[i].shape, pieces);
        for (LandShape& piece : pieces)
        {
            auto degrees =
                scenery::areaOf(piece.paths) < kLeastLeftM2 ? std::nullopt : plane.toDegrees(piece.paths);
            if (!degrees) continue;
            piece.paths = std::move(*degrees);
            shapes.push_back({std::move(piece), whole});
        }
    }
    return shapes;
}

/// A part with what its building tells of it; `whole` may be null.
BuiltPart builtPart(const Outlined& part, const LandShape* whole)
{
    const Tags none;
    BuiltPart built{*part.shape, part.rings};
    built.shape.tags = inherited(part.shape->tags, whole ? whole->tags : none);
    const auto building =
        scenery::buildingOf(part.rings, built.shape.tags, static_cast<std::uint64_t>(part.shape->id));
    if (building) built.lowM = building->liftedM, built.topM = building->eavesM + building->roofM;
    return built;
}

/// The height of what parts leave of a building; nothing: that of the building; 0: nothing stands there. A
/// building that is as high as its highest part tells the height of that part: the rest is as high as the
/// lowest part on the ground.
std::optional<double> leftHeightM(const BuiltPart& whole, const std::vector<BuiltPart>& parts)
{
    constexpr double kSameTopM = 0.5;
    double mostM = 0.0, leastM = 1e300;
    for (const BuiltPart& part : parts)
    {
        mostM = std::max(mostM, part.topM);
        if (part.lowM <= 0.0) leastM = std::min(leastM, part.topM);
    }
    if (std::fabs(mostM - whole.topM) > kSameTopM) return std::nullopt;
    return leastM < mostM - kSameTopM ? leastM : 0.0;
}

} // namespace

std::vector<HouseShape> houseShapesOf(const LandMap& map, const MapPlane& plane, std::size_t& parts)
{
    std::vector<Outlined> partsOfMap, wholes;
    PlanGrid grid;
    for (const LandShape& shape : map.shapes)
    {
        const bool isPart = isThere(shape, "building:part");
        if (!isPart && !isThere(shape, "building")) continue;
        auto rings = plane.toPlan(shape.paths);
        if (!rings || rings->empty() || rings->front().size() < 3) rings.emplace();
        if (isPart && !rings->empty()) partsOfMap.push_back({&shape, std::move(*rings)});
        if (isPart) continue;
        if (!rings->empty()) grid.add(wholes.size(), boxOf(rings->front()));
        wholes.push_back({&shape, std::move(*rings)});
    }
    parts = partsOfMap.size();
    std::vector<std::optional<std::size_t>> ofWhole(partsOfMap.size());
    for (std::size_t i = 0; i < partsOfMap.size(); ++i)
    {
        double mostM2 = kLeastWithin * scenery::areaOf(partsOfMap[i].rings);
        const auto look = [&](std::size_t whole)
        {
            const double commonM2 = commonAreaOf(wholes[whole].rings, partsOfMap[i].rings);
            if (commonM2 > mostM2) mostM2 = commonM2, ofWhole[i] = whole;
        };
        grid.near(boxOf(partsOfMap[i].rings.front()), look);
        if (ofWhole[i]) wholes[*ofWhole[i]].parts.push_back(i);
    }
    std::vector<HouseShape> shapes;
    for (const Outlined& whole : wholes)
    {
        if (whole.parts.empty())
        {
            shapes.push_back({*whole.shape});
            continue;
        }
        std::vector<BuiltPart> built;
        for (const std::size_t part : whole.parts)
            built.push_back(builtPart(partsOfMap[part], whole.shape));
        const auto leftM = leftHeightM(builtPart(whole, nullptr), built);
        for (LandShape& left : leftOf(whole, partsOfMap, plane))
        {
            if (leftM && *leftM <= 0.0) continue;
            if (leftM) left.tags.insert_or_assign("height", std::to_string(*leftM));
            shapes.push_back({std::move(left), whole.shape->id});
        }
        for (HouseShape& part : partsOf(std::move(built), whole.shape->id, plane))
            shapes.push_back(std::move(part));
    }
    for (std::size_t i = 0; i < partsOfMap.size(); ++i)
        if (!ofWhole[i]) shapes.push_back({builtPart(partsOfMap[i], nullptr).shape});
    return shapes;
}

} // namespace worldmaking
