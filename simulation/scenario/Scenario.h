// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "simulation/scenario/Entity.h"
#include "simulation/scenario/Storyboard.h"
#include "simulation/scenario/TrafficSignals.h"

namespace simulation
{

struct FileHeader
{
    int revMajor = 1;
    int revMinor = 3;
    std::string date; ///< as in the file
    std::string author;
    std::string description;

    bool operator==(const FileHeader&) const = default;
};

struct ParameterDeclaration
{
    SourceLine source;
    std::string name;
    std::string type;  ///< integer, int, double, string, boolean, dateTime, unsignedInt, unsignedShort
    std::string value; ///< resolved

    bool operator==(const ParameterDeclaration&) const = default;
};

/// A value that says at the end whether something has been so.
struct MonitorDeclaration
{
    SourceLine source;
    std::string name;
    bool value = false;

    bool operator==(const MonitorDeclaration&) const = default;
};

struct RoadNetwork
{
    std::string logicFile; ///< OpenDRIVE
    std::string sceneGraphFile;
    std::vector<TrafficSignalController> signalControllers{};
    SourceLine logicLine{}, sceneLine{}; ///< of LogicFile and SceneGraphFile

    bool operator==(const RoadNetwork&) const = default;
};

/// A scenario: the content of an OpenSCENARIO XML file with parameters and catalogue entries replaced. Plain
/// values without XML. Unsupported content is kept as Unsupported. Invariant (strict reading): every
/// reference to an entity names one of `entities`; isConsistent() checks it. Source: ASAM, *OpenSCENARIO XML*
/// 1.0 to 1.3.
struct Scenario
{
    FileHeader header;
    std::vector<ParameterDeclaration> parameters;
    std::vector<ParameterDeclaration> variables{};
    std::vector<MonitorDeclaration> monitors{};
    RoadNetwork roadNetwork;
    std::vector<ScenarioObject> entities;
    Storyboard storyboard;

    bool operator==(const Scenario&) const = default;

    /// Returns the index into `entities`, or -1.
    int entityIndex(const std::string& name) const;
    bool isConsistent() const;

    /// Returns the line of the first action that needs the roads of the LogicFile: one that places an entity
    /// on a road, or changes its lane; nothing: none does.
    std::optional<SourceLine> needsRoads() const;

    /// Returns the line of the first action that places an entity on a road; nothing: none does.
    std::optional<SourceLine> placesOnRoads() const;
};

} // namespace simulation
