// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/jsbsim/JsbsimFiles.h"

#include <cmath>
#include <cstdio>

#include <foundation/Angle.h>
#include <stdlib.h>

#include "simulation/vehicle/jsbsim/JsbsimRow.h"

namespace simulation
{
namespace
{

constexpr double kKnotMps = 1852.0 / 3600.0;

std::string element(const std::string& name, const char* unit, double value)
{
    return " <" + name + " unit=\"" + unit + "\"> " + jsbsimNumber(value) + " </" + name + ">\n";
}

/// A text as the value of an attribute.
std::string quoted(const std::string& text)
{
    std::string safe;
    for (const char c : text)
        switch (c)
        {
        case '&':
            safe += "&amp;";
            break;
        case '<':
            safe += "&lt;";
            break;
        case '"':
            safe += "&quot;";
            break;
        default:
            safe += c;
        }
    return '"' + safe + '"';
}

} // namespace

foundation::Result<TemporaryFolder> TemporaryFolder::create()
{
    std::error_code failed;
    std::string text = (std::filesystem::temp_directory_path(failed) / "osgtrainer-jsbsim-XXXXXX").string();
    if (failed || !mkdtemp(text.data()))
        return foundation::Error{text, "no temporary folder can be made",
                                 "set TMPDIR to a folder that can be written"};
    return TemporaryFolder(text);
}

TemporaryFolder::~TemporaryFolder()
{
    std::error_code ignored;
    if (!_path.empty()) std::filesystem::remove_all(_path, ignored);
}

std::string jsbsimNumber(double value)
{
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", value);
    return text;
}

std::string jsbsimStateText(const JsbsimStart& start)
{
    std::string text = "<?xml version=\"1.0\"?>\n<initialize name=\"start\">\n";
    text += element("latitude", "DEG", start.latitudeDeg) + element("longitude", "DEG", start.longitudeDeg);
    text += element("elevation", "FT", start.terrainM / kJsbsimFootM) +
            element("altitudeMSL", "FT", start.heightM / kJsbsimFootM);
    text += element("psi", "DEG", start.headingDeg);
    text += start.isTrimmed ? element("gamma", "DEG", 0.0) : element("theta", "DEG", start.pitchDeg);
    const double windMps = std::hypot(start.windMps.x, start.windMps.y);
    if (windMps > 0.0)
        // JSBSim's direction is the one that the air moves to.
        text +=
            element("winddir", "DEG", foundation::degreesOf(std::atan2(start.windMps.y, start.windMps.x))) +
            element("vwind", "KTS", windMps / kKnotMps);
    text += element("vnorth", "FT/SEC", start.velocityMps.x / kJsbsimFootM) +
            element("veast", "FT/SEC", start.velocityMps.y / kJsbsimFootM) +
            element("vdown", "FT/SEC", start.velocityMps.z / kJsbsimFootM);
    if (start.isTrimmed) text += " <running> -1 </running>\n";
    return text + "</initialize>\n";
}

std::string jsbsimScriptText(const JsbsimData& data, const JsbsimStart& start,
                             const std::filesystem::path& stateFile, int port, int outputNumber,
                             int stepsPerSecond)
{
    std::string text =
        "<?xml version=\"1.0\"?>\n<runscript name=\"osgTrainer\">\n <use aircraft=" + quoted(data.aircraft) +
        " initialize=" + quoted(stateFile.string()) + "/>\n";
    text += " <input port=\"" + std::to_string(port) + "\" action=\"BLOCKING_INPUT\"/>\n";
    // JSBSim takes names of files from its root on.
    text += " <output name=\"../../../../../../../../../../../../../../../../dev/fd/" +
            std::to_string(outputNumber) + "\" type=\"CSV\" rate=\"" + std::to_string(stepsPerSecond) +
            "\">\n";
    for (std::size_t i = 1; i < kJsbsimProperties.size(); ++i)
        text += "  <property>" + std::string(kJsbsimProperties[i]) + "</property>\n";
    for (const std::string& property : start.asked)
        text += "  <property>" + property + "</property>\n";
    text += " </output>\n <run start=\"0\" end=\"1e9\" dt=\"" + jsbsimNumber(1.0 / stepsPerSecond) +
            "\">\n  <property value=\"1\"> simulation/randomseed </property>\n";
    if (!start.settings.empty() || start.isTrimmed)
    {
        text += "  <event name=\"begin\">\n   <condition> simulation/sim-time-sec ge 0 </condition>\n";
        for (const auto& [property, value] : start.settings)
            text += "   <set name=" + quoted(property) + " value=\"" + jsbsimNumber(value) + "\"/>\n";
        if (start.isTrimmed) text += "   <set name=\"simulation/do_simple_trim\" value=\"1\"/>\n";
        text += "  </event>\n";
    }
    return text + " </run>\n</runscript>\n";
}

} // namespace simulation
