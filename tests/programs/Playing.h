// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "ProgramRun.h"
#include "Workplace.h"

/// The names of an object's members, in order.
std::vector<std::string> keysOf(const nlohmann::ordered_json& object);

/// What a run of the trainer left of its flight or drive.
struct Playing
{
    std::map<std::string, std::string> frames; ///< the bytes of each file of the capture folder, by name
    nlohmann::json statistics;
};

/// Runs `trainer COMMAND SUBJECT` and `more`, four frames of 96×54 unless `more` says otherwise, capturing
/// into the folder `name` of the workplace; a failed test if the program fails.
Playing playedAs(const Workplace& place, const std::string& name, const std::vector<std::string>& command,
                 const std::vector<std::string>& more = {});

/// The bytes of every file in a folder, by name.
std::map<std::string, std::string> bytesIn(const std::filesystem::path& folder);

/// A hash of all bytes of a file: a difference is told in one line.
std::size_t hashOf(const std::filesystem::path& file);

/// Statistics without what a clock fills: columns of the frames, and the stages of the opening.
nlohmann::json withoutMeasured(nlohmann::json statistics);

/// Colours that differ in a picture, and its size.
struct PictureFacts
{
    int widthPx = 0, heightPx = 0;
    std::size_t colours = 0;
};
PictureFacts factsOf(const std::filesystem::path& png);
