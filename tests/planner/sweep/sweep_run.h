#pragma once

namespace furrow::test {

/// Whether the environment asks for more than the everyday test:
///
///     FURROW_SWEEP          all; or sample:N:SEED, about N of all; or pairs:N:SEED, N pairs, each on
///                           one shape with one machine
///     FURROW_SWEEP_SETTING  only changes that have this in their name: "headland.", "path.method=u"
///     FURROW_SWEEP_SHAPE    only these, divided by commas
///     FURROW_SWEEP_MACHINE  likewise
///     FURROW_SWEEP_SHARD    I/N: every N-th group of cases of one shape and machine, from the I-th on
///     FURROW_SWEEP_OUT      a folder for cases.tsv (a line for each case, written at once), table.txt and
///                           failures.txt, and for the fields and files with which furrow-cli plans a case
///                           again; furrow_sweep among the temporary files by default
///     FURROW_SWEEP_SECONDS  how long a plan may take, 120 by default
bool sweepIsWanted();

/// Plans what is wanted, in processes of its own, so that a crash or a hang is one failing case. Prints
/// failing cases and the table. Gives the exit status of the program: 0 where no case failed.
int runSweep();

/// Whether this process is one of those, and what it does.
bool isSweepWorker();
int runSweepWorker();

}  // namespace furrow::test
