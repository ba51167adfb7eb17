// SPDX-License-Identifier: Apache-2.0
#include "FeatureTags.h"

#include <array>
#include <string_view>

#include <foundation/SmallLetters.h>
#include <foundation/TagQuantity.h>

namespace osgTerrainROAM::core
{

namespace
{

/// A value of a tag (nullptr: any other value) and its style, with a customary width.
struct Custom
{
    const char* value;
    FeatureStyle style;
};

constexpr auto kAsphalt = Pavement::asphalt;
constexpr auto kGravel = Pavement::gravel;
constexpr auto kEarth = Pavement::earth;

FeatureStyle road(double widthM, int lanes, bool marked, Pavement pavement)
{
    FeatureStyle style;
    style.widthM = widthM;
    style.lanes = lanes;
    style.marked = marked;
    style.pavement = pavement;
    return style;
}

FeatureStyle taxiway(Taxiing taxiing, double widthM)
{
    FeatureStyle style = road(widthM, 2, false, kAsphalt);
    style.taxiing = taxiing;
    return style;
}

FeatureStyle river(double widthM)
{
    FeatureStyle style;
    style.kind = FeatureKind::river;
    style.widthM = widthM;
    return style;
}

FeatureStyle field(Crop crop)
{
    FeatureStyle style;
    style.kind = FeatureKind::field;
    style.crop = crop;
    return style;
}

FeatureStyle runway(double widthM)
{
    FeatureStyle style;
    style.kind = FeatureKind::runway;
    style.widthM = widthM;
    return style;
}

using Table = std::vector<Custom>;

/// In OpenStreetMap each carriageway of a motorway is a way of its own.
const Table& highways()
{
    static const Table table{{"motorway", road(11.5, 2, true, kAsphalt)},
                             {"trunk", road(11.0, 2, true, kAsphalt)},
                             {"primary", road(8.0, 2, true, kAsphalt)},
                             {"secondary", road(7.0, 2, true, kAsphalt)},
                             {"tertiary", road(6.0, 2, true, kAsphalt)},
                             {"motorway_link", road(6.0, 1, true, kAsphalt)},
                             {"trunk_link", road(6.0, 1, true, kAsphalt)},
                             {"primary_link", road(5.5, 1, true, kAsphalt)},
                             {"secondary_link", road(5.5, 1, true, kAsphalt)},
                             {"tertiary_link", road(5.0, 1, false, kAsphalt)},
                             {"unclassified", road(5.0, 2, false, kAsphalt)},
                             {"residential", road(5.5, 2, false, kAsphalt)},
                             {"living_street", road(4.5, 1, false, kAsphalt)},
                             {"pedestrian", road(4.0, 1, false, kAsphalt)},
                             {"road", road(5.0, 2, false, kAsphalt)},
                             {"service", road(3.5, 1, false, kAsphalt)},
                             {"cycleway", road(2.5, 1, false, kAsphalt)},
                             {"track", road(2.8, 1, false, kGravel)},
                             {"bridleway", road(1.5, 1, false, kEarth)},
                             {"footway", road(1.5, 1, false, kEarth)},
                             {"path", road(1.0, 1, false, kEarth)}};
    return table;
}

const Table& waterways()
{
    static const Table table{{"river", river(20.0)}, {"riverbank", river(20.0)}, {"canal", river(12.0)},
                             {"stream", river(2.5)}, {"ditch", river(1.5)},      {"drain", river(1.5)},
                             {"dock", river(20.0)}};
    return table;
}

const Table& landuses()
{
    static const Table table{{"farmland", field(Crop::cereal)},
                             {"meadow", field(Crop::grassland)},
                             {"grass", field(Crop::grassland)},
                             {"orchard", field(Crop::orchard)},
                             {"vineyard", field(Crop::orchard)},
                             {"reservoir", river(20.0)},
                             {"basin", river(20.0)}};
    return table;
}

const Table& aeroways()
{
    static const Table table{{"runway", runway(30.0)},
                             {"taxiway", taxiway(Taxiing::taxiway, 15.0)},
                             {"taxilane", taxiway(Taxiing::taxilane, 8.0)},
                             {"parking_position", taxiway(Taxiing::taxilane, 6.0)},
                             {"apron", road(15.0, 2, false, kAsphalt)}};
    return table;
}

/// Values of `kind` beyond those of the tables above.
const Table& kinds()
{
    static const Table table{{"road", road(7.0, 2, true, kAsphalt)},
                             {"river", river(20.0)},
                             {"water", river(20.0)},
                             {"lake", river(20.0)},
                             {"field", field(Crop::cereal)},
                             {"runway", runway(30.0)}};
    return table;
}

const Table& crops()
{
    static const Table table{{"wheat", field(Crop::cereal)},     {"barley", field(Crop::cereal)},
                             {"rye", field(Crop::cereal)},       {"oat", field(Crop::cereal)},
                             {"cereal", field(Crop::cereal)},    {"maize", field(Crop::rowCrop)},
                             {"corn", field(Crop::rowCrop)},     {"sugar_beet", field(Crop::rowCrop)},
                             {"potato", field(Crop::rowCrop)},   {"rapeseed", field(Crop::rowCrop)},
                             {"row_crop", field(Crop::rowCrop)}, {"grass", field(Crop::grassland)},
                             {"hay", field(Crop::grassland)},    {"grassland", field(Crop::grassland)},
                             {"grape", field(Crop::orchard)},    {"orchard", field(Crop::orchard)}};
    return table;
}

std::optional<FeatureStyle> found(const Table& table, const std::string& value)
{
    for (const Custom& custom : table)
        if (value == custom.value) return custom.style;
    return std::nullopt;
}

std::optional<FeatureStyle> styleOfLayer(const std::string& layer)
{
    static constexpr std::array<std::pair<const char*, const char*>, 12> kWords{{{"runway", "runway"},
                                                                                 {"road", "road"},
                                                                                 {"street", "road"},
                                                                                 {"highway", "road"},
                                                                                 {"river", "river"},
                                                                                 {"water", "river"},
                                                                                 {"stream", "river"},
                                                                                 {"lake", "river"},
                                                                                 {"field", "field"},
                                                                                 {"crop", "field"},
                                                                                 {"farm", "field"},
                                                                                 {"meadow", "field"}}};
    for (const auto& [word, kind] : kWords)
        if (layer.find(word) != std::string::npos) return found(kinds(), kind);
    return std::nullopt;
}

std::optional<FeatureStyle> styleOfKind(const std::string& kind)
{
    for (const Table* table : {&kinds(), &highways(), &waterways(), &landuses(), &aeroways(), &crops()})
        if (const auto style = found(*table, kind)) return style;
    return std::nullopt;
}

std::optional<FeatureStyle> styleOfTags(const TagLookup& tag)
{
    if (const std::string value = foundation::inSmallLetters(tag("aeroway")); !value.empty())
        return found(aeroways(), value);
    if (const std::string value = foundation::inSmallLetters(tag("highway")); !value.empty())
        return found(highways(), value);
    if (const std::string value = foundation::inSmallLetters(tag("waterway")); !value.empty())
        return found(waterways(), value);
    if (foundation::inSmallLetters(tag("natural")) == "water") return river(20.0);
    if (const std::string value = foundation::inSmallLetters(tag("landuse")); !value.empty())
        return found(landuses(), value);
    return std::nullopt;
}

bool hasAnyTag(const TagLookup& tag)
{
    return unknownName(tag) != "(no tags)";
}

Pavement pavementOf(const std::string& surface, Pavement custom)
{
    for (const char* word : {"gravel", "compacted", "pebblestone", "fine_gravel", "unpaved"})
        if (surface == word) return kGravel;
    for (const char* word : {"ground", "dirt", "earth", "grass", "mud", "sand"})
        if (surface == word) return kEarth;
    for (const char* word : {"asphalt", "paved", "concrete", "paving_stones", "sett"})
        if (surface == word) return kAsphalt;
    return custom;
}

void applyDetails(FeatureStyle& style, const TagLookup& tag)
{
    if (const auto lanes = foundation::numberOfTag(tag("lanes")); lanes && *lanes >= 1.0 && *lanes <= 12.0)
    {
        const int count = static_cast<int>(*lanes);
        if (style.kind == FeatureKind::road && count != style.lanes)
            style.widthM *= static_cast<double>(count) / style.lanes;
        style.lanes = count;
    }
    if (const auto width = metresIn(tag("width"))) style.widthM = *width;
    style.pavement = pavementOf(foundation::inSmallLetters(tag("surface")), style.pavement);
    if (style.pavement != kAsphalt) style.marked = false;
    const std::string marked = foundation::inSmallLetters(tag("lane_markings"));
    if (!marked.empty()) style.marked = marked != "no";
    for (const char* name : {"kind", "crop"})
        if (const auto crop = found(crops(), foundation::inSmallLetters(tag(name))))
        {
            style.crop = crop->crop;
            style.isCropKnown = true;
        }
    if (style.kind == FeatureKind::runway) style.designator = tag("ref");
}

} // namespace

std::optional<double> metresIn(const std::string& text)
{
    const auto number = foundation::metresOfTag(text);
    return number && *number >= 0.1 && *number <= 5000.0 ? number : std::nullopt;
}

std::string hstoreValue(const std::string& text, const std::string& key)
{
    const std::string wanted = "\"" + key + "\"=>\"";
    const std::size_t at = text.find(wanted);
    if (at == std::string::npos) return {};
    const std::size_t begin = at + wanted.size();
    const std::size_t end = text.find('"', begin);
    return end == std::string::npos ? std::string() : text.substr(begin, end - begin);
}

std::string unknownName(const TagLookup& tag)
{
    for (const char* name :
         {"kind", "fclass", "aeroway", "highway", "waterway", "natural", "landuse", "railway", "building"})
        if (const std::string value = tag(name); !value.empty()) return std::string(name) + "=" + value;
    return "(no tags)";
}

std::optional<FeatureStyle> featureStyle(const TagLookup& tag, const std::string& layer)
{
    // "fclass" is the attribute's name in Geofabrik's extracts of OpenStreetMap.
    const std::string kind = foundation::inSmallLetters(tag("kind").empty() ? tag("fclass") : tag("kind"));
    std::optional<FeatureStyle> style = kind.empty() ? styleOfTags(tag) : styleOfKind(kind);
    // A tag of another meaning is stronger than the name of the layer.
    if (!style && !hasAnyTag(tag)) style = styleOfLayer(foundation::inSmallLetters(layer));
    if (style) applyDetails(*style, tag);
    return style;
}

} // namespace osgTerrainROAM::core
