// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/parser/ElementReader.h"

namespace simulation
{

// One function for each element that is read: it turns the element into its plain value. Problems go to the context
// of the reader; each function returns a usable value in every case.

Position parsePosition(ElementReader reader);                       // ParsePosition.cpp
Orientation parseOrientation(ElementReader reader);                 // ParsePosition.cpp
Trajectory parseTrajectory(ElementReader reader);                   // ParseTrajectory.cpp
FollowTrajectoryAction parseFollowTrajectory(ElementReader reader); // ParseTrajectory.cpp
Environment parseEnvironment(ElementReader reader);                 // ParseEnvironment.cpp
PrivateAction parsePrivateAction(ElementReader reader);             // ParseAction.cpp
GlobalAction parseGlobalAction(ElementReader reader);               // ParseAction.cpp
Trigger parseTrigger(ElementReader reader);                         // ParseCondition.cpp
ScenarioObject parseScenarioObject(ElementReader reader);           // ParseEntity.cpp
Storyboard parseStoryboard(ElementReader reader);                   // ParseStoryboard.cpp

} // namespace simulation
