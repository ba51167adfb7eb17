// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/road/RoadVehicleFile.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "simulation/vehicle/HullFile.h"
#include "simulation/vehicle/VehicleFileReader.h"

namespace simulation
{

namespace
{

constexpr std::size_t kMostRoadFileBytes = 4U << 20U;
constexpr std::size_t kMostBoxes = 8, kMostGears = 24;
constexpr double kWidestBoxM = 10.0;
constexpr const char* kRoadPage = "docs/reference/road-vehicle-file.md";

void readMasses(VehicleFileReader& reader, pugi::xml_node root, RoadVehicleData& data)
{
    const pugi::xml_node body = reader.child(root, "body");
    reader.onlyAttributes(body, "massKg xM yM zM rollKgM2 pitchKgM2 yawKgM2");
    data.body = {"body",
                 reader.number(body, "massKg", 50.0, 1e5),
                 reader.place(body),
                 {reader.number(body, "rollKgM2", 1.0, 1e7), reader.number(body, "pitchKgM2", 1.0, 1e7),
                  reader.number(body, "yawKgM2", 1.0, 1e7)}};
    for (const pugi::xml_node load : root.children("load"))
    {
        reader.onlyAttributes(load, "massKg xM yM zM");
        data.loads.push_back(
            {reader.name(load), reader.number(load, "massKg", 0.0, 1e5), reader.place(load), {}});
    }
    const pugi::xml_node air = reader.child(root, "air");
    reader.onlyAttributes(air, "dragAreaM2 sideAreaM2");
    data.air = {reader.number(air, "dragAreaM2", 0.0, 100.0), reader.number(air, "sideAreaM2", 0.0, 1000.0)};
}

RoadTyreData readTyre(VehicleFileReader& reader, pugi::xml_node node)
{
    reader.onlyAttributes(node, "radiusM widthM springNPerM dampingNsPerM referenceLoadN frictionAlong "
                                "frictionAcross slidingShare frictionLoss slipStiffness cornerStiffness "
                                "stiffnessLoss relaxationAlongM relaxationAcrossM rollingResistance");
    RoadTyreData tyre;
    tyre.radiusM = reader.number(node, "radiusM", 0.1, 2.0);
    tyre.widthM = reader.number(node, "widthM", 0.02, 2.0);
    tyre.springNPerM = reader.number(node, "springNPerM", 1e4, 5e6);
    tyre.dampingNsPerM = reader.number(node, "dampingNsPerM", 0.0, 5e3);
    tyre.referenceLoadN = reader.number(node, "referenceLoadN", 100.0, 1e5);
    tyre.frictionAlong = reader.number(node, "frictionAlong", 0.05, 3.0);
    tyre.frictionAcross = reader.number(node, "frictionAcross", 0.05, 3.0);
    tyre.slidingShare = reader.number(node, "slidingShare", 0.1, 1.0);
    tyre.frictionLoss = reader.number(node, "frictionLoss", 0.0, 0.5);
    tyre.slipStiffness = reader.number(node, "slipStiffness", 1.0, 60.0);
    tyre.cornerStiffness = reader.number(node, "cornerStiffness", 1.0, 60.0);
    tyre.stiffnessLoss = reader.number(node, "stiffnessLoss", 0.0, 0.5);
    tyre.relaxationAlongM = reader.number(node, "relaxationAlongM", 0.05, 3.0);
    tyre.relaxationAcrossM = reader.number(node, "relaxationAcrossM", 0.05, 3.0);
    tyre.rollingResistance = reader.number(node, "rollingResistance", 0.0, 0.2);
    return tyre;
}

AxleData readAxle(VehicleFileReader& reader, pugi::xml_node node,
                  const std::map<std::string, RoadTyreData>& tyres)
{
    reader.onlyAttributes(node,
                          "tyre xM trackM wheelInertiaKgM2 unsprungKg tyresPerSide springNPerM bumpNsPerM "
                          "reboundNsPerM antiRollNPerM bumpM reboundM stopNPerM rollCentreM steersShare "
                          "driveShare brakeShare handbrakeShare");
    AxleData axle;
    axle.xM = reader.number(node, "xM", 0.0, 20.0);
    axle.trackM = reader.number(node, "trackM", 0.3, 5.0);
    axle.wheelInertiaKgM2 = reader.number(node, "wheelInertiaKgM2", 0.1, 500.0);
    axle.unsprungKg = reader.number(node, "unsprungKg", 5.0, 2000.0);
    axle.tyresPerSide = reader.number(node, "tyresPerSide", 1.0, 2.0) > 1.5 ? 2 : 1;
    axle.springNPerM = reader.number(node, "springNPerM", 1e3, 2e6);
    axle.bumpNsPerM = reader.number(node, "bumpNsPerM", 0.0, 1e5);
    axle.reboundNsPerM = reader.number(node, "reboundNsPerM", 0.0, 1e5);
    axle.antiRollNPerM = reader.number(node, "antiRollNPerM", 0.0, 2e6);
    axle.bumpM = reader.number(node, "bumpM", 0.01, 1.0);
    axle.reboundM = reader.number(node, "reboundM", 0.01, 1.0);
    axle.stopNPerM = reader.number(node, "stopNPerM", 0.0, 5e6);
    axle.rollCentreM = reader.number(node, "rollCentreM", -0.5, 1.5);
    axle.steersShare = reader.number(node, "steersShare", -1.0, 1.0);
    axle.driveShare = reader.number(node, "driveShare", 0.0, 1.0);
    axle.brakeShare = reader.number(node, "brakeShare", 0.0, 1.0);
    axle.handbrakeShare = reader.number(node, "handbrakeShare", 0.0, 1.0);
    const auto tyre = tyres.find(node.attribute("tyre").value());
    if (tyre != tyres.end())
        axle.tyre = tyre->second;
    else
        reader.fail(node, "there is no tyre '" + std::string(node.attribute("tyre").value()) + "'",
                    "name a <tyre> of the file");
    return axle;
}

/// Two axles whose shares add up.
void readAxles(VehicleFileReader& reader, pugi::xml_node root, RoadVehicleData& data)
{
    std::map<std::string, RoadTyreData> tyres;
    for (const pugi::xml_node node : root.children("tyre"))
        if (!tyres.emplace(reader.name(node), readTyre(reader, node)).second)
            reader.fail(node, "there is a second tyre of that name", "name it otherwise");
    std::size_t count = 0;
    for (const pugi::xml_node node : root.children("axle"))
    {
        const AxleData axle = readAxle(reader, node, tyres);
        if (count < data.axles.size()) data.axles[count] = axle;
        ++count;
    }
    if (count != data.axles.size())
        reader.fail(root, "has " + std::to_string(count) + " axles", "give two, the front one first");
    if (reader.error()) return;
    const auto [front, rear] = data.axles;
    if (rear.xM != 0.0 || front.xM < 0.5)
        reader.fail(root,
                    "the axles lie at " + std::to_string(front.xM) + " and " + std::to_string(rear.xM) + " m",
                    "give the rear one xM=\"0\", the front one 0.5 or more");
    for (const auto& [sum, name] : {std::pair(front.driveShare + rear.driveShare, "driveShare"),
                                    std::pair(front.brakeShare + rear.brakeShare, "brakeShare"),
                                    std::pair(front.handbrakeShare + rear.handbrakeShare, "handbrakeShare")})
        if (sum < 0.999 || sum > 1.001)
            reader.fail(root,
                        std::string("the ") + name + " of both axles is " + std::to_string(sum) + " together",
                        "make it 1");
}

void readEngine(VehicleFileReader& reader, pugi::xml_node root, RoadEngineData& engine)
{
    const pugi::xml_node node = reader.child(root, "engine");
    reader.onlyAttributes(node, "inertiaKgM2 idleRpm limitRpm stallRpm lagS");
    engine.inertiaKgM2 = reader.number(node, "inertiaKgM2", 0.02, 50.0);
    engine.idleRpm = reader.number(node, "idleRpm", 200.0, 2000.0);
    engine.limitRpm = reader.number(node, "limitRpm", 1000.0, 20000.0);
    engine.stallRpm = reader.number(node, "stallRpm", 0.0, 1500.0);
    engine.lagS = reader.number(node, "lagS", 0.0, 5.0);
    engine.fullTorqueNm = reader.table(reader.child(node, "fullTorqueNm"), false);
    engine.dragTorqueNm = reader.table(reader.child(node, "dragTorqueNm"), false);
    if (engine.stallRpm >= engine.idleRpm || engine.idleRpm >= engine.limitRpm)
        reader.fail(node, "stallRpm, idleRpm and limitRpm do not rise", "correct them");
}

void readConverter(VehicleFileReader& reader, pugi::xml_node box, ConverterData& converter)
{
    const pugi::xml_node node = reader.child(box, "converter");
    reader.onlyAttributes(node, "lockupNm lockupFromGear lockupRatio");
    converter.lockupNm = reader.number(node, "lockupNm", 0.0, 1e5);
    converter.lockupFromGear = reader.number(node, "lockupFromGear", 1.0, 24.0);
    converter.lockupRatio = reader.number(node, "lockupRatio", 0.5, 1.0);
    converter.torqueFactor = reader.table(reader.child(node, "torqueFactor"), false);
    converter.torqueRatio = reader.table(reader.child(node, "torqueRatio"), false);
}

void readGearbox(VehicleFileReader& reader, pugi::xml_node root, GearboxData& box)
{
    const pugi::xml_node node = reader.child(root, "gearbox");
    const std::string_view kind = node.attribute("kind").value();
    box.isAutomatic = kind == "automatic";
    if (!box.isAutomatic && kind != "manual")
        reader.fail(node, "kind is '" + std::string(kind) + "'", "give manual or automatic");
    reader.onlyAttributes(node, box.isAutomatic
                                    ? "kind reverseRatio finalRatio efficiency inertiaKgM2 shiftS "
                                      "upIdleRpm upFullRpm downIdleRpm downFullRpm"
                                    : "kind reverseRatio finalRatio efficiency inertiaKgM2 shiftS "
                                      "clutchNm");
    box.reverseRatio = reader.number(node, "reverseRatio", 0.1, 50.0);
    box.finalRatio = reader.number(node, "finalRatio", 0.1, 50.0);
    box.efficiency = reader.number(node, "efficiency", 0.1, 1.0);
    box.inertiaKgM2 = reader.number(node, "inertiaKgM2", 0.001, 10.0);
    box.shiftS = reader.number(node, "shiftS", 0.01, 5.0);
    for (const pugi::xml_node gear : node.children("gear"))
    {
        reader.onlyAttributes(gear, "ratio");
        box.ratios.push_back(reader.number(gear, "ratio", 0.1, 50.0));
    }
    if (box.ratios.empty() || box.ratios.size() > kMostGears ||
        std::adjacent_find(box.ratios.begin(), box.ratios.end(), std::less_equal<>()) != box.ratios.end())
        reader.fail(
            node, "<gearbox> has gears that do not fall, or none, or more than " + std::to_string(kMostGears),
            "give a <gear ratio=\"…\"/> for each, the first one highest");
    if (!box.isAutomatic)
    {
        box.clutchNm = reader.number(node, "clutchNm", 1.0, 1e5);
        return;
    }
    box.upIdleRpm = reader.number(node, "upIdleRpm", 300.0, 20000.0);
    box.upFullRpm = reader.number(node, "upFullRpm", 300.0, 20000.0);
    box.downIdleRpm = reader.number(node, "downIdleRpm", 100.0, 20000.0);
    box.downFullRpm = reader.number(node, "downFullRpm", 100.0, 20000.0);
    readConverter(reader, node, box.converter);
}

void readControls(VehicleFileReader& reader, pugi::xml_node root, RoadVehicleData& data)
{
    const pugi::xml_node steering = reader.child(root, "steering");
    reader.onlyAttributes(steering, "lockDeg ratio rateDegPerS");
    data.steering = {reader.number(steering, "lockDeg", 1.0, 60.0),
                     reader.number(steering, "ratio", 1.0, 60.0),
                     reader.number(steering, "rateDegPerS", 10.0, 5000.0)};
    const pugi::xml_node brakes = reader.child(root, "brakes");
    reader.onlyAttributes(brakes, "mostNm handbrakeNm lagS absSlip absFromMps");
    data.brakes = {reader.number(brakes, "mostNm", 1.0, 1e6), reader.number(brakes, "handbrakeNm", 0.0, 1e6),
                   reader.number(brakes, "lagS", 0.0, 3.0), reader.number(brakes, "absSlip", 0.0, 5.0),
                   reader.number(brakes, "absFromMps", 0.0, 50.0)};
}

void readPerformance(VehicleFileReader& reader, pugi::xml_node root, PerformanceData& performance)
{
    const pugi::xml_node node = reader.child(root, "performance");
    reader.onlyAttributes(node, "toKmh accelerateS accelerateToleranceS stopM stopToleranceM lateral "
                                "lateralTolerance");
    performance = {reader.number(node, "toKmh", 10.0, 250.0),
                   reader.number(node, "accelerateS", 1.0, 300.0),
                   reader.number(node, "accelerateToleranceS", 0.0, 100.0),
                   reader.number(node, "stopM", 10.0, 500.0),
                   reader.number(node, "stopToleranceM", 0.0, 100.0),
                   reader.number(node, "lateral", 0.05, 3.0),
                   reader.number(node, "lateralTolerance", 0.0, 1.0)};
}

/// Brakes that hardly slow a vehicle are a mistake of unit or digits.
void checkBrakes(VehicleFileReader& reader, pugi::xml_node root, const RoadVehicleData& data)
{
    constexpr double kLeastMps2 = 1.0, kDefaultMps2 = 9.0;
    const double perMps2 = massProperties(data).massKg * data.axles[0].tyre.radiusM; // Nm
    if (data.brakes.mostNm >= kLeastMps2 * perMps2) return;
    std::ostringstream what, remedy;
    what.precision(2);
    what << "<brakes> mostNm of " << data.brakes.mostNm << " slows the vehicle by "
         << data.brakes.mostNm / perMps2 << " m/s² at most";
    remedy << "give the torque of all wheels together, here about "
           << std::lround(kDefaultMps2 * perMps2 / 100.0) * 100 << " Nm";
    reader.fail(root.child("brakes"), what.str(), remedy.str());
}

foundation::Result<RoadVehicleData> readRoadSource(const foundation::XmlSource& source)
{
    VehicleFileReader reader(source, kRoadPage);
    const pugi::xml_node root = source.root();
    RoadVehicleData data;
    if (std::string_view(root.name()) != "roadVehicle" ||
        std::string_view(root.attribute("version").value()) != "1")
        reader.fail(root, "is no <roadVehicle version=\"1\">",
                    "give a road vehicle's data file of this version");
    data.name = reader.name(root);
    reader.onlyAttributes(root, "version look");
    if (const std::string look = root.attribute("look").value(); !look.empty())
        data.lookFile = std::filesystem::path(source.name()).parent_path() / look;
    if (!reader.error())
        reader.onlyElements(root, "body load air hull tyre axle steering brakes engine gearbox performance");
    if (!reader.error()) readMasses(reader, root, data);
    if (!reader.error()) data.hull = readHull(reader, reader.child(root, "hull"), kMostBoxes, kWidestBoxM);
    if (!reader.error()) readAxles(reader, root, data);
    if (!reader.error()) readControls(reader, root, data);
    if (!reader.error()) readEngine(reader, root, data.engine);
    if (!reader.error()) readGearbox(reader, root, data.gearbox);
    if (!reader.error()) readPerformance(reader, root, data.performance);
    if (!reader.error())
    {
        const auto [front, rear] = restLoads(data);
        if (front <= 0.0 || rear <= 0.0)
            reader.fail(root, "its centre of mass does not lie between the axles",
                        "correct the masses' places");
        checkBrakes(reader, root, data);
    }
    if (reader.error()) return *reader.error();
    return data;
}

} // namespace

foundation::Result<RoadVehicleData> readRoadVehicle(const std::filesystem::path& file)
{
    const auto source = foundation::XmlSource::read(file, kMostRoadFileBytes);
    return source ? readRoadSource(**source) : source.error();
}

foundation::Result<RoadVehicleData> parseRoadVehicle(std::string_view text, const std::string& name)
{
    const auto source = foundation::XmlSource::parse(text, name);
    return source ? readRoadSource(**source) : source.error();
}

} // namespace simulation
