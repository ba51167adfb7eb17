// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/map/JoinOsm.h"

#include <algorithm>
#include <cstdint>
#include <exception>
#include <limits>
#include <map>
#include <new>
#include <set>
#include <stdexcept>
#include <string>
#include <system_error>
#include <tuple>
#include <utility>

#include <cpl_conv.h>
#include <cpl_vsi.h>
#include <foundation/ReadableFile.h>
#include <foundation/WholeFile.h>
#include <osmium/builder/osm_object_builder.hpp>
#include <osmium/io/any_input.hpp>
#include <osmium/io/detail/read_write.hpp>
#include <osmium/io/pbf_output.hpp>

#include "worldmaking/map/OsmMarks.h"

namespace worldmaking
{

namespace
{

using foundation::Error;

/// A state of an object.
struct State
{
    const osmium::OSMObject* object = nullptr;
    std::int64_t id = 0; ///< in the joined file
    std::uint32_t file = 0;
    std::uint32_t version = 0;
    std::uint32_t place = 0; ///< among all states
    std::uint32_t weight = 0;
    bool isChange = false, isDeleted = false;
    bool hasMiddle = false; ///< the file gives its middle (Overpass, `out center`)

    auto order() const
    {
        return std::tuple(object->type(), id, version, isChange, isChange ? 0U : weight, place);
    }
};

std::uint32_t weightOf(const osmium::OSMObject& object)
{
    auto weight = static_cast<std::uint32_t>(object.tags().size());
    if (object.type() == osmium::item_type::way)
        weight += static_cast<std::uint32_t>(static_cast<const osmium::Way&>(object).nodes().size());
    return weight;
}

/// Gives new objects of editors ids above those of the map. Each file has its own.
class NewIds
{
public:
    void raise(osmium::item_type type, std::int64_t id)
    {
        std::int64_t& next = _next[type];
        constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max() / 2;
        next = std::max(next, std::min(id, kMost) + 1);
    }

    std::int64_t of(std::uint32_t file, osmium::item_type type, std::int64_t id)
    {
        if (id > 0) return id;
        const auto [found, isNew] = _known.try_emplace({file, type, id}, 0);
        if (isNew) found->second = std::max<std::int64_t>(_next[type], 1), _next[type] = found->second + 1;
        return found->second;
    }

    std::size_t count() const { return _known.size(); }

private:
    std::map<osmium::item_type, std::int64_t> _next;
    std::map<std::tuple<std::uint32_t, osmium::item_type, std::int64_t>, std::int64_t> _known;
};

/// A copy of a file of XML without the middles of objects, which libosmium refuses; it goes with this object.
/// Throws where the file cannot be read.
class FileWithoutMiddles
{
public:
    FileWithoutMiddles(const osmium::io::File& file, const std::filesystem::path& beside)
        : _path(beside.string() + ".part-whole.osm")
    {
        const int descriptor = osmium::io::detail::open_for_reading(file.filename());
        const auto unpacked =
            osmium::io::CompressionFactory::instance().create_decompressor(file.compression(), descriptor);
        std::string text;
        for (std::string piece = unpacked->read(); !piece.empty(); piece = unpacked->read())
            text += piece;
        unpacked->close();
        std::string kept;
        std::size_t from = 0;
        for (std::size_t at = text.find("<center"); at != std::string::npos; at = text.find("<center", from))
        {
            kept.append(text, from, at - from);
            const std::size_t end = text.find('>', at);
            if (end == std::string::npos) break;
            const std::string close = "</center>";
            const bool isEmpty = text[end - 1] == '/';
            const std::size_t last = isEmpty ? end + 1 : text.find(close, end) + close.size();
            from = std::max(last, end + 1);
        }
        kept.append(text, from);
        const auto written = foundation::writeWholeFile(_path, kept);
        if (!written) throw std::runtime_error(written.error().message());
    }
    ~FileWithoutMiddles()
    {
        std::error_code ignored;
        std::filesystem::remove(_path, ignored);
    }
    FileWithoutMiddles(const FileWithoutMiddles&) = delete;
    FileWithoutMiddles& operator=(const FileWithoutMiddles&) = delete;

    osmium::io::File file() const { return osmium::io::File(_path.string()); }

private:
    std::filesystem::path _path;
};

/// Collects the states of objects from files, and writes those that stay.
class OsmJoiner
{
public:
    /// Throws what libosmium throws.
    void read(const osmium::io::File& file, const OsmMarks& marks)
    {
        osmium::io::Reader reader(file, osmium::osm_entity_bits::nwr);
        const bool isChangeFile = file.filename().find(".osc") != std::string::npos ||
                                  file.filename().find(".o5c") != std::string::npos;
        while (osmium::memory::Buffer buffer = reader.read())
        {
            for (const auto& object : buffer.select<osmium::OSMObject>())
                take(object, isChangeFile, marks);
            _buffers.push_back(std::move(buffer)); // it keeps its place in memory
        }
        reader.close();
        ++_files;
    }

    void write(const std::filesystem::path& path, JoinReport& report)
    {
        choose(report);
        osmium::io::Header header;
        header.set("generator", "osgTrainer worldtool");
        osmium::io::Writer writer(osmium::io::File(path.string(), "pbf,add_metadata=false"), header,
                                  osmium::io::overwrite::allow);
        writeNodes(writer);
        for (const State& state : _states)
            if (state.object->type() != osmium::item_type::node) writeOther(writer, state);
        writer.close();
        report.files = _files;
        report.objects = _states.size();
        report.middles = middles();
        report.renumbered = _renumbered;
        report.isJoined = true;
    }

private:
    void take(const osmium::OSMObject& object, bool isChangeFile, const OsmMarks& marks)
    {
        const OsmKey key(osmium::item_type_to_char(object.type()), object.id());
        State state;
        state.object = &object;
        state.file = _files;
        state.isDeleted = !object.visible() || marks.deleted.contains(key);
        state.isChange = isChangeFile || state.isDeleted || marks.changed.contains(key);
        state.version = object.version();
        if (state.version == 0 && state.isChange) state.version = std::numeric_limits<std::uint32_t>::max();
        state.place = static_cast<std::uint32_t>(_states.size());
        state.weight = weightOf(object);
        state.hasMiddle = marks.centred.contains(key);
        if (object.id() > 0) _ids.raise(object.type(), object.id());
        _states.push_back(state);
    }

    /// Keeps of each object the state that counts.
    void choose(JoinReport& report)
    {
        for (State& state : _states)
            state.id = _ids.of(state.file, state.object->type(), state.object->id());
        _renumbered = _ids.count();
        std::sort(_states.begin(), _states.end(),
                  [](const State& a, const State& b) { return a.order() < b.order(); });
        std::vector<State> kept;
        for (std::size_t i = 0; i < _states.size(); ++i)
        {
            const State& state = _states[i];
            const bool isLast = i + 1 == _states.size() || _states[i + 1].id != state.id ||
                                _states[i + 1].object->type() != state.object->type();
            const bool isNode = state.object->type() == osmium::item_type::node;
            if (!isLast)
                ++report.repeated;
            else if (state.isDeleted)
                ++report.deleted;
            else if (!isNode || static_cast<const osmium::Node&>(*state.object).location().valid())
                kept.push_back(state);
        }
        _states = std::move(kept);
    }

    /// How many ways and relations with a middle have nothing else: none of their nodes, or of their ways.
    std::size_t middles() const
    {
        if (std::none_of(_states.begin(), _states.end(), [](const State& state) { return state.hasMiddle; }))
            return 0;
        std::set<std::int64_t> nodes, placed;
        for (const State& state : _states)
            if (state.object->type() == osmium::item_type::node) nodes.insert(state.object->id());
        std::size_t count = 0;
        for (const State& state : _states) // ways come before relations
        {
            bool hasPlace = false;
            if (state.object->type() == osmium::item_type::way)
                for (const auto& node : static_cast<const osmium::Way&>(*state.object).nodes())
                    hasPlace = hasPlace || node.location().valid() || nodes.contains(node.ref());
            if (state.object->type() == osmium::item_type::relation)
                for (const auto& member : static_cast<const osmium::Relation&>(*state.object).members())
                    hasPlace = hasPlace ||
                               (member.type() == osmium::item_type::way && placed.contains(member.ref()));
            if (hasPlace && state.object->type() == osmium::item_type::way) placed.insert(state.object->id());
            count += state.hasMiddle && !hasPlace ? 1 : 0;
        }
        return count;
    }

    /// The nodes, and those that only stand within ways.
    void writeNodes(osmium::io::Writer& writer)
    {
        std::map<std::int64_t, osmium::Location> within;
        const auto lastNode =
            std::find_if(_states.begin(), _states.end(),
                         [](const State& state) { return state.object->type() != osmium::item_type::node; });
        for (auto state = lastNode; state != _states.end(); ++state)
            if (state->object->type() == osmium::item_type::way)
                for (const auto& node : static_cast<const osmium::Way&>(*state->object).nodes())
                    if (node.location().valid())
                        within.emplace(_ids.of(state->file, osmium::item_type::node, node.ref()),
                                       node.location());
        auto next = within.begin();
        for (auto state = _states.begin(); state != lastNode; ++state)
        {
            for (; next != within.end() && next->first < state->id; ++next)
                writeNode(writer, next->first, next->second, nullptr);
            if (next != within.end() && next->first == state->id) ++next;
            const auto& node = static_cast<const osmium::Node&>(*state->object);
            writeNode(writer, state->id, node.location(), &node.tags());
        }
        for (; next != within.end(); ++next)
            writeNode(writer, next->first, next->second, nullptr);
    }

    void writeNode(osmium::io::Writer& writer, std::int64_t id, const osmium::Location& place,
                   const osmium::TagList* tags)
    {
        {
            osmium::builder::NodeBuilder builder(_made);
            builder.set_id(id).set_location(place);
            if (tags && !tags->empty()) builder.add_item(*tags);
        }
        pass(writer);
    }

    void writeOther(osmium::io::Writer& writer, const State& state)
    {
        if (state.object->type() == osmium::item_type::way)
        {
            const auto& way = static_cast<const osmium::Way&>(*state.object);
            osmium::builder::WayBuilder builder(_made);
            builder.set_id(state.id);
            builder.add_item(way.tags());
            osmium::builder::WayNodeListBuilder nodes(builder);
            for (const osmium::NodeRef& node : way.nodes())
                nodes.add_node_ref(_ids.of(state.file, osmium::item_type::node, node.ref()));
        }
        else
        {
            const auto& relation = static_cast<const osmium::Relation&>(*state.object);
            osmium::builder::RelationBuilder builder(_made);
            builder.set_id(state.id);
            builder.add_item(relation.tags());
            osmium::builder::RelationMemberListBuilder members(builder);
            for (const osmium::RelationMember& member : relation.members())
                members.add_member(member.type(), _ids.of(state.file, member.type(), member.ref()),
                                   member.role());
        }
        pass(writer);
    }

    /// Passes the object that was built to the writer.
    void pass(osmium::io::Writer& writer)
    {
        _made.commit();
        writer(_made.get<osmium::memory::Item>(0));
        _made.clear();
    }

    osmium::memory::Buffer _made{4096, osmium::memory::Buffer::auto_grow::yes};
    std::vector<osmium::memory::Buffer> _buffers;
    std::vector<State> _states;
    NewIds _ids;
    std::uint32_t _files = 0;
    std::size_t _renumbered = 0;
};

/// A file on disk: the source, or a copy of what an archive holds of it, which goes with this object.
class UnpackedFile
{
public:
    UnpackedFile(const MapSource& source, const std::filesystem::path& joined) : _path(source.file)
    {
        if (!source.isInArchive()) return;
        const std::string name = std::filesystem::path(source.file).filename().string();
        _path = joined.string() + ".part-" + name;
        _isOwn = true;
        _isWhole = CPLCopyFile(_path.c_str(), source.file.c_str()) == 0;
    }
    ~UnpackedFile()
    {
        std::error_code ignored;
        if (_isOwn) std::filesystem::remove(_path, ignored);
    }
    UnpackedFile(const UnpackedFile&) = delete;
    UnpackedFile& operator=(const UnpackedFile&) = delete;

    const std::string& path() const { return _path; }
    bool isWhole() const { return _isWhole; }

private:
    std::string _path;
    bool _isOwn = false, _isWhole = true;
};

Error damaged(const std::string& name, const std::string& why)
{
    return {name, "cannot be read as OpenStreetMap data: " + why,
            "give an .osm, .osm.gz, .osm.bz2, .osm.pbf, .o5m or .osc file, and check that it is complete"};
}

/// What is read now, for errors.
struct Reading
{
    std::string name;
};

foundation::Result<std::filesystem::path> join(const std::vector<MapSource>& sources,
                                               const std::filesystem::path& joined, JoinReport& report,
                                               Reading& reading)
{
    OsmJoiner joiner;
    for (const MapSource& source : sources)
    {
        reading.name = source.file;
        const UnpackedFile unpacked(source, joined);
        if (!unpacked.isWhole())
            return Error{source.file, "cannot be unpacked beside " + joined.string(),
                         "unpack the archive, and check that the disk has room"};
        if (const auto readable = foundation::checkReadable(unpacked.path()); !readable)
            return readable.error();
        const osmium::io::File file(unpacked.path());
        const OsmMarks marks = marksOf(file);
        if (marks.isPlain && sources.size() == 1 && !source.isInArchive())
        {
            report.files = 1;
            return std::filesystem::path(source.file);
        }
        if (marks.centred.empty())
            joiner.read(file, marks);
        else
            joiner.read(FileWithoutMiddles(file, joined).file(), marks);
    }
    reading.name = joined.string();
    joiner.write(joined, report);
    return joined;
}

} // namespace

foundation::Result<std::filesystem::path> joinOsm(const std::vector<MapSource>& sources,
                                                  const std::filesystem::path& joined, JoinReport& report)
{
    Reading reading;
    try
    {
        return join(sources, joined, report, reading);
    }
    catch (const std::bad_alloc&)
    {
        return Error{reading.name, "does not fit into memory",
                     "raise the limit (ulimit -v), or cut a part out with osmium extract"};
    }
    catch (const std::exception& failed)
    {
        if (reading.name == joined.string())
            return Error{reading.name, std::string("cannot be written: ") + failed.what(),
                         "check that the folder can be written and the disk has room"};
        return damaged(reading.name, failed.what());
    }
}

} // namespace worldmaking
