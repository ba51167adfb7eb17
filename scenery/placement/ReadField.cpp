// SPDX-License-Identifier: Apache-2.0
#include "scenery/placement/ReadField.h"

#include <array>

#include "scenery/placement/ReadObjects.h"
#include "scenery/placement/ReadSelection.h"
#include "scenery/placement/ReadWhere.h"

namespace scenery
{

namespace
{

using nlohmann::json;

constexpr std::array kArrangements{"settlement", "parked", "rows", "scattered"};

void readLayouts(JsonFields& parent, SceneryField& field)
{
    if (const json* const found = parent.find("rows"))
    {
        JsonFields fields(*found, parent.at("rows"), parent.complaint());
        fields.number("spacingM", field.rows.spacingM, 0.5, 1000.0);
        fields.number("betweenM", field.rows.betweenM, 0.5, 1000.0);
        fields.number("lengthM", field.rows.lengthM, 1.0, 1e4);
        fields.whole("rows", field.rows.rows, 1.0, 100.0);
    }
    if (const json* const found = parent.find("settlement"))
    {
        JsonFields fields(*found, parent.at("settlement"), parent.complaint());
        fields.whole("settlements", field.settlement.settlements, 1.0, 1000.0);
        fields.whole("sideStreets", field.settlement.sideStreets, 0.0, 100.0);
        fields.number("streetM", field.settlement.streetM, 10.0, 1e4);
        fields.number("plotM", field.settlement.plotM, 5.0, 1000.0);
        fields.number("setbackM", field.settlement.setbackM, 0.5, 1000.0);
        fields.number("widthM", field.settlement.widthM, 2.0, 100.0);
    }
}

} // namespace

SceneryField readField(const json& object, const std::string& pointer, const std::filesystem::path& folder,
                       Complaint& complaint)
{
    SceneryField field;
    JsonFields fields(object, pointer, complaint);
    if (!fields.text("name", field.name) || field.name.empty())
        complaint.say(pointer + "/name", "is missing or empty", "give the field a name");
    fields.choice("arrangement", field.arrangement, kArrangements);
    readObjects(fields, folder, field.objects);
    const bool hasCount = fields.whole("count", field.count, 1.0, 1e7);
    const bool hasDensity = fields.number("densityPerKm2", field.densityPerKm2, 1e-6, 1e7);
    const bool isCounted = field.arrangement != Arrangement::settlement;
    if (isCounted && hasCount == hasDensity)
        complaint.say(pointer + "/count", "either count or densityPerKm2 has to be there", "give one");
    readWhere(fields, field.where);
    readLayouts(fields, field);
    fields.text("beside", field.beside);
    fields.number("spacingM", field.spacingM, 0.0, 1e4);
    fields.number("crowding", field.crowding, 0.0, 0.8);
    Span scale{1.0, 1.0};
    readSpan(fields, "scale", scale, 0.01, 100.0);
    field.leastScale = scale.least;
    field.mostScale = scale.most;
    readSelection(fields, field.selection);
    readSwitching(fields, field.switching);
    fields.number("importance", field.importance, 0.01, 100.0);
    const Where& where = field.where;
    if (!where.circle && where.polygon.empty() && !where.pathDistanceM)
        complaint.say(pointer + "/where", "does not say where", "give circle, polygonM or pathDistanceM");
    return field;
}

} // namespace scenery
