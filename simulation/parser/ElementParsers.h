// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/parser/ElementReader.h"

namespace simulation
{

// One function per element of the language that the model has room for: from the element to the plain value.
// Problems go to the reader's context; every function returns something usable.

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
