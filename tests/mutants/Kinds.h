// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

using Command = std::vector<std::string>;

/// One kind of input: the sound files that are damaged, and the commands that read a damaged one.
struct InputKind
{
    std::string name;
    std::vector<std::filesystem::path> seeds;
    /// Returns the commands for a file; one of them is run for each mutant, in turn.
    std::function<std::vector<Command>(const std::string& file)> commands;
    /// Makes check sums of a damaged file right again, or nothing else is tried; done for every second
    /// mutant. May be empty.
    std::function<void(std::string& bytes)> repair = {};
};

/// The folders that the kinds need.
struct MutantFolders
{
    std::filesystem::path programs; ///< with trainer, terraintool, pmtool, roadtool and worldtool
    std::filesystem::path source;   ///< of this project
    std::filesystem::path scratch;  ///< for what is made: seeds, mutants, outputs
    std::filesystem::path
        realData; ///< models/, dem/, openscenario/ and tracks/ give further seeds; empty: none

    std::filesystem::path corpus() const { return source / "tests/fuzz/corpus"; }
    /// A folder of real data, or nothing without them.
    std::filesystem::path real(const char* folder) const
    {
        return realData.empty() ? realData : realData / folder;
    }
    /// Returns a command of one of the programs.
    Command command(const char* program, Command words) const
    {
        words.insert(words.begin(), (programs / program).string());
        return words;
    }
    /// Returns a path in the scratch folder.
    std::string made(const char* name) const { return (scratch / name).string(); }
};

/// Models, progressive meshes and polygons, as pmtool reads them.
std::vector<InputKind> modelKinds(const MutantFolders& folders);

/// What a world is made of: rasters, .roam files, objects, views, road networks, maps and runways.
std::vector<InputKind> worldKinds(const MutantFolders& folders);

/// Multi-triangulations, and the surfaces from which they are built.
std::vector<InputKind> triangulationKinds(const MutantFolders& folders);

/// What moves: scenarios, vehicles, recorded flights, inputs, orders, keys and devices.
std::vector<InputKind> rideKinds(const MutantFolders& folders);

/// Maps and rasters in formats of others, and the files of a world, of which some are made by the programs.
std::vector<InputKind> formatKinds(const MutantFolders& folders);

/// Returns all kinds of input that the programs take, and writes the seeds that are made.
std::vector<InputKind> inputKinds(const MutantFolders& folders);
