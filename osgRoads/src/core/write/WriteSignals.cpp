// SPDX-License-Identifier: Apache-2.0
// Source: ASAM OpenDRIVE 1.7, 14 (signals).
#include <string>

#include "ElementWriters.h"
#include "XmlFields.h"

namespace osgRoads::core
{

namespace
{

void writeSignal(pugi::xml_node signals, const Signal& signal)
{
    pugi::xml_node node = signals.append_child("signal");
    set(node, "id", signal.id);
    set(node, "name", signal.name);
    writePlace(node, signal);
    set(node, "hOffset", signal.headingRad);
    set(node, "pitch", signal.pitchRad);
    set(node, "roll", signal.rollRad);
    set(node, "dynamic", signal.isDynamic ? "yes" : "no");
    set(node, "country", signal.country);
    if (!signal.countryRevision.empty()) set(node, "countryRevision", signal.countryRevision);
    set(node, "type", signal.type);
    set(node, "subtype", signal.subtype);
    if (signal.value)
    {
        set(node, "value", *signal.value);
        if (!signal.unit.empty()) set(node, "unit", signal.unit);
    }
    set(node, "width", signal.width);
    set(node, "height", signal.height);
    if (!signal.text.empty()) set(node, "text", signal.text);
    for (const LaneValidity& lanes : signal.validities)
    {
        const pugi::xml_node entry = node.append_child("validity");
        set(entry, "fromLane", lanes.fromLane);
        set(entry, "toLane", lanes.toLane);
    }
}

} // namespace

void writeSignals(pugi::xml_node roadNode, const Road& road)
{
    if (road.signals.empty()) return;
    const pugi::xml_node signals = roadNode.append_child("signals");
    for (const Signal& signal : road.signals)
        writeSignal(signals, signal);
}

void writeController(pugi::xml_node root, const Controller& controller)
{
    pugi::xml_node node = root.append_child("controller");
    set(node, "id", controller.id);
    set(node, "name", controller.name);
    if (controller.sequence != 0) set(node, "sequence", controller.sequence);
    for (const Controller::Control& control : controller.controls)
    {
        const pugi::xml_node entry = node.append_child("control");
        set(entry, "signalId", control.signalId);
        if (!control.type.empty()) set(entry, "type", control.type);
    }
}

} // namespace osgRoads::core
