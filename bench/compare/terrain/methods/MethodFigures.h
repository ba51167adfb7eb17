// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace terraintool
{

/// What a method does at a ceiling of triangles: as many as ROAM draws at equal error, or the fewest that it
/// can draw.
struct CeilingFigures
{
    double asked = 0.0;          ///< as many as ROAM draws
    double ceiling = 0.0;        ///< the same, or the fewest that the method can draw
    std::size_t framesAbove = 0; ///< with more triangles than allowed
    double leastShare = 1.0;     ///< of the ceiling that a frame used, at least
    double trueErrorPx = 0.0;
};

/// What a method does in slices of modelled time.
struct SliceFigures
{
    std::size_t stops = 0;  ///< frames whose work was left over
    std::size_t faults = 0; ///< frames after which the mesh was not valid, or not conforming
};

/// What an adaptation costs: µs = baseUs + nsPerTriangle of the mesh + nsPerChange of a triangle that is
/// written (WorkFit.h).
struct FitFigures
{
    double baseUs = 0.0, nsPerTriangle = 0.0, nsPerChange = 0.0;
    double sizePercent = 0.0,
           changePercent = 0.0; ///< of what is not base, at the compared error; both 0: all is base
};

/// What morphing costs: the first frames of the flight with it and without, at one tolerance.
struct MorphFigures
{
    double us = 0.0, plainUs = 0.0;     ///< medians
    double vertices = 0.0, plain = 0.0; ///< written in a frame, means
};

/// The figures of one method on one terrain, at the true error at which all methods are compared.
struct MethodFigures
{
    std::string name;
    bool isOfBlocks = false;
    bool adapts = true;       ///< false: one mesh for all eyes
    double tolerancePx = 0.0; ///< the method's own, at which the true error was found
    double triangles = 0.0;   ///< mean of the frames
    double trueErrorPx = 0.0; ///< by brute force, largest of the checked frames
    double adaptUsP50 = 0.0, adaptUsP99 = 0.0, adaptUsMax = 0.0;
    double changedPercent = 0.0; ///< triangles that the frame before did not draw, mean of the frames
    double popPx = 0.0;          ///< largest of the frames
    std::optional<double> transformsPerTriangle, stripLength; ///< the strips in the order of the slots
    std::optional<double> dualStripLength{};                  ///< strips made by the dual graph
    double lightPercent = 0.0; ///< of vertices: normals turned in a frame, mean of the frames (LightChange.h)
    double lightDeg = 0.0;     ///< the largest turn of all frames
    double regularPercent = 0.0; ///< of the triangles: right and isosceles in plan, last frame
    double areaRatio = 1.0;      ///< the largest triangle's area in plan to the smallest's, last frame
    std::optional<double> visiblePercent{}; ///< of the triangles left by culling, last frame
    std::optional<double> editUs{};         ///< following an edit of a sample; absent: not, or not measured
    std::optional<bool> followsEdits{};     ///< absent: not measured
    std::optional<MorphFigures> morph{};    ///< absent: the method does not morph
    std::optional<FitFigures> fit{};
    std::optional<double> frameMs{}; ///< a whole picture, median; absent: not drawn
    std::string picture{};           ///< name of the file; empty: none
    double memoryMB = 0.0;           ///< besides the tile
    double preparationS = 0.0;
    double parts = 1.0;                      ///< of what is prepared, each whole without the others
    std::size_t breaks = 0;                  ///< T-junctions and cracks in the checked frames
    std::optional<double> spikeTriangles{};  ///< that one raised sample adds; absent: not measured
    double sideSamples = 0.0;                ///< of the square
    std::optional<CeilingFigures> ceiling{}; ///< absent: the method takes none
    std::optional<SliceFigures> slices{};    ///< absent: the method takes no limit of time
    std::vector<double> frameUs{},
        frameTriangles{}; ///< for plots; the first frame, which builds the mesh, is left out
};

/// The time to remove a triangle, by both ways of merging; 0: the terrain is too small to tell.
struct MergeFigures
{
    double bulkNs = 0.0, singleNs = 0.0;
};

/// The time of one way to get from a frame to a very different one.
struct ReworkFigures
{
    std::string path, way; ///< IncoherentFrames.h
    bool inSight = false;  ///< refined only what is seen, by position and orientation; else all around
    double adaptUsP50 = 0.0, adaptUsMax = 0.0;
    double changedTriangles = 0.0; ///< split and merged in a frame, mean
};

/// All methods on one terrain.
struct DemComparison
{
    std::string dem;
    std::vector<MethodFigures> methods;
    MergeFigures merges{};
    std::vector<ReworkFigures> reworks{};

    /// The figures of that method; null: it was not compared.
    const MethodFigures* of(const std::string& name) const
    {
        for (const MethodFigures& method : methods)
            if (method.name == name) return &method;
        return nullptr;
    }

    /// The median of a way along a path; nothing: it was not measured.
    std::optional<double> reworkUs(const std::string& path, const std::string& way) const
    {
        for (const ReworkFigures& rework : reworks)
            if (rework.path == path && rework.way == way) return rework.adaptUsP50;
        return std::nullopt;
    }
};

} // namespace terraintool
