// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <foundation/Result.h>

#include <viewlod/ViewState.h>

#include "compare/terrain/methods/ExternalRival.h"
#include "compare/terrain/methods/MeshPainter.h"
#include "compare/terrain/methods/MethodFigures.h"
#include "compare/terrain/methods/Rival.h"

namespace terraintool
{

/// The flight over which methods are compared, and the error that is equal for all.
struct ComparedFlight
{
    std::vector<viewlod::ViewState> views;
    double errorPx = 2.0;         ///< true, largest of the checked frames
    int framesBetweenChecks = 12; ///< by brute force; 1: all

    bool isChecked(std::size_t frame) const
    {
        return (frame + 1) % static_cast<std::size_t>(framesBetweenChecks) == 0 || frame + 1 == views.size();
    }
};

/// Returns the largest distance between a visible sample and a drawn mesh, by brute force. Units: pixels.
double trueErrorPx(const RivalMesh& mesh, const osgTerrainROAM::core::RoamTile& tile,
                   const viewlod::ViewState& view);

/// Finds the tolerance of a method at which its true error is that of the flight: the error grows about as
/// the tolerance does, so the next one tried is where the line through two others, in logarithms, meets it;
/// every third one halves the interval. The error is no continuous function, so the nearest that was met is
/// taken. Cost: up to 20 passes over the checked frames, in parallel.
double toleranceForError(const Rival& rival, const osgTerrainROAM::core::RoamTile& tile,
                         const ComparedFlight& flight);

/// Measures a method along the flight. Times are of this thread, in microseconds.
MethodFigures measureRival(const Rival& rival, const osgTerrainROAM::core::RoamTile& tile,
                           const ComparedFlight& flight);

/// Who draws pictures of the meshes, and where they are written.
struct Painting
{
    MeshPainter* painter = nullptr; ///< null: none
    std::filesystem::path folder{}; ///< empty: pictures are measured, but not written
    std::string stem{};             ///< begins the names of the files
};

/// Compares all methods over a square of samples, and programs; of one that fails there is no row, and stderr
/// says so.
/// Errors: a method cannot draw it; a picture cannot be drawn or written.
using FlightMaker =
    std::function<foundation::Result<ComparedFlight>(const osgTerrainROAM::core::PlacedTile&)>;
foundation::Result<DemComparison> compareOver(const osgTerrainROAM::core::HeightField& square,
                                              const FlightMaker& flightOver, const Painting& painting = {},
                                              const std::vector<ExternalMethod>& external = {});

} // namespace terraintool
