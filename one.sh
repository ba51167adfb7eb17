# one.sh OBJ flags.. : compile the object w/ flag replacement, print time
obj=$1; shift
cmd=$(ninja -C . -t commands $obj 2>/dev/null | grep -- "-o $obj " | tail -1 | sed 's#^/tmp/tl ##; s#/tmp/tl ##')
cmd=${cmd/-o $obj/-o /tmp/one.o}
[ -n "$REPL" ] && cmd=${cmd/$REPL/}
( time eval "$cmd $*" ) 2>&1 | grep -E "user|error" 
