// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include <foundation/Result.h>

#include <osgTerrainROAM/core/edit/HeightRule.h>
#include <osgTerrainROAM/core/edit/PlanShape.h>
#include <osgTerrainROAM/core/edit/TileEditor.h>

namespace osgTerrainROAM::core
{

/// A crater with its rim. The height of the ejecta falls with the third power of the distance.
struct Crater
{
    glm::dvec2 centre{0.0};
    double radiusM = 10.0; ///< to the crest of the rim
    double depthM = 3.0;   ///< below the ground as it was
    double rimM = 0.5;     ///< above it
};

/// A level or sloping platform: inside a polygon the ground becomes the least-squares plane of the corners.
struct Platform
{
    std::vector<glm::dvec3> corners{}; ///< x and y in the tile's frame; z: height in the samples' datum
    double slope = 1.0 / 1.5;          ///< of cuttings and embankments around it
};

/// A road, a runway or a dam: a line with a cross-section.
struct Ribbon
{
    std::vector<glm::dvec2> points{};
    std::vector<double> heightsM{}; ///< at the points, in the samples' datum; empty: the ground's, smoothed
    double widthM = 7.0;            ///< of the surface at these heights
    double crossfall = 0.0;         ///< fall to either side, metres per metre
    double slope = 1.0 / 1.5;       ///< of cuttings and embankments
    double smoothM = 80.0;          ///< length over which the ground's heights are smoothed
};

/// Edits the ground by shapes. Each call is one step that undo() takes back; meshes of the tile follow in
/// their next frame.
/// Frame: horizontal positions are x and y of the tile's frame. Units: metres; heights in the samples' datum.
/// Errors: those of TileEditor::apply and changesBy; a shape without extent. Threads: as TileEditor.
class GroundEditor
{
public:
    explicit GroundEditor(std::shared_ptr<RoamTile> tile) : _tile(tile), _steps(std::move(tile)) {}

    /// Chooses whether edits add samples between those of the raster (EditDetail::places), where the tile's
    /// grid is finer.
    void setDetail(EditDetail detail) { _detail = detail; }

    /// Sets the width, inside a region's border, over which the effect fades in.
    void setFadeM(double metres) { _fadeM = metres; }

    foundation::Result<EditReport> setHeight(const Region& region, double heightM);
    foundation::Result<EditReport> raise(const Region& region, double byM);
    foundation::Result<EditReport> smooth(const Region& region,
                                          double radiusM); ///< weighted means over this radius
    foundation::Result<EditReport>
    flatten(const Region& region); ///< to the least-squares plane of the ground
    foundation::Result<EditReport> stamp(const Crater& crater);
    foundation::Result<EditReport> conform(const Platform& platform); // Conform.cpp
    foundation::Result<EditReport> conform(const Ribbon& ribbon);

    bool undo() { return _steps.undo(); }
    TileEditor& steps() { return _steps; }

    /// Heights at the given distances along a ribbon without heights of its own: the ground's, smoothed.
    std::vector<double> profile(const Ribbon& ribbon, const std::vector<double>& alongM) const;

private:
    foundation::Result<EditReport> apply(const HeightRule& rule, std::span<const PlanBox> boxes);
    foundation::Result<EditReport> applyIn(const Region& region, const HeightRule& rule);
    foundation::Error refusal(const char* what, const char* remedy) const;
    double groundM(const glm::dvec2& place) const;
    double placeM() const; ///< distance between neighbouring points that edits change

    std::shared_ptr<RoamTile> _tile;
    TileEditor _steps;
    EditDetail _detail = EditDetail::places;
    double _fadeM = 0.0;
};

} // namespace osgTerrainROAM::core
