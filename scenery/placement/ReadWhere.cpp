// SPDX-License-Identifier: Apache-2.0
#include "scenery/placement/ReadWhere.h"

namespace scenery
{

namespace
{

using nlohmann::json;

/// Farther than anything in a description lies or reaches.
constexpr double kFarM = 1e8;

void readCircle(JsonFields& parent, std::optional<Circle>& circle)
{
    const json* const found = parent.find("circle");
    if (!found) return;
    JsonFields fields(*found, parent.at("circle"), parent.complaint());
    circle.emplace();
    fields.number("eastM", circle->centreM.x, -kFarM, kFarM);
    fields.number("northM", circle->centreM.y, -kFarM, kFarM);
    if (!fields.number("radiusM", circle->radiusM, 1.0, kFarM))
        fields.complaint().say(fields.at("radiusM"), "is missing", "give metres");
}

void readPolygon(JsonFields& parent, std::vector<glm::dvec2>& polygon)
{
    std::vector<double> numbers;
    if (!parent.numbers("polygonM", numbers, -kFarM, kFarM)) return;
    if (numbers.size() < 6 || numbers.size() % 2 != 0)
        return parent.complaint().say(parent.at("polygonM"), "is no polygon",
                                      "write [east, north, east, north, east, north …]");
    for (std::size_t i = 0; i < numbers.size(); i += 2)
        polygon.emplace_back(numbers[i], numbers[i + 1]);
}

} // namespace

void readSpan(JsonFields& parent, const char* name, Span& span, double least, double most)
{
    std::vector<double> ends;
    if (!parent.numbers(name, ends, least, most)) return;
    if (ends.size() != 2 || !(ends[0] <= ends[1]))
        return parent.complaint().say(parent.at(name), "is no range", "write [least, most]");
    span = {ends[0], ends[1]};
}

void readWhere(JsonFields& parent, Where& where)
{
    const json* const found = parent.find("where");
    if (!found) return;
    JsonFields fields(*found, parent.at("where"), parent.complaint());
    readCircle(fields, where.circle);
    readPolygon(fields, where.polygon);
    Span path;
    readSpan(fields, "pathDistanceM", path, 0.0, kFarM);
    if (path.least >= 0.0) where.pathDistanceM = path;
    readSpan(fields, "heightM", where.heightM, -kFarM, kFarM);
    readSpan(fields, "slopeDeg", where.slopeDeg, 0.0, 90.0);
    fields.flag("inWater", where.inWater);
    fields.number("patchM", where.patchM, 1.0, kFarM);
    fields.number("patchShare", where.patchShare, 0.0, 1.0);
    const json* const covers = fields.list("covers");
    for (std::size_t i = 0; covers && i < covers->size(); ++i)
        if ((*covers)[i].is_string())
            where.covers.push_back((*covers)[i].get<std::string>());
        else
            fields.complaint().say(fields.at("covers"), "has something that is no text", "write names");
}

} // namespace scenery
