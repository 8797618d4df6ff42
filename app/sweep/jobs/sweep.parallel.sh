#!/bin/sh
# A sweep of pabd by GNU parallel. Start it with: sh @file@
# Options of parallel go behind: sh @file@ --sshloginfile nodes --jobs 16
seq 0 @last@ | exec parallel --jobs @processes@ --joblog @log@ "$@" @quoted_command@
