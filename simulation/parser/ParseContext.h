// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <pugixml.hpp>

#include "simulation/parser/ParseScenario.h"
#include "simulation/parser/XmlSource.h"
#include "simulation/scenario/Scenario.h"

namespace simulation
{

class CatalogShelf;

/// The state of one reading: the visible parameters, the current file and the problems found. A strict reading keeps
/// the first problem only, and its caller returns it as the Error.
class ParseContext
{
public:
    using Scope = std::map<std::string, std::string, std::less<>>;

    ParseContext(const ParseOptions& options, const XmlSource& source, CatalogShelf& shelf);

    void unsupported(pugi::xml_node node, const std::string& what);
    void invalid(pugi::xml_node node, const std::string& what, const std::string& remedy);
    void add(Problem problem);

    bool isStopped() const { return !options.tolerant && !problems.empty(); }
    std::string place(pugi::xml_node node) const;
    SourceLine line(pugi::xml_node node) const { return {_source->lineOf(node)}; }
    const XmlSource& source() const { return *_source; }

    std::optional<std::string> lookup(std::string_view name) const;

    /// Reads the ParameterDeclarations below `parent` into the innermost scope. A declaration sees the declarations
    /// before it. Values in `given` replace declared values.
    std::vector<ParameterDeclaration> declareParameters(pugi::xml_node parent, const Scope& given);
    void pushScope() { _scopes.emplace_back(); }
    void popScope() { _scopes.pop_back(); }

    const ParseOptions& options;
    CatalogShelf& shelf;
    std::vector<Problem> problems;
    std::set<std::string> entityNames;
    std::vector<std::string> catalogChain; ///< entries being read, outermost first: a repeated one is a cycle
    pugi::xml_node catalogEntry;           ///< the innermost entry, whose parameters are declared already

private:
    friend class CatalogVisit;

    void checkConstraints(pugi::xml_node declaration, const std::string& value);

    const XmlSource* _source;
    std::vector<Scope> _scopes;
};

/// Opens a scope for the declarations of one element and closes it at the end of the block. The declarations of a
/// catalogue entry are in place already, with the values of its reference.
class ParameterScope
{
public:
    ParameterScope(ParseContext& context, pugi::xml_node parent) : _context(context)
    {
        _context.pushScope();
        if (parent != _context.catalogEntry) _context.declareParameters(parent, {});
    }
    ~ParameterScope() { _context.popScope(); }
    ParameterScope(const ParameterScope&) = delete;
    ParameterScope& operator=(const ParameterScope&) = delete;

private:
    ParseContext& _context;
};

} // namespace simulation
