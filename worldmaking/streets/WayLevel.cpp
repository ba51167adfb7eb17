// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/streets/WayLevel.h"

#include <charconv>
#include <optional>
#include <string_view>

namespace worldmaking
{

namespace
{

constexpr int kMostLayer = 20; ///< farther ones are slips

StreetPlace placeOf(const Tags& tags)
{
    const std::string_view bridge = valueOf(tags, "bridge"), tunnel = valueOf(tags, "tunnel");
    const bool isOnGround = tunnel.empty() || tunnel == "no" || tunnel == "building_passage" ||
                            tunnel == "avalanche_protector" || tunnel == "covered";
    if (!isOnGround) return StreetPlace::tunnel;
    if (!bridge.empty() && bridge != "no") return StreetPlace::bridge;
    return StreetPlace::ground;
}

std::optional<int> layerOf(const Tags& tags)
{
    std::string_view text = valueOf(tags, "layer");
    if (text.starts_with('+')) text.remove_prefix(1);
    int layer = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), layer);
    if (read.ec != std::errc() || layer < -kMostLayer || layer > kMostLayer) return std::nullopt;
    return layer;
}

int rankOf(StreetPlace place)
{
    return place == StreetPlace::bridge ? 1 : place == StreetPlace::tunnel ? -1 : 0;
}

} // namespace

WayLevel levelOf(const Tags& tags)
{
    const StreetPlace place = placeOf(tags);
    return {place, layerOf(tags).value_or(rankOf(place))};
}

int aboveOf(const WayLevel& a, const WayLevel& b)
{
    if (a.layer != b.layer) return a.layer > b.layer ? 1 : -1;
    const int above = rankOf(a.place) - rankOf(b.place);
    return above > 0 ? 1 : above < 0 ? -1 : 0;
}

} // namespace worldmaking
