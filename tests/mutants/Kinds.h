// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

/// One kind of input: the sound files that are damaged, and the commands that read a damaged one.
struct InputKind
{
    std::string name;
    std::vector<std::filesystem::path> seeds;
    /// Returns the commands for a file; one of them is run for each mutant, in turn.
    std::function<std::vector<std::vector<std::string>>(const std::string& file)> commands;
    /// Makes check sums of a damaged file right again, or nothing else is tried; done for every second mutant. May be empty.
    std::function<void(std::string& bytes)> repair = {};
};

/// The folders that the kinds need.
struct MutantFolders
{
    std::filesystem::path programs; ///< with trainer, terraintool, pmtool and roadtool
    std::filesystem::path source;   ///< of this project
    std::filesystem::path scratch;  ///< for what is made: seeds, mutants, outputs
    std::filesystem::path realData; ///< models/, dem/ and openscenario/ give further seeds; empty: none
};

/// Returns all kinds of input that the programs take, and writes the seeds that are made.
std::vector<InputKind> inputKinds(const MutantFolders& folders);
