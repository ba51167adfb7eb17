// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include <osgTerrainROAM/core/heightfield/DemImport.h>

#include <osgOffscreen/Backend>

namespace trainer
{

/// Whose eye looks.
enum class EyePoint
{
    own,   ///< the driver's or the pilot's of the ownship
    chase, ///< behind and above it
};

/// What was asked on the command line. Empty paths: not asked for.
struct PlayRequest
{
    std::filesystem::path scenario;
    std::filesystem::path terrain;       ///< in place of the scenario's scene
    std::filesystem::path sceneryFile;   ///< what stands on the terrain
    std::filesystem::path objectsFolder; ///< models that stand there, too
    std::filesystem::path captureFolder;
    std::filesystem::path statsFile;
    std::filesystem::path reportFile;
    std::string contactSheet; ///< file beside the report that it shows
    std::string video;        ///< likewise
    std::filesystem::path viewFile;
    osgTerrainROAM::core::DemImportOptions import;
    osgOffscreen::Backend backend = osgOffscreen::defaultBackend();
    EyePoint eye = EyePoint::own;
    int widthPx = 960;
    int heightPx = 540;
    int samples = 4; ///< per pixel
    int framesPerSecond = 24;
    std::optional<int> frames; ///< absent: until the scenario ends
    double eyeHeightM = 1.5;   ///< of a driver
    double errorTolerancePx = 1.0;
    std::uint32_t maxTriangles = 500000;
    bool morphing = false; ///< detail comes and goes without a jump
    std::optional<int> patchExponent =
        0; ///< 2^k triangles a leaf; absent: what this machine draws fastest with
};

} // namespace trainer
