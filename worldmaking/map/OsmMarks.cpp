// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/map/OsmMarks.h"

#include <cstdlib>
#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <expat.h>
#include <osmium/io/any_input.hpp>
#include <osmium/io/detail/read_write.hpp>

namespace worldmaking
{

namespace
{

/// The order of objects in plain files.
int rankOf(char type)
{
    return type == 'n' ? 0 : type == 'w' ? 1 : 2;
}

/// Looks at one object after the other.
class PlainOrder
{
public:
    /// Whether the objects so far are in order.
    bool take(char type, std::int64_t id, bool isVisible)
    {
        const bool isLater =
            !_last || rankOf(type) > rankOf(_last->first) || (type == _last->first && id > _last->second);
        _last = OsmKey(type, id);
        return isLater && isVisible && id > 0;
    }

private:
    std::optional<OsmKey> _last;
};

/// Reads the marks of XML by expat: libosmium passes over `action`.
class XmlMarkReader
{
public:
    explicit XmlMarkReader(OsmMarks& marks) : _marks(marks), _parser(XML_ParserCreate(nullptr))
    {
        XML_SetUserData(_parser.get(), this);
        XML_SetElementHandler(
            _parser.get(),
            [](void* self, const char* name, const char** attributes)
            { static_cast<XmlMarkReader*>(self)->begin(name, attributes); },
            [](void*, const char*) {});
        XML_SetEntityDeclHandler(
            _parser.get(),
            [](void* self, const char*, int, const char*, int, const char*, const char*, const char*,
               const char*) { XML_StopParser(static_cast<XmlMarkReader*>(self)->_parser.get(), XML_FALSE); });
    }

    /// Returns false where the text is not well-formed; libosmium tells why.
    bool read(const std::string& text, bool isLast)
    {
        return XML_Parse(_parser.get(), text.data(), static_cast<int>(text.size()), isLast ? 1 : 0) ==
               XML_STATUS_OK;
    }

private:
    struct ParserFree
    {
        void operator()(XML_Parser parser) const { XML_ParserFree(parser); }
    };

    void begin(std::string_view name, const char** attributes)
    {
        if (name == "osmChange") _marks.isPlain = false;
        if (name == "center") _marks.isPlain = false, _marks.centred.insert(_object);
        const bool isPlace = name == "nd";
        if (!isPlace && name != "node" && name != "way" && name != "relation") return;
        std::int64_t id = 0;
        bool isVisible = true;
        std::string_view action;
        for (; *attributes; attributes += 2)
        {
            const std::string_view key = attributes[0], value = attributes[1];
            if (isPlace && key == "lat") _marks.isPlain = false; // nodes within ways
            if (key == "id") id = std::strtoll(attributes[1], nullptr, 10);
            if (key == "visible") isVisible = value != "false";
            if (key == "action") action = value;
        }
        if (isPlace) return;
        const OsmKey object(name.front(), id);
        _object = object;
        if (action == "delete") _marks.deleted.insert(object);
        if (action == "modify") _marks.changed.insert(object);
        const bool isPlain = _order.take(object.first, id, isVisible && action != "delete");
        _marks.isPlain = _marks.isPlain && isPlain;
    }

    OsmMarks& _marks;
    PlainOrder _order;
    OsmKey _object{'n', 0}; ///< the last one
    std::unique_ptr<std::remove_pointer_t<XML_Parser>, ParserFree> _parser;
};

void readXml(const osmium::io::File& file, OsmMarks& marks)
{
    const int descriptor = osmium::io::detail::open_for_reading(file.filename());
    const auto unpacked =
        osmium::io::CompressionFactory::instance().create_decompressor(file.compression(), descriptor);
    XmlMarkReader reader(marks);
    bool isSound = true;
    for (std::string text = unpacked->read(); isSound && !text.empty(); text = unpacked->read())
        isSound = reader.read(text, false);
    unpacked->close();
}

void readObjects(const osmium::io::File& file, OsmMarks& marks)
{
    PlainOrder order;
    osmium::io::Reader reader(file, osmium::osm_entity_bits::nwr);
    const bool isSorted =
        reader.header().get("sorting") == "Type_then_ID" && !file.has_multiple_object_versions();
    bool isFirst = true;
    while (marks.isPlain && !(isSorted && !isFirst)) // of a sorted file ids below 0 come first
    {
        const osmium::memory::Buffer buffer = reader.read();
        if (!buffer) break;
        for (const auto& object : buffer.select<osmium::OSMObject>())
            marks.isPlain = marks.isPlain && order.take(osmium::item_type_to_char(object.type()), object.id(),
                                                        object.visible());
        isFirst = false;
    }
    reader.close();
}

} // namespace

OsmMarks marksOf(const osmium::io::File& file)
{
    OsmMarks marks;
    const bool isXml = file.format() == osmium::io::file_format::xml;
    const bool isPbf = file.format() == osmium::io::file_format::pbf;
    if (isXml)
        readXml(file, marks);
    else if (isPbf)
        readObjects(file, marks);
    marks.isPlain = marks.isPlain && (isXml || isPbf) &&
                    file.compression() != osmium::io::file_compression::bzip2 &&
                    !(isPbf && file.compression() != osmium::io::file_compression::none);
    return marks;
}

} // namespace worldmaking
