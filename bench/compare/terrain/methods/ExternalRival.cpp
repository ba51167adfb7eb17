// SPDX-License-Identifier: Apache-2.0
#include "compare/terrain/methods/ExternalRival.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>

#include <osgMultiTriangulation/core/input/TinFile.h>

#include "compare/terrain/methods/ShellRun.h"

namespace terraintool
{

namespace
{

using namespace osgTerrainROAM::core;
using foundation::Error;
using foundation::Result;

/// What a program made at an error.
struct MadeMesh
{
    DrawnMesh mesh;
    double processorS = 0.0;
};
using MadePtr = std::shared_ptr<const MadeMesh>;

/// A folder of one's own for files that pass by.
class PassingFolder
{
public:
    PassingFolder()
    {
        std::string name = (std::filesystem::temp_directory_path() / "terraintool-XXXXXX").string();
        if (mkdtemp(name.data())) _path = name;
    }
    ~PassingFolder()
    {
        std::error_code ignored;
        if (!_path.empty()) std::filesystem::remove_all(_path, ignored);
    }
    PassingFolder(const PassingFolder&) = delete;
    PassingFolder& operator=(const PassingFolder&) = delete;

    const std::filesystem::path& path() const { return _path; }

private:
    std::filesystem::path _path;
};

void writeHeights(const PlacedTile& tile, const std::filesystem::path& file)
{
    std::ofstream out(file, std::ios::binary);
    const int shift = tile.grid().exponent();
    for (int row = 0; row < tile.field().rows; ++row)
        for (int column = 0; column < tile.field().columns; ++column)
        {
            const float heightM = tile.samples().heightM(column << shift, row << shift);
            out.write(reinterpret_cast<const char*>(&heightM), sizeof heightM);
        }
}

/// A mesh of samples as it is drawn. Errors: a vertex that is no sample's place.
Result<DrawnMesh> drawnMeshOf(const osgMultiTriangulation::core::MeasuredTin& tin, const PlacedTile& tile,
                              const std::string& name)
{
    const int shift = tile.grid().exponent();
    DrawnMesh mesh;
    mesh.stepM = tile.frame().vertexStepM();
    for (const auto& p : tin.points)
    {
        const double column = std::round(p[0]), row = std::round(p[1]);
        if (column != p[0] || row != p[1] || column < 0 || row < 0 || column >= tile.field().columns ||
            row >= tile.field().rows)
            return Error{name,
                         "has a vertex at " + std::to_string(p[0]) + ", " + std::to_string(p[1]) +
                             ", where no sample is",
                         "let it write v column row height"};
        const GridPoint place{static_cast<int>(column) << shift, static_cast<int>(row) << shift};
        mesh.grid.push_back(place);
        mesh.vertices.push_back(meshVertex(
            tile.frame().positionOf(place.column, place.row, static_cast<float>(p[2])), place, mesh.stepM));
    }
    for (const auto& t : tin.triangles)
        mesh.triangles.push_back({{t[0], t[1], t[2]}});
    return mesh;
}

/// Calls the program, and keeps what it made.
class MeshProgram
{
public:
    MeshProgram(ExternalMethod method, std::shared_ptr<const RoamTile> tile)
        : _method(std::move(method)), _tile(std::move(tile))
    {
        writeHeights(_tile->tile, _folder.path() / "heights.f32");
    }

    const RoamTile& tile() const { return *_tile; }

    Result<MadePtr> at(double errorM)
    {
        const std::scoped_lock lock(_mutex);
        if (const auto found = _made.find(errorM); found != _made.end()) return found->second;
        auto made = make(errorM);
        if (!made)
        {
            _failure = made.error();
            return made.error();
        }
        if (_made.size() >= kKept) _made.erase(_made.begin());
        return _made[errorM] = std::make_shared<const MadeMesh>(std::move(*made));
    }

    std::optional<Error> failure() const
    {
        const std::scoped_lock lock(_mutex);
        return _failure;
    }

private:
    static constexpr std::size_t kKept = 4; ///< meshes

    Result<MadeMesh> make(double errorM) const
    {
        const PlacedTile& tile = _tile->tile;
        const auto mesh = _folder.path() / "mesh.obj";
        const auto run = runInShell(
            _method.command, {(_folder.path() / "heights.f32").string(), std::to_string(tile.field().columns),
                              std::to_string(tile.field().rows), std::to_string(errorM), mesh.string()});
        if (!run) return run.error();
        const auto tin = osgMultiTriangulation::core::readTinFile(mesh);
        if (!tin) return tin.error();
        auto drawn = drawnMeshOf(*tin, tile, _method.name);
        if (!drawn) return drawn.error();
        return MadeMesh{std::move(*drawn), run->processorS};
    }

    const ExternalMethod _method;
    const std::shared_ptr<const RoamTile> _tile;
    PassingFolder _folder;
    mutable std::mutex _mutex;
    std::map<double, MadePtr> _made; ///< by error, metres
    std::optional<Error> _failure;
};

/// The mesh of a program for one error, whatever the eye.
class ProgramMesh final : public RivalMesh
{
public:
    explicit ProgramMesh(std::shared_ptr<MeshProgram> program) : _program(std::move(program)) {}

    RefineResult refine(const viewlod::ViewState&, const viewlod::Budget& budget) override
    {
        RefineResult result;
        if (const auto made = _program->at(budget.errorTolerancePx)) _made = *made;
        result.triangles = result.leaves = static_cast<std::uint32_t>(drawnMesh().triangles.size());
        return result;
    }
    DrawnMesh drawn() const override { return drawnMesh(); }
    std::optional<LeafOrder> order() const override { return orderOf(drawnMesh()); }
    WrittenSlots written() const override { return {}; }
    bool isValid() const override { return true; }
    std::size_t memoryBytes() const override
    {
        return drawnMesh().vertices.size() * sizeof(MeshVertex) +
               drawnMesh().triangles.size() * sizeof(LeafTriangle);
    }
    double preparationS() const override { return _made ? _made->processorS : 0.0; }

private:
    const DrawnMesh& drawnMesh() const
    {
        static const DrawnMesh none;
        return _made ? _made->mesh : none;
    }

    std::shared_ptr<MeshProgram> _program;
    MadePtr _made;
};

} // namespace

Result<Rival> externalRival(const ExternalMethod& method, const std::shared_ptr<const RoamTile>& tile)
{
    constexpr double kCoarseM = 1000.0;
    const auto program = std::make_shared<MeshProgram>(method, tile);
    if (const auto tried = program->at(kCoarseM); !tried) return tried.error();
    Rival rival;
    rival.name = method.name;
    rival.adapts = rival.keepsCeiling = false;
    rival.newMesh = [program] { return std::make_unique<ProgramMesh>(program); };
    rival.failure = [program] { return program->failure(); };
    return rival;
}

} // namespace terraintool
