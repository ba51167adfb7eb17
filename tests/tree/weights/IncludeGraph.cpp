// SPDX-License-Identifier: Apache-2.0
#include "IncludeGraph.h"

#include <fstream>
#include <iterator>

namespace
{

std::string contentsOf(const std::string& path)
{
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

} // namespace

IncludeGraph::IncludeGraph(std::vector<std::string> folders, const std::filesystem::path& root,
                           const std::filesystem::path& overlay, std::set<std::string> known)
    : _folders(std::move(folders)),
      _root(root.string() + "/"),
      _overlay(overlay.empty() ? "" : overlay.string() + "/"),
      _known(std::move(known))
{
}

IncludeGraph::File IncludeGraph::find(const std::string& path)
{
    const std::string normal = std::filesystem::path(path).lexically_normal().string();
    return present(normal) ? add(normal, -1) : -1;
}

std::vector<std::pair<IncludeGraph::File, IncludeGraph::File>> IncludeGraph::closure(File file)
{
    std::vector<std::pair<File, File>> found{{file, -1}};
    read(file);
    std::vector<bool> seen(_nodes.size());
    seen[file] = true;
    for (std::size_t i = 0; i < found.size(); ++i)
    {
        const File from = found[i].first;
        read(from); // may add nodes
        seen.resize(_nodes.size());
        for (const File to : _nodes[from].includes)
            if (!seen[to]) seen[to] = true, found.emplace_back(to, from);
    }
    return found;
}

long IncludeGraph::weight(File file)
{
    long sum = 0;
    for (const auto& [each, from] : closure(file))
        sum += _nodes[each].lines;
    return sum;
}

std::string IncludeGraph::chain(File from, File to)
{
    std::unordered_map<File, File> includer;
    for (const auto& [each, by] : closure(from))
        includer.emplace(each, by);
    if (!includer.contains(to)) return {};
    std::string text;
    for (File at = to; at != -1; at = includer[at])
    {
        std::string name = _nodes[at].path;
        if (name.starts_with(_root))
            name = name.substr(_root.size());
        else if (_nodes[at].folder >= 0)
            name = name.substr(_folders[_nodes[at].folder].size() + 1);
        text = text.empty() ? name : name + " > " + text;
    }
    return text;
}

IncludeGraph::Node& IncludeGraph::read(File file)
{
    if (_nodes[file].read) return _nodes[file];
    _nodes[file].read = true;
    const SourceText source = readSourceText(contentsOf(shadow(_nodes[file].path)));
    std::vector<File> includes;
    for (const IncludeLine& line : source.includes)
        if (const File included = resolve(_nodes[file], line); included >= 0) includes.push_back(included);
    _nodes[file].lines = source.lines;
    _nodes[file].includes = std::move(includes);
    return _nodes[file];
}

IncludeGraph::File IncludeGraph::resolve(const Node& from, const IncludeLine& line)
{
    if (line.name.starts_with('/')) return find(line.name);
    if (line.next) return lookUp(line.name, from.folder + 1);
    if (line.quoted)
    {
        const std::filesystem::path beside = std::filesystem::path(from.path).parent_path() / line.name;
        const std::string path = beside.lexically_normal().string();
        if (present(path)) return add(path, -1);
    }
    const auto [known, isNew] = _byName.try_emplace(line.name, -1);
    if (!isNew) return known->second;
    const File found = lookUp(line.name, 0);
    return _byName[line.name] = found;
}

IncludeGraph::File IncludeGraph::lookUp(const std::string& name, int firstFolder)
{
    for (std::size_t i = firstFolder; i < _folders.size(); ++i)
    {
        const std::string path = std::filesystem::path(_folders[i] + "/" + name).lexically_normal().string();
        if (present(path)) return add(path, static_cast<int>(i));
    }
    return -1;
}

IncludeGraph::File IncludeGraph::add(const std::string& path, int folder)
{
    const auto [place, isNew] = _byPath.try_emplace(path, static_cast<File>(_nodes.size()));
    if (isNew) _nodes.push_back({path, folder, false, 0, {}});
    return place->second;
}

std::string IncludeGraph::shadow(const std::string& path) const
{
    if (_overlay.empty() || !path.starts_with(_root)) return path;
    const std::string over = _overlay + path.substr(_root.size());
    return std::filesystem::is_regular_file(over) ? over : path;
}

bool IncludeGraph::present(const std::string& path)
{
    if (!path.starts_with(_root)) return _known.contains(path);
    const auto [place, isNew] = _present.try_emplace(path, false);
    if (isNew) place->second = std::filesystem::is_regular_file(shadow(path));
    return place->second;
}
