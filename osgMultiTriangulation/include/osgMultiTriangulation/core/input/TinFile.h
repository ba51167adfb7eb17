// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <foundation/Result.h>

#include <osgMultiTriangulation/core/input/PointSet.h>

namespace osgMultiTriangulation::core
{

/// A surface as files of triangles have it: x to the east, y to the north, z upwards.
struct MeasuredTin
{
    std::vector<MeasuredPoint> points;
    std::vector<Triangle> triangles;
};

/// Takes what a file of triangles has, in its order.
class TinSink
{
public:
    virtual ~TinSink() = default;
    virtual void add(const MeasuredPoint& point) = 0;
    virtual void add(const Triangle& triangle) = 0; ///< of points that were added before
};

/// Reads a file by its extension without holding it in memory. Errors: no such file; those of the format.
foundation::Outcome streamTinFile(const std::filesystem::path& file, TinSink& sink);

foundation::Outcome streamObj(std::string_view text, const std::string& name, TinSink& sink);
foundation::Outcome streamPly(std::string_view bytes, const std::string& name, TinSink& sink);

/// Reads the vertices and faces of a Wavefront OBJ text; all else is passed over, and faces of more corners
/// are cut into fans.
/// `name`: for messages. Errors: a vertex without three finite numbers, a face without three vertices or with
/// one that is not there, each with its line; no face.
foundation::Result<MeasuredTin> parseObj(std::string_view text, const std::string& name);

/// Reads the vertices (x, y, z) and faces of a PLY file, as text or in binary of either order; other
/// properties are passed over, and faces of more corners are cut into fans.
/// Source: Turk, *The PLY Polygon File Format* (1994).
/// Errors: no PLY file; a header that cannot be read; a file that ends too early; a value that is no finite
/// number; a face with a vertex that is not there; no face.
foundation::Result<MeasuredTin> parsePly(std::string_view bytes, const std::string& name);

/// Reads a tile of quantized-mesh 1.0. Its place on the globe follows from its header: the centre, and the
/// level from the size of its bounding sphere. Coordinates are metres from that centre on the tangent plane's
/// axes, scaled alike all over the tile (an equirectangular map about its middle latitude).
/// Source: *quantized-mesh-1.0 terrain format* (Cesium).
/// Errors: a file that ends too early; an index that is not there; a header that cannot be true.
foundation::Result<MeasuredTin> parseQuantizedMesh(std::string_view bytes, const std::string& name);

/// Whether the name of a file tells that readTinFile() reads it: .obj, .ply, .terrain.
bool isTinFile(const std::filesystem::path& file);

/// Reads a file by its extension. Errors: no such file, larger than 4 GiB; those of the format.
foundation::Result<MeasuredTin> readTinFile(const std::filesystem::path& file);

/// A TIN on a lattice.
struct PlacedTin
{
    SurfaceMesh mesh;
    PlanFrame frame;
    double mostMoved =
        0.0; ///< greatest distance of a place from its point of the lattice, in units of the input
};

/// Puts a TIN on a lattice, as placeOnLattice() does. Vertices at one place and height become one; clockwise
/// triangles are turned; points without a triangle are left out. `name`: for messages.
/// Errors: a triangle without area in the plan, or two points above each other: the surface has walls or
/// overhangs.
foundation::Result<PlacedTin> placeTin(const MeasuredTin& tin, const std::string& name);

} // namespace osgMultiTriangulation::core
