// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/parser/ElementReader.h"

namespace simulation
{

// One function for each element that is read: it turns the element into its plain value. Problems go to the
// context of the reader; each function returns a usable value in every case.

Position parsePosition(ElementReader reader);               // ParsePosition.cpp
Orientation parseOrientation(ElementReader reader);         // ParsePosition.cpp
Orientation parseOrientationOf(ElementReader position);     // ParsePosition.cpp
Route parseRouteIn(ElementReader holder);                   // ParseRoute.cpp
RoutePosition parseRoutePosition(ElementReader reader);     // ParseRoute.cpp
Trajectory parseTrajectory(ElementReader reader);           // ParseTrajectory.cpp
TrajectoryShape parseTrajectoryShape(ElementReader reader); // ParseTrajectoryShape.cpp
/// Refuses times that a Timing cannot use; of vertices at one time the first is kept. `holder`: the element
/// that the problem is told of. Returns false where the shape has no time at all, so that the Timing stands
/// for nothing.
bool checkShapeTimes(ParseContext& context, pugi::xml_node holder,
                     TrajectoryShape& shape);                             // CheckShapeTimes.cpp
TrajectoryPosition parseTrajectoryPosition(ElementReader reader);         // ParseTrajectory.cpp
FollowTrajectoryAction parseFollowTrajectory(ElementReader reader);       // ParseTrajectory.cpp
Environment parseEnvironment(ElementReader reader);                       // ParseEnvironment.cpp
PrivateAction parsePrivateAction(ElementReader reader);                   // ParseAction.cpp
PrivateAction parseLongitudinalAction(ElementReader reader);              // ParseLongitudinalAction.cpp
PrivateAction parseLateralAction(ElementReader reader);                   // ParseLateralAction.cpp
PrivateAction parseRoutingAction(ElementReader reader);                   // ParseRoutingAction.cpp
PrivateAction parseSynchronizeAction(ElementReader reader);               // ParseRoutingAction.cpp
TransitionDynamics parseDynamics(ElementReader reader);                   // ParseLongitudinalAction.cpp
GlobalAction parseGlobalAction(ElementReader reader);                     // ParseGlobalAction.cpp
OverrideAction parseOverride(ElementReader reader);                       // ParseOverride.cpp
GlobalAction parseTrafficAction(ElementReader reader);                    // ParseTraffic.cpp
Trigger parseTrigger(ElementReader reader);                               // ParseCondition.cpp
EntityCondition parseEntityCondition(ElementReader reader);               // ParseEntityCondition.cpp
DistanceMeasure parseDistanceMeasure(ElementReader& reader);              // ParseEntityCondition.cpp
std::string parseEntityRef(ElementReader& reader, const char* attribute); // ParseEntityCondition.cpp
/// The entity of an EntityRef or an actor, or the members of the EntitySelection that it names.
std::vector<std::string> parseEntityRefs(ElementReader reference); // ParseEntityCondition.cpp
std::vector<std::string> parseSelection(ElementReader reader,
                                        const std::vector<ScenarioObject>& objects); // ParseSelection.cpp
std::vector<ScenarioObject> parseScenarioObject(ElementReader reader); // ParseEntity.cpp: with its trailers
/// The same of an element without a name of its own. `instead`: see CatalogVisit.
std::vector<ScenarioObject> parseObjectContent(ElementReader reader, const std::string& name,
                                               const char* instead); // ParseEntity.cpp
FileHeader parseHeader(ElementReader reader);                        // ParseScenario.cpp
/// A Controller, or one of a catalogue. One that is not played is told.
Controller parseObjectController(ElementReader reader); // ParseEntity.cpp
Controller parseController(ElementReader reader);       // ParseController.cpp
Properties parseProperties(ElementReader reader);       // ParseEntity.cpp: those of an object
Storyboard parseStoryboard(ElementReader reader);       // ParseStoryboard.cpp

/// Reads the instant of `dateTime`.
DateTime parseInstant(ElementReader& reader); // ParseEnvironment.cpp
/// Reads the name of a parameter (`parameterRef`), variable or monitor that must be declared.
std::string parseDeclaredName(ElementReader& reader, const char* attribute);    // ParseGlobalAction.cpp
std::string parseSignalControllerRef(ElementReader& reader);                    // ParseTrafficSignals.cpp
std::vector<TrafficSignalController> parseTrafficSignals(ElementReader reader); // ParseTrafficSignals.cpp

/// Reports an element that is not read. `kind`: of thing, for the message.
Unsupported unsupportedContent(ElementReader& reader, const char* kind); // ParseAction.cpp

} // namespace simulation
