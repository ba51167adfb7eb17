// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include <pugixml.hpp>

#include "simulation/parser/ParseScenario.h"
#include "simulation/parser/XmlSource.h"
#include "simulation/scenario/Scenario.h"

namespace simulation
{

class CatalogShelf;
struct ElementCoverage;

/// The state of one reading: the visible parameters, the current file and the problems found. A strict
/// reading keeps the first problem only, and its caller returns it as the Error.
class ParseContext
{
public:
    using Scope = std::map<std::string, std::string, std::less<>>;

    ParseContext(const ParseOptions& options, const XmlSource& source, CatalogShelf& shelf);

    /// Reports an element that is not in effect, or that the standard has not, by its row of the table of
    /// elements. Each element is reported once.
    void foreign(pugi::xml_node node, const std::string& what);
    /// The same of an element where the standard demands one of a choice. A slip of the pen there (two
    /// letters at most) is a mistake: what its author meant would not be done. Others are of other programs.
    void foreignChoice(pugi::xml_node node, const std::string& what);
    /// Reports something about an element that is not in effect. `instead`: what is done instead.
    void unsupported(pugi::xml_node node, const std::string& what, const std::string& instead);
    /// Reports an element that is not in all in effect; the first of its name. A strict reading does not stop
    /// at it.
    void approximated(pugi::xml_node node, const ElementCoverage& coverage);
    /// Reports a controller of a kind that is not played. A strict reading does not stop at it.
    void controllerNotPlayed(pugi::xml_node node, const std::string& kind);
    /// Reports a slip that leaves one plain reading. `instead`: that reading.
    void assumed(pugi::xml_node node, const std::string& what, const std::string& instead);
    void invalid(pugi::xml_node node, const std::string& what, const std::string& remedy);
    void add(Problem problem);
    /// Reports what a text has that is not in its encoding.
    void tellNote(const XmlSource& source);

    /// Notes that a parser asks for an element or an attribute; reportUnread() reports the others.
    void touch(pugi::xml_node node) { _touched.insert(node.internal_object()); }
    void read(pugi::xml_attribute attribute) { _touched.insert(attribute.internal_object()); }
    bool isTouched(pugi::xml_node node) const { return _touched.contains(node.internal_object()); }
    bool isRead(pugi::xml_attribute attribute) const
    {
        return _touched.contains(attribute.internal_object());
    }
    bool isReported(pugi::xml_node node) const { return _reported.contains(node.internal_object()); }

    bool isStopped() const { return !options.tolerant && !problems.empty(); }
    std::string place(pugi::xml_node node) const;
    SourceLine line(pugi::xml_node node) const { return {_source->lineOf(node)}; }
    const XmlSource& source() const { return *_source; }

    std::optional<std::string> lookup(std::string_view name) const;

    /// Reads the ParameterDeclarations below `parent` into the innermost scope. A declaration sees the
    /// declarations before it. Values in `given` replace declared values.
    std::vector<ParameterDeclaration> declareParameters(pugi::xml_node parent, const Scope& given);
    void pushScope() { _scopes.emplace_back(); }
    void popScope() { _scopes.pop_back(); }

    const ParseOptions& options;
    CatalogShelf& shelf;
    std::vector<Problem> problems;
    std::set<std::string> entityNames;
    std::map<std::string, std::vector<std::string>> selections; ///< of entities: their members
    std::set<std::string> variableNames, monitorNames, signalControllerNames;
    bool hasRoads = false;                 ///< a LogicFile is named
    std::vector<std::string> catalogChain; ///< entries being read, outermost first: a repeated one is a cycle
    pugi::xml_node catalogEntry;           ///< the innermost entry, whose parameters are declared already
    std::map<std::string, int> elements;   ///< that reportUnread() has seen

private:
    friend class CatalogVisit;

    void checkConstraints(pugi::xml_node declaration, const std::string& value);

    const XmlSource* _source;
    std::vector<Scope> _scopes;
    std::unordered_set<const void*> _touched, _reported; ///< elements and attributes
    std::set<std::string_view> _approximated;            ///< elements that have been told
};

/// Opens a scope for the declarations of one element and closes it at the end of the block. The declarations
/// of a catalogue entry are in place already, with the values of its reference.
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
