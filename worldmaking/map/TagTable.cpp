// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/map/TagTable.h"

#include <algorithm>
#include <array>

#include <foundation/TagQuantity.h>

#include "worldmaking/map/SpeedTags.h"

namespace worldmaking
{

namespace
{

constexpr auto kRead = TagUse::read, kAbout = TagUse::approximated, kIgnored = TagUse::ignored;

constexpr std::array kTags = std::to_array<KnownTag>({
    // streets: what they are
    {"highway", kRead},
    {"proposed", kRead},
    {"abandoned", kRead},
    {"disused", kRead},
    {"construction", kIgnored},
    {"access", kRead},
    {"vehicle", kRead},
    {"motor_vehicle", kRead},
    {"motorcar", kRead},
    {"bus", kAbout},
    {"area", kRead},
    {"smoothness", kAbout},
    {"surface", kAbout},
    {"name", kRead},
    {"ref", kRead},
    {"bridge", kRead},
    {"tunnel", kRead},
    {"layer", kRead},
    {"junction", kRead},
    {"restriction", kAbout},
    {"sidewalk", kRead},
    {"step_count", kAbout, TagValue::number},
    {"lit", kRead},
    {"traffic_signals", kRead},
    {"traffic_signals:direction", kRead},
    {"crossing", kRead},
    {"crossing:signals", kRead},
    {"direction", kRead},
    {"stop", kIgnored},
    {"traffic_calming", kIgnored},
    {"maxheight", kIgnored},
    {"maxweight", kIgnored},
    {"ele", kIgnored},
    {"incline", kIgnored},
    // streets: lanes
    {"oneway", kRead},
    {"oneway:vehicle", kRead},
    {"oneway:motor_vehicle", kRead},
    {"oneway:motorcar", kRead},
    {"oneway:bus", kAbout},
    {"oneway:psv", kAbout},
    {"oneway:bicycle", kIgnored},
    {"busway", kAbout},
    {"cycleway", kRead},
    {"lanes", kRead, TagValue::number},
    {"lanes:forward", kRead, TagValue::number},
    {"lanes:backward", kRead, TagValue::number},
    {"lanes:both_ways", kRead, TagValue::number},
    {"lanes:psv", kAbout, TagValue::number},
    {"lanes:bus", kAbout, TagValue::number},
    {"centre_turn_lane", kRead},
    {"turn:lanes", kAbout},
    {"turn:bus:lanes", kAbout},
    {"bus:lanes", kAbout},
    {"vehicle:lanes", kAbout},
    {"bicycle:lanes", kAbout},
    {"change:lanes", kAbout},
    {"width:lanes", kAbout},
    {"lane_markings", kRead},
    {"width", kRead, TagValue::metres},
    {"width:carriageway", kRead, TagValue::metres},
    {"est_width", kRead, TagValue::metres},
    {"parking:lane", kIgnored},
    {"placement", kIgnored},
    // streets: speeds
    {"maxspeed", kRead, TagValue::speed},
    {"maxspeed:forward", kRead, TagValue::speed},
    {"maxspeed:backward", kRead, TagValue::speed},
    {"maxspeed:type", kAbout},
    {"source:maxspeed", kAbout},
    {"zone:maxspeed", kAbout},
    {"maxspeed:conditional", kIgnored},
    {"maxspeed:lanes", kIgnored},
    {"minspeed", kIgnored},
    // buildings and towers
    {"building", kRead},
    {"height", kRead, TagValue::metres},
    {"building:height", kRead, TagValue::metres},
    {"est_height", kRead, TagValue::metres},
    {"building:levels", kRead, TagValue::number},
    {"roof:height", kRead, TagValue::metres},
    {"roof:levels", kRead, TagValue::number},
    {"roof:shape", kAbout},
    {"roof:orientation", kRead},
    {"roof:colour", kRead},
    {"building:colour", kRead},
    {"building:material", kAbout},
    {"building:part", kRead},
    {"min_height", kRead, TagValue::metres},
    {"building:min_level", kRead, TagValue::number},
    {"roof:direction", kIgnored},
    {"roof:angle", kIgnored},
    {"man_made", kRead},
    {"location", kRead},
    // others
    {"barrier", kRead},
    {"power", kRead},
    {"voltage", kRead, TagValue::number},
    {"railway", kRead},
    {"electrified", kRead},
    {"generator:source", kRead},
    {"height:hub", kRead, TagValue::metres},
    {"aeroway", kRead},
    {"waterway", kRead},
    {"natural", kRead},
    {"landuse", kRead},
    {"leisure", kRead},
    {"amenity", kRead},
    {"place", kRead},
    {"crop", kRead},
});

} // namespace

std::span<const KnownTag> knownTags()
{
    return kTags;
}

bool isReadable(const KnownTag& tag, std::string_view value)
{
    switch (tag.value)
    {
    case TagValue::metres:
        return foundation::metresOfTag(value).has_value();
    case TagValue::number:
        return foundation::numberOfTag(value).has_value();
    case TagValue::speed:
    {
        // Words that tell no number, on purpose.
        constexpr std::array<std::string_view, 4> kWords{"signals", "variable", "implicit", "default"};
        return std::find(kWords.begin(), kWords.end(), value) != kWords.end() || speedKmhOf(value);
    }
    case TagValue::word:
        break;
    }
    return true;
}

} // namespace worldmaking
