// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <foundation/Result.h>
#include <glm/glm.hpp>

#include "simulation/vehicle/jsbsim/JsbsimData.h"

namespace simulation
{

/// Where JSBSim begins. Units: SI, degrees; local north, east, down.
struct JsbsimStart
{
    double latitudeDeg = 0.0, longitudeDeg = 0.0;
    double heightM = 0.0;  ///< of the centre of mass over the sea
    double terrainM = 0.0; ///< of the ground over the sea
    double headingDeg = 0.0, pitchDeg = 0.0;
    glm::dvec3 velocityMps{0.0};                            ///< over the ground
    glm::dvec3 windMps{0.0};                                ///< the direction in which the air moves
    bool isTrimmed = false;                                 ///< JSBSim finds the steady flight by itself
    std::vector<std::pair<std::string, double>> settings{}; ///< properties that are set at the begin
    std::vector<std::string>
        asked{}; ///< further properties of each row; those that the aircraft lacks are left out
};

/// A folder of its own below the system's for temporary files; it goes with this object.
class TemporaryFolder
{
public:
    static foundation::Result<TemporaryFolder> create();
    TemporaryFolder(TemporaryFolder&& other) noexcept : _path(std::exchange(other._path, {})) {}
    TemporaryFolder& operator=(TemporaryFolder&&) = delete;
    ~TemporaryFolder();

    const std::filesystem::path& path() const { return _path; }

private:
    explicit TemporaryFolder(std::filesystem::path path) : _path(std::move(path)) {}
    std::filesystem::path _path;
};

/// The state at the begin, as an initialisation file of JSBSim.
std::string jsbsimStateText(const JsbsimStart& start);

/// A run script of JSBSim: the aircraft, the state of `stateFile`, orders by the TCP port, a row of
/// kJsbsimProperties for each of `stepsPerSecond` steps to the file `outputNumber` of the process.
std::string jsbsimScriptText(const JsbsimData& data, const JsbsimStart& start,
                             const std::filesystem::path& stateFile, int port, int outputNumber,
                             int stepsPerSecond);

/// A number as JSBSim reads it back to the last bit.
std::string jsbsimNumber(double value);

} // namespace simulation
