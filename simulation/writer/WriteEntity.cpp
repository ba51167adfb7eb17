// SPDX-License-Identifier: Apache-2.0
#include "simulation/writer/ElementWriter.h"

namespace simulation
{
namespace
{

void writeBox(ElementWriter parent, const BoundingBox& box)
{
    ElementWriter element = parent.child("BoundingBox");
    element.child("Center").set("x", box.centre.x).set("y", box.centre.y).set("z", box.centre.z);
    element.child("Dimensions")
        .set("width", box.widthM)
        .set("length", box.lengthM)
        .set("height", box.heightM);
}

void writeAxle(ElementWriter element, const Axle& axle)
{
    element.set("maxSteering", axle.maxSteeringRad)
        .set("wheelDiameter", axle.wheelDiameterM)
        .set("trackWidth", axle.trackWidthM)
        .set("positionX", axle.positionXM)
        .set("positionZ", axle.positionZM);
}

void writeProperties(ElementWriter parent, const Properties& properties)
{
    ElementWriter element = parent.child("Properties");
    for (const auto& [name, value] : properties.values)
        element.child("Property").set("name", name).set("value", value);
    for (const std::string& file : properties.files)
        element.child("File").set("filepath", file);
}

void writeObject(ElementWriter parent, const Vehicle& vehicle)
{
    ElementWriter element = parent.child("Vehicle");
    element.set("name", vehicle.name).set("vehicleCategory", vehicle.category).set("mass", vehicle.massKg);
    if (!vehicle.model3d.empty()) element.set("model3d", vehicle.model3d);
    writeBox(element, vehicle.box);
    element.child("Performance")
        .set("maxSpeed", vehicle.performance.maxSpeedMps)
        .set("maxAcceleration", vehicle.performance.maxAccelerationMps2)
        .set("maxDeceleration", vehicle.performance.maxDecelerationMps2);
    ElementWriter axles = element.child("Axles");
    if (vehicle.frontAxle) writeAxle(axles.child("FrontAxle"), *vehicle.frontAxle);
    writeAxle(axles.child("RearAxle"), vehicle.rearAxle);
    for (const Axle& axle : vehicle.additionalAxles)
        writeAxle(axles.child("AdditionalAxle"), axle);
    writeProperties(element, vehicle.properties);
    if (vehicle.trailerHitchDxM) element.child("TrailerHitch").set("dx", *vehicle.trailerHitchDxM);
    if (vehicle.trailerCouplerDxM) element.child("TrailerCoupler").set("dx", *vehicle.trailerCouplerDxM);
}

template<class Object>
void writeSimple(ElementWriter element, const Object& object, const char* categoryAttribute)
{
    element.set("name", object.name).set(categoryAttribute, object.category).set("mass", object.massKg);
    if (!object.model3d.empty()) element.set("model3d", object.model3d);
    writeBox(element, object.box);
    writeProperties(element, object.properties);
}

void writeObject(ElementWriter parent, const Pedestrian& pedestrian)
{
    writeSimple(parent.child("Pedestrian"), pedestrian, "pedestrianCategory");
}

void writeObject(ElementWriter parent, const MiscObject& object)
{
    writeSimple(parent.child("MiscObject"), object, "miscObjectCategory");
}

void writeObject(ElementWriter parent, const Unsupported& content)
{
    parent.refuse(content);
}

} // namespace

void writeScenarioObject(ElementWriter parent, const ScenarioObject& object)
{
    ElementWriter element = parent.child("ScenarioObject");
    element.set("name", object.name);
    std::visit([&](const auto& content) { writeObject(element, content); }, object.object);
}

} // namespace simulation
