# SPDX-License-Identifier: Apache-2.0
# awk -f scripts/comment-lines.awk [-v check=1] FILE: writes a C++ source whose comments keep within `width` columns: from a line that is
# longer, its paragraph is filled anew; a comment behind code that does not fit stands above it. With check=1 the lines that are too
# long are named instead, FILE:LINE: each, and the exit status is 1 where there are any. A word that is longer than a line stays.

function columns(text)
{
    gsub(/[\200-\277]/, "", text) # all but the first byte of a character in UTF-8
    return length(text)
}

# What stands before the words of a line that is a comment alone; empty for other lines.
function lead(line) { return match(line, /^ *\/\/(\/<?)? /) ? substr(line, 1, RLENGTH) : "" }

# Whether a text begins a paragraph: a tag of a doc comment, an item of a list, a row of a table, a line that is set in.
function begins(text) { return text ~ /^([A-Z][A-Za-z ]*:( |$)|`[^`]*`(, `[^`]*`)*:|[-*|@] ?|[0-9]+\. |  |NOLINT|clang-format|SPDX)/ }

# Fills a paragraph of words.
function fill(before, text,    words, count, i, line)
{
    count = split(text, words, " ")
    line = before words[1]
    for (i = 2; i <= count; i++) {
        if (columns(line " " words[i]) > width) {
            print line
            line = before words[i]
        } else {
            line = line " " words[i]
        }
    }
    print line
}

function isTooLong(line,    before, rest)
{
    if (columns(line) <= width) return 0
    before = lead(line)
    if (before == "") return match(line, / \/\/\/< /) > 0
    rest = substr(line, length(before) + 1)
    return rest ~ / / && !(rest ~ /^(NOLINT|clang-format)/)
}

BEGIN { if (!width) width = 110 }
{ lines[NR] = $0 }
END {
    for (n = 1; n <= NR; n++) {
        if (!isTooLong(lines[n])) {
            if (!check) print lines[n]
            continue
        }
        if (check) {
            printf "%s:%d:\n", FILENAME, n
            isWrong = 1
            continue
        }
        before = lead(lines[n])
        if (before == "") {
            match(lines[n], / *\/\/\/< /)
            code = substr(lines[n], 1, RSTART - 1)
            text = substr(lines[n], RSTART + RLENGTH)
            match(code, /^ */)
            fill(substr(code, 1, RLENGTH) "/// ", text)
            print code
            continue
        }
        text = substr(lines[n], length(before) + 1)
        while (n < NR && lead(lines[n + 1]) == before && !begins(substr(lines[n + 1], length(before) + 1)))
            text = text " " substr(lines[++n], length(before) + 1)
        fill(before, text)
    }
    exit isWrong
}
