// SPDX-License-Identifier: Apache-2.0
#include "simulation/parser/ElementParsers.h"

namespace simulation
{
namespace
{

TimeOfDay parseTimeOfDay(ElementReader reader)
{
    return {parseInstant(reader), reader.flagOr("animation", false)};
}

Sun parseSun(ElementReader reader)
{
    return {reader.number("azimuth"), reader.number("elevation"), reader.optionalNumber("intensity"),
            reader.optionalNumber("illuminance")};
}

/// From version 1.1 on millimetres an hour; before, a share of the most, for which heavy rain is taken.
Precipitation parsePrecipitation(ElementReader reader)
{
    constexpr double kMostMmPerHour = 20.0;
    Precipitation precipitation{reader.text("precipitationType"),
                                reader.optionalNumber("precipitationIntensity")};
    const auto share = reader.optionalNumber("intensity");
    if (!precipitation.intensity && share) precipitation.intensity = *share * kMostMmPerHour;
    return precipitation;
}

double parseFog(ElementReader reader)
{
    reader.allowChildren({});
    const double range = reader.notNegative("visualRange");
    if (range == 0.0) reader.context.invalid(reader.node, "Fog/visualRange is 0", "write a range in metres");
    return range;
}

Weather parseWeather(ElementReader reader)
{
    reader.allowChildren({"Sun", "Fog", "Precipitation", "Wind"});
    ParseContext& context = reader.context;
    Weather weather;
    weather.cloudState = reader.textOr("fractionalCloudCover", reader.textOr("cloudState", ""));
    weather.temperatureK = reader.optionalNumber("temperature");
    weather.pressurePa = reader.optionalNumber("atmosphericPressure");
    if (const pugi::xml_node node = reader.node.child("Sun")) weather.sun = parseSun({context, node});
    if (const pugi::xml_node node = reader.node.child("Fog"))
        weather.fogVisualRangeM = parseFog({context, node});
    if (const pugi::xml_node node = reader.node.child("Precipitation"))
        weather.precipitation = parsePrecipitation({context, node});
    if (const pugi::xml_node node = reader.node.child("Wind"))
    {
        ElementReader wind(context, node);
        weather.wind = Wind{wind.number("direction"), wind.notNegative("speed")};
    }
    return weather;
}

} // namespace

DateTime parseInstant(ElementReader& reader)
{
    const std::string text = reader.text("dateTime");
    if (const std::optional<DateTime> dateTime = parseDateTime(text)) return *dateTime;
    if (reader.has("dateTime"))
        reader.context.invalid(reader.node,
                               std::string(reader.node.name()) + "/dateTime is not a date and time: \"" +
                                   text.substr(0, 40) + "\"",
                               "write it as 2025-06-13T06:00:00Z");
    return {};
}

constexpr Keywords<std::string_view, 5> kWetness{{{"dry", "dry"},
                                                  {"moist", "moist"},
                                                  {"wetWithPuddles", "wetWithPuddles"},
                                                  {"lowFlooded", "lowFlooded"},
                                                  {"highFlooded", "highFlooded"}}};

namespace
{

/// What lies on the ground, by the property "ground".
std::optional<SurfaceWeather> parseGround(ElementReader& road)
{
    std::optional<SurfaceWeather> ground;
    for (const auto& [name, value] : parseProperties(road).values)
    {
        if (name != "ground") continue;
        const auto read = readSurfaceWeather(value, "RoadCondition");
        if (read)
            ground = *read;
        else
            road.context.invalid(road.node, "RoadCondition/ground: " + read.error().what,
                                 read.error().remedy);
    }
    return ground;
}

} // namespace

Environment parseEnvironment(ElementReader reader)
{
    reader.allowChildren({"ParameterDeclarations", "TimeOfDay", "Weather", "RoadCondition"});
    ParseContext& context = reader.context;
    const ParameterScope scope(context, reader.node);
    Environment environment;
    environment.source = context.line(reader.node);
    environment.name = reader.name();
    if (const pugi::xml_node node = reader.node.child("TimeOfDay"))
        environment.timeOfDay = parseTimeOfDay({context, node});
    if (const pugi::xml_node node = reader.node.child("Weather"))
        environment.weather = parseWeather({context, node});
    if (const pugi::xml_node node = reader.node.child("RoadCondition"))
    {
        ElementReader road(context, node);
        environment.roadFriction = road.notNegative("frictionScaleFactor");
        environment.roadWetness = road.choiceOr("wetness", kWetness, std::string_view());
        environment.ground = parseGround(road);
    }
    return environment;
}

} // namespace simulation
