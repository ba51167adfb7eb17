// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/map/WaterTags.h"

#include <foundation/TagQuantity.h>

namespace worldmaking
{

namespace
{

constexpr double kRiverM = 10.0, kCanalM = 8.0; ///< customary widths

} // namespace

bool isRiverArea(const Tags& tags)
{
    const auto water = valueOf(tags, "water");
    return valueOf(tags, "waterway") == "riverbank" || water == "river" || water == "canal" ||
           water == "stream";
}

std::optional<double> riverWidthM(const LandShape& shape)
{
    const auto way = valueOf(shape.tags, "waterway"), tunnel = valueOf(shape.tags, "tunnel");
    if (shape.form != ShapeForm::line || (way != "river" && way != "canal")) return std::nullopt;
    if ((!tunnel.empty() && tunnel != "no") || valueOf(shape.tags, "location") == "underground")
        return std::nullopt;
    const double told = foundation::metresOfTag(valueOf(shape.tags, "width")).value_or(0.0);
    return told >= 1.0 && told <= 500.0 ? told : way == "river" ? kRiverM : kCanalM;
}

} // namespace worldmaking
