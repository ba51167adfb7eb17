// SPDX-License-Identifier: Apache-2.0
#include "simulation/parser/CatalogShelf.h"

#include <algorithm>
#include <system_error>

#include "simulation/parser/CoverageWalk.h"
#include "simulation/scenario/NamedFile.h"

namespace simulation
{
namespace
{

constexpr std::size_t kMaximumFiles = 1000;

std::vector<std::filesystem::path> catalogFiles(const std::filesystem::path& folder)
{
    std::vector<std::filesystem::path> files;
    std::error_code code;
    for (std::filesystem::directory_iterator at(folder, code), end; !code && at != end; at.increment(code))
        if (at->path().extension() == ".xosc" && at->is_regular_file(code) && files.size() < kMaximumFiles)
            files.push_back(at->path());
    std::sort(files.begin(), files.end());
    return files;
}

ParseContext::Scope assignments(ElementReader& reference)
{
    ParseContext::Scope given;
    for (pugi::xml_node node : reference.node.child("ParameterAssignments").children("ParameterAssignment"))
    {
        ElementReader reader(reference.context, node);
        reader.has("parameterRef");
        std::string name = node.attribute("parameterRef").value(); // a name, with or without $: not a value
        if (!name.empty() && name.front() == '$') name.erase(0, 1);
        given[name] = reader.text("value");
    }
    return given;
}

} // namespace

void CatalogShelf::open(ParseContext& context, pugi::xml_node locations)
{
    for (pugi::xml_node location : locations.children())
    {
        const pugi::xml_node directory = location.child("Directory");
        if (!directory) continue;
        const std::string path = ElementReader(context, directory).text("path");
        if (path.empty()) continue;
        if (!_folder)
            context.invalid(directory, "a scenario in memory has no catalogues", "read it from its file");
        else
            openDirectory(context, directory, namedFile(*_folder, path).lexically_normal());
    }
}

void CatalogShelf::openDirectory(ParseContext& context, pugi::xml_node directory,
                                 const std::filesystem::path& path)
{
    std::error_code code;
    if (!_opened.insert(path).second) return;
    if (std::filesystem::is_regular_file(path, code)) return openFile(context, path);
    if (!std::filesystem::is_directory(path, code))
    {
        context.add({Problem::Kind::unsupported,
                     {context.place(directory), "the catalogue folder " + path.string() + " does not exist",
                      "instead: it has no entries; the path counts from the scenario's folder"}});
        return;
    }
    for (const std::filesystem::path& file : catalogFiles(path))
        openFile(context, file);
}

void CatalogShelf::openFile(ParseContext& context, const std::filesystem::path& file)
{
    foundation::Result<std::unique_ptr<XmlSource>> source =
        XmlSource::read(file, context.options.maximumBytes);
    if (source)
    {
        context.tellNote(**source);
        _sources.push_back(std::move(*source));
    }
    else
        context.add({Problem::Kind::invalid, source.error()});
}

CatalogShelf::Entry CatalogShelf::find(const std::string& catalog, const std::string& entry) const
{
    for (const bool byName : {true, false})
        for (const std::unique_ptr<XmlSource>& source : _sources)
            for (pugi::xml_node node : source->root().children("Catalog"))
            {
                const std::string name = byName ? node.attribute("name").value()
                                                : std::filesystem::path(source->name()).stem().string();
                if (name != catalog) continue;
                for (pugi::xml_node candidate : node.children())
                    if (entry == candidate.attribute("name").value()) return {source.get(), candidate};
            }
    return {};
}

CatalogVisit::CatalogVisit(ElementReader reference, const char* instead)
    : _context(reference.context),
      _outerSource(reference.context._source),
      _outerEntry(reference.context.catalogEntry)
{
    reference.allowChildren({"ParameterAssignments"});
    const std::string catalog = reference.text("catalogName");
    const std::string entry = reference.text("entryName");
    const ParseContext::Scope given = assignments(reference);
    const std::string key = catalog + "/" + entry;
    const CatalogShelf::Entry found = _context.shelf.find(catalog, entry);
    const bool isCycle = std::find(_context.catalogChain.begin(), _context.catalogChain.end(), key) !=
                         _context.catalogChain.end();
    if (!found.node && instead)
        _context.assumed(reference.node, "the catalogue entry " + key + " does not exist",
                         std::string(instead) + "; correct catalogName, entryName or CatalogLocations");
    else if (!found.node)
        _context.invalid(reference.node, "the catalogue entry " + key + " does not exist",
                         "correct catalogName, entryName or CatalogLocations");
    else if (isCycle)
        _context.invalid(reference.node, "the catalogue entry " + key + " contains itself",
                         "break the cycle");
    else
        _entry = found.node;
    _context.catalogChain.push_back(key);
    _context.pushScope();
    if (!_entry) return;
    _context._source = found.source;
    _context.catalogEntry = _entry;
    _context.declareParameters(_entry, given);
}

CatalogVisit::~CatalogVisit()
{
    if (_entry) reportUnread(_context, _entry);
    _context.catalogChain.pop_back();
    _context._source = _outerSource;
    _context.catalogEntry = _outerEntry;
    _context.popScope();
}

} // namespace simulation
