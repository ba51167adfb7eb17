// SPDX-License-Identifier: Apache-2.0
#include "StoredBuild.h"

#include <algorithm>
#include <limits>
#include <string>

#include "../split/HiddenWalk.h"
#include "../split/JobQueue.h"

namespace osgMultiTriangulation::core
{

namespace
{

/// Takes the hidden points of a part's rest one by one: chooses some, and writes all to a file.
class HiddenOutput
{
public:
    HiddenOutput(RecordFile<HiddenRecord>& file, const PartMesh& rest, std::uint64_t most)
        : _file(file),
          _selection(static_cast<std::uint32_t>(rest.measured.mesh.triangles.size()),
                     static_cast<std::uint32_t>(
                         most / std::max<std::size_t>(1, rest.measured.mesh.triangles.size())))
    {
    }

    void add(const SurfacePoint& point, std::uint32_t triangle, float errorM)
    {
        _selection.add(triangle, point, errorM);
        _run.push_back({point.height, point.x, point.y, triangle, 0});
        if (_run.size() == RecordFile<HiddenRecord>::kBuffered) addRun();
    }

    void finish(PartMesh& rest)
    {
        if (!_run.empty()) addRun();
        rest.allHidden = _file.size();
        _file.flush();
        rest.hiddenSum = _sum;
        _selection.moveInto(rest.measured);
    }

private:
    void addRun()
    {
        _sum = sumOfRecords(_run, _sum);
        for (const HiddenRecord& record : _run)
            _file.append(record);
        _run.clear();
    }

    RecordFile<HiddenRecord>& _file;
    HiddenSelection _selection;
    std::vector<HiddenRecord> _run;
    std::uint32_t _sum = 0;
};

/// Calls visit(point, triangle of the rest) for all hidden points of a part that was built.
template<class Visit>
foundation::Outcome visitHidden(const PartStore& store, std::uint32_t part, const Visit& visit)
{
    const auto rest = store.rest(part);
    if (!rest)
        return foundation::Error{store.folder().string(), "a finished part has disappeared", "start again"};
    if (rest->hasAllHidden())
    {
        for (std::uint32_t t = 0; t < rest->measured.mesh.triangles.size(); ++t)
            for (const SurfacePoint& point : rest->measured.hiddenOf(t))
                visit(point, t);
        return foundation::success();
    }
    const auto file = store.openHidden(part);
    if (!file) return file.error();
    file->scan(
        [&](std::span<const HiddenRecord> run)
        {
            for (const HiddenRecord& record : run)
                visit(record.point(), record.triangle);
        });
    return file->outcome();
}

} // namespace

StoredBuild::StoredBuild(const PartSource& source, const Partition& partition, const PartStore& store,
                         double heightStep, std::uint64_t mostHidden)
    : _source(source),
      _partition(partition),
      _store(store),
      _heightStep(heightStep),
      _mostHidden(mostHidden),
      _entries(partition.parts.size()),
      _locked(partition.parts.size())
{
}

std::vector<bool> StoredBuild::resume()
{
    std::vector<bool> isDone(_partition.parts.size(), false);
    for (std::uint32_t part = 0; part < isDone.size(); ++part)
    {
        const std::uint32_t parent = _partition.parts[part].parent;
        const auto tree = _store.tree(part);
        if (!tree || (parent != kNone && !isDone[parent] && !hasRest(part))) continue;
        isDone[part] = true;
        keep(part, *tree);
    }
    return isDone;
}

bool StoredBuild::hasRest(std::uint32_t part) const
{
    const auto rest = _store.rest(part);
    return rest && _store.isHiddenWhole(part, *rest);
}

bool StoredBuild::isDone(std::uint32_t part) const
{
    if (!_store.tree(part)) return false;
    const std::uint32_t parent = _partition.parts[part].parent;
    return parent == kNone || hasRest(part) || isDone(parent);
}

void StoredBuild::build(std::uint32_t part)
{
    PartHalves halves = halvesOf(part);
    const bool hasAll = halves[0].hasAllHidden() && halves[1].hasAllHidden();
    if (!outcome()) return;
    BuiltPart built = buildPart(_source, _partition, part, std::move(halves));
    if (built.fault) return note(foundation::Error{"the input", *built.fault, "repair the input"});
    if (!hasAll)
        measureAgain(part, built);
    else if (part != 0 && built.rest.allHidden > _mostHidden)
        thinOut(part, built);
    note(_source.outcome());
    if (!outcome()) return;
    if (part != 0) note(_store.putRest(part, built.rest));
    built.rest = {};
    const StoredTree tree{encodedTree(built.record, _partition.parts[part].parent, _heightStep),
                          built.locked};
    note(_store.putTree(part, tree));
    if (!outcome()) return;
    keep(part, tree);
    for (const std::uint32_t half : _partition.parts[part].halves)
        if (half != kNone) _store.dropRest(half);
}

PartHalves StoredBuild::halvesOf(std::uint32_t part)
{
    PartHalves halves;
    for (std::size_t place = 0; place < halves.size(); ++place)
    {
        const std::uint32_t half = _partition.parts[part].halves[place];
        if (half == kNone) continue;
        if (auto rest = _store.rest(half))
            halves[place] = std::move(*rest);
        else
            note(foundation::Error{_store.folder().string(), "a finished part has disappeared",
                                   "start the build again"});
    }
    return halves;
}

/// Measures the errors of a tree that was built with some of its hidden points over all of them.
void StoredBuild::measureAgain(std::uint32_t part, BuiltPart& built)
{
    MultiTriangulation& tree = built.record.part;
    HiddenWalk walk(tree);
    std::optional<RecordFile<HiddenRecord>> file;
    std::optional<HiddenOutput> output;
    if (part != 0)
    {
        auto created = _store.createHidden(part);
        if (!created) return note(created.error());
        file = std::move(*created);
        output.emplace(*file, built.rest, _mostHidden);
    }
    float error = 0.0f;
    std::size_t place = 0;
    for (const std::uint32_t half : _partition.parts[part].halves)
    {
        if (half == kNone) continue;
        const std::vector<std::uint32_t>& roots = built.record.childRoots[place++];
        note(visitHidden(_store, half,
                         [&](const SurfacePoint& point, std::uint32_t triangle)
                         {
                             const std::uint32_t root = walk.climb(point, roots[triangle], error);
                             if (output) output->add(point, root, error);
                         }));
    }
    for (std::uint32_t f = 0; f < tree.fragments.size(); ++f)
    {
        const std::uint32_t root = walk.climbFrom(f, error);
        if (output) output->add(tree.points[tree.rootPoints + f], root, error);
    }
    walk.finish();
    if (!output) return;
    output->finish(built.rest);
    note(file->outcome());
    note(_store.commitHidden(part));
    std::copy_n(tree.errors.begin(), tree.rootTriangles, built.rest.measured.errors.begin());
}

/// Puts the hidden points of a part that has all of them into a file, and keeps some.
void StoredBuild::thinOut(std::uint32_t part, BuiltPart& built)
{
    auto file = _store.createHidden(part);
    if (!file) return note(file.error());
    HiddenOutput output(*file, built.rest, _mostHidden);
    const MeasuredMesh& rest = built.rest.measured;
    for (std::uint32_t t = 0; t < rest.mesh.triangles.size(); ++t)
    {
        const Triangle& corners = rest.mesh.triangles[t];
        for (const SurfacePoint& point : rest.hiddenOf(t))
            output.add(point, t,
                       verticalDistance(point, rest.mesh.points[corners[0]], rest.mesh.points[corners[1]],
                                        rest.mesh.points[corners[2]]));
    }
    output.finish(built.rest);
    note(file->outcome());
    note(_store.commitHidden(part));
}

foundation::Outcome StoredBuild::outcome() const
{
    const std::lock_guard lock(_mutex);
    return _outcome;
}

foundation::Outcome StoredBuild::write(MtInfo info, const std::filesystem::path& file) const
{
    info.heightStep = _heightStep;
    return writeMtFile(file, info, _entries,
                       [this, &file](std::uint32_t part) -> foundation::Result<std::vector<std::byte>>
                       {
                           auto tree = _store.tree(part);
                           if (tree) return std::move(tree->encoded.bytes);
                           return foundation::Error{file.string(), "a finished part has disappeared",
                                                    "start the build again"};
                       });
}

ForestReport StoredBuild::report() const
{
    return reportOf(_partition, _locked, _entries[0].points);
}

void StoredBuild::keep(std::uint32_t part, const StoredTree& tree)
{
    _entries[part] = tree.encoded.entry;
    _locked[part] = tree.locked;
}

void StoredBuild::note(const foundation::Outcome& outcome)
{
    const std::lock_guard lock(_mutex);
    if (_outcome && !outcome) _outcome = outcome;
}

} // namespace osgMultiTriangulation::core
