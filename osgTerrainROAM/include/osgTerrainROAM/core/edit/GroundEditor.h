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

/// A hole that something has made, with the rim that it threw up: ejecta thins out with the third power of the distance.
struct Crater
{
    glm::dvec2 centre{0.0};
    double radiusM = 10.0; ///< to the crest of the rim
    double depthM = 3.0;   ///< below the ground as it was
    double rimM = 0.5;     ///< above it
};

/// A level or sloping platform: inside a polygon the ground is the plane nearest to its corners' heights.
struct Platform
{
    std::vector<glm::dvec3> corners{}; ///< x and y in the tile's frame, z as the samples are counted
    double slope = 1.0 / 1.5;          ///< of cuttings and embankments around it
};

/// A road, a runway or a dam: a line with a cross-section.
struct Ribbon
{
    std::vector<glm::dvec2> points{};
    std::vector<double>
        heightsM{};           ///< at the points, as the samples are counted; none: the ground's, smoothed
    double widthM = 7.0;      ///< that lies at these heights
    double crossfall = 0.0;   ///< how much it falls to either side, per metre
    double slope = 1.0 / 1.5; ///< of cuttings and embankments
    double smoothM = 80.0;    ///< over which the ground's heights are smoothed
};

/// Edits of the ground by their shapes. Each is one step that undo() takes back; meshes that show the tile follow with their
/// next frame.
/// Frame: places are x and y of the tile's frame; a place keeps the height that it is seen under. Units: metres; heights as
/// the tile's samples are counted. Errors: as TileEditor::apply and changesBy; shapes without extent.
/// Threads: as TileEditor.
class GroundEditor
{
public:
    explicit GroundEditor(std::shared_ptr<RoamTile> tile) : _tile(tile), _steps(std::move(tile)) {}

    /// `places` puts samples between those of the raster where the tile's grid has room for them.
    void setDetail(EditDetail detail) { _detail = detail; }

    /// How wide, inside its border, the effect of a region fades in.
    void setFadeM(double metres) { _fadeM = metres; }

    foundation::Result<EditReport> setHeight(const Region& region, double heightM);
    foundation::Result<EditReport> raise(const Region& region, double byM);
    foundation::Result<EditReport> smooth(const Region& region,
                                          double radiusM); ///< takes means of that reach
    foundation::Result<EditReport>
    flatten(const Region& region); ///< to the plane that is nearest to its samples
    foundation::Result<EditReport> stamp(const Crater& crater);
    foundation::Result<EditReport> conform(const Platform& platform); // Conform.cpp
    foundation::Result<EditReport> conform(const Ribbon& ribbon);

    bool undo() { return _steps.undo(); }
    TileEditor& steps() { return _steps; }

    /// Heights of a ribbon that has none, at the given distances along it: the ground's, smoothed.
    std::vector<double> profile(const Ribbon& ribbon, const std::vector<double>& alongM) const;

private:
    foundation::Result<EditReport> apply(const HeightRule& rule, std::span<const PlanBox> boxes);
    foundation::Result<EditReport> applyIn(const Region& region, const HeightRule& rule);
    foundation::Error refusal(const char* what, const char* remedy) const;
    double groundM(const glm::dvec2& place) const;
    double placeM() const; ///< from one place that edits change to the next

    std::shared_ptr<RoamTile> _tile;
    TileEditor _steps;
    EditDetail _detail = EditDetail::places;
    double _fadeM = 0.0;
};

} // namespace osgTerrainROAM::core
