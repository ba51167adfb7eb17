// SPDX-License-Identifier: Apache-2.0
// Source: ASAM OpenDRIVE 1.8, 14 (signals).
#include <utility>

#include "ElementReaders.h"

namespace osgRoads::core
{

namespace
{

std::optional<Signal::Post> readPost(NodeReader& element)
{
    std::optional<Signal::Post> post;
    element.each("positionRoad",
                 [&](NodeReader& position)
                 {
                     post = Signal::Post{true,
                                         position.id("roadId"),
                                         position.number("s"),
                                         position.number("t"),
                                         position.numberOr("zOffset", 0.0),
                                         position.numberOr("hOffset", 0.0),
                                         position.numberOr("pitch", 0.0),
                                         position.numberOr("roll", 0.0)};
                 });
    element.each("positionInertial",
                 [&](NodeReader& position)
                 {
                     post = Signal::Post{false,
                                         "",
                                         position.number("x"),
                                         position.number("y"),
                                         position.numberOr("z", 0.0),
                                         position.numberOr("hdg", 0.0),
                                         position.numberOr("pitch", 0.0),
                                         position.numberOr("roll", 0.0)};
                 });
    return post;
}

std::optional<double> readValue(NodeReader& element)
{
    return element.text("value").empty() ? std::nullopt : element.optionalNumber("value");
}

Signal readSignal(NodeReader& element)
{
    Signal signal;
    readItem(element, signal);
    signal.headingRad = element.numberOr("hOffset", 0.0);
    signal.country = element.text("country");
    signal.countryRevision = element.text("countryRevision");
    signal.unit = element.text("unit");
    signal.text = element.text("text");
    signal.value = readValue(element);
    element.each("dependency",
                 [&](NodeReader& other) {
                     signal.dependencies.push_back({other.id("id"), other.text("type")});
                 });
    element.each("reference",
                 [&](NodeReader& other)
                 {
                     other.has("elementType");
                     signal.references.push_back({other.id("elementId"), other.text("type")});
                 });
    signal.post = readPost(element);
    return signal;
}

SignalReference readReference(NodeReader& element)
{
    SignalReference reference;
    reference.line = element.line();
    reference.id = element.id("id");
    reference.s = element.number("s");
    reference.t = element.number("t");
    reference.orientation = readOrientation(element);
    reference.validities = readValidities(element);
    return reference;
}

} // namespace

void readSignals(NodeReader& road, Road& into)
{
    road.each("signals",
              [&](NodeReader& signals)
              {
                  signals.each("signal",
                               [&](NodeReader& element)
                               {
                                   into.signals.push_back(readSignal(element));
                                   const Signal& signal = into.signals.back();
                                   reportOffRoad(element, "signal " + signal.id, signal.s, into);
                               });
                  signals.each("signalReference", [&](NodeReader& element)
                               { into.signalReferences.push_back(readReference(element)); });
              });
}

Controller readController(NodeReader& element)
{
    Controller controller;
    controller.line = element.line();
    controller.id = element.id("id");
    controller.name = element.text("name");
    controller.sequence = element.integer("sequence", 0);
    element.each("control",
                 [&](NodeReader& control) {
                     controller.controls.push_back({control.id("signalId"), control.text("type")});
                 });
    return controller;
}

} // namespace osgRoads::core
