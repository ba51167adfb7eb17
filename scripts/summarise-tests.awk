# SPDX-License-Identifier: Apache-2.0
# awk -f scripts/summarise-tests.awk LastTest.log: what a run of ctest found, a line a test: "passed NAME", "failed NAME",
# "skipped real NAME: REASON" (for want of real data) or "skipped other NAME: REASON". A ctest test that is a suite of
# GoogleTest counts by the suite's tests; another program, or one that died before it could report, counts as one, "failed NAME, in SUITE.TEST".
function finishEntry()
{
    if (entry == "") return
    if (entrySkipped && !reported) print "skipped " (real ? "real " : "other ") entry ": "
    else if (entryPassed && !reported) print "passed " entry
    else if (!entryPassed && !entrySkipped && !failures) print "failed " entry (running ? ", in " running : "")
    entry = ""
}
# "[  FAILED  ] Suite.Test/0, where GetParam() = 7 (3 ms)" → "Suite.Test/0"
function nameIn(line) { sub(/^\[[^]]*\] /, "", line); sub(/ \([0-9]+ ms\)$/, "", line); sub(/,? where .*$/, "", line); return line }

/^[0-9]+\/[0-9]+ Testing: / {
    finishEntry()
    entry = $0
    sub(/^[^:]*: /, "", entry)
    reported = failures = entryPassed = entrySkipped = 0
    running = ""
    real = tolower(entry) ~ /real.?data/
    next
}
tolower($0) ~ /real.?data/ { real = 1 }
/^\[ RUN      \] / { reason = ""; running = nameIn($0) }
/^\[ .* \([0-9]+ ms\)$/ { running = "" }
reasonFollows { reason = $0; reasonFollows = 0 }
/: Skipped$/ { reasonFollows = 1 }
/^\[       OK \] .* \([0-9]+ ms\)$/ { print "passed " nameIn($0); reported++ }
/^\[  FAILED  \] .* \([0-9]+ ms\)$/ { print "failed " nameIn($0); reported++; failures++ }
/^\[  SKIPPED \] .* \([0-9]+ ms\)$/ {
    print "skipped " (tolower(nameIn($0) " " reason) ~ /real.?data/ ? "real " : "other ") nameIn($0) ": " reason
    reported++
}
/^Test Passed\.$/ { entryPassed = 1 }
/^Skip regular expression found in output/ { entrySkipped = 1 }
END { finishEntry() }
