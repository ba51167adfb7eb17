// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "SourceText.h"

/// The graph of include lines: each file is read once, when it is asked for first, and files that are not
/// found are left out. All units share one list of folders, so that a header brings the same wherever it is
/// included.
class IncludeGraph
{
public:
    using File = int; ///< its place in the graph

    /// folders: where names are looked up, in this order. A file below `root` is read from the same place
    /// below `overlay` if it is there; of the files elsewhere only those in `known` are followed, so that
    /// headers of other machines and languages do not count.
    IncludeGraph(std::vector<std::string> folders, const std::filesystem::path& root,
                 const std::filesystem::path& overlay, std::set<std::string> known);

    /// The file of an absolute path; -1 if there is none.
    File find(const std::string& path);
    const std::string& path(File file) const { return _nodes[file].path; }

    /// All files that one includes, itself first, each once; with each the file in the list that includes it
    /// first.
    std::vector<std::pair<File, File>> closure(File file);
    /// The lines of the closure.
    long weight(File file);
    /// The lines of the file alone.
    long lines(File file) { return read(file).lines; }
    /// The include chain from one file to another, with names below the root: "a.h > b.h > vector".
    std::string chain(File from, File to);

private:
    struct Node
    {
        std::string path;
        int folder = -1; ///< index of the folder that it was found in; -1: beside the including file
        bool read = false;
        long lines = 0;
        std::vector<File> includes;
    };

    Node& read(File file);
    File resolve(const Node& from, const IncludeLine& line);
    File lookUp(const std::string& name, int firstFolder);
    File add(const std::string& path, int folder);
    std::string shadow(const std::string& path) const;
    bool present(const std::string& path);

    std::vector<std::string> _folders;
    std::string _root, _overlay;
    std::set<std::string> _known;
    std::vector<Node> _nodes;
    std::unordered_map<std::string, File> _byPath;
    std::unordered_map<std::string, File> _byName; ///< of names looked up from the first folder on
    std::unordered_map<std::string, bool> _present;
};
