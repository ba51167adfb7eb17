// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "ProgramRun.h"

inline const char* const kSeatAircraft = OSGTRAINER_SOURCE_DIR "/data/aircraft/c172p.xml";
inline const char* const kSeatCar = OSGTRAINER_SOURCE_DIR "/data/vehicles/car.xml";
inline const char* const kSeatStreet = OSGTRAINER_SOURCE_DIR "/data/street.xodr";

/// Runs a command on an X display of its own: on-display COMMAND, or on-display XVFB-OPTION… -- COMMAND.
inline const char* const kOnDisplay = OSGTRAINER_SOURCE_DIR "/tests/programs/on-display";

bool hasXvfb();

/// Runs the trainer on a display of its own, in a window of 96x54.
ProgramRun inWindow(std::vector<std::string> arguments, std::vector<std::string> command = {kOnDisplay});

/// The bytes of a file; empty where there is none.
std::string allOf(const std::string& file);

std::vector<std::string> with(std::vector<std::string> words, const std::vector<std::string>& more);
