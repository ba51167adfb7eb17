# SPDX-License-Identifier: Apache-2.0
# awk -f scripts/comment-lines.awk [-v check=1] FILE…: keeps the comments of C++ sources within `width` columns (110). From a line that
# is longer on, its paragraph is filled anew; a comment behind code that does not fit goes above it. With check=1 nothing is written: the
# lines that are too long are named, FILE:LINE: each, and the exit status is 1 where there are any. A word longer than a line stays.

function columns(text)
{
    gsub(/[\200-\277]/, "", text) # all but the first byte of a character in UTF-8
    return length(text)
}

# What stands before the words of a line that is a comment alone; empty for other lines.
function lead(line) { return match(line, /^ *\/\/(\/<?)? /) ? substr(line, 1, RLENGTH) : "" }

# Whether a text begins a paragraph: a tag of a doc comment, an item of a list, a row of a table, a line that is set in.
function begins(text) { return text ~ /^([A-Z][A-Za-z ]*:( |$)|`[^`]*`(, `[^`]*`)*:|[-*|@] ?|[0-9]+\. | |NOLINT|clang-format|SPDX)/ }

# Adds a paragraph of words to what is written.
function fill(before, text,    words, count, i, line)
{
    count = split(text, words, " ")
    line = before words[1]
    for (i = 2; i <= count; i++) {
        if (columns(line " " words[i]) > width) {
            out[++outCount] = line
            line = before words[i]
        } else {
            line = line " " words[i]
        }
    }
    out[++outCount] = line
}

# The column at which a line that is set in, or an item of a list, goes on below: that of its last cell, or two behind where it begins.
function columnOf(text) { return text !~ /^- / && match(text, /^ *[^ ]+.*  +[^ ]/) ? RLENGTH - 1 : match(text, /[^ ]/) + 1 }

# Adds a row of a table, a formula, or an item: what is too much goes below, from a column on.
function hang(before, text, column,    rest, i)
{
    while (columns(before text) > width) {
        for (i = length(text); i > column + 1 && (substr(text, i, 1) != " " || columns(before substr(text, 1, i - 1)) > width); i--) {}
        if (i <= column + 1) break
        rest = substr(text, i + 1)
        sub(/ +$/, "", text)
        out[++outCount] = before substr(text, 1, i - 1)
        text = sprintf("%*s%s", column, "", rest)
    }
    out[++outCount] = before text
}

# Adds a line of code whose comment goes above the first line of its declaration.
function lift(line,    code, text, first, above, i)
{
    match(line, / *\/\/\/< /)
    code = substr(line, 1, RSTART - 1)
    text = substr(line, RSTART + RLENGTH)
    first = outCount + 1
    while (first > 1 && out[first - 1] !~ /([;,{}:)]|[^\/]\/\/.*)$|^ *(\/\/.*|#.*)?$/) first--
    for (i = outCount; i >= first; i--) above[i] = out[i]
    i = outCount
    outCount = first - 1
    above[i + 1] = code
    match(above[first], /^ */)
    fill(substr(above[first], 1, RLENGTH) "/// ", text)
    for (; first <= i + 1; first++) out[++outCount] = above[first]
}

function isTooLong(line,    before, rest)
{
    if (columns(line) <= width) return 0
    before = lead(line)
    if (before == "") return match(line, / \/\/\/< /) > 0
    rest = substr(line, length(before) + 1)
    return rest ~ / / && !(rest ~ /^(NOLINT|clang-format)/)
}

# Names the lines of the file that was read that are too long.
function name(    n)
{
    for (n = 1; n <= count; n++)
        if (isTooLong(lines[n])) {
            printf "%s:%d:\n", file, n
            isWrong = 1
        }
}

# Writes the file that was read anew, where a line of it is too long.
function write(    n, before, text, column)
{
    for (n = 1; n <= count && !isTooLong(lines[n]); n++) {}
    if (n > count) return
    outCount = 0
    for (n = 1; n <= count; n++) {
        before = lead(lines[n])
        if (!isTooLong(lines[n])) {
            out[++outCount] = lines[n]
        } else if (before == "") {
            lift(lines[n])
        } else if (substr(lines[n], length(before) + 1) ~ /^(- | )/) {
            text = substr(lines[n], length(before) + 1)
            column = columnOf(text)
            while (n < count && lead(lines[n + 1]) == before && match(substr(lines[n + 1], length(before) + 1), /[^ ]/) == column + 1)
                text = text " " substr(lines[++n], length(before) + column + 1)
            hang(before, text, column)
        } else {
            text = substr(lines[n], length(before) + 1)
            while (n < count && lead(lines[n + 1]) == before && !begins(substr(lines[n + 1], length(before) + 1)))
                text = text " " substr(lines[++n], length(before) + 1)
            fill(before, text)
        }
    }
    for (n = 1; n <= outCount; n++) print out[n] > file
    close(file)
}

function end() { if (check) name(); else write() }

BEGIN { if (!width) width = 110 }
FNR == 1 { if (file != "") end(); file = FILENAME; count = 0 }
{ lines[++count] = $0 }
END {
    if (file != "") end()
    exit isWrong
}
