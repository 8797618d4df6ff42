#!/bin/sh
# A sweep of pabd, its tasks dealt out to the ranks of MPI. Start it with: sh @file@ -n 64
# Options of mpirun go behind: sh @file@ -n 64 --hostfile nodes
exec mpirun "$@" @command@
