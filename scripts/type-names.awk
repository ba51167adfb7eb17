# SPDX-License-Identifier: Apache-2.0
# Reads C++ sources and fails when two of them define a type of one qualified name; see scripts/type-names.
# `head` holds the tokens since the last ';', '{' or '}'. scope[d] is what the d-th open brace opened: "::NAME" for a
# namespace or class, "" for extern "C", "-" for everything in which no type counts.

# Libraries are linked together, so they share their names; each folder of apps/ is a program, or a library of its own.
function groupOf(file,    parts) { return file ~ /^apps\// && split(file, parts, "/") > 2 ? parts[1] "/" parts[2] : "libraries" }

function failFile(what) { print "type-names: " file ": " what > "/dev/stderr"; failed = 1 }

function closeFile()
{
    if (file != "" && depth != 0) failFile("braces do not match; #if branches must open and close the same ones")
    depth = parens = heads = 0
    inComment = inDirective = 0
    rawEnd = ""
}

# The qualified name of the scope that is open, or "-" where no type counts.
function scopeName(    d, name)
{
    for (d = 1; d <= depth; ++d)
    {
        if (scope[d] == "-") return "-"
        name = name scope[d]
    }
    return name
}

function define(name,    outer, key)
{
    outer = scopeName()
    if (outer == "-" || name == "") return
    ++types
    key = groupOf(file) SUBSEP outer name
    if (!(key in definedIn)) definedIn[key] = file
    else if (definedIn[key] != file)
    {
        print "type-names: " substr(outer name, 3) ": defined in " definedIn[key] " and in " file > "/dev/stderr"
        failed = 1
    }
}

# The token after a bracketed list that opens at token i.
function skip(i, left, right,    level)
{
    for (; i <= heads; ++i)
    {
        if (head[i] == left) ++level
        else if (head[i] == right && --level == 0) return i + 1
    }
    return i
}

# The token that follows all template<…> at the start of the head.
function declarationStart(    i)
{
    for (i = 1; i <= heads && head[i] == "template" && head[i + 1] == "<";) i = skip(i + 1, "<", ">")
    return i
}

# The name that a class, struct, union or enum head defines, "" when it defines none: from the key at token i on.
function definedName(i,    name)
{
    if (head[i] == "enum" && (head[i + 1] == "class" || head[i + 1] == "struct")) ++i
    for (++i; i <= heads; ++i)
    {
        if (head[i] == "alignas" || head[i] == "__attribute__") i = skip(i + 1, "(", ")") - 1
        else if (head[i] == "[") i = skip(i, "[", "]") - 1
        else if (head[i] == ":" || head[i] == "final") return name
        else if (head[i] == "::") name = name "::" head[++i]
        else if (head[i] ~ /^[A-Za-z_]/) name = "::" head[i] # the last one: a macro may stand before
        else return "" # a specialisation or a function
    }
    return name
}

# What the brace after the head opens.
function opened(    i, name)
{
    if (parens > 0) return "-"
    i = declarationStart()
    if (head[i] == "inline" && head[i + 1] == "namespace") ++i
    if (head[i] == "namespace")
    {
        for (++i; i <= heads; ++i)
            if (head[i] ~ /^[A-Za-z_]/ && head[i] != "inline") name = name "::" head[i]
        return name == "" ? "-" : name
    }
    if (head[i] == "extern" && head[i + 1] == "\"") return ""
    for (; i <= heads; ++i)
    {
        if (head[i] == "(") i = skip(i, "(", ")") - 1
        else if (head[i] == "=") return "-"
        else if (head[i] ~ /^(class|struct|union|enum)$/)
        {
            name = definedName(i)
            define(name)
            return name == "" || head[i] == "enum" ? "-" : name
        }
    }
    return "-"
}

# What the ';' after the head ends: an alias defines its name.
function ended(    i)
{
    i = declarationStart()
    if (head[i] == "using" && head[i + 2] == "=") define("::" head[i + 1])
    else if (head[i] == "typedef" && head[heads] ~ /^[A-Za-z_]/) define("::" head[heads])
}

function take(token)
{
    if (token == "{")
    {
        scope[depth + 1] = opened()
        parensOutside[++depth] = parens
        parens = heads = 0
    }
    else if (token == "}")
    {
        if (depth == 0) failFile("a brace closes that none opened")
        else parens = parensOutside[depth--]
        heads = 0
    }
    else if (token == ";" && parens == 0)
    {
        ended()
        heads = 0
    }
    else if (token == ":" && heads == 1 && head[1] ~ /^(public|protected|private)$/) heads = 0
    else
    {
        if (token == "(") ++parens
        else if (token == ")") --parens
        head[++heads] = token
        delete head[heads + 1]
        delete head[heads + 2]
    }
}

# Reads a string that begins in rest; returns what follows it.
function skipString(rest,    mark)
{
    if (match(rest, /^R"[^(]*\(/))
    {
        mark = ")" substr(rest, 3, RLENGTH - 3) "\""
        rest = substr(rest, RLENGTH + 1)
        if (!index(rest, mark))
        {
            rawEnd = mark
            return ""
        }
        return substr(rest, index(rest, mark) + length(mark))
    }
    match(rest, /^"([^"\\]|\\.)*"/)
    return RLENGTH > 0 ? substr(rest, RLENGTH + 1) : ""
}

# The rest of a line after what an earlier line has left open: a comment, a raw string, a preprocessor directive.
function continued(line,    at)
{
    if (inComment)
    {
        if (!(at = index(line, "*/"))) return ""
        inComment = 0
        return substr(line, at + 2)
    }
    if (rawEnd != "")
    {
        if (!(at = index(line, rawEnd))) return ""
        line = substr(line, at + length(rawEnd))
        rawEnd = ""
        return line
    }
    if (inDirective || line ~ /^[ \t]*#/)
    {
        inDirective = line ~ /\\$/
        return ""
    }
    return line
}

FNR == 1 {
    closeFile()
    file = FILENAME
    ++files
}

{
    rest = continued($0)
    while (rest != "")
    {
        if (match(rest, /^[ \t\r]+/)) rest = substr(rest, RLENGTH + 1)
        else if (rest ~ /^\/\//) break
        else if (rest ~ /^\/\*/)
        {
            inComment = 1
            rest = continued(substr(rest, 3))
        }
        else if (rest ~ /^(R)?"/)
        {
            take("\"")
            rest = skipString(rest)
        }
        else if (match(rest, /^'([^'\\]|\\.[^']*)'/)) rest = substr(rest, RLENGTH + 1)
        else if (match(rest, /^([A-Za-z_][A-Za-z_0-9]*|[0-9][0-9A-Za-z_.']*|::)/))
        {
            take(substr(rest, 1, RLENGTH))
            rest = substr(rest, RLENGTH + 1)
        }
        else
        {
            take(substr(rest, 1, 1))
            rest = substr(rest, 2)
        }
    }
}

END {
    closeFile()
    if (types == 0)
    {
        print "type-names: no type was read" > "/dev/stderr"
        failed = 1
    }
    if (failed) exit 1
    print "type-names: " types " types in " files " files, each name defined in one file"
}
