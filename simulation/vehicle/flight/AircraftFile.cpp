// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/flight/AircraftFile.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include <glm/geometric.hpp>

#include "simulation/vehicle/HullFile.h"
#include "simulation/vehicle/VehicleFileReader.h"
#include "simulation/vehicle/flight/AircraftHull.h"
#include "simulation/vehicle/flight/FlightModel.h"

namespace simulation
{

namespace
{

constexpr std::size_t kMostBytes = 4U << 20U;
constexpr double kMost = 1e9;
constexpr std::size_t kMostHullBoxes = 12;
constexpr double kWidestHullM = 100.0;

void readBody(VehicleFileReader& reader, pugi::xml_node root, AircraftData& data)
{
    const pugi::xml_node geometry = reader.child(root, "geometry");
    reader.onlyAttributes(geometry, "wingAreaM2 wingSpanM meanChordM");
    data.wingAreaM2 = reader.number(geometry, "wingAreaM2", 0.1, 2000.0);
    data.wingSpanM = reader.number(geometry, "wingSpanM", 0.5, 200.0);
    data.meanChordM = reader.number(geometry, "meanChordM", 0.05, 50.0);
    const pugi::xml_node point = reader.child(root, "aerodynamicPoint");
    reader.onlyAttributes(point, "xM yM zM");
    data.aerodynamicPoint = reader.place(point);
    const pugi::xml_node empty = reader.child(root, "empty");
    reader.onlyAttributes(empty, "massKg xM yM zM rollKgM2 pitchKgM2 yawKgM2 rollYawKgM2");
    data.empty = {"empty", reader.number(empty, "massKg", 1.0, 1e6), reader.place(empty)};
    const double product = reader.number(empty, "rollYawKgM2", -kMost, kMost);
    data.emptyInertia = glm::dmat3(0.0);
    data.emptyInertia[0][0] = reader.number(empty, "rollKgM2", 0.01, kMost);
    data.emptyInertia[1][1] = reader.number(empty, "pitchKgM2", 0.01, kMost);
    data.emptyInertia[2][2] = reader.number(empty, "yawKgM2", 0.01, kMost);
    data.emptyInertia[0][2] = data.emptyInertia[2][0] = -product;
    if (product * product >= data.emptyInertia[0][0] * data.emptyInertia[2][2])
        reader.fail(empty, "no body has this rollYawKgM2", "correct the moments and the product of inertia");
    for (const pugi::xml_node load : root.children("load"))
    {
        reader.onlyAttributes(load, "massKg xM yM zM");
        data.loads.push_back(
            {reader.name(load), reader.number(load, "massKg", 0.0, 1e6), reader.place(load)});
    }
    for (const pugi::xml_node tank : root.children("tank"))
    {
        reader.onlyAttributes(tank, "capacityKg contentsKg xM yM zM");
        const double capacity = reader.number(tank, "capacityKg", 0.0, 1e6);
        data.tanks.push_back({reader.name(tank), capacity, reader.number(tank, "contentsKg", 0.0, capacity),
                              reader.place(tank)});
    }
    if (data.tanks.size() > kMostTanks)
        reader.fail(root, "has more than " + std::to_string(kMostTanks) + " tanks", "join some");
}

SurfaceTravel readTravel(VehicleFileReader& reader, pugi::xml_node root, const char* name)
{
    const pugi::xml_node node = reader.child(root, name);
    reader.onlyAttributes(node, "negativeDeg positiveDeg");
    return {reader.number(node, "negativeDeg", -90.0, 0.0), reader.number(node, "positiveDeg", 0.0, 90.0)};
}

void readControls(VehicleFileReader& reader, pugi::xml_node root, AircraftData& data)
{
    data.elevator = readTravel(reader, root, "elevator");
    data.aileron = readTravel(reader, root, "aileron");
    data.rudder = readTravel(reader, root, "rudder");
    const pugi::xml_node flaps = reader.child(root, "flaps");
    reader.onlyAttributes(flaps, "fullDeg rateDegPerS");
    data.flaps = {reader.number(flaps, "fullDeg", 0.0, 90.0),
                  reader.number(flaps, "rateDegPerS", 0.01, 1000.0)};
    const pugi::xml_node stall = reader.child(root, "stall");
    reader.onlyAttributes(stall, "beginsDeg endsDeg plateNormal plateSide platePitch");
    data.stall = {reader.number(stall, "beginsDeg", 1.0, 90.0), reader.number(stall, "endsDeg", -90.0, 90.0),
                  reader.number(stall, "plateNormal", 0.0, 5.0), reader.number(stall, "plateSide", 0.0, 5.0),
                  reader.number(stall, "platePitch", 0.0, 5.0)};
}

void readEngine(VehicleFileReader& reader, pugi::xml_node root, EngineData& engine)
{
    const pugi::xml_node node = reader.child(root, "engine");
    reader.onlyAttributes(
        node, "displacementM3 volumetricEfficiency residualShare intakeLossS throttleLossS idleOpening "
              "manifoldLagS fullRichness heatingValueJPerKg frictionNm frictionNmS pumpingNmPerPa "
              "starterNm stopRadps");
    engine.displacementM3 = reader.number(node, "displacementM3", 1e-6, 1.0);
    engine.volumetricEfficiency = reader.number(node, "volumetricEfficiency", 0.01, 3.0);
    engine.residualShare = reader.number(node, "residualShare", 0.0, 0.9);
    engine.intakeLoss = reader.number(node, "intakeLossS", 0.0, 10.0);
    engine.throttleLoss = reader.number(node, "throttleLossS", 0.0, 1000.0);
    engine.idleOpening = reader.number(node, "idleOpening", 0.0, 1.0);
    engine.manifoldLagS = reader.number(node, "manifoldLagS", 0.001, 60.0);
    engine.fullRichness = reader.number(node, "fullRichness", 0.1, 5.0);
    engine.heatingValueJPerKg = reader.number(node, "heatingValueJPerKg", 1e6, 2e8);
    engine.frictionNm = reader.number(node, "frictionNm", 0.0, 1e4);
    engine.frictionNms = reader.number(node, "frictionNmS", 0.0, 100.0);
    engine.pumpingNmPerPa = reader.number(node, "pumpingNmPerPa", 0.0, 1.0);
    engine.starterNm = reader.number(node, "starterNm", 0.0, 1e4);
    engine.stopRadps = reader.number(node, "stopRadps", 0.1, 1000.0);
    engine.efficiency = reader.table(reader.child(node, "efficiency"), false);
}

void readPropeller(VehicleFileReader& reader, pugi::xml_node root, PropellerData& propeller)
{
    const pugi::xml_node node = reader.child(root, "propeller");
    reader.onlyAttributes(node, "diameterM inertiaKgM2 turnsRight discShiftMPerRad xM yM zM");
    propeller.diameterM = reader.number(node, "diameterM", 0.1, 20.0);
    propeller.inertiaKgM2 = reader.number(node, "inertiaKgM2", 0.001, 1e5);
    propeller.turnsRight = reader.number(node, "turnsRight", -1.0, 1.0);
    if (propeller.turnsRight != 1.0 && propeller.turnsRight != -1.0)
        reader.fail(node, "turnsRight is neither 1 nor -1",
                    "give 1 for a propeller that turns right seen from behind");
    propeller.discShiftMPerRad = reader.number(node, "discShiftMPerRad", 0.0, 10.0);
    propeller.place = reader.place(node);
    propeller.thrust = reader.table(reader.child(node, "thrust"), false);
    propeller.power = reader.table(reader.child(node, "power"), false);
}

void readContact(VehicleFileReader& reader, pugi::xml_node node, bool isWheel, AircraftData& data)
{
    reader.onlyAttributes(
        node, isWheel ? "xM yM zM radiusM springNPerM dampingNsPerM friction corneringPerRad steeringDeg "
                        "brake breaksAtMps"
                      : "xM yM zM springNPerM dampingNsPerM friction breaksAtMps");
    ContactData contact;
    contact.name = reader.name(node);
    contact.isWheel = isWheel;
    contact.place = reader.place(node);
    contact.springNPerM = reader.number(node, "springNPerM", 1.0, kMost);
    contact.dampingNsPerM = reader.number(node, "dampingNsPerM", 0.0, kMost);
    contact.friction = reader.number(node, "friction", 0.0, 5.0);
    contact.strongestMps = reader.number(node, "breaksAtMps", 0.0, 1000.0);
    if (isWheel)
    {
        contact.radiusM = reader.number(node, "radiusM", 0.01, 5.0);
        if (node.attribute("corneringPerRad"))
            contact.corneringPerRad = reader.number(node, "corneringPerRad", 0.5, 100.0);
        contact.steeringDeg = reader.number(node, "steeringDeg", -90.0, 90.0);
        const std::string_view brake = node.attribute("brake").value();
        contact.brake = brake == "left" ? Brake::left : brake == "right" ? Brake::right : Brake::none;
        if (contact.brake == Brake::none && brake != "none")
            reader.fail(node, "brake is '" + std::string(brake) + "'", "give left, right or none");
    }
    data.contacts.push_back(std::move(contact));
}

/// A file without a hull gets one of its measures.
void readAircraftHull(VehicleFileReader& reader, pugi::xml_node root, AircraftData& data)
{
    const pugi::xml_node node = root.child("hull");
    data.hull = node ? readHull(reader, node, kMostHullBoxes, kWidestHullM) : hullOfMeasures(data);
    if (!node) return;
    for (HullBox& box : data.hull.boxes)
        box.place = hullPlace(box.place);
}

/// An aircraft's centre of mass is nearer to what it stands on than its span. One in inches or millimetres is
/// not.
void checkCentre(VehicleFileReader& reader, pugi::xml_node root, const AircraftData& data)
{
    if (data.contacts.empty()) return;
    double nearestM = 1e9;
    for (const ContactData& contact : data.contacts)
        nearestM = std::min(nearestM, glm::distance(contact.place, data.empty.place));
    if (nearestM <= std::max(data.wingSpanM, 2.0)) return;
    std::ostringstream what;
    what.precision(3);
    what << "the centre of mass of <empty> lies " << nearestM
         << " m from the nearest wheel or skid, and the wings span " << data.wingSpanM << " m";
    reader.fail(root.child("empty"), what.str(), "give xM, yM and zM in metres (1 inch is 0.0254 m)");
}

/// The place of a name in a list of names, or the list's length.
template<std::size_t N>
std::size_t indexOf(const std::array<std::string_view, N>& names, std::string_view name)
{
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

Argument readArgument(VehicleFileReader& reader, pugi::xml_node node, const char* attribute)
{
    const pugi::xml_attribute found = node.attribute(attribute);
    if (!found) return Argument::none;
    const std::size_t index = indexOf(kArgumentNames, found.value());
    if (index < kArgumentNames.size()) return static_cast<Argument>(index);
    reader.fail(node, std::string(attribute) + " is '" + found.value() + "'",
                "give alphaDeg, betaDeg, flapDeg, stalled or heightOverSpan");
    return Argument::none;
}

void readCoefficients(VehicleFileReader& reader, pugi::xml_node root, AircraftData& data)
{
    std::array<bool, kPartNames.size()> isGiven{};
    for (const Part factor : {Part::liftGround, Part::dragGround})
        data.coefficients[static_cast<std::size_t>(factor)].table = Table(1.0);
    for (const pugi::xml_node node : root.children("coefficient"))
    {
        reader.onlyAttributes(node, "part over across");
        const std::string_view part = node.attribute("part").value();
        const std::size_t index = indexOf(kPartNames, part);
        if (index == kPartNames.size())
        {
            reader.fail(node, "the part '" + std::string(part) + "' is unknown",
                        "docs/reference/aircraft-file.md lists all parts");
            return;
        }
        if (std::exchange(isGiven[index], true))
            reader.fail(node, "the part '" + std::string(part) + "' is given twice", "keep one");
        CoefficientTable& coefficient = data.coefficients[index];
        coefficient.row = readArgument(reader, node, "over");
        coefficient.column = readArgument(reader, node, "across");
        coefficient.table = reader.table(node, coefficient.column != Argument::none);
    }
    for (const Part needed : {Part::lift, Part::drag, Part::pitchAlpha, Part::pitchElevator})
        if (!isGiven[static_cast<std::size_t>(needed)])
            reader.fail(root,
                        "has no coefficient '" + std::string(kPartNames[static_cast<std::size_t>(needed)]) +
                            "'",
                        "add it: without it nothing flies");
}

foundation::Result<AircraftData> readSource(const foundation::XmlSource& source)
{
    VehicleFileReader reader(source, "docs/reference/aircraft-file.md");
    const pugi::xml_node root = source.root();
    AircraftData data;
    if (std::string_view(root.name()) != "aircraft" ||
        std::string_view(root.attribute("version").value()) != "1")
        reader.fail(root, "is no <aircraft version=\"1\">", "give an aircraft's data file of this version");
    data.name = reader.name(root);
    if (!reader.error())
        reader.onlyElements(root, "geometry aerodynamicPoint empty load tank elevator aileron rudder flaps "
                                  "stall engine propeller wheel skid hull coefficient");
    if (!reader.error()) readBody(reader, root, data);
    if (!reader.error()) readControls(reader, root, data);
    if (!reader.error()) readEngine(reader, root, data.engine);
    if (!reader.error()) readPropeller(reader, root, data.propeller);
    for (const pugi::xml_node node : root.children("wheel"))
        readContact(reader, node, true, data);
    for (const pugi::xml_node node : root.children("skid"))
        readContact(reader, node, false, data);
    if (!reader.error()) readAircraftHull(reader, root, data);
    if (!reader.error()) checkCentre(reader, root, data);
    if (!reader.error()) readCoefficients(reader, root, data);
    if (reader.error()) return *reader.error();
    return data;
}

} // namespace

foundation::Result<AircraftData> readAircraft(const std::filesystem::path& file)
{
    const auto source = foundation::XmlSource::read(file, kMostBytes);
    return source ? readSource(**source) : source.error();
}

foundation::Result<AircraftData> parseAircraft(std::string_view text, const std::string& name)
{
    const auto source = foundation::XmlSource::parse(text, name);
    return source ? readSource(**source) : source.error();
}

} // namespace simulation
